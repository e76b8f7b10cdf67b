import base64
import dataclasses
import gzip
import io
import json
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from planners.errors import InputError
from planners.map import Circle, Map, Raster
from planners.path import Path
from reports.html.columns import Pool, packed, samples
from reports.html.embed import as_json, filled, plotly
from reports.html.page import write_html
from reports.html.pictures import embedded
from reports.html.world import World, map_data, path_data


def unpacked(column, count, kind):
    low, step, codes = column
    if not codes:
        return np.full(count, low)
    found = np.frombuffer(base64.b64decode(codes), kind)
    return np.where(found == np.iinfo(kind).max, np.nan, low + step * found)


def embedded_data(page):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1])


@pytest.fixture(scope="module")
def page(finished, data, tmp_path_factory):
    file = tmp_path_factory.mktemp("page") / "report.html"
    write_html(finished, data, file)
    return file.read_text("utf-8")


def test_same_results_same_bytes(finished, data, page, tmp_path):
    write_html(finished, data, tmp_path / "again.html")
    assert (tmp_path / "again.html").read_text("utf-8") == page
    assert [file.name for file in tmp_path.iterdir()] == ["again.html"]


def test_nothing_is_loaded(page):
    outside = re.sub(r'<script type="text/plain" id="plotly-packed">.*?</script>', "", page, flags=re.DOTALL)
    assert not re.search(r"https?://|//cdn|@import|url\(", outside)
    assert "default-src 'none'" in outside
    assert "connect-src" not in outside
    assert "innerHTML" not in outside
    assert "eval(" not in outside


def test_names_are_data_only(finished, data, page):
    assert page.count("<script") == page.count("</script>") == 3
    assert "<img" not in page
    told = embedded_data(page)
    assert told["told"]["title"] == finished.campaign.title
    assert [row["name"] for row in told["rows"]] == [case.name for case in finished.campaign.cases]
    assert told["about"]["note"] == finished.campaign.note


def test_a_nonce_that_only_the_scripts_of_the_page_know(page):
    nonce = re.search(r"script-src 'nonce-([^']+)'", page)[1]
    assert f'<script nonce="{nonce}">' in page
    assert page.count(nonce) == 2


def test_every_kept_trial_can_be_replayed(finished, page):
    told = embedded_data(page)
    for result in finished.results:
        case = told["cases"][result.case.name]
        assert sorted(run["trial"] for run in case["runs"]) == list(range(1, result.case.trials + 1))
        assert case["runs"][0]["trial"] == result.worst.trial
        assert case["left_out"] == 0


def test_a_replay_is_the_track(finished, page):
    told = embedded_data(page)
    for name, outcome in finished.outcomes.items():
        vehicle = told["cases"][name]["runs"][0]["vehicles"][0]
        t, error, x = (
            unpacked(vehicle["pool"][vehicle["columns"][column]], vehicle["samples"], kind)
            for column, kind in (("t", "<u4"), ("cross_track", "<u2"), ("x", "<u4"))
        )
        track = outcome.track
        assert (t[0], t[-1]) == pytest.approx((track["t"][0], track["t"][-1]), abs=1e-6)
        spread = np.ptp(track["cross_track"])
        assert error.min() == pytest.approx(track["cross_track"].min(), abs=1e-4 * spread)
        assert error.max() == pytest.approx(track["cross_track"].max(), abs=1e-4 * spread)
        assert x == pytest.approx(np.interp(t, track["t"], track["x"]), abs=1e-3)


def test_what_has_no_room_is_counted(finished, data, tmp_path):
    write_html(finished, data, tmp_path / "small.html", limit=len(plotly()) + 60_000)
    page = (tmp_path / "small.html").read_text("utf-8")
    cases = embedded_data(page)["cases"]
    for result in finished.results:
        case = cases[result.case.name]
        assert case["left_out"] == result.case.trials - len(case["runs"])
    assert sum(case["left_out"] for case in cases.values()) > 0


def test_a_damaged_track_is_no_obstacle(finished, data, tmp_path):
    (tmp_path / "tracks").mkdir()
    (tmp_path / "tracks" / "broken.parquet").write_bytes(b"PAR1")
    moved = dataclasses.replace(finished, folder=tmp_path)
    write_html(moved, data, tmp_path / "report.html")
    assert all(
        len(case["runs"]) == 1 for case in embedded_data((tmp_path / "report.html").read_text())["cases"].values()
    )


def test_no_folder_no_page(finished, data, tmp_path):
    with pytest.raises(InputError, match="missing"):
        write_html(finished, data, tmp_path / "missing" / "report.html")


def test_plotly_is_the_packages_own():
    assert b"plotly" in gzip.decompress(base64.b64decode(plotly()))[:200]


@given(st.text())
def test_json_ends_no_script(text):
    told = as_json({text: [text]})
    assert not re.search("[<>&\u2028\u2029]", told)
    assert json.loads(told) == {text: [text]}


def test_what_is_put_in_is_not_a_template():
    assert filled("a{{one}}b{{two}}", {"one": "{{two}}", "two": "{{one}}"}) == "a{{two}}b{{one}}"
    with pytest.raises(KeyError):
        filled("", {"one": ""})


@given(st.lists(st.floats(-1e6, 1e6) | st.just(float("nan")), min_size=1, max_size=50))
def test_columns_keep_a_share_of_their_range(values):
    column = np.array(values)
    known = column[np.isfinite(column)]
    size = np.ptp(known) if len(known) else 0.0
    for wide, kind, share in ((False, "<u2", 65534), (True, "<u4", 4294967294)):
        found = unpacked(packed(column, wide), len(column), kind)
        assert found == pytest.approx(
            column, abs=size / share + 1e-8 * (1.0 + np.abs(known).max(initial=0.0)), nan_ok=True
        )


def test_a_column_is_kept_once():
    pool = Pool()
    assert [pool.add(np.array(values)) for values in ([1.0, 2.0], [3.0, 3.0], [1.0, 2.0])] == [0, 1, 0]
    assert pool.columns[1] == [3.0, 0, ""]


def test_samples_keep_the_line_and_the_worst(route):
    track = route.track
    kept = samples(track, route.corridor, 400)
    assert len(kept) <= 440
    assert {0, len(track) - 1, int(np.argmax(np.abs(track["cross_track"])))} <= set(kept.tolist())
    x, y, error = (np.interp(track["t"], track["t"][kept], track[column][kept]) for column in ("x", "y", "cross_track"))
    assert np.hypot(x - track["x"], y - track["y"]).max() < 0.2 * route.corridor
    assert np.abs(error - track["cross_track"]).max() < 0.02 * np.ptp(track["cross_track"])


def test_a_map_as_rings():
    square = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)])
    area = Map(
        polygons=(square, square[::-1] + 2.0), circles=(Circle(20.0, 0.0, 3.0),), bounds=(-1.0, -1.0, 30.0, 30.0)
    )
    told = map_data(area)
    assert len(told["solid"]) == 2  # what overlaps is one, whichever way round it was given
    for ring in told["solid"]:
        x, y = np.array(ring).reshape(-1, 2).T
        assert np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) > 0.0  # counter-clockwise
    assert told["bounds"] == [-1.0, -1.0, 30.0, 30.0]


def test_cells_are_a_picture_from_the_south_on():
    told = map_data(Map(raster=Raster(np.array([[True, False, False], [False, False, False]]), 2.0, 5.0, 6.0)))
    raster = told["raster"]
    assert (raster["x"], raster["y"], raster["width"], raster["height"]) == (5.0, 6.0, 6.0, 4.0)
    assert (raster["columns"], raster["rows"]) == (3, 2)
    picture = Image.open(io.BytesIO(base64.b64decode(raster["picture"].partition(",")[2]))).convert("RGBA")
    assert picture.size == (3, 2)
    assert [picture.getpixel((0, row))[3] for row in (0, 1)] == [255, 0]


def test_a_path_and_its_corridor():
    told = path_data(Path(np.array([(0.0, 0.0), (1000.0, 0.0)])), 25.0)
    assert told["line"] == [0.0, 0.0, 1000.0, 0.0]
    x, y = np.array(told["corridor"][0]).reshape(-1, 2).T
    assert (x.min(), x.max(), y.min(), y.max()) == pytest.approx((0.0, 1000.0, -25.0, 25.0), abs=1.0)


def test_maps_and_paths_are_told_once(route, yard):
    world = World()
    assert [world.map(one) for one in (route.obstacles, None, yard.obstacles, route.obstacles)] == [0, None, 1, 0]
    assert [world.path(one.path, one.corridor) for one in (route, yard, route)] == [0, 1, 0]


def test_paper_stays_white(tmp_path):
    noise = np.random.default_rng(1).integers(200, 256, (200, 300, 3), dtype=np.uint8)
    noise[:40] = 255
    Image.fromarray(noise).save(tmp_path / "a.png")
    source = embedded({"file": "a.svg"}, tmp_path, 10**6)[0]["source"]
    picture = Image.open(io.BytesIO(base64.b64decode(source.partition(",")[2]))).convert("RGB")
    assert picture.getpixel((5, 5)) == (255, 255, 255)


def test_pictures_within_their_room(tmp_path):

    Image.new("RGB", (1600, 400), "#0072b2").save(tmp_path / "a.1.png")
    Image.new("RGB", (1600, 400), "#d55e00").save(tmp_path / "b.png")
    told = {
        "plans": [{"pictures": [{"file": "a.1.svg", "caption": "one"}, {"file": "gone.svg"}]}],
        "figures": ["b.svg"],
    }
    found, left = embedded(told, tmp_path, 100_000)
    one, gone = found["plans"][0]["pictures"]
    other = found["figures"][0]
    assert one["caption"] == "one"
    assert one["source"].startswith("data:image/png;base64,")
    assert gone["source"] == ""
    assert other["source"] not in ("", one["source"])
    assert left == 100_000 - len(one["source"]) - len(other["source"])
    assert embedded(told, tmp_path, len(other["source"]))[0]["plans"][0]["pictures"][0]["source"] == one["source"]
    assert embedded(told, tmp_path, 10)[0]["figures"] == [{**other, "source": ""}]
