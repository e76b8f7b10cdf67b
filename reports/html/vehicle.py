"""One vehicle's run as the page replays and plots it."""

from __future__ import annotations

import math

import numpy as np

from planners.footprint import Disc, Footprint
from planners.kernel import Floats, Ints
from planners.units import STANDARD_GRAVITY
from reports.figures.panels import Panel, panels
from reports.files.json_result import Json
from reports.html.columns import Pool, samples
from tracking.outcome import Outcome

_WIDE = ("t", "x", "y", "s")  # columns that need more than two bytes
# What the replay shows besides, and the factor to the unit it is shown in
_CHANNELS = {
    "cross_track": 1.0, "z": 1.0, "ground_speed": 1.0, "airspeed": 1.0, "climb_rate": 1.0, "load_factor": 1.0,
    "heading": math.degrees(1.0), "bank": math.degrees(1.0), "pitch": math.degrees(1.0),
    "steering": math.degrees(1.0), "lateral_acceleration": 1.0 / STANDARD_GRAVITY,
}  # fmt: skip


def vehicle_data(outcome: Outcome, departure: float, number: int, most: int, path: int | None) -> dict[str, Json]:
    """The run of the vehicle of that `number`, from 1, of about `most` samples, and its panels.

    `departure` [s] is when it leaves, `path` the number of its path on the page. Angles are in degrees, lateral
    accelerations in g.
    """
    track, pool = outcome.track, Pool()
    kept = samples(track, outcome.corridor, most)
    columns: dict[str, Json] = {name: pool.add(track[name][kept], wide=True) for name in _WIDE}
    columns |= {
        name: pool.add(factor * track[name][kept])
        for name, factor in _CHANNELS.items()
        if name in track and not _idle(outcome, name)
    }
    return {
        "number": number,
        "departure": round(departure, 3),
        "samples": len(kept),
        "ended": track.ended,
        "path": path,
        "columns": columns,
        "panels": [_panel(panel, outcome, kept, pool, path) for panel in (*panels(outcome), _speed(outcome))],
        "pool": pool.columns,
    }


def body_data(body: Footprint) -> Json:
    """The body from above [m]: a disc's radius, or a rectangle and how far its centre is ahead."""
    if isinstance(body, Disc):
        return {"radius": body.radius}
    return {"length": body.length, "width": body.width, "ahead": body.ahead}


def _idle(outcome: Outcome, column: str) -> bool:
    """Whether a ground vehicle's column says nothing: its height and its climb are the map's."""
    return outcome.limits.kind == "ground" and column in ("z", "climb_rate", "airspeed")


def _speed(outcome: Outcome) -> Panel:
    ground = outcome.limits.kind == "ground"
    title, column = ("Speed", "ground_speed") if ground else ("Airspeed", "airspeed")
    return Panel(title, "m/s", outcome.track[column], command=outcome.track["speed_command"], symmetric=False)


def _panel(panel: Panel, outcome: Outcome, kept: Ints, pool: Pool, path: int | None) -> Json:
    lower, upper = _bounds(panel, outcome)

    def add(values: Floats | None) -> int | None:
        return None if values is None else pool.add(np.asarray(values, float)[kept])

    needed = None
    if panel.needed is not None and path is not None:  # what another path needs says nothing
        s, wanted = panel.needed
        needed = np.interp(outcome.track["s"], s, wanted)
    return {
        "title": {"Lateral accel.": "Lateral acceleration"}.get(panel.title, panel.title),
        "unit": panel.unit,
        "values": add(panel.values),
        "command": add(panel.command),
        "lower": add(lower),
        "upper": add(upper),
        "needed": add(needed),
        "corridor": panel.corridor,
    }


def _bounds(panel: Panel, outcome: Outcome) -> tuple[Floats | None, Floats | None]:
    """Between which limits the panel's values are to be; of height and airspeed as far as one is stated."""
    if panel.limit is not None:
        return -panel.limit, panel.limit
    metric = {"Height": "altitude_error_max", "Airspeed": "speed_error_max", "Speed": "speed_error_max"}.get(
        panel.title
    )
    stated = [m.requirement.limit for m in outcome.verdict.margins if m.requirement.metric == metric]
    if not stated or panel.command is None:
        return None, None
    return panel.command - stated[0], panel.command + stated[0]
