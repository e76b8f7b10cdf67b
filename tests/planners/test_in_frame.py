from dataclasses import replace

import numpy as np
import pytest

from planners.errors import InputError
from planners.frame import Frame
from planners.in_frame import in_frame_of
from planners.map import Map
from planners.path import Path
from planners.scenario import Scenario


@pytest.fixture
def scenario():
    ends = np.array([[1.0, 1.0]])
    return Scenario(name="here", map=Map(frame=Frame(47.0, 8.0)), starts=ends, goals=ends + 5.0, size=(10.0, 10.0))


def test_a_path_stays_where_it_is_on_the_planet(scenario):
    path = Path(np.array([[0.0, 0.0, 30.0], [500.0, 200.0, 40.0]]), Frame(47.01, 8.02), "there")
    moved = in_frame_of(scenario, path)
    assert moved.frame == scenario.map.frame
    assert moved.name == "there"
    assert moved.z.tolist() == [30.0, 40.0]
    before, after = path.frame.to_geographic(path.xy), moved.frame.to_geographic(moved.xy)
    assert after == pytest.approx(before, abs=1e-10)


def test_a_path_in_metres_is_in_the_frame_already(scenario):
    path = Path(np.array([[0.0, 0.0], [5.0, 2.0]]))
    assert in_frame_of(scenario, path) is path


def test_a_scenario_without_origin_takes_no_geographic_path(scenario):
    path = Path(np.array([[0.0, 0.0], [5.0, 2.0]]), Frame(47.0, 8.0))
    with pytest.raises(InputError, match=r"here: .* no place on the planet.*origin = \[lat, lon\]"):
        in_frame_of(replace(scenario, map=Map()), path)
