import pytest

from campaigns.limits import DEFAULT_LIMITS, NO_DIRECTION, Limit
from planners.map import Map
from planners.path import Path
from tracking.trial import Trial, run_trial


def test_every_metric_that_can_get_worse_has_a_limit_and_no_other():
    here = Path([[0.0, 0.0], [1.0, 0.0]])
    beside = Path([[0.0, 50.0], [1.0, 50.0]])
    trials = (
        Trial("one metre", here, vehicle, obstacles=Map(), max_range=1.0, others=(beside,))
        for vehicle in ("c172x", "truck")
    )
    metrics = [metric for trial in trials for metric in run_trial(trial).metrics.values()]
    assert {metric.name for metric in metrics if metric.better != "neither"} == DEFAULT_LIMITS.keys()
    assert {metric.name for metric in metrics if metric.better == "neither"} == set(NO_DIRECTION)


@pytest.mark.parametrize(("old", "allowed"), [(0.0, 0.002), (0.01, 0.002), (1.0, 0.05), (-1.0, 0.05)])
def test_the_larger_of_absolute_and_relative_counts(old, allowed):
    assert Limit(0.002, 0.05).allowed(old) == pytest.approx(allowed)
