import operator
import os
import signal
import time

import pytest

from campaigns.workers import WorkerDiedError, Workers, WorkerTimedOutError


@pytest.fixture
def workers():
    made = Workers(2, timeout=60.0)
    yield made
    made.shutdown(cancel_futures=True)


def alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def gone(pids, within=10.0):
    end = time.monotonic() + within
    while any(map(alive, pids)) and time.monotonic() < end:
        time.sleep(0.05)
    return not any(map(alive, pids))


def test_results_and_errors_come_back(workers):
    assert workers.submit(operator.add, 2, 3).result() == 5
    with pytest.raises(ZeroDivisionError):
        workers.submit(operator.truediv, 1, 0).result()


def test_tasks_run_in_other_processes(workers):
    assert workers.submit(os.getpid).result() != os.getpid()


@pytest.mark.parametrize("dying", [(os.abort,), (os._exit, 0), (os._exit, 139)])
def test_a_process_that_dies_costs_its_task_and_is_replaced(workers, dying):
    futures = [workers.submit(operator.neg, i) for i in range(5)]
    dead = workers.submit(*dying)
    futures += [workers.submit(operator.neg, i) for i in range(5, 10)]
    with pytest.raises(WorkerDiedError):
        dead.result()
    assert [future.result() for future in futures] == [-i for i in range(10)]


@pytest.mark.parametrize("sent", [signal.SIGKILL, signal.SIGTERM])
def test_a_process_killed_from_outside_costs_its_task(sent):
    workers = Workers(1, timeout=60.0)
    try:
        pid = workers.submit(os.getpid).result()
        future = workers.submit(time.sleep, 30.0)
        time.sleep(0.3)
        os.kill(pid, sent)
        with pytest.raises(WorkerDiedError):
            future.result(10.0)
        assert workers.submit(operator.neg, 1).result() == -1
    finally:
        workers.shutdown(cancel_futures=True)


def test_a_task_that_hangs_is_killed_with_its_process(monkeypatch):
    monkeypatch.setattr("campaigns.workers.START_UP", 0.0)
    workers = Workers(1, timeout=1.0)
    try:
        pid = workers.submit(os.getpid).result()
        with pytest.raises(WorkerTimedOutError, match="longer than 1 s"):
            workers.submit(time.sleep, 60.0).result()
        assert gone([pid])
        assert workers.submit(operator.neg, 1).result() == -1
    finally:
        workers.shutdown(cancel_futures=True)


def test_an_orderly_end_waits_for_what_is_under_way():
    workers = Workers(2, timeout=60.0)
    futures = [workers.submit(operator.neg, i) for i in range(20)]
    workers.shutdown()
    assert [future.result() for future in futures] == [-i for i in range(20)]


def test_breaking_off_leaves_no_process():
    workers = Workers(2, timeout=60.0)
    pids = [workers.submit(os.getpid).result() for _ in range(4)]
    futures = [workers.submit(time.sleep, 60.0) for _ in range(6)]
    begun = time.monotonic()
    workers.shutdown(cancel_futures=True)
    assert time.monotonic() - begun < 20.0
    assert gone(pids)
    assert all(future.done() for future in futures)
