"""Maps and paths as the page draws them, each of them once."""

from __future__ import annotations

import base64
import io

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from planners.kernel import Floats
from planners.map import Circle, Map, Raster
from planners.path import Path
from reports.figures.decimate import polyline
from reports.files.json_result import Json

_ROUND = 16  # segments in a quarter of a circle
_POINTS = 400  # of a path or a ring, about
_SHARE = 4000.0  # of its size: how far a line may move, and the last digit of its coordinates


class World:
    """All maps and paths of a page."""

    def __init__(self) -> None:
        self.maps: list[Json] = []
        self.paths: list[Json] = []
        # By identity; what is held keeps its own
        self._maps: dict[int, tuple[Map, int]] = {}
        self._paths: dict[tuple[int, float], tuple[Path, int]] = {}

    def map(self, area: Map | None) -> int | None:
        """The place of `area` among the maps; None for no map."""
        if area is None:
            return None
        if id(area) not in self._maps:
            self._maps[id(area)] = (area, _once(self.maps, map_data(area)))
        return self._maps[id(area)][1]

    def path(self, path: Path, corridor: float) -> int:
        """The place of `path` with its `corridor` [m] among the paths."""
        key = (id(path), corridor)
        if key not in self._paths:
            self._paths[key] = (path, _once(self.paths, path_data(path, corridor)))
        return self._paths[key][1]


def map_data(area: Map) -> Json:
    """What is forbidden as rings [m], fences, the edge, and cells as a picture."""
    solid = [*map(shapely.Polygon, area.polygons), *map(_disc, area.circles)]
    fences = [*map(shapely.Polygon, area.keep_in), *map(_disc, area.keep_in_circles)]
    return {
        "solid": _rings(shapely.unary_union([shapely.make_valid(shape) for shape in solid])) if solid else [],
        "fences": [ring for shape in fences for ring in _rings(shape)],
        "bounds": None if area.bounds is None else [*area.bounds],
        "raster": None if area.raster is None else _raster(area.raster),
    }


def path_data(path: Path, corridor: float) -> Json:
    """The line of `path` [m], how far its corridor reaches, and its length [m]."""
    size = float(np.ptp(path.xy, axis=0).max())
    tolerance = min(size / _SHARE, corridor / 10.0)
    while len(kept := polyline(path.xy, tolerance, 1)) > 2 * _POINTS:
        tolerance *= 2.0
    line = path.xy[kept]
    reach = shapely.LineString(line).buffer(corridor, cap_style="flat", quad_segs=3)
    rings = _rings(shapely.simplify(reach, corridor / 10.0))
    return {"line": _flat(line, corridor / 100.0), "corridor": rings, "length": path.length}


def _rings(shape: BaseGeometry) -> list[Json]:
    """The outlines of all polygons of `shape`, outer ones counter-clockwise and holes clockwise."""
    parts = [part for part in shapely.get_parts(shape) if part.geom_type == "Polygon" and part.area > 0.0]
    size = max((max(part.bounds[2] - part.bounds[0], part.bounds[3] - part.bounds[1]) for part in parts), default=1.0)
    found: list[Json] = []
    for part in parts:
        turned = shapely.geometry.polygon.orient(part)
        found += [_flat(shapely.get_coordinates(ring), size / _SHARE) for ring in (turned.exterior, *turned.interiors)]
    return found


def _flat(xy: Floats, step: float) -> Json:
    """x, y, x, y, ... with as many decimals as `step` asks for."""
    decimals = max(0, int(np.ceil(-np.log10(step))) + 1)
    return [round(float(value), decimals) for value in np.asarray(xy).ravel()]


def _raster(raster: Raster) -> Json:
    """A picture of its blocked cells, southern ones first, and where its south-west corner and its sides are [m]."""
    from PIL import Image

    from reports.figures.style import OBSTACLE

    rows, columns = raster.blocked.shape
    picture = Image.fromarray(raster.blocked.astype(np.uint8), "P")
    colour = [int(OBSTACLE[i : i + 2], 16) for i in (1, 3, 5)]
    picture.putpalette([255, 255, 255, *colour])
    file = io.BytesIO()
    picture.save(file, "PNG", transparency=0, bits=1, optimize=True)
    return {
        "picture": f"data:image/png;base64,{base64.b64encode(file.getvalue()).decode()}",
        "x": raster.x,
        "y": raster.y,
        "width": columns * raster.cell,
        "height": rows * raster.cell,
        "columns": columns,
        "rows": rows,
    }


def _disc(circle: Circle) -> shapely.Polygon:
    return shapely.Point(circle.x, circle.y).buffer(circle.radius, quad_segs=_ROUND)


def _once(among: list[Json], one: Json) -> int:
    if one not in among:
        among.append(one)
    return among.index(one)
