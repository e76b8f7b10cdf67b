import json
import math
from dataclasses import replace

import numpy as np
import pytest

from planners.frame import Frame
from planners.map import Circle, Map, Raster
from planners.scenario import BUILT_IN_SCENARIOS, Scenario, load_scenario
from planners.scenario_json import SCHEMA_VERSION, scenario_bytes

RING = np.array([[2.0, 1.0], [4.0, 1.0], [3.0, 3.0]])


@pytest.fixture
def scenario():
    area = Map(
        polygons=(RING,),
        circles=(Circle(6.0, 5.0, 1.5),),
        keep_in=(4.0 * RING,),
        keep_in_circles=(Circle(5.0, 4.0, 9.0),),
        raster=Raster(np.array([[True, False, False], [False, False, True]]), 2.5, 1.0, 0.5),
        frame=Frame(47.0, 8.0),
    )
    return Scenario(
        name="here",
        map=area,
        starts=np.array([[1.0, 1.0]]),
        goals=np.array([[9.0, 7.0], [8.0, 7.0]]),
        size=(10.0, 8.0),
        unit=2.0,
        max_range=100.0,
        max_turn_angle=math.radians(45.0),
    )


def test_every_part_of_a_scenario_is_told_in_metres(scenario):
    told = json.loads(scenario_bytes(scenario))
    assert "metres" in told.pop("units")
    assert told == {
        "schema": SCHEMA_VERSION,
        "name": "here",
        "size": [10.0, 8.0],
        "map_unit": 2.0,
        "origin": [47.0, 8.0],
        "edge": "closed",
        "starts": [[1.0, 1.0]],
        "goals": [[9.0, 7.0], [8.0, 7.0]],
        "max_range": 100.0,
        "max_turn_angle_deg": 45.0,
        "obstacles": [{"polygon": RING.tolist()}, {"circle": {"center": [6.0, 5.0], "radius": 1.5}}],
        "keep_in": [{"polygon": (4.0 * RING).tolist()}, {"circle": {"center": [5.0, 4.0], "radius": 9.0}}],
        "raster": {"cell": 2.5, "origin": [1.0, 0.5], "rows": ["100", "001"]},
        "picture": None,
    }


def test_what_is_not_finite_is_null(scenario):
    told = json.loads(scenario_bytes(replace(scenario, max_range=math.inf, max_turn_angle=math.nan)))
    assert told["max_range"] is None
    assert told["max_turn_angle_deg"] is None


@pytest.mark.parametrize("name", BUILT_IN_SCENARIOS)
def test_the_same_scenario_is_the_same_bytes(name):
    assert scenario_bytes(load_scenario(name)) == scenario_bytes(load_scenario(name))


def test_lengths_in_map_units_become_metres():
    told = json.loads(scenario_bytes(load_scenario("mars-hazards-15")))
    assert told["size"] == [75000.0, 75000.0]
    assert told["max_range"] == 424.0 * 250.0
    assert told["obstacles"][0] == {"circle": {"center": [67500.0, 43500.0], "radius": 2500.0}}


def test_a_picture_whose_truth_is_known_is_named():
    scenario = load_scenario("target-vehicle-640m")
    told = json.loads(scenario_bytes(scenario))
    assert told["picture"] == str(scenario.picture)
    rows = told["raster"]["rows"]
    assert (len(rows), len(rows[0])) == (512, 512)
    assert [row.count("1") for row in rows] == scenario.map.raster.blocked.sum(axis=1).tolist()
