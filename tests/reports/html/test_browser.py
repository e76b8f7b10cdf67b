"""The page in a real browser."""

import dataclasses
import time

import pytest

pytest.importorskip("selenium", reason="selenium is not installed: pip install -e '.[dev]'")
from in_browser import numbers, opened, wait
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from reports.html.page import write_html


@pytest.fixture
def page(browser, address):
    """The page, opened anew; whatever a test does, no name has run, and nothing was said on the console."""
    browser.get("about:blank")
    browser.get(address)
    yield browser
    assert browser.execute_script("return window.hacked") is None
    assert browser.find_element(By.ID, "trouble").text == ""
    assert [entry["message"] for entry in browser.get_log("browser")] == []


def at(browser):
    """What the replay shows: the clock [s], where the vehicle is [px], and where the cursor stands [s]."""
    return browser.execute_script(
        "const v = document.getElementById('vehicles').dataset;"
        "return [parseFloat(document.getElementById('clock').textContent), parseFloat(v.x), parseFloat(v.y),"
        " parseFloat(document.querySelector('.cursor').dataset.at)]"
    )


def test_names_are_text(page, finished):
    title = page.find_element(By.CSS_SELECTOR, "header h1")
    assert title.text == finished.campaign.title
    assert page.title.startswith(finished.campaign.title)
    assert not page.find_elements(By.TAG_NAME, "img")
    for result in finished.results:
        opened(page, result.number)
        assert page.find_element(By.ID, "case-name").text == result.case.name
        assert not page.find_elements(By.TAG_NAME, "img")
    drawn = page.execute_script("return document.querySelectorAll('#plots .scatterlayer path.js-line').length")
    assert drawn > 3


def test_it_plays(page):
    opened(page, 3)
    Select(page.find_element(By.ID, "speed")).select_by_value("4")
    before = at(page)
    page.find_element(By.ID, "play").click()
    wait(page, lambda b: at(b)[0] > before[0] + 1.0)
    page.find_element(By.ID, "play").click()
    after = at(page)
    assert after[1:3] != before[1:3]
    assert after[3] == pytest.approx(after[0], abs=0.06)
    assert "Play" in page.find_element(By.ID, "play").text
    time.sleep(0.2)
    assert at(page) == after  # it stands


def test_speed_is_that_of_the_clock(page):
    opened(page, 3)
    Select(page.find_element(By.ID, "speed")).select_by_value("64")
    page.find_element(By.ID, "play").click()
    end = page.execute_script("return shownCase.player.end")
    wait(page, lambda b: at(b)[0] == pytest.approx(end, abs=0.06))
    wait(page, lambda b: "Play" in b.find_element(By.ID, "play").text)  # it stops at the end


def test_scrub_and_keys(page):
    opened(page, 1)
    slider = page.find_element(By.ID, "scrub")
    page.execute_script("arguments[0].value = 5000; arguments[0].dispatchEvent(new Event('input'))", slider)
    start, end = page.execute_script("const p = shownCase.player; return [p.start, p.end]")
    middle = at(page)
    assert middle[0] == pytest.approx((start + end) / 2, abs=0.06)
    assert middle[3] == pytest.approx((start + end) / 2, abs=1e-3)
    page.find_element(By.ID, "case-name").click()
    ActionChains(page).send_keys(Keys.ARROW_RIGHT).perform()
    later = at(page)
    assert later[0] > middle[0]
    assert later[1:3] != middle[1:3]
    ActionChains(page).send_keys(Keys.SPACE).perform()
    wait(page, lambda b: "Pause" in b.find_element(By.ID, "play").text)
    ActionChains(page).send_keys(Keys.SPACE).perform()
    wait(page, lambda b: "Play" in b.find_element(By.ID, "play").text)


def test_a_click_on_the_error_goes_there(page):
    opened(page, 1)
    plots = page.find_element(By.ID, "plots")
    page.execute_script("arguments[0].scrollIntoView({ block: 'center' })", plots)
    inside = page.execute_script(
        "const plots = document.getElementById('plots');"
        "const f = plots._fullLayout, r = plots.getBoundingClientRect();"
        "return [r.width, r.height, f.xaxis._offset + 0.7 * f.xaxis._length, f.yaxis._offset + 0.5 * f.yaxis._length]"
    )
    width, height, x, y = inside
    ActionChains(page).move_to_element_with_offset(plots, int(x - width / 2), int(y - height / 2)).pause(
        0.3
    ).click().perform()
    end = page.execute_script("return shownCase.player.end")
    wait(page, lambda b: at(b)[0] == pytest.approx(0.7 * end, rel=0.05))


def test_another_trial_and_over_distance(page, finished):
    opened(page, 1)
    runs = Select(page.find_element(By.ID, "run"))
    assert len(runs.options) == 3
    seeds = {page.find_element(By.ID, "stage").text.partition("seed ")[2].partition("\n")[0].split()[0]}
    page.execute_script("delete document.getElementById('stage').dataset.ready")
    runs.select_by_index(1)
    wait(page, lambda b: b.execute_script("return document.getElementById('stage').dataset.ready === 'yes'"))
    seeds.add(page.find_element(By.ID, "stage").text.partition("seed ")[2].partition("\n")[0].split()[0])
    assert len(seeds) == 2
    assert seeds <= {str(seed) for seed in finished.results[0].statistics.seeds}
    Select(page.find_element(By.ID, "over")).select_by_value("distance")
    length = finished.outcomes[finished.results[0].case.name].path.length
    page.execute_script("shownCase.player.go(shownCase.player.end)")
    wait(page, lambda b: at(b)[3] == pytest.approx(length, rel=0.02))


def test_rows_are_filtered_and_sorted(page, finished):
    assert numbers(page) == [1, 2, 3]
    page.find_element(By.CSS_SELECTOR, 'th[data-key="speed"] button').click()
    speeds = {result.number: finished.outcomes[result.case.name].speed for result in finished.results}
    assert numbers(page) == sorted(speeds, key=speeds.__getitem__)
    page.find_element(By.CSS_SELECTOR, 'th[data-key="speed"] button').click()
    assert numbers(page) == sorted(speeds, key=speeds.__getitem__, reverse=True)
    text = page.find_element(By.ID, "filter-text")
    text.send_keys("ROAD")
    assert sorted(numbers(page)) == [1, 2]
    assert page.find_element(By.ID, "case-count").text == "2 of 3 cases"
    text.clear()
    text.send_keys("x")
    text.send_keys(Keys.BACKSPACE)
    Select(page.find_element(By.ID, "filter-vehicle")).select_by_value("c172x")
    assert numbers(page) == [3]
    page.find_element(By.CSS_SELECTOR, "#case-rows tbody tr td:nth-child(4)").click()
    wait(page, lambda b: b.find_elements(By.ID, "case-name"))
    assert page.find_element(By.ID, "case-name").text == finished.results[2].case.name
    page.find_element(By.ID, "back").click()
    wait(page, lambda b: b.find_element(By.ID, "case-rows").is_displayed())


def test_a_fleet_shares_a_clock(browser, finished, data, apart_fleet, tmp_path):
    name = finished.results[0].case.name
    flown = dataclasses.replace(finished, outcomes={**finished.outcomes, name: apart_fleet}, folder=tmp_path)
    write_html(flown, data, tmp_path / "report.html")
    browser.get((tmp_path / "report.html").as_uri())
    opened(browser, 1)
    assert len(Select(browser.find_element(By.ID, "vehicle")).options) == 3
    states = (
        "return shownCase.player.vehicles.map((one) => stateAt(one, arguments[0]))"
        ".map((state) => [state.x, state.waiting])"
    )
    late = max(apart_fleet.fleet.departures)
    waiting = [departure > late / 2 for departure in apart_fleet.fleet.departures]
    assert any(waiting)
    told = browser.execute_script(states, late / 2)
    assert [one[1] for one in told] == waiting
    for (x, waits), member in zip(told, apart_fleet.fleet.members, strict=True):
        if waits:
            assert x == pytest.approx(member.track["x"][0], abs=1e-2)
    nearest = apart_fleet.metrics["separation_min"]
    between = (
        "const states = shownCase.player.vehicles.map((one) => stateAt(one, arguments[0]));"
        "return nearestOther(states, arguments[1])"
    )
    told = browser.execute_script(between, nearest.t, int(nearest.who[0]) - 1)
    assert told == pytest.approx(nearest.value, rel=0.01)
    assert browser.get_log("browser") == []


def test_a_run_takes_as_long_as_one_looks_on(page):
    for number in (1, 3):
        opened(page, number)
        long, speed = page.execute_script("const p = shownCase.player; return [p.end - p.start, p.speed]")
        assert speed == 1.0 or 10.0 < long / speed <= 20.0
        assert long / speed <= 20.0
