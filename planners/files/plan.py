"""Missions as QGroundControl plans (QGroundControl developer guide, "Plan File Format")."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import msgspec

from planners.errors import InputError
from planners.files import commands
from planners.files.fence import GeoFence, fence_map
from planners.files.json_text import decode
from planners.files.mission import MissionItem, take_path, waypoint_positions
from planners.files.source import PathFile, Source
from planners.files.text import check_marks
from planners.path import Path

# QGroundControlQmlGlobal::AltMode; "above terrain" is absolute, computed by QGroundControl from terrain data
_RELATIVE, _ABSOLUTE, _ABOVE_TERRAIN, _TERRAIN_FRAME = 1, 2, 3, 4
_MODE_FRAMES = {
    _RELATIVE: commands.FRAME_RELATIVE,
    _ABSOLUTE: commands.FRAME_GLOBAL,
    _ABOVE_TERRAIN: commands.FRAME_TERRAIN,
    _TERRAIN_FRAME: commands.FRAME_TERRAIN,
}

Numbers = list[float | None]


class _Item(msgspec.Struct):
    """A simple or complex item; old ones have `coordinate` and `param1` to `param4` in place of `params`."""

    type: str = "SimpleItem"
    command: int = 0
    frame: int = commands.FRAME_GLOBAL
    params: Numbers = []
    coordinate: Numbers = []
    param2: float | None = None
    altitude: float | None = msgspec.field(name="Altitude", default=None)
    altitude_mode: int | None = msgspec.field(name="AltitudeMode", default=None)
    amsl: float | None = msgspec.field(name="AMSLAltAboveTerrain", default=None)
    complex_type: str = msgspec.field(name="complexItemType", default="complex item")
    transects: _Transects | None = msgspec.field(name="TransectStyleComplexItem", default=None)


class _Transects(msgspec.Struct):
    items: list[_Item] = msgspec.field(name="Items", default_factory=list)


class _Home(msgspec.Struct):
    coordinate: Numbers = []


class _Mission(msgspec.Struct):
    items: list[_Item] = []
    home: Numbers | _Home | None = msgspec.field(name="plannedHomePosition", default=None)


class _Rally(msgspec.Struct):
    points: list[msgspec.Raw] = []


class _Plan(msgspec.Struct):
    file_type: str = msgspec.field(name="fileType", default="Plan")
    mission: _Mission | None = None
    fence: GeoFence | None = msgspec.field(name="geoFence", default=None)
    rally: _Rally | None = msgspec.field(name="rallyPoints", default=None)


def read(source: Source) -> PathFile:
    """The path and the geofence of a plan, comments allowed.

    Of surveys and corridor scans the items that QGroundControl stored are flown; complex items without stored
    items are skipped with a note, and so are rally points. An altitude is taken as it would be sent to the
    vehicle (`params` in `frame`), and if that is null, from `Altitude` and `AltitudeMode`.
    """
    check_marks(source.text.count("["), source.place)  # every item has an array
    plan = decode(source.text, _Plan, source.place)
    if plan.file_type != "Plan":
        raise InputError(source.place, f"fileType is {plan.file_type!r}, not 'Plan'", "save the mission as a plan")
    if plan.mission is None:
        raise InputError(source.place, "there is no mission in the plan", "add a mission with waypoints")
    notes: list[str] = []
    items = list(_items(plan.mission.items, "item ", notes))
    mission = take_path(source, items, _home_alt(plan.mission.home))
    if plan.rally and plan.rally.points:
        notes.append(f"rallyPoints: {len(plan.rally.points)} points are not part of the path")
    fence = fence_map(plan.fence, mission.path, source.place, notes) if plan.fence else None
    return replace(mission, notes=(*notes, *mission.notes), fence=fence)


def write(path: Path, place: str) -> str:
    """The path, which must lie on Earth, as absolute waypoints; no height is 0 m."""
    positions = waypoint_positions(path, place)
    items = [
        {
            "AMSLAltAboveTerrain": None,
            "Altitude": position[2],
            "AltitudeMode": _ABSOLUTE,
            "autoContinue": True,
            "command": commands.NAV_WAYPOINT,
            "doJumpId": i,
            "frame": commands.FRAME_GLOBAL,
            "params": [0, 0, 0, None, *position],
            "type": "SimpleItem",
        }
        for i, position in enumerate(positions, 1)
    ]
    plan = {
        "fileType": "Plan",
        "geoFence": {"circles": [], "polygons": [], "version": 2},
        "groundStation": "QGroundControl",
        "mission": {
            "cruiseSpeed": 15,  # [m/s] as hoverSpeed, QGroundControl's default for its time estimates
            "firmwareType": 12,  # MAV_AUTOPILOT_PX4
            "hoverSpeed": 5,
            "items": items,
            "plannedHomePosition": positions[0],
            "vehicleType": 1,  # MAV_TYPE_FIXED_WING
            "version": 2,
        },
        "rallyPoints": {"points": [], "version": 2},
        "version": 1,
    }
    return msgspec.json.format(msgspec.json.encode(plan), indent=4).decode() + "\n"


def _items(items: list[_Item], prefix: str, notes: list[str]) -> Iterator[MissionItem]:
    for number, item in enumerate(items, 1):
        label = f"{prefix}{number}"
        if item.type == "SimpleItem":
            yield _mission_item(item, label)
        elif item.transects is not None and item.transects.items:
            yield from _items(item.transects.items, f"{label}.", notes)
        else:
            kind = item.complex_type if item.type == "ComplexItem" else item.type
            notes.append(f"{label}: {kind}: its track is not stored in the plan")


def _mission_item(item: _Item, label: str) -> MissionItem:
    params = [*item.params, *[None] * (7 - len(item.params))]
    lat, lon, alt = params[4:7]
    if not lat and not lon and item.coordinate:
        lat, lon, alt = [*item.coordinate, None, None, None][:3]
    frame = item.frame
    if alt is None and item.altitude_mode == _ABOVE_TERRAIN and item.amsl is not None:
        frame, alt = commands.FRAME_GLOBAL, item.amsl
    elif alt is None and item.altitude is not None:
        frame, alt = _MODE_FRAMES.get(item.altitude_mode or 0, frame), item.altitude
    speed = params[1] if item.params else item.param2
    return MissionItem(label, item.command, frame, speed, lat, lon, alt)


def _home_alt(home: Numbers | _Home | None) -> float | None:
    position = home.coordinate if isinstance(home, _Home) else home or []
    return position[2] if len(position) > 2 else None
