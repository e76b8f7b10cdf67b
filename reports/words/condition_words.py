"""The conditions of a case in words: what every trial meets, and what each draws anew."""

from __future__ import annotations

from campaigns.conditions import CALM, ConditionKeys, DrydenKeys, GustKeys, WindKeys, known_wind
from campaigns.distribution import Distribution, Value
from reports.words.quantity import number
from reports.words.words import wind_words

# What a condition is called, and its unit as it is written after the number
_WORDS = {
    "turbulence": ("turbulence", ""),
    "cross_track_offset": ("start to the left by", " m"),
    "heading_offset": ("start turned to the left by", "°"),
    "mass": ("mass", " times the nominal"),
    "friction": ("friction", ""),
    "position_noise": ("position noise", " m"),
    "heading_noise": ("heading noise", "°"),
    "speed_noise": ("speed noise", " m/s"),
    "noise_time": ("noise correlated over", " s"),
    "latency": ("latency", " s"),
}


def condition_words(keys: ConditionKeys) -> list[str]:
    """Every condition that is not the default: "friction 0.6 to 0.9", "wind Weibull of shape 2, scale 6 m/s"."""
    told = [wind_case_words(keys)] if keys.wind != CALM.wind else []
    told += [_gust_words(keys.gust)] if keys.gust else []
    told += [_dryden_words(keys.dryden)] if keys.dryden else []
    for name, (word, unit) in _WORDS.items():
        value = getattr(keys, name)
        if value is not None and value != getattr(CALM, name):
            told.append(f"{word} {_value(value, unit)}")
    return told


def wind_case_words(keys: ConditionKeys) -> str:
    """The wind of all trials, or what each draws it from."""
    if (wind := known_wind(keys)) is not None or not isinstance(keys.wind, WindKeys):
        return wind_words(wind) if wind else "no wind"
    return f"wind {_value(keys.wind.speed, ' m/s')}, from {_value(keys.wind.origin, '°')}"


def _dryden_words(dryden: DrydenKeys) -> str:
    return f"Dryden turbulence of {_value(dryden.sigma, ' m/s')} over {_value(dryden.length, ' m')}"


def _gust_words(gust: GustKeys) -> str:
    up = f", {_value(gust.up, ' m/s')} up" if gust.up else ""
    wind = f"{_value(gust.speed, ' m/s')}, from {_value(gust.origin, '°')}"
    return f"gust {wind}{up}, at {_value(gust.start, ' s')} for {_value(gust.duration, ' s')}"


def _value(value: Value | str, unit: str) -> str:
    """A number, or what it is drawn from: "0 ± 0.1 m" is normal, "0.6 to 0.9" uniform."""
    if isinstance(value, str):
        return value
    if not isinstance(value, Distribution):
        return f"{number(value, 4)}{unit}"
    if value.normal:
        return f"{number(value.normal[0], 4)} ± {number(value.normal[1], 4)}{unit}"
    if value.uniform:
        return f"{number(value.uniform[0], 4)} to {number(value.uniform[1], 4)}{unit}"
    shape, scale = value.weibull or (1.0, 0.0)
    return f"Weibull of shape {number(shape, 4)}, scale {number(scale, 4)}{unit}"
