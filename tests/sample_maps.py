"""Maps for tests of planners: small, of 20 m a map unit."""

import math

import numpy as np
import shapely
from hypothesis import strategies as st

from planners.map import Circle, Map
from planners.scenario import Scenario

UNIT = 20.0
WIDTH, HEIGHT = 120.0, 80.0


def scenario(polygons=(), circles=(), start=(5.0, 40.0), goal=(115.0, 40.0), unit=UNIT):
    """A scenario given in map units."""
    area = Map(
        polygons=tuple(np.array(ring, dtype=float) * unit for ring in polygons),
        circles=tuple(Circle(x * unit, y * unit, r * unit) for x, y, r in circles),
        bounds=(0.0, 0.0, WIDTH * unit, HEIGHT * unit),
    )
    places = [np.array([place], dtype=float) * unit for place in (start, goal)]
    return Scenario(
        name="sample", map=area, starts=places[0], goals=places[1], size=(WIDTH * unit, HEIGHT * unit), unit=unit
    )


def box(x, y, width, height):
    """A rectangle's ring."""
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


FREE = scenario()
ONE_CIRCLE = scenario(circles=[(60.0, 40.0, 20.0)])
GATE = scenario(polygons=[box(55.0, 0.0, 8.0, 52.0), box(55.0, 64.0, 8.0, 16.0)])
WALLED = scenario(polygons=[box(55.0, 0.0, 8.0, 80.0)])

coordinates = st.floats(10.0, 110.0)
radii = st.floats(1.0, 25.0)


@st.composite
def rings(draw):
    """A polygon that does not cross itself."""
    x, y, size = draw(st.floats(25.0, 95.0)), draw(st.floats(0.0, HEIGHT)), draw(st.floats(3.0, 40.0))
    turns = sorted(draw(st.lists(st.floats(0.0, 6.28), min_size=3, max_size=7, unique=True)))
    reach = [draw(st.floats(0.3, 1.0)) * size for _ in turns]
    ring = [(round(x + r * math.cos(t), 3), round(y + r * math.sin(t), 3)) for t, r in zip(turns, reach, strict=True)]
    polygon = shapely.Polygon(ring)
    return ring if polygon.is_valid and polygon.area > 1.0 else box(x, y, 5.0, 5.0)


def within(low, high):
    """In thousandths: GEOS, which is the tests' judge, divides by zero on lines of 1e-310 m."""
    return st.integers(int(1e3 * low), int(1e3 * high)).map(lambda value: value / 1e3)


scenarios = st.builds(
    scenario,
    polygons=st.lists(rings(), max_size=4),
    circles=st.lists(st.tuples(coordinates, st.floats(-10.0, 90.0), radii), max_size=4),
    start=st.tuples(within(6.0, 30.0), within(6.0, 74.0)),
    goal=st.tuples(within(90.0, 114.0), within(6.0, 74.0)),
)


def room(found, path):
    """Least distance [m] of the drawn line from the scenario's obstacles and edge; exact."""
    line = shapely.LineString(path.xy)
    width, height = found.size
    least = shapely.distance(line, shapely.box(0.0, 0.0, width, height).exterior)
    if not shapely.box(0.0, 0.0, width, height).covers(line):
        return -math.inf
    for ring in found.map.polygons:
        least = min(least, shapely.distance(line, shapely.Polygon(ring)))
        if line.crosses(shapely.Polygon(ring)):
            return -math.inf
    for circle in found.map.circles:
        least = min(least, shapely.distance(line, shapely.Point(circle.x, circle.y)) - circle.radius)
    return float(least)
