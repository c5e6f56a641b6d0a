"""Decoded results of this program at one commit, kept to show that a later one computes the same."""
