"""Paths as GeoJSON (RFC 7946): one LineString, alone, in a Feature, or in a collection."""

from __future__ import annotations

from collections.abc import Iterator

import msgspec

from planners.errors import InputError
from planners.files.json_text import decode, decode_raw
from planners.files.points import HEIGHT_DIGITS, geographic_path, range_notes, to_degrees
from planners.files.source import PathFile, Source
from planners.files.text import check_count
from planners.path import Path


class _Node(msgspec.Struct):
    """A GeoJSON object; `coordinates` stay raw until its type is known."""

    type: str
    coordinates: msgspec.Raw = msgspec.Raw()
    geometry: _Node | None = None
    geometries: list[_Node] = []
    features: list[_Node] = []


class _LineString(msgspec.Struct):
    coordinates: list[list[float]]
    type: str = "LineString"


class _Properties(msgspec.Struct):
    name: str


class _Feature(msgspec.Struct):
    properties: _Properties
    geometry: _LineString
    type: str = "Feature"


def read(source: Source) -> PathFile:
    """The one LineString in the file, positions in the order longitude, latitude[, altitude] [deg, m].

    Features of other types beside it are skipped with a note; several LineStrings are an error.
    """
    geometries = list(_geometries(decode(source.text, _Node, source.place), ""))
    lines = [(label, node) for label, node in geometries if node.type == "LineString"]
    if len(lines) > 1:
        labels = ", ".join(label for label, _ in lines[:6]) + (", ..." if len(lines) > 6 else "")
        what = f"{len(lines)} LineStrings ({labels}), and a path file holds one"
        raise InputError(source.place, what, "save each in a file of its own")
    if not lines:
        kinds = ", ".join(sorted({node.type for _, node in geometries})) or "nothing"
        raise InputError(source.place, f"no LineString, only {kinds}", "export the path as one LineString")
    path = _path(source, *lines[0])
    skipped = [f"{label}: a {node.type} is not a path" for label, node in geometries if node.type != "LineString"]
    return PathFile(path, (*skipped, *range_notes(path)))


def write(path: Path, place: str) -> str:
    """The path, which must lie on Earth, as a Feature with one LineString."""
    positions = to_degrees(path, place)[:, ::-1].tolist()
    if path.z is not None:
        positions = [[*xy, round(z, HEIGHT_DIGITS)] for xy, z in zip(positions, path.z.tolist(), strict=True)]
    feature = _Feature(_Properties(path.name), _LineString(positions))
    return msgspec.json.format(msgspec.json.encode(feature), indent=1).decode() + "\n"


def _geometries(node: _Node, label: str) -> Iterator[tuple[str, _Node]]:
    """The geometries in the tree below `node`, each with its place."""
    inner = f"{label} " if label else ""
    if node.type == "FeatureCollection":
        for i, feature in enumerate(node.features, 1):
            yield from _geometries(feature, f"{inner}feature {i}")
    elif node.type == "GeometryCollection":
        for i, geometry in enumerate(node.geometries, 1):
            yield from _geometries(geometry, f"{inner}geometry {i}")
    elif node.type != "Feature":
        yield label or "the geometry", node
    elif node.geometry is not None:
        yield from _geometries(node.geometry, label)


def _path(source: Source, label: str, line: _Node) -> Path:
    raw = bytes(line.coordinates)
    check_count(raw.count(b"[") - 1, source.place)
    positions = decode_raw(line.coordinates, list[list[float]], f"{source.place}: {label}: coordinates")
    sizes = {len(position) for position in positions}
    for i, position in enumerate(positions, 1):
        if len(position) < 2:
            what = f"{len(position)} numbers"
            raise InputError(f"{source.place}: position {i}", what, "give longitude, latitude[, altitude]")
    for i, position in enumerate(positions, 1):
        if len(position) == 2 and sizes != {2}:
            raise InputError(f"{source.place}: position {i}", "no altitude, but others have one", "give all or none")
    z = [position[2] for position in positions] if positions and sizes != {2} else None
    lat, lon = [position[1] for position in positions], [position[0] for position in positions]
    return geographic_path(source, lambda i: f"position {i + 1}", lat, lon, z)
