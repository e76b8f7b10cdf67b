"""What is seen of the page in windows of several sizes, and of cases without a track or with cells for a map."""

import dataclasses
import io

import numpy as np
import pytest
from PIL import Image

pytest.importorskip("selenium", reason="selenium is not installed: pip install -e '.[dev]'")
from in_browser import numbers, opened, wait
from selenium.webdriver.common.by import By

from campaigns.lanes import Lanes
from campaigns.seeds import plan_seed
from planners.map import Map, Raster
from reports.figures.style import OBSTACLE
from reports.html.page import write_html
from reports.write import campaign_report
from sample_results import unplanned
from small_campaigns import Here

# Upper and lower edges of the controls, the map, the first plot and all plots [px]
EDGES = (
    "const edges = (e) => { const r = e.getBoundingClientRect(); return [r.top, r.bottom]; };"
    "const get = (one) => edges(document.querySelector(one));"
    "return [get('.transport'), get('.map-box'), get('#plots .xy'), get('#plots')]"
)
PIXELS = (
    "const plot = document.getElementById('map');"
    "const scale = /km/.test(plot._fullLayout.xaxis.title.text) ? 1000 : 1;"
    "return arguments[0].map(([x, y]) => projection(plot, scale).at(x, y))"
)


def test_a_case_without_a_track_says_so(browser, finished, tmp_path):
    bare = dataclasses.replace(finished, outcomes={}, folder=tmp_path)
    write_html(bare, campaign_report(bare, Lanes(Here(), 1)).data, tmp_path / "report.html")
    browser.get((tmp_path / "report.html").as_uri())
    assert numbers(browser) == [1, 2, 3]
    browser.execute_script("location.hash = '#case-1'")
    wait(browser, lambda b: "no replay: its track was not kept" in b.find_element(By.ID, "stage").text)
    assert browser.get_log("browser") == []


def test_a_case_without_a_path_says_why_and_leads_to_its_plan(browser, finished, tmp_path):
    results = [*finished.results[:2], dataclasses.replace(unplanned(), number=3)]
    lost = dataclasses.replace(finished, results=results, folder=tmp_path)
    told = campaign_report(lost, Lanes(Here(), 1)).data
    plans = {
        "scenario": "slalom",
        "cases": ["lost"],
        "about": "",
        "rows": [],
        "note": "",
        "pictures": [],
        "fleet": False,
    }
    write_html(lost, {**told, "plans": [plans]}, tmp_path / "report.html")
    browser.get((tmp_path / "report.html").as_uri())
    browser.execute_script("location.hash = '#case-3'")
    wait(browser, lambda b: b.find_elements(By.CSS_SELECTOR, "#stage a"))
    stage = browser.find_element(By.ID, "stage").text
    assert "the planner found no path: none of 9 ants arrived" in stage
    assert f"seed {plan_seed(finished.campaign.seed, results[2].case)}" in stage
    assert "--case lost --trial 1" in stage
    browser.find_element(By.CSS_SELECTOR, "#stage a").click()
    wait(browser, lambda b: b.find_element(By.ID, "plans-1").is_displayed())
    browser.execute_script("sortBy('rank')")
    assert numbers(browser)[0] == 3
    assert browser.get_log("browser") == []


@pytest.mark.parametrize("size", [(1280, 1000), (390, 800)])
def test_controls_map_and_error_are_seen_together(browser, address, size):
    window = {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": size[0] < 500}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", window)
    try:
        browser.get("about:blank")
        browser.get(address)
        opened(browser, 3)
        if size[0] < 500:
            browser.execute_script("document.querySelector('.transport').scrollIntoView()")
        else:  # to the last of the plots
            browser.execute_script("document.getElementById('plots').scrollIntoView({ block: 'end' })")
        edges = browser.execute_script(EDGES)
        wide = browser.execute_script("return document.documentElement.scrollWidth")
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    assert wide <= size[0]
    bar, seen, error, plots = edges
    assert bar[0] >= -1.0
    assert seen[0] > bar[1] - 1.0  # the map begins below the controls
    assert max(seen[1], error[1] if size[0] < 500 else plots[1]) < size[1] + 1.0


def test_cells_lie_where_they_are(browser, finished, data, tmp_path):
    name = finished.results[2].case.name
    outcome = finished.outcomes[name]
    (west, south), (east, north) = outcome.path.xy.min(axis=0), outcome.path.xy.max(axis=0)
    cell = (north - south) / 2
    blocked = np.zeros((2, int(np.ceil((east - west) / cell))), dtype=bool)
    blocked[1] = True  # the northern half
    area = Map(raster=Raster(blocked, cell, west, south))
    moved = {**finished.outcomes, name: dataclasses.replace(outcome, obstacles=area)}
    write_html(dataclasses.replace(finished, outcomes=moved), data, tmp_path / "report.html")
    browser.get((tmp_path / "report.html").as_uri())
    opened(browser, 3)
    wait(browser, lambda b: b.find_elements(By.CSS_SELECTOR, "#map .im image"))
    picture = Image.open(io.BytesIO(browser.find_element(By.ID, "map").screenshot_as_png)).convert("RGB")
    grey = tuple(int(OBSTACLE[i : i + 2], 16) for i in (1, 3, 5))
    shares = []
    for y in (0.1, 0.9):
        points = [[west + x * (east - west), south + y * (north - south)] for x in np.linspace(0.05, 0.95, 40)]
        pixels = browser.execute_script(PIXELS, points)
        shares.append(np.mean([picture.getpixel((int(u), int(v))) == grey for u, v in pixels]))
    assert shares[0] == 0.0
    assert shares[1] > 0.7  # but for the lines over it
    assert browser.get_log("browser") == []
