import pickle
import sys
import tempfile
from dataclasses import replace

import msgspec
import numpy as np
import pytest

from planners.errors import InputError, TrackworthyError
from planners.frame import Frame
from planners.map import Map
from planners.outside import OutsidePlanner, PlannerError, plan_outside
from planners.scenario import Scenario
from planners.typed_toml import convert

STRAIGHT = [[1.1, 2.0 / 3.0], [9.0, 7.0]]

COMMAND = """
import json, sys
scenario, output = sys.argv[1:3]
task = json.load(open(scenario))
with open(output, "w") as stream:
    print("x,y", file=stream)
    for x, y in (task["starts"][0], task["goals"][0]):
        print(f"{x!r},{y!r}", file=stream)
"""

MODULE = """
def straight(scenario, seed):
    return [scenario["starts"][0], scenario["goals"][0]]
"""


@pytest.fixture
def scenario():
    start, goal = np.array(STRAIGHT)
    return Scenario(name="here", map=Map(), starts=start[None], goals=goal[None], size=(10.0, 8.0))


@pytest.fixture(autouse=True)
def temporary(tmp_path, monkeypatch):
    """Where temporary folders go; none may stay."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield folder
    assert list(folder.iterdir()) == []


@pytest.fixture
def command(tmp_path, scenario):
    """Plans by a script in Python, run as a command with the arguments given."""

    def plan(text, *arguments, seed=1, timeout=20.0, output="path.csv", scenario=scenario):
        (tmp_path / "script.py").write_text(text)
        words = (sys.executable, "script.py", *(arguments or ("{scenario}", "{output}")))
        return plan_outside(OutsidePlanner(words, timeout=timeout, output=output), scenario, seed, tmp_path)

    return plan


@pytest.fixture
def python(tmp_path, scenario):
    """Plans by a module in Python."""

    def plan(text, target="mine:plan", seed=1, timeout=20.0):
        (tmp_path / f"{target.partition(':')[0]}.py").write_text(text)
        return plan_outside(OutsidePlanner(python=target, timeout=timeout), scenario, seed, tmp_path)

    return plan


def failure(plan, *arguments, **options):
    """The message of a failure, which is one line."""
    with pytest.raises(PlannerError) as caught:
        plan(*arguments, **options)
    message = str(caught.value)
    assert "\n" not in message
    assert tempfile.gettempdir() not in message
    return message


def writes(text):
    """A script that writes `text` as its path."""
    return f"import sys; open(sys.argv[2], 'w').write({text!r})"


def test_a_straight_line_is_planned_alike_in_both_forms(command, python):
    planned = command(COMMAND), python(MODULE, "mine:straight")
    for one in planned:
        assert one.path.points.tolist() == STRAIGHT
        assert (one.notes, one.stderr) == ((), "")


def test_a_command_is_found_in_the_folder(tmp_path, scenario):
    script = tmp_path / "my_planner"
    script.write_text(f"#!{sys.executable}\n{COMMAND}")
    script.chmod(0o755)
    planned = plan_outside(OutsidePlanner(("./my_planner", "{scenario}", "{output}")), scenario, 1, tmp_path)
    assert planned.path.points.tolist() == STRAIGHT


def test_placeholders_are_filled_in_and_other_braces_stay(command):
    text = "import sys; print(sys.argv[3:]); open(sys.argv[2], 'w').write('0,0\\n1,1\\n')"
    literal = ['{"a": {}}', "${HOME}", "{print $1}", "{}", "{0}", "{a,b}"]
    arguments = ["{scenario}", "{output}", "--seed={seed}", "{{seed}}", "{{{seed}}}", *literal]
    planned = command(text, *arguments, seed=7)
    assert planned.stderr == str(["--seed=7", "{seed}", "{{seed}}", *literal])
    assert planned.notes == ("no header: the columns are taken as x, y[, z] in metres",)


@pytest.mark.parametrize(
    ("keys", "says"),
    [
        ({}, "either a command or python; give command"),
        ({"command": ["a", "{output}"], "python": "a:b"}, "either a command or python; give command"),
        ({"command": []}, "the command is empty; give command"),
        ({"command": ["a", "{output}", "{sed}"]}, r"unknown placeholder \{sed\}.*\{\{sed\}\} for braces"),
        ({"command": ["a", "{scenario}"]}, r"where to write the path; add \{output\}"),
        ({"command": ["a", "{output}"], "timeout": 0.0}, "timeout of 0.0 s is not possible; give seconds above 0"),
        ({"command": ["a", "{output}"], "output": "path.xyz"}, "'path.xyz' is not the name of a path file; .*.csv"),
        ({"command": ["a", "{output}"], "output": "../path.csv"}, "is not the name of a path file"),
        ({"python": "module"}, 'write it as "module:callable"'),
        ({"python": "./my.py:plan"}, 'write it as "module:callable"'),
        ({"python": "a:b", "output": "path.plan"}, "leave output out"),
        ({"python": "a:b", "time": 3}, "unknown key 'time'; did you mean 'timeout'"),
    ],
)
def test_keys_that_describe_no_planner_are_named_with_their_place_and_a_remedy(keys, says):
    class Case(msgspec.Struct):
        planner: OutsidePlanner

    with pytest.raises(InputError, match=rf"^campaign.toml: planner: .*{says}"):
        convert({"planner": keys}, Case, "campaign.toml")


def test_keys_are_checked_in_python_too():
    with pytest.raises(InputError, match="either a command or python"):
        OutsidePlanner()


@pytest.mark.parametrize(
    ("program", "says"),
    [
        ("./no_such", "there is no program './no_such' in"),
        ("no-such-planner", "there is no program 'no-such-planner' on the PATH; correct the command"),
        ("./plain", "./plain is not executable; chmod"),
        ("./bad_first_line", "names an interpreter that does not exist"),
        ("./no_first_line", "./no_first_line cannot be started: Exec format error"),
        ("nul\0", "cannot be started: embedded null byte"),
    ],
)
def test_a_command_that_cannot_be_started(tmp_path, scenario, program, says):
    for name, text in (("plain", ""), ("bad_first_line", "#!/no/such\n"), ("no_first_line", "exit\n")):
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o644 if name == "plain" else 0o755)
    planner = OutsidePlanner((program, "{output}"))
    with pytest.raises(PlannerError, match=f"^planner .*{says}"):
        plan_outside(planner, scenario, 1, tmp_path)


def test_a_failure_says_how_it_ended_and_what_was_said_last(command, python):
    text = "import sys; sys.stderr.write('first\\n\\x1b[31mno way\\x1b[0m  out\\n\\n'); print('out'); sys.exit(3)"
    message = failure(command, text)
    assert message.startswith(f"planner {sys.executable} script.py"[:50])
    assert message.endswith(": it failed with exit code 3: no way out")
    message = failure(python, "def plan(scenario, seed): print('so far'); return 1 / 0")
    assert message == "planner mine:plan: it failed with exit code 1: ZeroDivisionError: division by zero"


def test_what_was_said_is_the_same_each_time(command):
    text = "import sys; sys.exit('cannot write ' + sys.argv[2])"
    assert failure(command, text).endswith("exit code 1: cannot write output/path.csv")


def test_a_crash_names_the_signal(command, python):
    text = "import os, signal\n{}os.kill(os.getpid(), signal.SIGSEGV)"
    assert failure(command, text.format("")).endswith("it was killed by SIGSEGV")
    assert failure(python, text.format("plan = lambda *_: ")).endswith("it was killed by SIGSEGV")


def test_an_endless_loop_is_stopped(command, python):
    text = "import sys\n{}\n    sys.stderr.write('thinking\\n')\n    while True: pass"
    says = "stopped after 0.5 s without a path; give it a longer timeout: thinking"
    assert failure(command, text.format("if True:"), timeout=0.5).endswith(says)
    assert failure(python, text.format("def plan(scenario, seed):"), timeout=0.5).endswith(says)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "path.csv: is empty"),
        ("x,y\n", "path.csv: a path needs at least two points, this has 0; add points"),
        ("x,y\n1,2\n", "path.csv: a path needs at least two points, this has 1; add points"),
        ("x,y\n1,2\nnan,3\n", "path.csv: line 3: 'nan' is not a finite number"),
        ("no path found\n", "path.csv: line 1: there is only one column"),
        ("lat,lon\n47,8\n47.1,8\n", "here: this scenario has no place on the planet, but the path has; give it origin"),
    ],
)
def test_a_file_that_is_no_path_is_named_with_its_planner(command, text, says):
    message = failure(command, writes(text))
    assert f": {says}" in message
    assert message.startswith(f"planner {sys.executable}"[:50])


def test_a_planner_that_writes_no_path(command):
    assert "it ended without writing path.csv" in failure(command, "")
    assert "path.csv: is a directory" in failure(command, "import os, sys; os.mkdir(sys.argv[2])")


def test_any_path_file_will_do_and_what_is_not_taken_is_noted(command):
    plan = "QGC WPL 110\n" + "".join(
        f"{i}\t{int(i == 0)}\t3\t{command}\t{p}\t{q}\t0\t0\t{lat}\t8\t50\t1\n"
        for i, (command, p, q, lat) in enumerate([(16, 0, 0, 47), (178, 1, 25, 0), (16, 0, 0, 47), (16, 0, 0, 47.001)])
    )
    scenario = Scenario(
        name="here",
        map=Map(frame=Frame(47.0, 8.0)),
        starts=np.array([[0.0, 0.0]]),
        goals=np.array([[0.0, 100.0]]),
        size=(10.0, 200.0),
    )
    planned = command(writes(plan), output="mission.waypoints", scenario=scenario)
    assert planned.path.frame == scenario.map.frame
    assert planned.path.xy == pytest.approx(np.array([[0.0, 0.0], [0.0, 111.17]]), abs=0.05)
    assert "its speed of 25 m/s is not taken" in planned.notes


def test_a_geographic_path_is_moved_into_the_frame_of_the_scenario(command, scenario):
    scenario = replace(scenario, map=Map(frame=Frame(46.999, 8.0)))
    planned = command(writes("lat,lon\n47,8\n47.001,8\n"), scenario=scenario)
    assert planned.path.xy == pytest.approx(np.array([[0.0, 111.17], [0.0, 222.34]]), abs=0.05)


@pytest.mark.parametrize(
    "rows", ["((0, 0, 5), (1, 2, 6))", "np.array([[0, 0, 5], [1, 2, 6]])", "iter([[0, 0, 5], [1, 2, 6]])"]
)
def test_a_callable_may_return_any_rows_of_numbers(python, rows):
    planned = python(f"import numpy as np\ndef plan(scenario, seed): return {rows}")
    assert planned.path.points.tolist() == [[0.0, 0.0, 5.0], [1.0, 2.0, 6.0]]


@pytest.mark.parametrize(
    ("returned", "says"),
    [
        ("None", "mine:plan returned NoneType None, not rows of x, y or x, y, z"),
        ("[1, 2]", r"mine:plan returned list \[1, 2\], not rows"),
        ("[[0, 0], [1, 2, 3]]", "not rows"),
        ("[[0], [1]]", "not rows"),
        ("['ab', 'cd']", "not rows"),
        ("[]", "path.csv: a path needs at least two points, this has 0"),
        ("[[0, 0], [float('nan'), 1]]", "path.csv: line 3: 'nan' is not a finite number"),
    ],
)
def test_a_callable_that_returns_no_path(python, returned, says):
    with pytest.raises(PlannerError, match=f"^planner mine:plan: .*{says}"):
        python(f"def plan(scenario, seed): return {returned}")


def test_a_callable_that_is_not_there(python):
    assert failure(python, "", "mine:plan").endswith("AttributeError: module 'mine' has no attribute 'plan'")
    assert failure(python, "plan = 3", "mine:plan").endswith("mine:plan is not callable")


@pytest.mark.parametrize("name", ["path", "errors", "planners", "json_text"])
def test_a_module_may_have_a_name_of_ours(python, name):
    assert python(MODULE, f"{name}:straight").path.points.tolist() == STRAIGHT


def test_our_modules_do_not_hide_those_of_a_planner(python):
    text = "from importlib.util import find_spec\ndef plan(*_): print(find_spec('clearance')); return [[0, 0], [1, 1]]"
    assert python(text).stderr == "None"


def test_a_callable_gets_scenario_and_seed_and_may_print(python):
    planned = python("def plan(scenario, seed): print(scenario['name'], seed); return [[0, 0], [1, 1]]", seed=5)
    assert planned.stderr == "here 5"


def test_a_failure_crosses_processes_whole():
    error = pickle.loads(pickle.dumps(PlannerError("planner a: it failed", "all it said")))
    assert isinstance(error, TrackworthyError)
    assert (str(error), error.stderr, error.exit_code) == ("planner a: it failed", "all it said", 3)
