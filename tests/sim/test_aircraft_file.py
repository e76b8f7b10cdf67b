import shutil
from pathlib import Path

import jsbsim
import pytest

from planners.errors import InputError
from sim.aircraft_file import AIRCRAFT_FOLDER, ALL_AIRCRAFT, load_aircraft
from sim.fixed_wing import FixedWing
from sim.vehicle import Command, Conditions, Pose
from sim.vehicles import make_vehicle

C172X = (AIRCRAFT_FOLDER / "c172x.toml").read_text()


def variant(tmp_path, old, new):
    file = tmp_path / "mine.toml"
    assert old in C172X
    file.write_text(C172X.replace(old, new))
    return str(file)


def test_every_file_in_the_folder_is_listed():
    assert sorted(ALL_AIRCRAFT) == sorted(path.stem for path in AIRCRAFT_FOLDER.glob("*.toml"))


def test_the_next_aircraft_needs_no_code(tmp_path):
    aircraft = make_vehicle(variant(tmp_path, 'name = "c172x"', 'name = "mine"'))
    assert aircraft.name == "mine"
    assert aircraft.reset(Pose(0.0, 0.0, 500.0, 1.0), 50.0, Conditions(), 0).airspeed == pytest.approx(50.0, abs=0.1)


def test_a_model_that_jsbsim_does_not_have_is_named_with_those_it_has(tmp_path):
    aircraft = load_aircraft(variant(tmp_path, 'model = "c172x" ', 'model = "c173x" '))
    with pytest.raises(InputError, match=r"no model 'c173x'.*did you mean 'c172x'") as error:
        FixedWing(aircraft).reset(Pose(0.0, 0.0, 500.0, 1.0), 55.0, Conditions(), 0)
    assert "\n" not in str(error.value)


def test_a_broken_model_is_an_error_with_its_file(tmp_path):
    folder = tmp_path / "aircraft" / "broken"
    folder.mkdir(parents=True)
    (folder / "broken.xml").write_text("<fdm_config>")
    aircraft = load_aircraft(variant(tmp_path, 'model = "c172x" ', 'root = "."\nmodel = "broken" '))
    with pytest.raises(InputError, match=r"broken.xml: is not XML"):
        FixedWing(aircraft).reset(Pose(0.0, 0.0, 500.0, 1.0), 55.0, Conditions(), 0)


def test_what_jsbsim_dislikes_is_in_the_error_and_nowhere_else(tmp_path, capfd):
    folder = tmp_path / "aircraft" / "broken"
    folder.mkdir(parents=True)
    (folder / "broken.xml").write_text('<fdm_config name="x" version="2.0"><metrics/></fdm_config>')
    aircraft = load_aircraft(variant(tmp_path, 'model = "c172x" ', 'root = "."\nmodel = "broken" '))
    with pytest.raises(InputError, match=r"broken.xml: JSBSim cannot load it \(.+\)") as error:
        FixedWing(aircraft).reset(Pose(0.0, 0.0, 500.0, 1.0), 55.0, Conditions(), 0)
    assert "\n" not in str(error.value)
    assert capfd.readouterr() == ("", "")


def test_a_speed_at_which_it_does_not_fly_level_is_refused(tmp_path, capfd):
    fast = load_aircraft(variant(tmp_path, "speed_max = 62.0", "speed_max = 300.0"))
    with pytest.raises(InputError, match=r"no equilibrium for 1125 kg at 90 m/s and 1000 m \(.*trimmable"):
        FixedWing(fast).reset(Pose(0.0, 0.0, 1000.0, 1.0), 90.0, Conditions(), 0)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("bank_limit = 45.0", "bank_limits = 45.0", "bank_limit"),
        ("bank_limit = 45.0", 'bank_limit = "steep"', "envelope.bank_limit"),
        ("bank_limit = 45.0", "bank_limit = 0.0", "envelope.bank_limit"),
        ("bank_limit = 45.0", "bank_limit = -45.0", "envelope.bank_limit"),
        ("alpha_stall = 16.0", "alpha_stall = nan", "envelope.alpha_stall"),
        ("altitude_time = 5.0", "altitude_time = 0.0", "pitch.altitude_time"),
        ("span = 10.97", "span = -1.0", "span"),
        ("span = 10.97", 'planet = "marz"\nspan = 10.97', "no planet 'marz'; did you mean 'mars'"),
        ("[roll] ", "[role] ", "role"),
        ("[roll] ", "[roll ", "TOML"),
    ],
)
def test_a_wrong_file_is_one_line_that_names_the_key(tmp_path, old, new, message):
    with pytest.raises(InputError, match=message) as error:
        load_aircraft(variant(tmp_path, old, new))
    assert "mine.toml" in str(error.value)
    assert "\n" not in str(error.value)


def test_unknown_vehicles_and_missing_files_are_refused():
    with pytest.raises(InputError, match="no vehicle 'boat'"):
        make_vehicle("boat")
    with pytest.raises(InputError, match="no such file"):
        make_vehicle("nowhere.toml")


def test_a_run_writes_nothing_beside_the_aircraft(tmp_path):
    """The stock c172x asks for a CSV file in JSBSim's own folder."""
    data = Path(jsbsim.get_default_root_dir())
    shutil.copytree(data / "aircraft" / "c172x", tmp_path / "aircraft" / "c172x")
    for folder in ("engine", "systems"):
        shutil.copytree(data / folder, tmp_path / folder)
    aircraft = FixedWing(load_aircraft(variant(tmp_path, 'model = "c172x" ', 'root = "."\nmodel = "c172x" ')))
    before = set(tmp_path.rglob("*"))
    aircraft.reset(Pose(0.0, 0.0, 500.0, 1.0), 55.0, Conditions(), 0)
    for _ in range(100):
        aircraft.step(Command(0.0, 55.0, 500.0))
    assert set(tmp_path.rglob("*")) == before
