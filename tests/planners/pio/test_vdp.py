"""Paper 001's pigeons on our maps of its numbers. Seeds from 100 on were not used for tuning."""

from dataclasses import replace

import numpy as np
import pytest

from planners.all_planners import make_planner, plan_with
from planners.facts import facts_of
from planners.pio.course import is_even
from planners.scenario import load_scenario

MAPS = {15: load_scenario("mars-hazards-15"), 25: load_scenario("mars-hazards-25")}
EXACT = {15: 687.21, 25: 690.96}  # map units, by visibility graph for a point
PAPER = {15: (725.0, 17.2), 25: (757.0, 31.9)}  # map units and deg, its Table 2
BEST = ["aircraft 1 to target 2", "aircraft 2 to target 3", "aircraft 3 to target 1"]  # by exact lengths


@pytest.mark.parametrize("hazards", [15, 25])
@pytest.mark.parametrize("seed", [100, 101])
def test_gccpio_does_what_the_paper_claims(hazards, seed):
    planner, fleet = make_planner("vdp"), MAPS[hazards]
    plan = plan_with(planner, fleet, seed)
    told = facts_of(plan, planner, fleet, seed)
    assert [path.name for path in plan.paths] == BEST
    assert told.length / fleet.unit <= 1.02 * EXACT[hazards] < PAPER[hazards][0]
    assert told.turn_angle_max_deg <= PAPER[hazards][1]
    assert told.longest <= fleet.max_range
    assert told.clearance_min >= 250.0
    assert plan.notes == ()
    assert all(len(path.xy) == 21 and is_even(path.xy) for path in plan.paths)
    roadmap, sight, optimised = (length for _, length in told.stages)
    assert optimised < sight < roadmap


def test_the_roadmap_alone_breaks_the_turn_limit_among_25_hazards():
    """As the paper finds: 88.4 deg there."""
    plan = plan_with(make_planner("vd"), MAPS[25], 0)
    assert [path.name for path in plan.paths] == BEST
    assert max(np.abs(path.turns).max() for path in plan.paths) > MAPS[25].max_turn_angle
    assert "the turn limit of 45 deg is not kept" in plan.notes[0]


def test_one_joint_swarm_as_printed_does_worse():
    settings = {"joint": True, "communication": "printed"}
    lengths = [
        sum(path.length for path in plan_with(make_planner("vdp", more), MAPS[15], 100).paths)
        for more in ({}, settings)
    ]
    assert lengths[0] < lengths[1]


def test_a_history_of_three_swarms_is_their_sum():
    settings = {"pigeons": 30, "compass_iterations": 4, "landmark_iterations": 2}
    history = plan_with(make_planner("vdp-pio", settings), MAPS[15], 1).history
    assert history.population == 90
    assert history.evaluations.tolist() == [3 * count for count in (60, 90, 120, 150, 165, 173)]


def test_where_no_pigeon_keeps_the_limits_the_roadmap_path_is_flown():
    """Two segments cannot pass between the hazards; the roadmap paths can, where turns are free."""
    settings = {"segments": 2, "pigeons": 5, "compass_iterations": 1, "landmark_iterations": 0}
    plan = plan_with(make_planner("vdp-pio", settings), replace(MAPS[25], max_turn_angle=None), 1)
    assert [note for note in plan.notes if "flies its roadmap path" in note] == list(plan.notes)
    assert len(plan.notes) == 3
    for path, short in zip(plan.paths, plan.stages[1].paths, strict=True):
        assert np.array_equal(path.xy, short.xy)


def test_where_neither_keeps_them_none_is_found():
    settings = {"segments": 2, "pigeons": 5, "compass_iterations": 1, "landmark_iterations": 0}
    plan = plan_with(make_planner("vdp-pio", settings), replace(MAPS[25], max_turn_angle=0.1), 1)
    assert (plan.paths, plan.outcome) == ((), "not found")
    assert "nor does its roadmap path" in plan.reason
