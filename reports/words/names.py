"""The metrics' names as words, for sentences and pages; where names are typed, they stay as they are."""

from __future__ import annotations

import re

# What the name without its statistic does not say by itself
_WORDS = {
    "cross_track": "cross-track error",
    "frechet": "Fréchet distance",
    "corridor_fraction": "path within the corridor",
    "corridor_violation_count": "times off the corridor",
    "corridor_violation_time": "time off the corridor",
    "corridor_violation_distance": "length off the corridor",
    "corridor_violation_worst": "beyond the corridor, max",
    "incursion_count": "times in obstacles",
    "incursion_time": "time in obstacles",
    "incursion_depth": "depth in obstacles",
    "turn_angle_max_planned": "turn angle, planned",
    "turn_angle_max_flown": "turn angle, flown",
    "turn_radius_min": "turn radius offered",
    "turn_radius_required": "turn radius needed",
    "turn_margin": "turn radius margin",
    "lateral_acceleration_demanded": "lateral acceleration asked",
}
_STATISTICS = {"max": "max", "min": "min", "mean": "mean", "rms": "RMS", "p50": "median"}
_STATISTIC = re.compile(r"(\w+)_(max|min|mean|rms|p\d+)")


def listed(name: str) -> str:
    """A name for a list of many: "cross_track_p95" is "cross-track error, 95 %"."""
    subject, statistic = _parts(name)
    return f"{subject}, {statistic}" if statistic else subject


def spoken(name: str) -> str:
    """A name in a sentence about a limit, where extremes go without saying: "bank_max" is "bank"."""
    subject, statistic = _parts(name)
    return subject if statistic in ("", "max", "min") else f"{statistic} {subject}"


def _parts(name: str) -> tuple[str, str]:
    """What is measured, and the statistic of it, "" for none."""
    match = None if name in _WORDS else _STATISTIC.fullmatch(name)
    subject, statistic = match.groups() if match else (name, "")
    return _WORDS.get(subject, subject.replace("_", " ")), _STATISTICS.get(statistic) or _percentile(statistic)


def _percentile(statistic: str) -> str:
    return f"{int(statistic.removeprefix('p'))} %" if statistic else ""
