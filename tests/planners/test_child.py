import signal
import sys
import time

import pytest

from planners.child import TAIL_BYTES, run_child

# Its child writes a heartbeat for ever; {prelude} runs in the child first.
PARENT = """
import subprocess, sys, time
subprocess.Popen([sys.executable, "-c", '''
import os, time
{prelude}
while True:
    open("beat", "a").write(".")
    time.sleep(0.01)
'''])
while not __import__("os").path.exists("beat"):
    time.sleep(0.01)
print("started", flush=True)
{then}
"""


def run(tmp_path, text, timeout=20.0):
    return run_child([sys.executable, "-c", text], tmp_path, timeout)


def silent(beat):
    """Whether a heartbeat has stopped."""
    before = beat.stat().st_size
    time.sleep(0.15)
    return beat.stat().st_size == before


def test_a_program_runs_in_the_folder_and_what_it_says_is_kept_errors_last(tmp_path):
    (tmp_path / "here").touch()
    text = "import os, sys; sys.stderr.write('oh\\n'); print(os.listdir()); sys.exit(3)"
    ended = run(tmp_path, text)
    assert (ended.code, ended.said) == (3, "['here']\noh")


def test_a_program_gets_no_input(tmp_path):
    assert run(tmp_path, "import sys; print(repr(sys.stdin.read()))").said == "''"


def test_sets_of_a_python_program_come_in_the_same_order(tmp_path, monkeypatch):
    monkeypatch.delenv("PYTHONHASHSEED", raising=False)
    first, second = (run(tmp_path, "print(hash('trackworthy'))").said for _ in range(2))
    assert first == second


@pytest.mark.parametrize("stream", ["stdout", "stderr"])
def test_of_much_output_the_end_is_kept(tmp_path, stream):
    text = f"import sys\nfor _ in range(100): sys.{stream}.write('x' * 2**20)\nsys.{stream}.write('the end')"
    ended = run(tmp_path, text)
    assert ended.code == 0
    assert len(ended.said) == TAIL_BYTES
    assert ended.said.endswith("xthe end")


def test_a_program_that_takes_too_long_is_killed_with_its_children(tmp_path):
    ended = run(tmp_path, PARENT.format(prelude="", then="time.sleep(60)"), timeout=1.0)
    assert (ended.code, ended.said) == (None, "started")
    assert silent(tmp_path / "beat")


def test_children_that_outlive_a_program_are_killed(tmp_path):
    ended = run(tmp_path, PARENT.format(prelude="", then=""))
    assert (ended.code, ended.said) == (0, "started")
    assert silent(tmp_path / "beat")


def test_a_child_that_left_the_group_and_holds_the_pipe_blocks_nobody(tmp_path):
    prelude = "os.setsid(); import threading; threading.Timer(5, lambda: os._exit(0)).start()"
    start = time.monotonic()
    ended = run(tmp_path, PARENT.format(prelude=prelude, then=""))
    assert (ended.code, ended.said) == (0, "started")
    assert time.monotonic() - start < 4.0


@pytest.mark.parametrize("interruption", [KeyboardInterrupt, SystemExit])
def test_an_interruption_of_ours_leaves_nothing_running(tmp_path, interruption):
    def interrupt(*_):
        raise interruption

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 1.0)
        with pytest.raises(interruption):
            run(tmp_path, PARENT.format(prelude="", then="time.sleep(60)"))
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert silent(tmp_path / "beat")
