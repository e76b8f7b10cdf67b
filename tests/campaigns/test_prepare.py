import numpy as np
import pytest

from campaigns.case import Case
from campaigns.inputs import Reader
from campaigns.prepare import assemble
from planners import files
from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.frame import Frame
from planners.path import Path

PLAN = """{"fileType": "Plan", "version": 1, "groundStation": "QGroundControl",
 "mission": {"version": 2, "firmwareType": 3, "vehicleType": 1, "plannedHomePosition": [47, 8, 400], "items": [%s]}}"""
ITEM = (
    '{"type": "SimpleItem", "command": %d, "frame": %d, "autoContinue": true, "doJumpId": 1, "params": [%s], '
    '"Altitude": 500, "AltitudeMode": 1}'
)


def prepare(folder, path, **settings):
    case = Case(path=path, vehicle="c172x", **settings)
    return assemble(case, Reader(folder).read(case))


def mission(tmp_path, speed):
    items = [ITEM % (178, 2, f"0, {speed}, -1, 0, 0, 0, 0")]
    items += [ITEM % (16, 3, f"0, 0, 0, null, {47 + 0.02 * i}, 8, 500") for i in range(3)]
    (tmp_path / "mission.plan").write_text(PLAN % ", ".join(items))
    return "mission.plan"


def test_a_mission_sets_its_speed_where_the_vehicle_can_keep_it(tmp_path):
    ready = prepare(tmp_path, mission(tmp_path, 50))
    assert ready.speed == 50.0
    slow = prepare(tmp_path, mission(tmp_path, 12))
    assert slow.speed == 55.0
    assert any("12 m/s, which is not a speed of this vehicle" in note for note in slow.notes)


def test_the_users_speed_counts_before_the_missions(tmp_path):
    trial = prepare(tmp_path, mission(tmp_path, 50), speed="100kt")
    assert trial.speed == pytest.approx(51.444, abs=1e-3)


def test_an_altitude_replaces_the_paths_heights(tmp_path):
    trial = prepare(tmp_path, mission(tmp_path, 50), altitude="1.2km")
    assert trial.path.z is None
    assert trial.altitude == 1200.0


def test_a_scenario_without_a_place_does_not_fit_a_geographic_path(tmp_path):
    with pytest.raises(InputError, match="no place on the planet"):
        prepare(tmp_path, mission(tmp_path, 50), scenario="nofly-1000x660")


def test_a_geographic_path_is_moved_into_the_frame_of_the_scenario(tmp_path):
    (tmp_path / "field.toml").write_text(
        'name = "field"\nsize = [1000, 1000]\nstart = [10, 10]\ngoal = [900, 900]\norigin = [47.0, 8.0]\n'
        "[[obstacle]]\ncircle = { center = [500.0, 100.0], radius = 50.0 }\n"
    )
    field = Frame(47.0, 8.0)
    (lat, lon), *_ = field.to_geographic(Path([[200.0, 300.0], [900.0, 300.0]]).xy).tolist()
    files.write(Path([[0.0, 0.0], [700.0, 0.0]], frame=Frame(lat, lon)), tmp_path / "path.csv")
    trial = prepare(tmp_path, "path.csv", scenario="field.toml")
    assert trial.path.frame == field
    assert trial.path.points[0] == pytest.approx([200.0, 300.0], abs=1e-3)
    assert trial.obstacles is not None
    assert clearance(trial.obstacles, np.array([[500.0, 300.0, 0.0]]), Disc(0.0))[0] == pytest.approx(150.0)


def test_fly_by_reports_each_corner(tmp_path):
    files.write(Path([[0.0, 0.0], [3000.0, 0.0], [3000.0, 3000.0]]), tmp_path / "corner.csv")
    ready = prepare(tmp_path, "corner.csv", corners="fly-by")
    notes = [note for note in ready.notes if "rounded" in note]
    assert len(notes) == 1
    assert "corner at 3.00 km, 90 deg: rounded with a radius of 370 m, cut by 153.3 m" in notes[0]
    assert len(ready.path.points) > 10


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ({"controller": "stanly"}, "there is no controller 'stanly'"),
        ({"require": ("cros_track_p95<=2",)}, "there is no metric 'cros_track_p95'; did you mean 'cross_track_p95'?"),
        ({"require": ("bank_max",)}, "'bank_max' is not a requirement"),
    ],
)
def test_a_wrong_name_is_found_before_the_run(tmp_path, settings, told):
    files.write(Path([[0.0, 0.0], [3000.0, 0.0]]), tmp_path / "line.csv")
    with pytest.raises(InputError) as refused:
        prepare(tmp_path, "line.csv", **settings)
    assert told in str(refused.value)
