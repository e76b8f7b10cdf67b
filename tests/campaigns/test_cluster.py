"""Against a real scheduler with two worker processes on loopback."""

import os
import signal
import socket
import subprocess
import sys
import time

import pytest

from campaigns.campaign import load_campaign
from campaigns.cluster import Cluster
from campaigns.execute import Machines, execute
from campaigns.ready import make_ready
from campaigns.workers import WorkerDiedError
from planners.errors import InputError
from small_campaigns import AIR, ROAD, run_here, write_campaign

pytest.importorskip("distributed")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    """A scheduler, and two workers in a folder of their own that see nothing of ours."""
    folder = tmp_path_factory.mktemp("cluster")
    address = f"tcp://127.0.0.1:{free_port()}"
    dask = [sys.executable, "-m", "dask"]
    commands = [
        [*dask, "scheduler", "--host", "127.0.0.1", "--port", address.rpartition(":")[2], "--no-dashboard"],
        *([*dask, "worker", address, "--nthreads", "1", "--no-dashboard"] for _ in range(2)),
    ]
    with open(folder / "log", "w") as log:
        options = {"cwd": folder, "stdout": log, "stderr": log, "start_new_session": True}
        processes = [subprocess.Popen(command, **options) for command in commands]
    try:
        wait_for_workers(address, processes, folder / "log")
        yield address
    finally:
        for process in processes:
            os.killpg(process.pid, signal.SIGTERM)
        for process in processes:
            process.wait(20)


def wait_for_workers(address, processes, log):
    from distributed import Client

    end = time.monotonic() + 60.0
    while time.monotonic() < end:
        assert all(process.poll() is None for process in processes), log.read_text()
        try:
            with Client(address, timeout="5s", set_as_default=False) as client:
                client.wait_for_workers(2, timeout=60.0)
                return
        except OSError:
            time.sleep(0.2)
    raise AssertionError(log.read_text())


def summary(folder):
    return (folder / "summary.json").read_bytes()


def test_the_same_bytes_as_in_this_process(address, tmp_path):
    few = ROAD.replace("trials = 20", "trials = 6") + AIR.replace("trials = 20", "trials = 2")
    file = write_campaign(tmp_path, few, head='seed = 1\nkeep_tracks = "all"')
    campaign = load_campaign(str(file))
    execute(campaign, make_ready(campaign), tmp_path / "far", Machines(1, address), lambda one, *_: list(one))
    run_here(file, tmp_path / "here")
    assert summary(tmp_path / "far") == summary(tmp_path / "here")
    far, here = (
        {track.name: track.read_bytes() for track in (tmp_path / where / "tracks").iterdir()}
        for where in ("far", "here")
    )
    assert far == here
    assert len(far) == 8


def test_a_process_that_dies_costs_its_task_and_no_dask_worker(address):
    cluster = Cluster(address, timeout=60.0)
    try:
        futures = [cluster.submit(divmod, i, 3) for i in range(4)]
        with pytest.raises(WorkerDiedError):
            cluster.submit(os.abort).result(60)
        assert [future.result(60) for future in futures] == [divmod(i, 3) for i in range(4)]
        assert cluster.submit(divmod, 7, 2).result(60) == (3, 1)
        assert cluster.width == 4
    finally:
        cluster.shutdown()


def test_nobody_at_the_address_is_one_line(monkeypatch):
    monkeypatch.setattr("campaigns.cluster.CONNECT_WITHIN", "1s")
    with pytest.raises(InputError, match=r"no dask scheduler answers .*give it as tcp://host:8786"):
        Cluster(f"tcp://127.0.0.1:{free_port()}", timeout=1.0)


def test_workers_with_another_version_are_refused(address, monkeypatch):
    monkeypatch.setattr("campaigns.manifest._versions", lambda: {"numpy": "0.1"})
    with pytest.raises(InputError, match="has another version of trackworthy"):
        Cluster(address, timeout=1.0)
