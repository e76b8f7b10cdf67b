import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.path import Path
from planners.turns import available_radii
from sample_paths import arcs, circle, right_angle


def test_a_corner_between_long_legs_offers_what_the_corridor_allows():
    vertices, turns, radii = available_radii(right_angle(4000.0), 30.0)
    assert vertices.tolist() == [1]
    assert turns[0] == pytest.approx(math.pi / 2)
    assert radii[0] == pytest.approx(30.0 / (math.sqrt(2.0) - 1.0))


def test_a_corner_between_short_legs_offers_what_fits_on_half_of_the_shorter():
    path = Path([[0.0, 0.0], [1000.0, 0.0], [1000.0, 40.0]])
    assert available_radii(path, 30.0)[2][0] == pytest.approx(20.0)


@given(st.floats(20.0, 800.0), st.floats(0.5, 20.0), st.sampled_from([0.5, 30.0]))
def test_a_sampled_circle_offers_its_radius(radius, spacing, corridor):
    path = circle(radius, 1.5, min(spacing, radius / 10))
    radii = available_radii(path, corridor)[2]
    assert np.median(radii) == pytest.approx(radius, rel=0.05)
    assert radii.min() > 0.6 * radius


@pytest.mark.parametrize("radius", [100.0, 300.0, 600.0])
def test_arcs_between_legs_offer_their_radius(radius):
    assert available_radii(arcs(radius, 1500.0), 30.0)[2].min() == pytest.approx(radius, rel=0.05)


def test_a_reversal_offers_nothing():
    assert available_radii(Path([[0.0, 0.0], [100.0, 0.0], [0.0, 0.0]]), 30.0)[2][0] == pytest.approx(0.0, abs=1e-6)


def test_a_straight_path_has_no_turns():
    assert len(available_radii(Path([[0.0, 0.0], [5.0, 0.0], [9.0, 0.0]]), 1.0)[0]) == 0


@pytest.mark.parametrize("chamfer", [0.5, 1.0, 2.0])
def test_a_chamfer_does_not_make_a_corner_a_curve(chamfer):
    path = Path([[0.0, 0.0], [1000.0 - chamfer, 0.0], [1000.0, chamfer], [1000.0, 40.0]])
    assert available_radii(path, 30.0)[2].min() == pytest.approx(20.0, rel=0.1)
