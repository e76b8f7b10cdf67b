import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyproj import Geod

from planners.frame import Frame


@given(st.floats(-80, 80), st.floats(-180, 180), st.floats(0, 360), st.floats(1, 200e3))
def test_distance_and_bearing_from_the_origin_are_the_geodesic_ones(lat, lon, azimuth, distance):
    there_lon, there_lat, _ = Geod(ellps="WGS84").fwd(lon, lat, azimuth, distance)
    x, y = Frame(lat, lon).to_local(np.array([there_lat]), np.array([there_lon]))[0]
    assert np.hypot(x, y) == pytest.approx(distance, abs=1e-3)
    assert np.cos(np.arctan2(x, y) - np.radians(azimuth)) == pytest.approx(1.0, abs=1e-9)


# PROJ takes what lies within 1e-10 rad of the origin for the origin itself (EPS10 in aeqd.cpp)
SNAPPED = 1.1e-10 * 6_378_137.0  # [m]


@given(st.floats(-80, 80), st.floats(-180, 180), st.floats(-1e5, 1e5), st.floats(-1e5, 1e5))
def test_there_and_back_is_exact_to_a_micrometre_but_at_the_origin(lat, lon, x, y):
    frame = Frame(lat, lon)
    geographic = frame.to_geographic(np.array([[x, y]]))
    exact = 1e-6 if np.hypot(x, y) > SNAPPED else SNAPPED
    assert frame.to_local(geographic[:, 0], geographic[:, 1])[0] == pytest.approx([x, y], abs=exact)


@pytest.mark.parametrize("y", [1e-4, -5e-4, 7.1e-4, 1e-2])
def test_what_is_snapped_to_the_origin_is_less_than_a_millimetre_away(y):
    frame = Frame(0.0, 0.0)
    geographic = frame.to_geographic(np.array([[0.0, y]]))
    assert abs(frame.to_local(geographic[:, 0], geographic[:, 1])[0][1] - y) < (SNAPPED if abs(y) < SNAPPED else 1e-6)
