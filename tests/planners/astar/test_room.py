import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.all_planners import make_planner
from planners.astar.room import body_of, room_of
from planners.astar.room_kernels import along_arc, arc_fits, drawn, fits, room_at
from planners.clearance import clearance
from planners.footprint import Disc, Rectangle
from sample_maps import scenario, scenarios

TRUCK = make_planner("astar-arc")
BODY, SHAPE = body_of(TRUCK), Rectangle(7.0, 2.5, 2.25)
ARGUMENTS = BODY.along, BODY.radius

# Obstacles of 1 to 25 m and 1 to 40 m on 120 x 80 m, with room for a truck between them
small = scenarios.map(lambda found: scenario_of_metres(found))


def scenario_of_metres(found):
    """The same, with 1 m a map unit."""
    unit = found.unit
    return scenario(
        polygons=[ring / unit for ring in found.map.polygons],
        circles=[(circle.x / unit, circle.y / unit, circle.radius / unit) for circle in found.map.circles],
        start=found.starts[0] / unit,
        goal=found.goals[0] / unit,
        unit=1.0,
    )


def test_the_discs_cover_the_body_and_stand_out_by_8_percent():
    discs = shapely.union_all([shapely.Point(ahead, 0.0).buffer(BODY.radius, 256) for ahead in BODY.along])
    body = shapely.box(-1.25, -1.25, 5.75, 1.25)
    assert body.difference(discs).area < 1e-6
    around = shapely.Point(BODY.middle, 0.0).buffer(BODY.around, 1024)
    assert body.difference(around).area < 1e-3
    out = np.abs(np.array(discs.exterior.coords)[:, 1]).max() - 1.25
    assert out == pytest.approx(math.hypot(1.25, 0.5) - 1.25, rel=1e-4)
    assert 0.07 < out / 1.25 < 0.08


def test_a_field_is_read_linearly_between_the_centres_of_its_cells():
    rows, columns = np.indices((5, 7))
    field = 2.0 * columns - 3.0 * rows
    for x, y in [(0.25, 0.25), (1.0, 0.7), (3.25, 2.25), (2.013, 1.77)]:
        assert room_at(field, 0.5, x, y) == pytest.approx(2.0 * (x / 0.5 - 0.5) - 3.0 * (y / 0.5 - 0.5))
    assert room_at(field, 0.5, -4.0, 9.0) == field[-1, 0]


@settings(max_examples=60)
@given(found=small, cell=st.sampled_from([0.3, 0.5, 1.25]), seed=st.integers(0, 1000))
def test_the_room_of_a_disc_is_less_than_its_clearance_by_two_diagonals_at_most(found, cell, seed):
    room, rng = room_of(found, cell), np.random.default_rng(seed)
    places = rng.uniform((0.0, 0.0), found.size, (40, 2))
    exact = clearance(found.map, np.column_stack([places, np.zeros(40)]), Disc(0.0))
    for (x, y), true in zip(places, exact, strict=True):
        near = room_at(room.field, cell, x, y)
        if true > 2.0 * cell:
            assert true - 2.0 * math.sqrt(2.0) * cell <= near
            assert near <= true + 1e-9


poses = st.tuples(st.floats(5.0, 115.0), st.floats(5.0, 75.0), st.floats(-math.pi, math.pi))


@settings(max_examples=300)
@given(found=small, cell=st.sampled_from([0.3, 0.5, 1.25]), start=poses,
       curvature=st.floats(-0.22, 0.22), length=st.floats(0.5, 12.0))  # fmt: skip
def test_where_an_arc_fits_the_body_is_clear_all_along_it(found, cell, start, curvature, length):
    room = room_of(found, cell)
    args = room.field, cell, room.size, *ARGUMENTS
    # The arc's own start is of the arc before
    if fits(*args, *start) and arc_fits(*args, BODY.middle, BODY.around, *start, curvature, length):
        driven = [along_arc(*start, curvature, s) for s in np.linspace(0.0, length, 60)]
        assert clearance(found.map, np.array(driven), SHAPE).min() >= -1e-9


def test_a_quick_look_in_the_open_and_a_thorough_one_agree():
    """One disc so large that the quick look never suffices decides the same."""
    found = scenario(circles=[(60.0, 40.0, 8.0)], unit=1.0)
    room, rng, said = room_of(found, 0.3), np.random.default_rng(5), []
    for _ in range(400):
        pose = *rng.uniform((5.0, 5.0), (115.0, 75.0)), rng.uniform(-math.pi, math.pi)
        arc = rng.uniform(-0.2, 0.2), rng.uniform(1.0, 10.0)
        args = room.field, 0.3, room.size, *ARGUMENTS, BODY.middle
        quick, thorough = (arc_fits(*args, around, *pose, *arc) for around in (BODY.around, 1e6))
        assert quick == thorough
        said.append(quick)
    assert 0.2 < np.mean(said) < 0.95


@given(start=poses, radius=st.floats(0.5, 1000.0), angle=st.floats(0.0, 6.0), side=st.sampled_from([-1.0, 1.0]))
def test_along_an_arc_one_stays_on_its_circle(start, radius, angle, side):
    x, y, heading = along_arc(*start, side / radius, radius * angle)
    centre = start[0] - side * radius * math.sin(start[2]), start[1] + side * radius * math.cos(start[2])
    to = start[2] - side * 0.5 * math.pi + side * angle
    assert (x, y) == pytest.approx((centre[0] + radius * math.cos(to), centre[1] + radius * math.sin(to)), abs=1e-7)
    assert heading == pytest.approx(start[2] + side * angle)


def test_a_drawn_circle_lies_on_it_at_equal_distances():
    half = 4.0 * math.pi
    nodes = np.array(
        [[0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 8.0, math.pi, half, 0.25], [-3.0, 8.0, math.pi, half + 3.0, 0.0]]
    )
    points = drawn(nodes, 0.5)
    assert len(points) == 1 + math.ceil(half / 0.5) + 6
    on_arc = points[: 1 + math.ceil(half / 0.5)]
    assert np.hypot(on_arc[:, 0], on_arc[:, 1] - 4.0) == pytest.approx(4.0)
    legs = np.hypot(*np.diff(on_arc, axis=0).T)
    assert legs == pytest.approx(legs[0])
    assert points[-7:, 1] == pytest.approx(8.0)
