from __future__ import annotations

import pickle

import numpy as np
import pytest

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.map import Circle, Map, Raster

SQUARE = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
BOWTIE = np.array([[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]])


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"polygons": (SQUARE, BOWTIE)}, r"polygon 2: its edges cross .* \(2 2\)"),
        ({"polygons": (SQUARE[:2],)}, "polygon 1: .* at least three vertices, this has 2"),
        ({"polygons": (np.array([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]),)}, "polygon 1: its edges cross"),
        ({"polygons": (np.array([[0.0, 0.0], [np.nan, 1.0], [2.0, 0.0]]),)}, "polygon 1: vertex 2 is"),
        ({"polygons": (np.zeros((3, 3)),)}, r"polygon 1: .* shape \(3, 3\)"),
        ({"keep_in": (BOWTIE,)}, "keep-in polygon 1"),
        ({"circles": (Circle(0.0, 0.0, 1.0), Circle(0.0, 0.0, 0.0))}, "circle 2: its radius is 0"),
        ({"circles": (Circle(np.inf, 0.0, 1.0),)}, "circle 1: .* not finite"),
        ({"keep_in_circles": (Circle(0.0, 0.0, -2.0),)}, "keep-in circle 1: its radius is -2"),
        ({"bounds": (4.0, 0.0, 0.0, 4.0)}, "bounds: .* enclose no area"),
        ({"bounds": (0.0, 0.0, np.nan, 4.0)}, "bounds"),
        ({"edge": "soft"}, "edge: 'soft' is not known; use closed or open"),
    ],
)
def test_an_area_that_is_none_is_refused_by_name(fields, message):
    with pytest.raises(InputError, match=message):
        Map(**fields)


@pytest.mark.parametrize("raster", [(np.zeros(3), 1.0), (np.zeros((0, 3)), 1.0), (np.zeros((2, 2)), 0.0)])
def test_a_raster_needs_cells_with_an_extent(raster):
    with pytest.raises(InputError, match="raster"):
        Raster(*raster)


def test_a_closed_ring_is_the_same_polygon():
    assert len(Map(polygons=(np.vstack([SQUARE, SQUARE[:1]]),)).polygons[0]) == 4


def test_a_map_cannot_be_changed_through_its_arrays():
    mine = SQUARE.copy()
    area = Map(polygons=(mine,), raster=Raster(np.zeros((2, 2), dtype=bool), 1.0))
    mine[0] = 99.0
    assert area.polygons[0][0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        area.polygons[0][0, 0] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        area.raster.blocked[0, 0] = True


def test_a_map_travels_to_another_process():
    area = pickle.loads(pickle.dumps(Map(polygons=(SQUARE,), circles=(Circle(9.0, 9.0, 1.0),))))
    assert clearance(area, np.array([[2.0, 2.0, 0.0]]), Disc(0.5)) == pytest.approx(-2.5)
