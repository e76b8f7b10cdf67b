"""The folder of a campaign's results: one run at a time, one campaign, and nothing else touched."""

from __future__ import annotations

import contextlib
import fcntl
import os
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from campaigns.campaign import Campaign
from campaigns.manifest import check_same, manifest_of, read_manifest, write_manifest
from campaigns.ready import ReadyCase
from campaigns.search_ready import ReadySearch
from campaigns.store import Store
from planners.errors import InputError

# What a run makes; --fresh removes this and nothing else, the manifest last
MADE = (
    "campaign.toml", "inputs/*/*", "results.sqlite", "results.sqlite-wal", "results.sqlite-shm", "plans/*.csv",
    "plans/*.json", "plans/*.log", "tracks/*.parquet", "searches/*.json", "figures/*.png", "figures/*.svg",
    "report.pdf", "report.html", "junit.xml", "summary.md", "summary.json", "manifest.json",
)  # fmt: skip
FOLDERS = ("inputs/*", "inputs", "plans", "tracks", "searches", "figures")
ELSEWHERE = "give another folder with -o"


@contextmanager
def opened(
    folder: Path,
    campaign: Campaign,
    cases: Sequence[ReadyCase],
    fresh: bool = False,
    searches: Sequence[ReadySearch] = (),
) -> Iterator[Store]:
    """The store in `folder`, which is made where it does not exist, and locked meanwhile.

    Raises `InputError` with the remedy for a folder in use, of another campaign, or that may not be written to.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = os.open(folder / ".lock", os.O_RDWR | os.O_CREAT, 0o644)
    except OSError as error:
        raise InputError(str(folder), f"cannot be written to: {error.strerror}", "give another with -o") from error
    try:
        _lock(lock, folder)
        manifest, file = manifest_of(campaign, cases, searches), folder / "manifest.json"
        if fresh and file.exists():
            if campaign.folder.resolve() == folder.resolve():
                raise InputError(str(folder), "--fresh would remove the campaign that is to be run", ELSEWHERE)
            clear(folder)
        found = read_manifest(file)
        if found is not None:
            check_same(found, manifest, folder)
            _forget_unfinished(folder)
        elif campaign.folder.resolve() == folder.resolve():
            raise InputError(str(folder), "is the folder of the campaign itself", ELSEWHERE)
        elif foreign := next((path for name in MADE for path in folder.glob(name)), None):
            raise InputError(
                str(folder), f"holds {foreign.relative_to(folder)}, and no results of a campaign", ELSEWHERE
            )
        write_manifest(manifest, file)
        store = Store(folder / "results.sqlite")
        try:
            yield store
        finally:
            store.close()
    finally:
        os.close(lock)


def clear(folder: Path) -> None:
    """Remove the results in `folder`; anything else stays."""
    _forget_unfinished(folder)
    for name in MADE:
        for path in folder.glob(name):
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path)  # what belongs to an input
            else:
                path.unlink()
    for name in FOLDERS:
        for path in folder.glob(name):
            with contextlib.suppress(OSError):  # something else is in it
                path.rmdir()


def _forget_unfinished(folder: Path) -> None:
    """Remove what a killed run was writing (`atomic`); the lock says that nobody is at it any more."""
    for name in MADE:
        for path in folder.glob(str(Path(name).with_name(f".{Path(name).name}.*.tmp"))):
            path.unlink()


def _lock(lock: int, folder: Path) -> None:
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        owner = os.pread(lock, 20, 0).decode(errors="replace").strip() or "another process"
        remedy = "wait for it, or give another folder with -o"
        raise InputError(str(folder), f"is in use by process {owner}", remedy) from None
    os.ftruncate(lock, 0)
    os.pwrite(lock, str(os.getpid()).encode(), 0)
