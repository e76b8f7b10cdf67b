"""A number that is drawn anew for every trial: `{ normal = [0, 3] }` in a campaign file."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from planners.errors import InputError

MOST_DRAWS = 1000  # until one lies within the bounds
Pair = tuple[float, float]


class Distribution(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """One of `normal` [mean, standard deviation], `uniform` [lowest, highest], `weibull` [shape, scale]."""

    normal: Pair | None = None
    uniform: Pair | None = None
    weibull: Pair | None = None

    def check(self, place: str) -> None:
        """Raises `InputError` unless it is exactly one distribution with parameters that make sense."""
        given = {name: pair for name in self.__struct_fields__ if (pair := getattr(self, name)) is not None}
        if len(given) != 1:
            what = "names no distribution" if not given else f"names {len(given)} distributions"
            raise InputError(place, what, "give one of normal, uniform, weibull")
        ((name, (a, b)),) = given.items()
        if not (math.isfinite(a) and math.isfinite(b)):
            raise InputError(place, f"{name} = [{a:g}, {b:g}] has a value that is not finite")
        if name == "normal" and b < 0.0:
            raise InputError(place, f"the standard deviation {b:g} is negative", "write normal = [mean, deviation]")
        if name == "uniform" and not math.isfinite(b - a):
            raise InputError(place, f"uniform = [{a:g}, {b:g}] is too wide", "write [lowest, highest]")
        if name == "uniform" and a > b:
            raise InputError(place, f"uniform = [{a:g}, {b:g}] runs backwards", "write [lowest, highest]")
        if name == "weibull" and (a <= 0.0 or b <= 0.0):
            raise InputError(place, f"weibull = [{a:g}, {b:g}] is none", "write [shape, scale], both above 0")

    def draw(self, rng: np.random.Generator) -> float:
        """One value."""
        if self.normal:
            return float(rng.normal(*self.normal))
        if self.uniform:
            return float(rng.uniform(*self.uniform))
        shape, scale = self.weibull or (1.0, 0.0)
        return float(scale * rng.weibull(shape))


Value = float | Distribution


def drawn(value: Value, rng: np.random.Generator, place: str, low: float = -math.inf, high: float = math.inf) -> float:
    """`value`, or one drawn from it between `low` and `high`; what falls outside is drawn again.

    Raises `InputError` naming `place` for a value outside, and for a distribution that does not get inside.
    """
    if not isinstance(value, Distribution):
        if not (low <= value <= high and math.isfinite(value)):
            raise InputError(place, f"{value:g} is out of range", f"choose {_range(low, high)}")
        return float(value)
    value.check(place)
    for _ in range(MOST_DRAWS):
        if low <= (one := value.draw(rng)) <= high:
            return one
    raise InputError(place, "this distribution gives no possible value", f"choose one with values {_range(low, high)}")


def _range(low: float, high: float) -> str:
    if math.isinf(high):
        return "a finite number" if math.isinf(low) else f"{low:g} or more"
    return f"{low:g} to {high:g}"
