from __future__ import annotations

import json
from typing import Any

import pytest

from planners import files
from planners.frame import Frame
from planners.path import Path

# QGroundControl 4 with a survey, a structure scan, null altitudes and comments by hand
PLAN = """{ // flown at http://example.org
    "fileType": "Plan", "groundStation": "QGroundControl", "version": 1,
    "geoFence": {
        "circles": [{"circle": {"center": [47.402, 8.002], "radius": 5}, "inclusion": false, "version": 1}],
        "polygons": [{"inclusion": true, "version": 1,
                      "polygon": [[47.39, 7.99], [47.39, 8.02], [47.41, 8.02], [47.41, 7.99]]}],
        "version": 2
    },
    "mission": {
        "cruiseSpeed": 15, "hoverSpeed": 5, "firmwareType": 12, "vehicleType": 2, "globalPlanAltitudeMode": 1,
        "items": [
            {"AMSLAltAboveTerrain": null, "Altitude": 50, "AltitudeMode": 1, "command": 22,
             "autoContinue": true, "doJumpId": 1, "frame": 3,
             "params": [15, 0, 0, null, 47.397, 8.0, 50], "type": "SimpleItem"},
            {"autoContinue": true, "command": 178, "doJumpId": 2, "frame": 2,
             "params": [1, 12.5, -1, 0, 0, 0, 0], "type": "SimpleItem"},
            {"AMSLAltAboveTerrain": null, "Altitude": 60, "AltitudeMode": 1, "command": 16,
             "autoContinue": true, "doJumpId": 3, "frame": 3,
             "params": [0, 0, 0, null, 47.398, 8.0, null], "type": "SimpleItem"},
            /* the survey
               of the field */
            {"type": "ComplexItem", "complexItemType": "survey", "version": 5, "angle": 0,
             "TransectStyleComplexItem": {"CameraCalc": {"CameraName": "Manual // none"}, "Items": [
                {"autoContinue": true, "command": 16, "doJumpId": 4, "frame": 3,
                 "params": [0, 0, 0, null, 47.399, 8.0, 70], "type": "SimpleItem"},
                {"autoContinue": true, "command": 206, "doJumpId": 5, "frame": 2,
                 "params": [25, 0, 1, 0, 0, 0, 0], "type": "SimpleItem"},
                {"autoContinue": true, "command": 16, "doJumpId": 6, "frame": 0,
                 "params": [0, 0, 0, null, 47.399, 8.01, 560], "type": "SimpleItem"}]}},
            {"type": "ComplexItem", "complexItemType": "StructureScan", "version": 3, "Layers": 1},
            {"autoContinue": true, "command": 20, "doJumpId": 7, "frame": 2,
             "params": [0, 0, 0, 0, 0, 0, 0], "type": "SimpleItem"}
        ],
        "plannedHomePosition": [47.397, 8.0, 488], "version": 2
    },
    "rallyPoints": {"points": [[47.3, 8.1, 50]], "version": 2}
}"""


def plan(*items: dict[str, Any], **parts: Any) -> str:
    home = [47.0, 8.0, 400.0]
    return json.dumps({"fileType": "Plan", "mission": {"items": items, "plannedHomePosition": home}} | parts)


def waypoint(lat: float, **values: Any) -> dict[str, Any]:
    return {
        "type": "SimpleItem",
        "command": 16,
        "frame": 0,
        "params": [0, 0, 0, None, lat, 8.0, 100],
    } | values


def test_a_real_plan(read):
    file = read("field.plan", PLAN)
    assert file.path.frame == Frame(47.398, 8.0)
    assert file.path.z.tolist() == [548.0, 558.0, 560.0]
    assert (file.path.name, file.speed) == ("field", 12.5)
    assert file.notes == (
        "item 5: StructureScan: its track is not stored in the plan",
        "rallyPoints: 1 points are not part of the path",
        "item 1: NAV_TAKEOFF (22): the take-off is not flown, the path starts at the first waypoint",
        "item 4.2: DO_SET_CAM_TRIGG_DIST (206): it is no waypoint",
        "item 6: NAV_RETURN_TO_LAUNCH (20): the way home is not flown",
    )
    assert file.fence.frame == file.path.frame
    assert len(file.fence.keep_in) == len(file.fence.circles) == 1


@pytest.mark.parametrize(
    ("values", "z"),
    [
        ({"AltitudeMode": 1, "Altitude": 50}, 450.0),
        ({"AltitudeMode": 2, "Altitude": 500}, 500.0),
        ({"AltitudeMode": 3, "Altitude": 50, "AMSLAltAboveTerrain": 470.5}, 470.5),
        ({"AltitudeMode": 3, "Altitude": 50, "AMSLAltAboveTerrain": None}, 450.0),
        ({"AltitudeMode": 4, "Altitude": 50}, 450.0),
        ({"AltitudeMode": None, "Altitude": 500}, 500.0),
        ({"Altitude": 50, "frame": 3}, 450.0),
        ({"AltitudeMode": 1, "Altitude": None}, 100.0),
        ({"AltitudeMode": 1, "Altitude": 50, "params": [0, 0, 0, None, 47.1, 8.0, 999]}, 999.0),
    ],
)
def test_altitudes(read, values, z):
    item = {"params": [None, None, None, None, 47.1, 8.0, None]} | values
    assert read("a.plan", plan(waypoint(47.0), waypoint(47.1, **item))).path.z.tolist() == [100.0, z]


def test_old_items_with_a_coordinate(read):
    old = {"command": 16, "frame": 3, "param1": 0, "param2": 1.5, "type": "missionItem"}
    file = read("a.plan", plan(waypoint(47.0), old | {"type": "SimpleItem", "coordinate": [47.1, 8, 50]}))
    assert file.path.z.tolist() == [100.0, 450.0]
    both = waypoint(0.0, coordinate=[47.1, 8, 50], params=[0, 0, 0, 0, 0, 0, 0])
    assert len(read("a.plan", plan(waypoint(47.0), both)).path.points) == 2


def test_home_of_an_old_plan(read):
    text = plan(waypoint(47.0, frame=3), waypoint(47.1))
    old = text.replace("[47.0, 8.0, 400.0]", '{"coordinate": [47.0, 8.0, 300.0]}')
    assert read("a.plan", old).path.z.tolist() == [400.0, 100.0]
    for unknown in ("[47.0, 8.0, null]", "[47.0, 8.0]", "null"):
        file = read("a.plan", text.replace("[47.0, 8.0, 400.0]", unknown))
        assert file.path.z.tolist() == [100.0, 100.0]
        assert "the altitude of home is not known" in file.notes[0]


def test_items_without_a_position_are_skipped(read):
    file = read("a.plan", plan(waypoint(47.0), waypoint(0, params=[0]), {"command": 530}, waypoint(47.1)))
    assert file.notes == (
        "item 2: NAV_WAYPOINT (16): no position",
        "item 3: SET_CAMERA_MODE (530): it is no waypoint",
    )


def test_a_complex_item_whose_items_are_not_stored(read):
    survey = {"type": "ComplexItem", "complexItemType": "survey", "TransectStyleComplexItem": {"Items": []}}
    file = read("a.plan", plan(waypoint(47.0), survey, waypoint(47.1)))
    assert file.notes == ("item 2: survey: its track is not stored in the plan",)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "line 1, column 1: broken JSON: it ends here; correct it or export it again"),
        ('{"fileType": "Plan",\n "mission": {]}', "line 2, column 14: broken JSON: "),
        ("[]", "expected object, got array"),
        ('{"fileType": "Plan"}', "there is no mission in the plan; add a mission with waypoints"),
        ('{"fileType": "Parameters"}', "fileType is 'Parameters', not 'Plan'; save the mission as a plan"),
        (plan(), "a path needs at least two waypoints, this mission has none; add waypoints"),
        (plan(waypoint(47.0)), "a path needs at least two waypoints, this mission has 1; add waypoints"),
        (plan(waypoint(47.0, command="16")), "$.mission.items[0].command: expected int, got str; correct"),
        (plan(waypoint(47.0, params=["0"])), "$.mission.items[0].params[0]: expected float | null, got str"),
        (plan(waypoint(47.0), waypoint(95.0)), "item 2: latitude 95.0 is not within +-90 degrees"),
        (plan(waypoint(47.0)).replace("100", "1e400"), "$.mission.items[0].params[6]: Number out of range"),
        (plan(waypoint(47.0)).replace("100", "Infinity"), "line 1, column "),
    ],
)
def test_refused(refusal, text, said):
    assert refusal("a.plan", text).startswith(said)


def test_written_as_qgroundcontrol_writes_it(tmp_path):
    files.write(Path([[0.0, 0.0, 50.0], [1000.0, 0.0, 60.0]], Frame(47.0, 8.0)), tmp_path / "a.plan")
    data = json.loads((tmp_path / "a.plan").read_text())
    assert data.keys() == {"fileType", "geoFence", "groundStation", "mission", "rallyPoints", "version"}
    assert data["mission"]["plannedHomePosition"] == [47.0, 8.0, 50.0]
    first = data["mission"]["items"][0]
    assert first["params"] == [0, 0, 0, None, 47.0, 8.0, 50.0]
    assert (first["frame"], first["AltitudeMode"], first["Altitude"]) == (0, 2, 50.0)
    assert files.read(tmp_path / "a.plan").notes == ()
