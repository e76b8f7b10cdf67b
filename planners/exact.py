"""The exact shortest path by visibility graph, the yardstick of all others."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Annotated, Any, ClassVar

import msgspec
import numpy as np
import shapely

from planners.assignment import assigned
from planners.fleet import fleet_ends, pair_name, unserved, why_unserved
from planners.kernel import Floats
from planners.map import Circle, Map, Raster
from planners.offset import bearings, grown, overlay, shrunk, tangents
from planners.outline import raster_edges
from planners.path import Path
from planners.planner import NO_PATH, Plan
from planners.scenario import Scenario
from planners.visibility import shortest

GAP = 1e-10  # [largest coordinates] kept from everything, so that no path slips between obstacles that touch
MOST_EDGES = 20_000  # of a raster: its exact path takes some 5 s, and three times that for twice as many
NEAR = 100.0  # [gaps] as far as a start or goal is moved out of the gap


class Exact(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Shortest path that keeps `clearance` [m] from everything; it may touch, but not pass between what touches.

    A fleet takes the assignment of least total length. Range and turn limits do not count: it is a yardstick.
    """

    name: ClassVar[str] = "exact"
    summary: ClassVar[str] = "shortest paths by visibility graph (Lozano-Perez and Wesley 1979)"

    clearance: Annotated[float, msgspec.Meta(ge=0.0)] = 0.0

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same paths for every seed.

        Arcs are drawn by tangents, so that the path cuts no corner. It is longer than the exact one by less than 1e-5
        of its length, and as much again for each full turn about small round corners; a gap narrower than that counts
        as closed. Raises `InputError` for a start or goal that is nearer than the clearance to what is forbidden.
        """
        ends = fleet_ends(scenario, self.clearance, self.name)
        free, starts = free_space(scenario.map, self.clearance, ends), len(scenario.starts)
        aircraft, targets = (index.ravel() for index in np.indices((starts, len(scenario.goals))))
        ways = [_shortest(free, ends[[i, starts + j]]) for i, j in zip(aircraft, targets, strict=True)]
        found = np.array([way is not None for way in ways])
        lengths = np.array([0.0 if way is None else float(np.hypot(*np.diff(way, axis=0).T).sum()) for way in ways])
        chosen = assigned(aircraft, targets, lengths, found)
        flown = [(int(aircraft[k]), int(targets[k]), ways[k]) for k in chosen]
        if not flown:
            room = f" with {self.clearance:g} m to spare on either side" if self.clearance else ""
            return Plan(outcome=NO_PATH, reason=f"obstacles and edges leave no way from start to goal{room}")
        frame = scenario.map.frame
        paths = tuple(Path(way, name=pair_name(scenario, i, j), frame=frame) for i, j, way in flown if way is not None)
        straight = all(len(path.points) == 2 for path in paths)
        notes = unserved(scenario, {i for i, _, _ in flown}, why_unserved(scenario))
        return Plan(paths=paths, smallest_radius=math.inf if straight else None, notes=notes)


def too_fine(area: Map) -> bool:
    """Whether the exact path takes too long where it is but a yardstick."""
    return area.raster is not None and len(raster_edges(area.raster)) > MOST_EDGES


# A campaign compares many plans on a handful of maps.
@lru_cache(maxsize=16)
def exact_paths(scenario: Scenario, clearance: float) -> tuple[Path, ...]:
    """The exact shortest paths that keep `clearance` [m], one a vehicle; none where none is or it takes too long.

    Raises as `Exact.plan` does, and `TrackworthyError` where GEOS fails.
    """
    if too_fine(scenario.map):
        return ()
    return Exact(clearance=clearance).plan(scenario, np.random.default_rng(0)).paths


def free_space(area: Map, clearance: float, ends: Floats) -> Any:
    """Where a point has the `clearance` [m]: polygons, clipped to what paths between `ends` (N, 2) [m] may need."""
    span = float(np.hypot(*np.ptp(ends, axis=0)))
    arc = _arc(clearance, span)
    obstacles = [grown(shapely.Polygon(ring), clearance, arc, ends) for ring in area.polygons]
    for circle in area.circles:
        wide = Circle(circle.x, circle.y, circle.radius + clearance)
        obstacles.append(shapely.Polygon(tangents(wide, step=_arc(wide.radius, span), towards=ends)))
    if area.raster is not None:
        obstacles.append(grown(_squares(area.raster), clearance, arc, ends))
    blocked = overlay(shapely.union_all, obstacles)
    if area.bounds is not None:
        narrower = clearance if area.edge == "closed" else 0.0
        whole = shapely.box(*np.array(area.bounds) + narrower * np.array([1.0, 1.0, -1.0, -1.0]))
    else:
        whole = shapely.envelope(shapely.buffer(shapely.union(blocked, shapely.MultiPoint(ends)), span))
    inside = [shrunk(shapely.Polygon(ring), clearance, arc, ends) for ring in area.keep_in]
    for circle in area.keep_in_circles:
        inner = Circle(circle.x, circle.y, circle.radius - clearance)
        at = bearings(inner, 0.0, 2.0 * np.pi, _arc(inner.radius, span), ends)
        chords = np.column_stack([inner.x + inner.radius * np.cos(at), inner.y + inner.radius * np.sin(at)])
        inside.append(shapely.Polygon(chords))
    outside = [overlay(shapely.difference, whole, part) for part in inside]
    return overlay(shapely.difference, whole, overlay(shapely.union_all, [blocked, *outside]))


def _shortest(free: Any, ends: Floats) -> Floats | None:
    """The corners (N, 2) [m] of the shortest line between the `ends` (2, 2) in the polygons `free`, if there is any."""
    gap = GAP * np.abs(shapely.bounds(free)).max()
    if np.hypot(*(ends[1] - ends[0])) <= NEAR * gap:
        return ends
    ways = []
    for part in shapely.get_parts(shapely.buffer(free, -gap, join_style="mitre")):
        inner = shapely.buffer(part, -gap / 4.0, join_style="mitre")
        starts, goals = (_inside(inner, shapely.Point(end), NEAR * gap) for end in ends)
        ways += [shortest(part, start, goal) for start in starts for goal in goals]
    if not ways:
        return None
    way = min(ways, key=lambda points: float(np.hypot(*np.diff(points, axis=0).T).sum()))
    way[[0, -1]] = ends
    line = shapely.simplify(shapely.LineString(way), 2.0 * gap, preserve_topology=False)
    return np.asarray(shapely.get_coordinates(line), dtype=float)


def _inside(area: Any, end: Any, reach: float) -> list[Floats]:
    """The points (2,) of `area` nearest to `end`, up to `reach` [m] away; several where obstacles touch at the end."""
    pieces = shapely.get_parts(overlay(shapely.intersection, area, shapely.buffer(end, reach)))
    return [shapely.get_coordinates(shapely.shortest_line(piece, end))[0] for piece in pieces if not piece.is_empty]


def _arc(radius: float, span: float) -> float:
    """The angle [rad] between tangents of an arc, which in a full turn lengthen it by at most 1e-5 `span` [m].

    An arc is longer along its tangents by the square of that angle / 12.
    """
    return float(np.clip(np.sqrt(12e-5 / (2.0 * np.pi) * span / max(radius, 1e-4 * span)), 0.01, 0.2))


def _squares(raster: Raster) -> Any:
    """The blocked cells as polygons [m]."""
    steps = np.diff(np.pad(raster.blocked, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, west = np.nonzero(steps == 1)
    east = np.nonzero(steps == -1)[1]
    x, y = (raster.x + np.array([west, east]) * raster.cell), raster.y + np.array([row, row + 1]) * raster.cell
    return shapely.simplify(overlay(shapely.union_all, shapely.box(x[0], y[0], x[1], y[1])), 0.0)
