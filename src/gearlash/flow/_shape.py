"""Where things lie in the memory that kernels read (`_tables`)."""

from __future__ import annotations

from typing import NamedTuple


class Shape(NamedTuple):
    """Sizes, and places in the flat array `memory`."""

    n: int  # states
    p: int  # 1 + n, padded
    clearances: int
    cells: int
    rows: int  # of a column of `step`: state, then rough Bernstein coefficients of every clearance
    harmonics: int  # of the longest series
    scalars: int  # ω/N (of the phase per τ), cell duration in τ, cell width in θ
    gaps: int  # (clearances, 4): D⁺, D⁻, ζ⁺, ζ⁻
    reach: int  # (clearances): |D⁺| + |D⁻| + Σ|e|, whose rounding is that of a boundary's place
    reads: int  # (clearances, p): (0, h)
    offset: int  # (clearances, 2H+1): e(θ)
    speed: int  # (clearances, p): (0, h·M)
    drift: int  # (clearances, 2H+1): h·b - e'
    stiffness: int  # (clearances, 2, 2H+1): η(θ) of side +, side -
    eta: int  # (cells, clearances, 2, TERMS): its Taylor coefficients over each cell
    lost: int  # (clearances, 2): bound on what those leave out, over any cell
    bernstein: int  # (2, ORDER+1, TERMS): Taylor to Bernstein, of degree ORDER and ORDER-1
    pascal: int  # (ORDER+1, TERMS): column m holds C(m, i)
    hilbert: int  # (ORDER+1, TERMS): column k holds 1/(i+k+1)
    rough: int  # (ORDER+1, ROUGH): Taylor to the Bernstein coefficients of degree ROUGH-1 of what is close
    spared: int  # (TERMS): how far that is at most, per unit of each Taylor coefficient; its rounding
    slots: int  # where the first slot begins
    slot: int  # length of a slot
    # inside a slot:
    step: int  # (cells, 1+n, rows): state at the end of the cell, rough coefficients of what is watched
    near: int  # (cells, clearances, p): bound on what those coefficients leave out
    fine: int  # (cells, 1+n, clearances, TERMS): Bernstein coefficients of what is watched
    rest: int  # (cells, clearances, p): bound on what those leave out
    gap: int  # (cells, clearances, 1+n, TERMS): Taylor coefficients of X - edge
    bound: int  # (cells, clearances, p): bound on the error of X: remainder and rounding
    pull: int  # (cells, clearances, ORDER+1, p): flow from s back to 0, applied to g: coefficients in s
    push: int  # (cells, clearances, 2, ORDER+1, p): `pull` times η of side +, side -
    matrix: int  # (n + clearances, p): columns of M with its damping, then of g
    forcing: int  # (n, 2H+1)
    tail: int  # (clearances, 4): Taylor remainder of X, of dX/ds: per unit of Σ|z|, constant
    centre: int  # (p): (0, c); the state of a motion here is z - c, and X that from the contact's edge
    lap: int  # (1+n, p): state at the end of a whole base period without contact
    centred: int  # (p): start of the motion that repeats under it
    swing: int  # (clearances, p): largest change of what is watched, per unit of each state at the start
    margin: int  # (clearances, 2): how far it stays above its lower, below its upper limit on that motion
    lag: int  # (clearances): h·c - edge - mean of e, zero wherever a centre can be had
