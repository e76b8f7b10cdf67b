import numpy as np
import pytest

from reports.figures.decimate import envelope, polyline


def test_keeps_spikes_and_ends():
    y = np.zeros(20_000)
    y[7777], y[12345] = 5.0, -3.0
    kept = envelope(np.arange(20_000.0), y, 500)
    assert {0, 7777, 12345, 19_999} <= set(kept.tolist())
    assert len(kept) < 2100
    assert (np.diff(kept) > 0).all()


def test_keeps_gaps():
    y = np.zeros(20_000)
    y[4000:4100] = np.nan
    kept = envelope(np.arange(20_000.0), y, 500)
    assert np.isnan(y[kept]).any()


@pytest.mark.parametrize("count", [0, 1, 2, 999])
def test_short_lines_stay(count):
    assert len(envelope(np.arange(float(count)), np.zeros(count), 500)) == count


def test_all_nan():
    assert len(envelope(np.full(3000, np.nan), np.full(3000, np.nan), 500)) <= 1502


def test_polyline_stays_within_tolerance():
    t = np.linspace(0.0, 6.0, 20_000)
    xy = np.column_stack([100 * t, 50 * np.sin(t)])
    kept = polyline(xy, 0.1, 100)
    assert len(kept) < 400
    assert np.abs(np.interp(xy[:, 0], xy[kept, 0], xy[kept, 1]) - xy[:, 1]).max() < 0.11


def test_polyline_that_crosses_itself():
    t = np.linspace(0.0, 4.0 * np.pi, 1000)
    kept = polyline(np.column_stack([np.cos(t), np.sin(t)]), 0.01, 10)
    assert kept[0] == 0
    assert kept[-1] == 999
    assert (np.diff(kept) > 0).all()


def test_polyline_that_stands_still():
    assert polyline(np.zeros((50, 2)), 0.1, 10)[-1] == 49
