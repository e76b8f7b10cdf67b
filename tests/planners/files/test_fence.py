from __future__ import annotations

import json
from typing import Any

import pytest

SQUARE = [[46.99, 7.99], [46.99, 8.03], [47.02, 8.03], [47.02, 7.99]]
BOWTIE = [SQUARE[i] for i in (0, 2, 1, 3)]


def plan(**fence: Any) -> str:
    items = [{"command": 16, "frame": 0, "params": [0, 0, 0, 0, lat, 8.0, 100]} for lat in (47.0, 47.01)]
    return json.dumps({"fileType": "Plan", "mission": {"items": items}, "geoFence": {"version": 2} | fence})


def polygon(inclusion: bool, points: Any = SQUARE) -> dict[str, Any]:
    return {"inclusion": inclusion, "polygon": points, "version": 1}


def circle(inclusion: bool, radius: float = 100.0) -> dict[str, Any]:
    return {"inclusion": inclusion, "circle": {"center": [47.01, 8.0], "radius": radius}, "version": 1}


def test_inclusions_are_kept_in_and_exclusions_kept_out_of(read):
    file = read("a.plan", plan(polygons=[polygon(True), polygon(False)], circles=[circle(False)]))
    fence = file.fence
    assert (len(fence.keep_in), len(fence.polygons), len(fence.circles)) == (1, 1, 1)
    assert fence.keep_in_circles == ()
    assert fence.frame == file.path.frame
    assert fence.keep_in[0].shape == (4, 2)
    (ring,) = fence.circles
    assert (ring.x, ring.y, ring.radius) == pytest.approx((0.0, 1111.8, 100.0), abs=0.1)
    assert file.notes == ()


def test_several_inclusions_are_noted(read):
    file = read("a.plan", plan(polygons=[polygon(True)], circles=[circle(True)]))
    assert len(file.fence.keep_in) == len(file.fence.keep_in_circles) == 1
    assert file.notes == (
        "geoFence: the path must stay inside all inclusion areas; PX4 is content with any one of them",
    )


def test_no_areas_no_fence(read):
    assert read("a.plan", plan(polygons=[], circles=[])).fence is None
    assert read("a.plan", plan().replace('"geoFence"', '"other"')).fence is None


def test_version_1_is_skipped_with_a_note(read):
    file = read("a.plan", plan(version=1, polygon=SQUARE))
    assert file.fence is None
    assert file.notes == ("geoFence: a fence of version 1 is skipped; save the plan again with a newer QGroundControl",)


@pytest.mark.parametrize(
    ("fence", "said"),
    [
        ({"polygons": [polygon(True), polygon(True, SQUARE[:2])]}, "geoFence polygon 2: a polygon needs at"),
        ({"polygons": [polygon(True, BOWTIE)]}, "geoFence polygon 1: its edges cross or"),
        ({"polygons": [polygon(True, [[47.0]])]}, "geoFence polygon 1: [47.0] is not a position; give"),
        ({"polygons": [polygon(True, [[147.0, 8.0]])]}, "geoFence polygon 1: latitude 147.0 is not within"),
        ({"polygons": [polygon(True, [])]}, "geoFence polygon 1: a polygon needs"),
        ({"circles": [circle(True, 0.0)]}, "geoFence circle 1: its radius is 0.0; give a radius above 0"),
        ({"circles": [{"circle": {"center": [47, 8]}}]}, "$.geoFence.circles[0].circle: Object missing"),
    ],
)  # fmt: skip
def test_refused(refusal, fence, said):
    assert refusal("a.plan", plan(**fence)).startswith(said)
