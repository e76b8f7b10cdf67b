"""A browser that shows the page: Debian's chromium, driven by its chromedriver."""

import shutil

import pytest

pytest.importorskip("selenium", reason="selenium is not installed: pip install -e '.[dev]'")
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

PATIENCE = 60.0  # [s] for a machine that is busy
FLAGS = ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1280,1400")


def started():
    """A session, to be quit; skips the test where there is no browser."""
    chromium, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if chromium is None or driver is None:
        pytest.skip("no browser to show the page in: apt install chromium chromium-driver")
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for flag in FLAGS:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(options=options, service=webdriver.ChromeService(driver))


def wait(browser, what):
    WebDriverWait(browser, PATIENCE, poll_frequency=0.05).until(what)


def opened(browser, number):
    """A case, once its plots are drawn."""
    browser.execute_script(f"location.hash = '#case-{number}'")
    wait(browser, lambda b: b.execute_script("return document.getElementById('stage')?.dataset.ready === 'yes'"))


def numbers(browser):
    return [
        int(row.get_attribute("data-case")) for row in browser.find_elements(By.CSS_SELECTOR, "#case-rows tbody tr")
    ]
