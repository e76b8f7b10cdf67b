from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from planners import files
from planners.errors import InputError
from planners.frame import Frame
from planners.path import Path

SUFFIXES = [suffix for form in files.FORMATS for suffix in form.suffixes]


@pytest.mark.parametrize("name", ["a.gpx", "a", "a.csv.gz", ".csv"])
def test_unknown_suffix(name):
    known = r"known are \.csv, \.geojson, \.json, \.waypoints, \.txt, \.plan$"
    with pytest.raises(InputError, match=known):
        files.read(name)
    with pytest.raises(InputError, match=known):
        files.write(Path([[0.0, 0.0], [1.0, 0.0]]), name)


def test_suffix_in_capitals(read):
    assert read("A.CSV", "x,y\n0,0\n1,0\n").path.name == "A"


@pytest.mark.parametrize("suffix", SUFFIXES)
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    lat=st.floats(-75.0, 75.0),
    lon=st.floats(-180.0, 180.0),
    steps=st.lists(st.tuples(st.floats(0.05, 20e3), st.floats(-np.pi, np.pi)), min_size=1, max_size=5),
    heights=st.booleans(),
)
def test_round_trip_within_a_centimetre_over_100_km(tmp_path, suffix, lat, lon, steps, heights):
    xy = np.cumsum([[0.0, 0.0], *([r * np.cos(a), r * np.sin(a)] for r, a in steps)], axis=0)
    z = np.linspace(0.0, 1234.5678, len(xy))
    assume(abs(lat) > 1e-9 or abs(lon) > 1e-9)  # a mission takes 0, 0 for no position
    path = Path(np.column_stack([xy, z]) if heights else xy, Frame(lat, lon))
    files.write(path, tmp_path / f"a{suffix}")
    again = files.read(tmp_path / f"a{suffix}").path
    geographic = again.frame.to_geographic(again.xy)
    back = path.frame.to_local(geographic[:, 0], geographic[:, 1])
    assert np.hypot(*(back - path.xy).T).max() < 0.01
    if heights:
        assert again.z == pytest.approx(z, abs=1e-6)
    else:
        assert again.z is None or not again.z.any()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_is_written_is_the_same_every_time(tmp_path, suffix):
    path = Path([[0.0, 0.0, 1.0], [50e3, 60e3, 2.0], [100e3, 0.0, 3.0]], Frame(47.0, 8.0))
    for name in ("a", "b"):
        files.write(path, tmp_path / f"{name}{suffix}")
    first, second = ((tmp_path / f"{name}{suffix}").read_bytes() for name in ("a", "b"))
    assert first == second
    assert first.endswith(b"\n")
