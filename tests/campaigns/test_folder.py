"""One folder holds one campaign, of one run at a time, and loses nothing."""

import os
import sqlite3
import subprocess
import sys

import pytest

from campaigns.campaign import load_campaign
from campaigns.folder import opened
from campaigns.ready import make_ready
from planners.errors import InputError
from small_campaigns import ROAD, run_here, write_campaign

FEW = ROAD.replace("trials = 20", "trials = 3")
# Runs a campaign with a limit on the size of any file, as a full quota has it
LIMITED = """
import resource, signal, sys
resource.setrlimit(resource.RLIMIT_FSIZE, ({limit}, resource.RLIM_INFINITY))
from trackworthy.__main__ import main
if __name__ == "__main__":
    sys.exit(main(["run", {file!r}, "-o", {folder!r}, "-j", "1"]))
"""


def enter(file, folder, fresh=False):
    campaign = load_campaign(str(file))
    return opened(folder, campaign, make_ready(campaign), fresh)


def test_a_folder_in_use_is_refused_and_names_the_process(tmp_path):
    file = write_campaign(tmp_path, FEW)
    out, told = tmp_path / "out", f"in use by process {os.getpid()}; wait"
    with enter(file, out), pytest.raises(InputError, match=told), enter(file, out):
        pass
    with enter(file, tmp_path / "out"):
        pass


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (("name", '"small"', '"other"'), "another campaign, 'small'"),
        (("seed", "seed = 1", "seed = 2"), "the campaign or its files have changed"),
        (("speed", "45km/h", "46km/h"), "'road' is not the same"),
        (("noise", "0.01", "0.02"), "'road' is not the same"),
    ],
)
def test_a_folder_of_something_else_is_refused_with_the_remedy(tmp_path, change, told):
    file = write_campaign(tmp_path, FEW)
    with enter(file, tmp_path / "out"):
        pass
    _, old, new = change
    file.write_text(file.read_text().replace(old, new))
    with pytest.raises(InputError, match="-o, or start anew with --fresh") as refused, enter(file, tmp_path / "out"):
        pass
    assert told in str(refused.value)
    with enter(file, tmp_path / "out", fresh=True):
        pass


def test_a_changed_path_file_is_another_campaign(tmp_path):
    file = write_campaign(tmp_path, FEW)
    with enter(file, tmp_path / "out"):
        pass
    (tmp_path / "road.csv").write_text("x,y\n0,0\n100,0\n")
    with pytest.raises(InputError, match="'road' is not the same"), enter(file, tmp_path / "out"):
        pass


def test_other_code_is_refused(tmp_path, monkeypatch):
    file = write_campaign(tmp_path, FEW)
    with enter(file, tmp_path / "out"):
        pass
    monkeypatch.setattr("campaigns.manifest.fingerprint", lambda: "0" * 64)
    with pytest.raises(InputError, match="another version of trackworthy"), enter(file, tmp_path / "out"):
        pass


def test_a_damaged_manifest_is_refused(tmp_path):
    file = write_campaign(tmp_path, FEW)
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "manifest.json").write_text("{")
    with pytest.raises(InputError, match="is damaged, or of another version"), enter(file, tmp_path / "out"):
        pass


def test_fresh_removes_what_a_run_made_and_nothing_else(tmp_path):
    file = write_campaign(tmp_path, FEW)
    run_here(file, tmp_path / "out")
    (tmp_path / "out" / "notes.txt").write_text("mine")
    with enter(file, tmp_path / "out", fresh=True) as store:
        assert store.finished() == set()
    assert (tmp_path / "out" / "notes.txt").read_text() == "mine"


@pytest.mark.parametrize("mine", ["figures/mine.png", "summary.json", "report.pdf", "campaign.toml", "results.sqlite"])
@pytest.mark.parametrize("fresh", [False, True])
def test_a_folder_with_files_that_a_run_would_overwrite_is_refused(tmp_path, mine, fresh):
    file = write_campaign(tmp_path, FEW)
    (tmp_path / "out" / mine).parent.mkdir(parents=True)
    (tmp_path / "out" / mine).write_text("mine")
    with (
        pytest.raises(InputError, match=f"holds {mine}, and no results .*; give another folder with -o"),
        enter(file, tmp_path / "out", fresh),
    ):
        pass
    assert (tmp_path / "out" / mine).read_text() == "mine"


def test_fresh_leaves_what_users_put_among_the_results(tmp_path):
    file = write_campaign(tmp_path, FEW)
    run_here(file, tmp_path / "out")
    for folder in ("tracks", "inputs"):
        (tmp_path / "out" / folder / "mine.txt").write_text("mine")
    with enter(file, tmp_path / "out", fresh=True):
        pass
    left = {path.relative_to(tmp_path / "out").as_posix() for path in (tmp_path / "out").rglob("*") if path.is_file()}
    assert {"tracks/mine.txt", "inputs/mine.txt"} <= left
    assert not any(path.endswith(".parquet") for path in left)


def test_fresh_does_not_remove_the_campaign_that_is_to_be_run(tmp_path):
    run_here(write_campaign(tmp_path, FEW), tmp_path / "out")
    resolved = tmp_path / "out" / "campaign.toml"
    before = resolved.read_bytes()
    with pytest.raises(InputError, match="--fresh would remove the campaign"), enter(resolved, tmp_path / "out", True):
        pass
    assert resolved.read_bytes() == before


def test_more_trials_go_on_from_those_there_are(tmp_path):
    file = write_campaign(tmp_path, FEW)
    run_here(file, tmp_path / "out")
    file.write_text(file.read_text().replace("trials = 3", "trials = 5"))
    tried = []
    from campaigns.execute import execute
    from small_campaigns import InThisProcess

    campaign = load_campaign(str(file))

    def watch(results, tasks, total):
        tried.extend(task.trial for task in tasks)
        return list(results)

    (result,) = execute(campaign, make_ready(campaign), tmp_path / "out", InThisProcess(), watch).results
    assert tried == [4, 5]
    assert result.statistics.tried == 5


def test_a_folder_that_cannot_be_made_is_one_line(tmp_path):
    file = write_campaign(tmp_path, FEW)
    (tmp_path / "out").write_text("a file")
    with (
        pytest.raises(InputError, match="cannot be written to: File exists; give another with -o"),
        enter(file, tmp_path / "out"),
    ):
        pass


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_read_only_folder_is_one_line(tmp_path):
    file = write_campaign(tmp_path, FEW)
    (tmp_path / "out").mkdir(mode=0o500)
    with pytest.raises(InputError, match="cannot be written to"), enter(file, tmp_path / "out"):
        pass


def test_a_full_disk_is_told_and_loses_nothing_stored(tmp_path):
    """A limit on the size of files stands for the quota: the database stops growing in the middle of the run."""
    file = write_campaign(tmp_path, ROAD.replace("trials = 20", "trials = 60"))
    folder = tmp_path / "out"
    script = tmp_path / "limited.py"
    script.write_text(LIMITED.format(limit=120_000, file=str(file), folder=str(folder)))
    ended = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=120)
    assert ended.returncode == 3, ended.stderr
    last = ended.stderr.strip().splitlines()[-1]
    assert "results.sqlite: cannot be used: " in last
    assert "what was stored before is kept; make room and run the same command again" in last
    assert "Traceback" not in ended.stderr
    with sqlite3.connect(folder / "results.sqlite") as db:
        before = db.execute("SELECT * FROM trials ORDER BY key").fetchall()
    db.close()
    assert 0 < len(before) < 60
    run_here(file, folder)
    with sqlite3.connect(folder / "results.sqlite") as db:
        after = db.execute("SELECT * FROM trials ORDER BY key").fetchall()
    db.close()
    assert len(after) == 60
    assert set(before) <= set(after)
    run_here(file, tmp_path / "whole")
    assert (folder / "summary.json").read_bytes() == (tmp_path / "whole" / "summary.json").read_bytes()


def test_the_campaigns_own_folder_is_refused(tmp_path):
    file = write_campaign(tmp_path, FEW)
    with pytest.raises(InputError, match="is the folder of the campaign itself; give another"), enter(file, tmp_path):
        pass


@pytest.mark.parametrize("fresh", [False, True])
def test_what_a_killed_run_was_writing_goes_with_the_next(tmp_path, fresh):
    """A SIGKILL between the writing of a file and its renaming leaves a file that is none."""
    file, out = write_campaign(tmp_path, FEW, head='keep_tracks = "all"'), tmp_path / "out"
    run_here(file, out)
    tracks = sorted(path.name for path in (out / "tracks").iterdir())
    for left in (f"tracks/.{tracks[0]}.12345.tmp", ".summary.json.12345.tmp"):
        (out / left).write_bytes(b"PAR1")
    (out / "tracks" / ".mine.tmp").touch()
    with enter(file, out, fresh):
        assert sorted(path.name for path in (out / "tracks").iterdir()) == [".mine.tmp", *([] if fresh else tracks)]
        assert not (out / ".summary.json.12345.tmp").exists()
