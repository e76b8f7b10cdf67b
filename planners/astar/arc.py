"""Arc A* that keeps its promise: paper 004's idea with a vehicle's own limits, and a search that can go back."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import msgspec
import numpy as np

from planners.astar.arc_kernels import HEADINGS, MOST, TURNS, search
from planners.astar.finish_kernels import FREE_HEADING
from planners.astar.home_kernels import pooled, ways_home
from planners.astar.linearised import Bounds
from planners.astar.room import HALF_DIAGONAL, Body, Room, body_of, room_of
from planners.astar.room_kernels import drawn, fits
from planners.astar.smooth import smoothed
from planners.astar.truck_settings import TruckSettings
from planners.clearance import clearance
from planners.fleet import fleet_ends
from planners.footprint import Rectangle
from planners.kernel import Bools, Floats, Ints
from planners.path import Path
from planners.planner import NO_PATH, NOT_FOUND, Plan, Stage, only_pair
from planners.scenario import Scenario

ARCS, SMOOTH = "arcs", "smooth"
DRAWN = 0.5  # [m] between the points of an arc, and the poses at which the body is looked at
FEW_CELLS, MOST_CELLS = 512, 2048  # of distances, along the longer side of a map that is no picture
CELLS_ACROSS = 8.0  # the body
HOME_CELLS = 256  # along the longer side, on which the way home is found
POSE_CELLS = 640  # at most, along the longer side
STEP_CELLS = 4.0  # cells of a pose along a step
SLACKS = 1.01, 1.02  # the search's, the first of which may look at that many poses
QUICK = 20_000
LEAVES = 1.5  # cells of a pose that a step is long at least: more than a diagonal
STATIONS, NEAREST = 4.0, 0.25  # points of the smooth path along a step, and how near [m] to each other at most

Heading = Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)]


class AstarArc(TruckSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A* over position and heading, complete up to its cells, by arcs that the vehicle can drive with its body.

    A step lasts from one steering action to the next (or to that after it, and so on, where the wheels are too slow for
    one of the turns meanwhile, or the map is large), and its curvature keeps to `lateral`, to the steering's limit and
    to its rate. `start_heading` and `goal_heading` [deg, counter-clockwise from east] are free where they are not
    given. The arcs are then drawn as a smooth path, which keeps to `smooth_lateral` [g] and `smooth_rate` [deg/s] of
    the wheels, so that a controller has something left. The arcs keep the body `margin` [m] from everything, and the
    smooth path does where it can. `cell` [map units] is that of the grid of distances, and `most` poses are looked at.
    """

    name: ClassVar[str] = "astar-arc"
    summary: ClassVar[str] = "arcs that a truck can drive, by a complete search, and smoothed"

    smooth_lateral: Annotated[float, msgspec.Meta(gt=0.0, le=2.0)] = 0.5
    smooth_rate: Annotated[float, msgspec.Meta(gt=0.0, le=1000.0)] = 15.0
    margin: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)] = 0.2
    start_heading: Heading | None = None
    goal_heading: Heading | None = None
    cell: Annotated[float, msgspec.Meta(gt=0.0)] | None = None
    most: Annotated[int, msgspec.Meta(ge=1, le=10_000_000)] = 500_000

    @property
    def clearance(self) -> float:
        """The reference point's distance [m] to the nearest side of the body."""
        return min(self.width / 2.0, self.overhang, self.length - self.overhang)

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same path for every seed.

        Raises `InputError` for a scenario with more than one start or goal.
        """
        only_pair(scenario, self.name)
        start, goal = fleet_ends(scenario, self.clearance, self.name, "set a smaller width, length and overhang")
        room, body = room_of(scenario, self._cell_side(scenario)), body_of(self)
        paths: list[Path] = []
        # Where no smooth path lies near the arcs, those that keep to its own bound may have one
        for lateral in dict.fromkeys((self.lateral, min(self.lateral, self.smooth_lateral))):
            found = self._arcs(scenario, room, body, start - room.origin, goal - room.origin, lateral)
            if isinstance(found, Plan):
                if not paths:
                    return found
                break
            arcs = _path(found, room, scenario)
            smooth = self._smooth(found, room, body, scenario)
            paths = [arcs, smooth] if smooth is not None else paths or [arcs]
            if smooth is not None:
                break
        path = paths[-1]
        if scenario.max_range is not None and path.length > scenario.max_range:
            what = f"its {path.length:.6g} m exceed the range of {scenario.max_range:.6g} m"
            return Plan(outcome=NOT_FOUND, reason=what)
        kept = f"{self.smooth_lateral:g} g and {self.smooth_rate:g} deg/s of the wheels, clear of everything"
        return Plan(
            paths=(path,),
            polylines=(paths[0],),
            stages=tuple(Stage(name, (one,)) for name, one in zip((ARCS, SMOOTH), paths, strict=False)),
            notes=() if len(paths) > 1 else (f"no path near the arcs keeps to {kept}: they are left as they are",),
            smallest_radius=_smallest_radius(path),
        )

    def _smooth(self, points: Floats, room: Room, body: Body, scenario: Scenario) -> Path | None:
        """The smooth path near arcs through `points` (N, 2) [m from the grid's corner]; None where none is found."""
        bounds = Bounds(
            self.curvature(self.smooth_lateral), self.curvature_rate(self.smooth_rate), self.margin,
            _radians(self.start_heading), _radians(self.goal_heading),
        )  # fmt: skip
        smooth = smoothed(points, max(self.step / STATIONS, NEAREST), room, body, bounds)
        if smooth is None:
            return None
        path = _path(smooth, room, scenario)
        return None if self._touches(path, scenario) else path

    def _arcs(
        self, scenario: Scenario, room: Room, body: Body, start: Floats, goal: Floats, lateral: float
    ) -> Floats | Plan:
        """Points (N, 2) on arcs within `lateral` [g] from `start` to `goal` (2,), or why there are none.

        All in metres from the grid's corner.
        """
        radius = body.radius + self.margin
        home, home_cell = _ways_home(room, radius - float(np.abs(body.along).min()), goal)
        if not math.isfinite(home[_cell(home, start, home_cell)]):
            # A proof asks of the field no more than that it may err by, once more
            home, home_cell = _ways_home(room, self.clearance - 2.0 * HALF_DIAGONAL * room.cell, goal)
            if not math.isfinite(home[_cell(home, start, home_cell)]):
                what = f"obstacles and edges leave no way {2.0 * self.clearance:g} m wide from start to goal"
                return Plan(outcome=NO_PATH, reason=what)
        goal_heading, starts = _radians(self.goal_heading), _headed(start, self.start_heading)
        for name, poses in (("start", starts), ("goal", _headed(goal, self.goal_heading))):
            if not any(fits(room.field, room.cell, room.size, body.along, radius, *pose) for pose in poses):
                which = "any heading" if len(poses) > 1 else "the heading given"
                what = f"the body, {self.margin:g} m clear of everything, does not fit at the {name} at {which}"
                return Plan(outcome=NOT_FOUND, reason=what)
        step, pose_cell = self._step(float(room.size.max()))
        cells = np.floor(room.size / pose_cell).astype(int) + 1
        for slack, most in zip(SLACKS, (min(QUICK, self.most), self.most), strict=True):
            seen = np.zeros(int(cells.prod()) * HEADINGS, dtype=np.uint8)
            last, looked, nodes, parents = search(
                room.field, room.cell, room.size, body.along, radius, body.middle, body.around + self.margin,
                home, home_cell, starts, goal, FREE_HEADING if goal_heading is None else goal_heading,
                step, self.curvature(lateral), self.curvature_rate(self.steering_rate) * step,
                seen, pose_cell, slack, most,
            )  # fmt: skip
            if last != MOST:
                break
        if last < 0:
            ended = f"{self.most} poses were looked at, the `most`"
            if last != MOST:
                ended = f"no pose that can be reached leads on, of {looked} looked at"
            what = f"no way to drive at {3.6 * self.planned_speed:.3g} km/h within {lateral:g} g was found: {ended}"
            return Plan(outcome=NOT_FOUND, reason=what)
        points = _drawn(last, nodes, parents)
        if self._touches(_path(points, room, scenario), scenario):
            what = f"the body touches, for cells of {room.cell:g} m say too little: give smaller ones"
            return Plan(outcome=NOT_FOUND, reason=f"on the arcs found {what}")
        return points

    def _touches(self, path: Path, scenario: Scenario) -> bool:
        """Whether the body touches anything along `path`, by its exact rectangle."""
        east, north = np.gradient(path.xy, axis=0).T
        at = np.linspace(0.0, path.length, math.ceil(path.length / DRAWN) + 1)
        poses = [np.interp(at, path.s, values) for values in (*path.xy.T, np.unwrap(np.arctan2(north, east)))]
        body = Rectangle(self.length, self.width, self.length / 2.0 - self.overhang)
        return bool(clearance(scenario.map, np.column_stack(poses), body).min() < 0.0)

    def _cell_side(self, scenario: Scenario) -> float:
        """The side [m] of the cells: that of the map's picture, else as fine as the body asks for and time allows."""
        if self.cell is not None:
            return self.cell * scenario.unit
        if scenario.map.raster is not None:
            return scenario.map.raster.cell
        longest = max(scenario.size)
        return max(longest / MOST_CELLS, min(longest / FEW_CELLS, self.width / CELLS_ACROSS))

    def _step(self, longest: float) -> tuple[float, float]:
        """The length [m] of an arc, and the cells' of poses, on a map as `longest` [m] as that.

        A whole number of steps, so many that the curvature may change by one of the turns and an arc leaves its cell.
        """
        turns = self.curvature(self.lateral) / TURNS / (self.curvature_rate(self.steering_rate) * self.step)
        step = self.step * math.ceil(max(turns, LEAVES * longest / POSE_CELLS / self.step))
        return step, max(step / STEP_CELLS, longest / POSE_CELLS)


def _headed(point: Floats, degrees: float | None) -> Floats:
    """The poses (P, 3) at `point` (2,): with all headings, or the one given."""
    headings = np.arange(HEADINGS) * (2.0 * math.pi / HEADINGS) if degrees is None else np.radians([degrees])
    return np.column_stack([np.tile(point, (len(headings), 1)), headings])


def _path(points: Floats, room: Room, scenario: Scenario) -> Path:
    """The path through `points` (N, 2) [m from the grid's corner], just from start to goal.

    In whole micrometres, for the last bits of what a solver gives are the machine's.
    """
    xy = np.round(points + room.origin, 6)
    xy[0], xy[-1] = scenario.starts[0], scenario.goals[0]
    return Path(xy, name=scenario.name, frame=scenario.map.frame)


def _smallest_radius(path: Path) -> float:
    """That of the tightest curve [m]: legs over the turn between them; inf for a straight path."""
    legs = np.diff(path.s)
    curvature = np.abs(path.turns[1:-1]) / (0.5 * (legs[1:] + legs[:-1]))
    return 1.0 / float(curvature.max()) if curvature.any() else math.inf


def _ways_home(room: Room, least: float, goal: Floats) -> tuple[Floats, float]:
    """The way [cells] to the `goal` from every cell some point of which has `least` [m] of room, and the side of those.

    Such a point is at most half a diagonal from the centre whose room is known, and that is of a cell that is free.
    """
    factor = max(1, round(max(room.field.shape) / HOME_CELLS))
    half_diagonal = HALF_DIAGONAL * room.cell
    free = pooled(room.field, factor, max(least - half_diagonal, 1e-6 - half_diagonal))
    row, column = _cell(free, goal, factor * room.cell)
    free[row, column] = True
    return ways_home(free, row, column), factor * room.cell


def _cell(cells: Floats | Bools, point: Floats, side: float) -> tuple[int, int]:
    column, row = np.minimum((point / side).astype(int), np.array(cells.shape[::-1]) - 1)
    return int(row), int(column)


def _drawn(last: int, nodes: Floats, parents: Ints) -> Floats:
    """Points (N, 2) on the arcs that end at the node `last`."""
    chain = [last]
    while parents[chain[-1]] >= 0:
        chain.append(int(parents[chain[-1]]))
    return drawn(nodes[chain[::-1]], DRAWN)


def _radians(degrees: float | None) -> float | None:
    return None if degrees is None else math.radians(degrees)
