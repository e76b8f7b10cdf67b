"""Planned and flown line as KML 2.2 (OGC 07-147r2), for Google Earth."""

from __future__ import annotations

import math
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from planners.atomic_file import atomic
from planners.kernel import Floats
from reports.figures.focus import focus
from reports.files.geographic import flown, frame_of, planned
from reports.words.words import sentence
from tracking.outcome import Outcome

_NAMESPACE = "http://www.opengis.net/kml/2.2"
# Colours are aabbggrr: Okabe and Ito's sky blue and vermilion.
_STYLES = {"planned": ("ffe9b456", 2), "flown": ("ff005ed5", 4)}


def write_kml(outcome: Outcome, file: str | Path) -> None:
    """Write a Document with the planned and the flown line and the worst point.

    Heights are written as they are, above the ellipsoid; KML means the sea's level, tens of metres off at
    most. A ground vehicle's lines lie on the ground.
    """
    frame = frame_of(outcome.path, "KML")
    clamped = outcome.limits.kind == "ground"
    root = ElementTree.Element("kml", xmlns=_NAMESPACE)
    document = _child(root, "Document")
    _child(document, "name", outcome.name)
    _child(document, "description", sentence(outcome))
    for line, (colour, width) in _STYLES.items():
        look = _child(_child(document, "Style", id=line), "LineStyle")
        _child(look, "color", colour)
        _child(look, "width", str(width))
    _line(document, "planned", planned(outcome, frame), clamped)
    places = flown(outcome, frame)
    _line(document, "flown", places, clamped)
    if (worst := focus(outcome)) is not None:
        [[lat, lon]] = frame.to_geographic(np.array([[worst.x, worst.y]]))
        z = math.nan if clamped or worst.index is None else float(outcome.track["z"][worst.index])
        _point(document, f"{worst.title}: {worst.label}", lon, lat, z)
    ElementTree.indent(root)
    with atomic(file) as temporary:
        ElementTree.ElementTree(root).write(temporary, encoding="utf-8", xml_declaration=True)


def _line(document: ElementTree.Element, name: str, places: Floats, clamped: bool) -> None:
    if len(places) < 2:  # a LineString needs two positions
        return
    mark = _child(document, "Placemark")
    _child(mark, "name", name)
    _child(mark, "styleUrl", f"#{name}")
    line = _child(mark, "LineString")
    _child(line, "tessellate", "1")
    _child(line, "altitudeMode", "clampToGround" if clamped else "absolute")
    _child(line, "coordinates", " ".join(f"{lon:.9f},{lat:.9f},{z:.3f}" for lon, lat, z in places.tolist()))


def _point(document: ElementTree.Element, name: str, lon: float, lat: float, z: float) -> None:
    """A point at height `z` [m], or on the ground where that is NaN."""
    mark = _child(document, "Placemark")
    _child(mark, "name", name)
    point = _child(mark, "Point")
    if math.isfinite(z):
        _child(point, "altitudeMode", "absolute")
    _child(point, "coordinates", f"{lon:.9f},{lat:.9f},{z:.3f}" if math.isfinite(z) else f"{lon:.9f},{lat:.9f}")


def _child(parent: ElementTree.Element, tag: str, text: str | None = None, **attributes: str) -> ElementTree.Element:
    element = ElementTree.SubElement(parent, tag, attributes)
    # XML has no way to write a control character, escaped or not.
    element.text = None if text is None else "".join(c for c in text if c.isprintable() or c in "\n\t")
    return element
