"""`trackworthy list`: what there is to choose from."""

from __future__ import annotations

import argparse
import inspect
import re
from collections.abc import Callable
from typing import Any


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser("list", help="list planners, vehicles, controllers, scenarios and more")
    parser.set_defaults(main=main)
    parser.add_argument("what", nargs="?", choices=tuple(_LISTS), help=f"left out: everything but {', '.join(_LONG)}")


def main(args: argparse.Namespace) -> int:
    """Print the names, one a line, with what they are."""
    if args.what:
        print(*_LISTS[args.what](), sep="\n")
        return 0
    for name, lines in _LISTS.items():
        if name not in _LONG:
            print(f"{name}:", *(f"  {line}" for line in lines()), sep="\n")
    return 0


def _planners() -> list[str]:
    from planners.all_planners import ALL_PLANNERS

    return [f"{planner.name:<19}{planner.summary}" for planner in ALL_PLANNERS]


def _planner_settings() -> list[str]:
    """Each planner's settings as `--set` takes them, and what they are."""
    import msgspec

    from planners.all_planners import ALL_PLANNERS, make_planner

    lines = []
    for planner in ALL_PLANNERS:
        settings: dict[str, Any] = msgspec.to_builtins(make_planner(planner.name))
        lines.append(planner.name)
        for key, value in settings.items():
            default = f"{key}, not set" if value is None else f"{key} = {msgspec.json.encode(value).decode()}"
            lines.append(f"  {default:<32}{_about(key, planner)}".rstrip())
    return lines


def _about(key: str, planner: type) -> str:
    """What the docstring of the class that has a setting says of it: in a line "key: ...", or a sentence with `key`.

    A class that only gives it another default leaves that to those it comes from.
    """
    owners = [kind.__doc__ or "" for kind in planner.__mro__ if key in inspect.get_annotations(kind)]
    split = r"\n\s*(?=[a-z_, ]+: )|(?<=\.)\s+(?=[A-Z`])|\n\s*\n"
    parts = [part for told in owners for part in re.split(split, told)]
    lines = [told for keys, _, told in (part.partition(": ") for part in parts) if key in keys.split(", ")]
    sentences = [part for part in parts if f"`{key}`" in part]
    return " ".join(" ".join([*lines, *sentences][:1]).split())


def _vehicles() -> list[str]:
    from sim.vehicles import ALL_VEHICLES, make_vehicle

    lines = []
    for name in ALL_VEHICLES:
        limits = make_vehicle(name).limits
        speeds = f"{limits.speed_min:g} to {limits.speed_max:g} m/s, {limits.speed:g} by default"
        lines.append(f"{name:<14}{limits.kind}, {speeds}; corridor {limits.corridor:g} m")
    return lines


def _planets() -> list[str]:
    from sim.planet import ALL_PLANETS

    lines = []
    for planet in ALL_PLANETS:
        temperature, _ = planet.air(0.0)
        air = f"{planet.density(0.0):.4g} kg/m³, sound at {planet.speed_of_sound(temperature):.0f} m/s"
        lines.append(f"{planet.name:<14}{planet.gravity:.4g} m/s²; air of {air}")
    return lines


def _modes() -> list[str]:
    """The natural modes of every aircraft at home, at its speed and altitude: no loop closed."""
    from sim.aircraft_file import ALL_AIRCRAFT, load_aircraft
    from sim.modes import modes_of

    lines = []
    for name in ALL_AIRCRAFT:
        aircraft = load_aircraft(name)
        speed, altitude = aircraft.envelope.speed, aircraft.envelope.altitude
        lines.append(f"{name}, {speed:g} m/s at {altitude:g} m")
        for mode in modes_of(aircraft, aircraft.home, speed, altitude):
            halves = f"{'halves' if mode.decay > 0.0 else 'doubles'} in {abs(mode.half_time):.3g} s"
            swings = f"damping {mode.damping:.3g} at {mode.frequency:.3g} rad/s, " if abs(mode.damping) < 1.0 else ""
            lines.append(f"  {mode.name:<14}{swings}{halves}")
    return lines


def _controllers() -> list[str]:
    from tracking.controllers import ALL_CONTROLLERS

    return [f"{controller.name:<14}{_summary(controller)}" for controller in ALL_CONTROLLERS]


def _scenarios() -> list[str]:
    from planners.scenario import BUILT_IN_SCENARIOS, load_scenario

    lines = []
    for name in BUILT_IN_SCENARIOS:
        scenario = load_scenario(name)
        width, height = scenario.size
        lines.append(f"{name:<22}{width:g} x {height:g} m")
    return lines


def _campaigns() -> list[str]:
    from campaigns.campaign import BUILT_IN_CAMPAIGNS
    from campaigns.full import FULL, find_campaign

    return [f"{name:<22}{find_campaign(name).title}" for name in (*BUILT_IN_CAMPAIGNS, *FULL)]


def _formats() -> list[str]:
    from planners.files import FORMATS

    return [f"{form.name:<22}{' '.join(form.suffixes)}" for form in FORMATS]


def _metrics() -> list[str]:
    """Their names, from two on one metre each, driven and flown: what a vehicle measures depends on the vehicle."""
    import numpy as np

    from campaigns.limits import DEFAULT_LIMITS
    from planners.map import Map
    from planners.path import Path
    from tracking.trial import Trial, run_trial

    here, beside = (Path(np.array([[0.0, y], [1.0, y]])) for y in (0.0, 50.0))
    trials = (
        Trial("one metre", here, vehicle, obstacles=Map(), max_range=1.0, others=(beside,))
        for vehicle in ("c172x", "truck")
    )
    metrics = {name: metric for trial in trials for name, metric in run_trial(trial).metrics.items()}
    shown = {"rad": "deg", "rad/s": "deg/s", "m/s^2": "m/s^2 or g", "share": "%", "1": ""}
    better = {"lower": "lower is better", "higher": "higher is better", "neither": ""}
    lines = []
    for name, metric in metrics.items():
        line = f"{name:<30}{shown.get(metric.unit, metric.unit):<12}{better[metric.better]:<18}"
        if limit := DEFAULT_LIMITS.get(name):
            share = f" or {100 * limit.relative:g} %" if limit.relative else ""
            scale = 100.0 if metric.unit == "share" else 1.0
            line += f"may worsen by {scale * limit.absolute:g}{share}"
        lines.append(line.rstrip())
    return lines


def _summary(documented: object) -> str:
    return (documented.__doc__ or "").strip().splitlines()[0]


_LISTS: dict[str, Callable[[], list[str]]] = {
    "planners": _planners,
    "planner-settings": _planner_settings,
    "vehicles": _vehicles,
    "planets": _planets,
    "modes": _modes,
    "controllers": _controllers,
    "scenarios": _scenarios,
    "campaigns": _campaigns,
    "formats": _formats,
    "metrics": _metrics,
}
_LONG = ("metrics", "planner-settings", "modes")
