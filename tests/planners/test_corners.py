import math

import numpy as np
import pytest

from planners.corners import fly_by
from planners.path import Path
from sample_paths import right_angle


def constant(radius):
    return lambda course, angle: radius


def test_an_arc_starts_and_cuts_where_geometry_says():
    path, report = fly_by(right_angle(2000.0), constant(300.0), 0.01)
    assert len(report) == 1
    assert report[0].radius == pytest.approx(300.0)
    assert report[0].cut == pytest.approx(300.0 * (math.sqrt(2.0) - 1.0))
    assert path.points[1] == pytest.approx([1700.0, 0.0])
    assert path.project(2000.0, 0.0).cross_track == pytest.approx(-report[0].cut, abs=0.011)
    assert path.length == pytest.approx(2 * 1700.0 + 300.0 * math.pi / 2, abs=0.1)


def test_neighbouring_arcs_share_a_short_leg():
    zigzag = Path([[0.0, 0.0], [1000.0, 0.0], [1000.0, 200.0], [2000.0, 200.0]])
    path, report = fly_by(zigzag, constant(300.0), 0.01)
    assert [corner.radius for corner in report] == pytest.approx([100.0, 100.0])
    assert all(corner.wanted == 300.0 for corner in report)
    assert np.abs(path.turns).max() < 0.2


def test_a_corner_beyond_120_deg_stays_as_drawn_and_is_reported():
    hairpin = Path([[0.0, 0.0], [1000.0, 0.0], [0.0, 100.0]])
    path, report = fly_by(hairpin, constant(300.0), 0.01)
    assert path.points.tolist() == hairpin.points.tolist()
    assert report[0].radius == 0.0


def test_heights_go_on_along_the_original_path():
    climb = Path([[0.0, 0.0, 100.0], [1000.0, 0.0, 200.0], [1000.0, 1000.0, 300.0]])
    path, _ = fly_by(climb, constant(200.0), 0.01)
    assert path.z is not None
    assert path.z[1] == pytest.approx(180.0)
    assert (np.diff(path.z) > 0.0).all()


def test_a_sampled_curve_is_left_alone():
    angle = np.linspace(0.0, 1.0, 200)
    curve = Path(np.column_stack([500.0 * np.sin(angle), 500.0 * (1.0 - np.cos(angle))]))
    path, report = fly_by(curve, constant(308.0), 0.1)
    assert report == ()
    assert np.array_equal(path.points, curve.points)
