"""Numbers as a reader wants them: enough digits, a real minus sign, an em dash where there is nothing."""

from __future__ import annotations

from math import isfinite

NOTHING = "—"
SMALLEST_NUMBER = 1e-12


def number(value: float, digits: int = 6) -> str:
    """``digits`` significant digits, without trailing noise."""
    if not isfinite(value):
        return NOTHING if value != value else ("∞" if value > 0 else "−∞")
    return minus(_power(f"{value:.{digits}g}"))


def fixed(value: float, places: int) -> str:
    """A fixed number of decimal places."""
    return minus(f"{value:.{places}f}") if isfinite(value) else NOTHING


def percent(value: float, places: int = 2) -> str:
    """A relative deviation in per cent, with its sign."""
    return minus(f"{100.0 * value:+.{places}f} %") if isfinite(value) else NOTHING


def scientific(value: float, places: int = 1) -> str:
    """Small numbers such as residuals: 1.3 × 10⁻¹²."""
    if not isfinite(value):
        return NOTHING
    return "0" if value == 0.0 else minus(_power(f"{value:.{places}e}"))


def uncertainty(value: float) -> str:
    """± of a computed value; what lies below the accuracy of the method is not spelled out."""
    if not isfinite(value):
        return NOTHING
    return "± less than 10⁻¹²" if value < SMALLEST_NUMBER else f"± {scientific(value)}"


def complex_number(value: complex, places: int = 4) -> str:
    """A multiplier; its imaginary part only if there is one."""
    if not (isfinite(value.real) and isfinite(value.imag)):
        return NOTHING
    if abs(value.imag) < 0.5 * 10.0**-places:
        return fixed(value.real, places)
    sign = "+" if value.imag > 0 else "−"
    return (
        f"{fixed(value.real, places)} {sign} {abs(value.imag):.{places}f} i (modulus {abs(value):.{places}f})"
    )


def interval(lower: float, upper: float, digits: int = 6) -> str:
    """[lower, upper], or an em dash."""
    if not (isfinite(lower) and isfinite(upper)):
        return NOTHING
    return f"[{number(lower, digits)}, {number(upper, digits)}]"


def minus(text: str) -> str:
    """With the minus sign of mathematics."""
    return text.replace("-", "−")


_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def _power(text: str) -> str:
    mantissa, e, exponent = text.partition("e")
    return f"{mantissa} × 10{str(int(exponent)).translate(_RAISED)}" if e else mantissa
