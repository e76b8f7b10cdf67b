import json
import math
from typing import ClassVar

import msgspec
import numpy as np
import pytest

from planners import files
from planners.path import Path
from planners.planner import NO_PATH, NOT_FOUND, History, Plan

FIELD = """name = "field"
size = [100.0, 60.0]
unit = 10.0
start = [10.0, 10.0]
goal = [90.0, 10.0]

[[obstacle]]
circle = { center = [50.0, 30.0], radius = 5.0 }
"""


class Bent(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A bend on the way. It is `height` [m] high, as high as wanted.

    ants: how many look for it (eq. 1; Table
        1: 3). More are faster.
    outcome: other than "" there is none.
    """

    name: ClassVar[str] = "bent"
    summary: ClassVar[str] = "bends"

    height: float = 30.0
    ants: int = 3
    outcome: str = ""

    @property
    def clearance(self) -> float:
        return 0.0

    def plan(self, scenario, rng):
        lengths = 1000.0 + np.array([math.nan, 100.0, 5.0, 0.0])
        alive = np.array([0, 1, 2, self.ants])
        history = History(lengths, 2.0 * lengths, alive, self.ants)
        if self.outcome:
            return Plan(outcome=self.outcome, reason="it is dark", notes=("no light",), history=history)
        start, goal = scenario.starts[0], scenario.goals[0]
        path = Path(np.array([start, (start + goal) / 2 + [0.0, self.height + rng.random()], goal]))
        return Plan(paths=(path,), polylines=(path,), notes=("it bends",), history=history)


@pytest.fixture(autouse=True)
def _a_planner_and_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "field.toml").write_text(FIELD)
    monkeypatch.setattr("planners.all_planners.ALL_PLANNERS", (Bent,))


BENT = ("plan", "field.toml", "--planner", "bent")


def test_a_path_is_told_in_metres_and_map_units_and_saved(run, tmp_path):
    code, out, err = run(*BENT, "--set", "height=40", "-o", "path.csv", "--picture", "path.png")
    assert code == 0
    path = files.read("path.csv").path
    lines = {line.split("  ")[0].strip(): line.split() for line in out.splitlines() if line.strip()}
    assert lines["length"][-3:] == [f"{path.length:.1f}", "m", f"{path.length / 10.0:.6g}"]
    assert lines["exact shortest path"][-3:] == ["800", "m", "80"]
    assert float(lines["length over it"][-1]) == pytest.approx(path.length / 800.0, abs=1e-4)
    turn = math.degrees(2 * math.atan(path.points[1, 1] / 400.0 - 0.25))
    assert lines["largest turn as drawn"][-1] == f"{turn:.1f}°"
    assert lines["arrived in the last"][-3:] == ["3", "of", "3"]
    assert lines["within 1 % of the best"][-1] == "3"
    assert err.splitlines() == ["it bends", "saved path.csv", "saved path.png"]
    assert (tmp_path / "path.png").read_bytes().startswith(b"\x89PNG")


def test_the_seed_decides(run):
    outputs = [run(*BENT, "--seed", seed)[1] for seed in (1, 1, 2)]
    assert outputs[0] == outputs[1] != outputs[2]


def test_json_is_one_object_on_standard_output_and_nothing_else(run):
    code, out, err = run(*BENT, "--json", "--seed", "3")
    told = json.loads(out)
    assert code == 0
    assert err == "it bends\n"
    assert (told["planner"], told["scenario"], told["seed"]) == ("bent", "field", 3)
    assert told["best"] == [None, 1100.0, 1005.0, 1000.0]
    assert told["length_ratio"] == pytest.approx(told["length"] / told["exact_length"])
    assert told["path"][0] == [100.0, 100.0]
    assert len(told["path"]) == 3


@pytest.mark.parametrize("outcome", [NO_PATH, NOT_FOUND])
def test_without_a_path_it_says_why_and_exits_with_1(run, tmp_path, outcome):
    fails = (*BENT, "--set", f'outcome="{outcome}"')
    code, out, err = run(*fails, "-o", "path.csv", "--picture", "search.png")
    assert code == 1
    assert out.splitlines()[-1] == f"{outcome}: it is dark"
    assert err.splitlines() == ["no light", "saved search.png"]
    assert not (tmp_path / "path.csv").exists()
    code, out, _ = run(*fails, "--json")
    told = json.loads(out)
    assert code == 1
    assert (told["outcome"], told["reason"], told["path"]) == (outcome, "it is dark", None)
    assert told["length_ratio"] is None


def test_a_word_needs_no_quotes(run):
    code, out, _ = run(*BENT, "--set", "outcome=lost")
    assert (code, out.splitlines()[-1]) == (1, "lost: it is dark")


BAD_INPUT = {
    "no such planner": (("plan", "field.toml", "--planner", "bend"), "did you mean 'bent'?"),
    "no planner": (("plan", "field.toml"), "--planner"),
    "no such scenario": (("plan", "nofly-1000", "--planner", "bent"), "did you mean 'nofly-1000x660'?"),
    "an unknown setting": ((*BENT, "--set", "ant=5"), "did you mean 'ants'?"),
    "a setting of a wrong kind": ((*BENT, "--set", "ants=2.5"), "ants"),
    "a setting without a value": ((*BENT, "--set", "ants"), "'ants' is not key=value"),
    "a value that is neither TOML nor a word": ((*BENT, "--set", "outcome=[lost"), "'outcome=[lost' is not key=value"),
    "a word for a number": ((*BENT, "--set", "ants=lots"), "ants"),
    "two settings in one": ((*BENT, "--set", "ants=2\nheight=3"), "is not key=value"),
    "a table": ((*BENT, "--set", "[ants]"), "'[ants]' is not key=value"),
    "a negative seed": ((*BENT, "--seed", "-1"), "--seed"),
    "an unknown kind of path file": ((*BENT, "-o", "path.xyz"), ".geojson"),
    "a mission without a place on Earth": ((*BENT, "-o", "path.plan"), "no place on Earth"),
    "a path in no folder": ((*BENT, "-o", "nowhere/path.csv"), "nowhere"),
    "a picture of an unknown kind": ((*BENT, "--picture", "a.bmp"), ".png"),
}


@pytest.mark.parametrize("name", BAD_INPUT)
def test_bad_input_is_one_line_and_exit_code_2(run, name):
    arguments, told = BAD_INPUT[name]
    code, out, err = run(*arguments)
    assert code == 2
    assert out == ""
    assert len(err.splitlines()) == 1
    assert told in err


def test_what_is_read_is_not_overwritten(run, tmp_path):
    (tmp_path / "field.png").symlink_to(tmp_path / "field.toml")
    code, _, err = run(*BENT, "--picture", "field.png")
    assert code == 2
    assert "overwrite" in err
    assert (tmp_path / "field.toml").read_text() == FIELD


def test_planners_are_listed(run):
    code, out, _ = run("list", "planners")
    assert code == 0
    assert out == "bent               bends\n"


def test_settings_are_listed_with_their_defaults_and_what_they_are(run):
    code, out, _ = run("list", "planner-settings")
    assert code == 0
    assert out.splitlines() == [
        "bent",
        "  height = 30.0                   It is `height` [m] high, as high as wanted.",
        "  ants = 3                        how many look for it (eq. 1; Table 1: 3).",
        '  outcome = ""                    other than "" there is none.',
    ]


def test_every_planner_plans_by_default(run, monkeypatch):
    monkeypatch.undo()
    code, out, _ = run("plan", "nofly-1000x660", "--planner", "exact")
    assert code == 0
    assert "map units" in out
