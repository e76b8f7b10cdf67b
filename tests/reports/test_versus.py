"""Cases side by side, in words and as a picture."""

import json
import math
import pickle

import numpy as np
import pytest
from PIL import Image

from campaigns.conditions import ConditionKeys
from campaigns.versus import versus_groups
from reports.figures.style import save, style
from reports.figures.versus_figure import versus_figure
from reports.figures.versus_layout import MOST_ROWS, columns, pages
from reports.pages.versus_section import versus_section
from reports.words.versus_words import change_text, families, share_text, versus_table
from sample_results import made_result
from small_reports import save_figure

CONTROLLERS = ("lqr", "stanley", "pure-pursuit")


def results(trials=20, speeds=("30km/h", "45km/h"), controllers=CONTROLLERS, scale=0.1, worthy=None, **case):
    """Errors grow from controller to controller, the same weather for all."""
    weather = np.random.default_rng(4).normal(1.0, 0.05, trials)
    made = []
    for speed in speeds:
        for i, controller in enumerate(controllers):
            metrics = {
                "cross_track_p95": scale * (1.0 + i) * weather,
                "completion": np.full(trials, 1.0),
                "bank_max": math.radians(20.0) * weather,
                "track_length": 500.0 + weather,
            }
            name = f"{controller} {speed}"
            more = {"controller": controller, "speed": speed, "corridor": 0.25, "name": name, **case}
            made.append(made_result(metrics, worthy, number=len(made) + 1, **more))
    return made


def only_family(made):
    (family,) = families(versus_groups(made, {}))
    return family


def test_groups_of_one_path_and_vehicle_are_one_family_with_a_block_a_speed():
    family = only_family(results())
    assert (family.title, family.about) == ("Controllers on road", "road.csv · truck · no wind")
    assert family.names == ("8.33 m/s (30 km/h)", "12.5 m/s (45 km/h)")
    alone = only_family(results(speeds=["30km/h"], conditions=ConditionKeys(friction=0.5)))
    assert alone.about == "road.csv · truck · 8.33 m/s (30 km/h) · no wind · friction 0.5"
    assert alone.names == ("",)


def test_a_table_tells_value_spread_difference_and_what_it_comes_to():
    made = results(worthy=[True] * 18 + [False] * 2)
    table = versus_table(only_family(made))
    first, second, _ = table["blocks"][0]["rows"]
    assert (first["name"], first["reference"], first["share"]) == ("lqr", "reference", "18 of 20 (68 to 98.8 %)")
    error = second["cells"][table["blocks"][0]["metrics"].index("cross-track error, 95 %")]
    assert error["outcome"] == "worse"
    assert error["change"].startswith("+0.0")
    assert error["change"].endswith(" m)")
    share = second["cells"][table["blocks"][0]["metrics"].index("trackworthy")]
    assert share == {"value": "90 %", "spread": "", "change": "0 points", "outcome": "the same"}
    assert "over trials of the same seed" in table["note"]
    json.dumps(table, allow_nan=False)


def test_one_trial_has_no_interval_and_the_note_says_so():
    table = versus_table(only_family(results(trials=1)))
    row = table["blocks"][0]["rows"][1]
    assert row["share"] == "yes"
    assert all(cell["spread"] == "" and "(" not in cell["change"] for cell in row["cells"])
    assert "One trial each: what chance does is not known." in table["note"]


def test_trials_without_chance_have_no_interval():
    a, b = (made_result({"cross_track_p95": [error] * 20}, controller=f"c{error}") for error in (1.0, 2.0))
    row = versus_table(only_family([a, b]))["blocks"][0]["rows"][1]
    assert row["share"] == "20 of 20, all alike"
    assert (row["cells"][1]["change"], row["cells"][1]["outcome"]) == ("+1 m", "worse")


def test_shares_change_by_points():
    group = versus_groups(
        [*results(2, ["9"], ["a"], worthy=[True, True]), *results(2, ["9"], ["b"], worthy=[True, False])], {}
    )[0]
    assert change_text(group.members[1].differences["trackworthy"]) == "−50 points (−100 to 0)"
    assert share_text(group.members[1].result) == "1 of 2 (1.3 to 98.7 %)"


def test_an_axis_is_logarithmic_where_values_are_far_apart_and_in_degrees_where_they_are_angles():
    shown = {one.metric: one for one in columns(only_family(results()).groups)}
    assert not shown["cross_track_p95"].logarithmic
    assert shown["bank_max"].unit == "°"
    assert shown["bank_max"].low < 20.0 < shown["bank_max"].high
    far = columns(only_family([*results(scale=0.1), *results(scale=900.0, controllers=["l1"])]).groups)[0]
    assert (far.metric, far.logarithmic) == ("cross_track_p95", True)


def overlapping(figure):
    """Pairs of texts that lie on each other, and texts that leave the figure."""
    renderer = figure.canvas.get_renderer()
    figure.draw(renderer)
    texts = [text for text in figure.texts if text.get_text()]
    for axes in figure.axes:
        texts += [axes.xaxis.label, *axes.texts]
        if axes.xaxis.label.get_text():
            low, high = axes.get_xlim()
            texts += [tick for tick in axes.get_xticklabels() if low <= tick.get_position()[0] <= high]
    texts += figure.legends[0].get_texts()
    boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in texts if text.get_text()]
    boxes = [(words, box) for words, box in boxes if box.width]
    outside = [w for w, b in boxes if b.x0 < 0 or b.y0 < 0 or b.x1 > figure.bbox.x1 or b.y1 > figure.bbox.y1]
    on = [(w, v) for i, (w, a) in enumerate(boxes) for v, b in boxes[:i] if a.shrunk(0.98, 0.9).overlaps(b)]
    return outside, on


LONG = "a-very-long-name-without-a-single-space-that-goes-on-and-on-for-ever"
SHAPES = {
    "as usual": {},
    "one trial": {"trials": 1},
    "no successes": {"worthy": [False] * 20},
    "long names": {"controllers": [f"{LONG}-{i}" for i in range(3)], "path": f"{LONG}.csv"},
    "other scripts": {"controllers": ["控制器", "<script>$x^2$", "*_[]#@"], "path": "路.csv"},
    "kilometres": {"scale": 3000.0},
    "a full page": {"controllers": [f"c{i}" for i in range(14)]},
    "much weather": {
        "conditions": ConditionKeys(
            wind="10@270", friction=0.5, mass=1.1, latency=0.1, position_noise=0.1, speed_noise=1.0
        )
    },
}


@pytest.mark.parametrize("shape", SHAPES)
def test_nothing_overlaps_and_nothing_is_cut(shape, tmp_path):
    (part,) = pages(only_family(results(**SHAPES[shape])))
    with style():
        figure = versus_figure(part)
        assert overlapping(figure) == ([], [])
        save(figure, tmp_path / "f.png")
    with Image.open(tmp_path / "f.png") as picture:
        assert picture.size[0] == 1600


def test_the_same_results_give_the_same_bytes(tmp_path):
    for name in ("a", "b"):
        for suffix in ("png", "svg"):
            save_figure(versus_figure, only_family(results()), file=tmp_path / f"{name}.{suffix}")
    for suffix in ("png", "svg"):
        assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()


def test_what_a_page_does_not_hold_is_on_more_pages():
    many = only_family(results(trials=1, controllers=[f"c{i}" for i in range(40)]))
    parts = pages(many)
    assert [sum(len(group.members) for group in part.groups) for part in parts] == [30, 10, 30, 10]
    assert all(sum(len(g.members) + 2 for g in part.groups) <= MOST_ROWS for part in parts)
    assert parts[1].names == ("8.33 m/s (30 km/h) (2 of 2)",)
    assert [group.reference for part in parts for group in part.groups] == [0, -30, 0, -30]
    with style():
        assert overlapping(versus_figure(parts[1])) == ([], [])


def test_a_report_gets_tables_and_the_figures_they_name():
    tables, drawings = versus_section(results(), {})
    assert [table["figures"] for table in tables] == [["versus-1-1-controllers-on-road.svg"]]
    assert [drawing.svg for drawing in drawings] == tables[0]["figures"]
    assert 0.0 < drawings[0].head < 1.0
    (part,) = pickle.loads(pickle.dumps(drawings[0].arguments))  # other processes draw
    assert part.names == ("8.33 m/s (30 km/h)", "12.5 m/s (45 km/h)")
    assert versus_section(results(controllers=["lqr"]), {}) == ([], [])


def test_a_logarithmic_axis_does_not_reach_down_to_rounding():
    errors = {"lqr": 1e-9, "l1": 0.02, "stanley": 20.0}
    cases = [made_result({"cross_track_p95": [value]}, controller=name) for name, value in errors.items()]
    (column,) = columns(versus_groups(cases, {}))
    assert column.logarithmic
    assert 1e-4 < column.low < column.high / 1e4
