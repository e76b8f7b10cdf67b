"""From SI numbers to what people read: degrees, kilometres, per cent, and g beside accelerations."""

from __future__ import annotations

import math
import re

from planners.units import STANDARD_GRAVITY

KILO = 1000.0
_MOST_DIGITS = 9  # beyond them two numbers may look the same

# SI unit -> what it is multiplied by, and the unit shown after it, with its space
_SHOWN = {
    "rad": (math.degrees(1.0), "°"),
    "rad/s": (math.degrees(1.0), "°/s"),
    "share": (100.0, " %"),
    "m/s^2": (1.0, " m/s²"),
    "1/m": (KILO, " 1/km"),
    "1": (1.0, ""),
    "": (1.0, ""),
}


def text(value: float, unit: str, digits: int = 3) -> str:
    """`value` in the SI `unit` as text of `digits` significant digits: 0.785 rad is "45°", 3412 m is "3.41 km"."""
    if math.isnan(value):
        return "n/a"
    if unit == "m" and abs(value) >= KILO and math.isfinite(value):
        return f"{number(value / KILO, digits)} km"
    factor, after = shown(unit)
    if unit in ("1", "g"):
        digits += 1  # ratios and load factors differ from 1 by little
    return number(value * factor, digits) + after


def shown(unit: str) -> tuple[float, str]:
    """What a value in the SI `unit` is multiplied by to be shown, and the unit after it, with its space."""
    return _SHOWN.get(unit, (1.0, f" {unit}"))


def shown_in(unit: str) -> tuple[float, str]:
    """What a quantity in the SI `unit` is multiplied by for an axis, and the unit that stands beside it."""
    factor, shown = _SHOWN.get(unit, (1.0, unit))
    return factor, shown.strip() or "1"


def text_with_g(value: float, unit: str, digits: int = 3) -> str:
    """Like `text`, with accelerations also as multiples of g: "5.88 m/s² (0.6 g)"."""
    plain = text(value, unit, digits)
    if unit != "m/s^2" or not math.isfinite(value):
        return plain
    return f"{plain} ({number(value / STANDARD_GRAVITY, digits)} g)"


def pair(value: float, limit: float, unit: str, met: bool = False) -> tuple[str, str]:
    """Both as text; unless `met`, with as many digits as it takes to tell them apart: never "30 m > 30 m"."""
    digits = 3
    while not met and digits < _MOST_DIGITS and text(value, unit, digits) == text(limit, unit, digits):
        digits += 1
    return text(value, unit, digits), text(limit, unit, digits)


def span(low: float, high: float, unit: str) -> str:
    """From one value to another, the unit said once: "1.2 – 3.4 km"; one value alone where they are the same."""
    if low == high:
        return text(low, unit)
    first, last = pair(low, high, unit)
    amount, _, shown = first.rpartition(" ")
    return f"{amount if last.endswith(f' {shown}') else first} – {last}"


def number(value: float, digits: int = 3) -> str:
    """A number with `digits` significant digits, whole digits kept, no exponent and no trailing zeros."""
    if not math.isfinite(value):
        return "n/a" if math.isnan(value) else ("∞" if value > 0.0 else "−∞")
    if value == 0.0:
        return "0"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    shown = f"{value:.{min(decimals, digits + 3)}f}"
    if "." in shown:
        shown = shown.rstrip("0").rstrip(".")
    return shown.removeprefix("-") if float(shown) == 0.0 else shown.replace("-", "−")


def counted(count: int, noun: str) -> str:
    """A number of things: "1 case", "2 cases"."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


_AN = re.compile(r"8|1[18](?!\d)|[aeio]|RMS")


def with_article(words: str) -> str:
    """The `words` with their article, as they are spoken: "a 7 m", "an 8 m", "an 11.8 m", "a 110 m", "an RMS"."""
    return f"{'an' if _AN.match(words) else 'a'} {words}"
