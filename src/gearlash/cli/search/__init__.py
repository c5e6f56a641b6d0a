"""What commands compute beyond one call of a study: impact-free speeds nearby, the way to the next grazing.
No terminal here; these belong to nobody's room yet and import only what studies import.
"""
