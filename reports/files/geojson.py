"""Planned and flown line as GeoJSON (RFC 7946), for GIS and web maps."""

from __future__ import annotations

import json
from pathlib import Path

from planners.atomic_file import atomic
from planners.kernel import Floats
from reports.files.geographic import flown, frame_of, planned
from reports.files.json_result import Json, to_json
from tracking.outcome import Outcome

_TOLD = ("name", "vehicle", "controller", "speed", "corridor", "wind", "verdict", "sentence", "ended")


def write_geojson(outcome: Outcome, file: str | Path) -> None:
    """Write a FeatureCollection of the planned and the flown line, positions as longitude, latitude, height [m]."""
    frame = frame_of(outcome.path, "GeoJSON")
    told = to_json(outcome)
    about: dict[str, Json] = {key: told[key] for key in _TOLD}
    collection: Json = {
        "type": "FeatureCollection",
        "features": [
            _feature("planned", planned(outcome, frame), {"length": outcome.path.length}),
            _feature("flown", flown(outcome, frame), about),
        ],
    }
    with atomic(file) as temporary:
        temporary.write_text(json.dumps(collection, ensure_ascii=False, allow_nan=False), encoding="utf-8")


def _feature(line: str, places: Floats, properties: dict[str, Json]) -> Json:
    return {"type": "Feature", "properties": {"line": line, **properties}, "geometry": _geometry(places)}


def _geometry(places: Floats) -> Json:
    """A LineString, which needs two positions; of one a Point, of none no geometry."""
    positions: list[Json] = [[round(lon, 9), round(lat, 9), round(z, 3)] for lon, lat, z in places.tolist()]
    if len(positions) > 1:
        return {"type": "LineString", "coordinates": positions}
    return {"type": "Point", "coordinates": positions[0]} if positions else None
