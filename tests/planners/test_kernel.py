import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import planners

SAYS_FOLDER = "import numba, planners.kernel; print(numba.config.CACHE_DIR)"


def folder_of(root, **environment):
    """Where a fresh process with the code in `root` keeps its kernels."""
    told = subprocess.run(
        [sys.executable, "-c", SAYS_FOLDER], cwd=root, env={**os.environ, **environment}, capture_output=True, text=True
    )
    assert told.returncode == 0, told.stderr
    return Path(told.stdout.strip())


def copied(tmp_path):
    shutil.copytree(Path(planners.__file__).parent, tmp_path / "planners", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def test_changed_code_keeps_its_kernels_elsewhere(tmp_path):
    root = copied(tmp_path)
    before = folder_of(root)
    assert before == folder_of(root)
    assert before.parent == root / "planners" / "__pycache__"
    with (root / "planners" / "segments.py").open("a") as file:
        file.write("# changed\n")
    after = folder_of(root)
    assert after != before
    assert before.exists()  # another process may still work with it
    os.utime(before, (time.time() - 90_000.0,) * 2)
    assert folder_of(root) == after
    assert not before.exists()


def test_a_users_own_cache_counts(tmp_path):
    assert folder_of(copied(tmp_path), NUMBA_CACHE_DIR=str(tmp_path / "own")) == tmp_path / "own"
