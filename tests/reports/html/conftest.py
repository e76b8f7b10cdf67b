import pytest

from campaigns.lanes import Lanes
from planners import files
from reports.html.page import write_html
from reports.write import campaign_report
from sample_paths import aircraft_weave, road_weave
from small_campaigns import Here, run_here

SCRIPT, IMAGE, END = "<script>window.hacked=1</script>", '"><img src=x onerror=window.hacked=1>', "</script>"
# A name may hold anything that can be printed, and a file's anything but a slash
CAMPAIGN = f"""
name = 'hostile'
title = '{SCRIPT}{IMAGE} & {END}'
note = '{IMAGE}{SCRIPT} <!-- {END}'
seed = 1
keep_tracks = "all"
[[case]]
name = '{SCRIPT} road {END}'
path = '{IMAGE}.csv'
vehicle = "truck"
speed = ["30km/h", "45km/h"]
trials = 3
conditions.cross_track_offset = {{ normal = [0, 0.05] }}
[[case]]
name = 'air {IMAGE}'
path = "air.csv"
vehicle = "c172x"
conditions.wind = "10@270"
"""


@pytest.fixture(scope="session")
def finished(tmp_path_factory):
    """A campaign whose title, note, cases and path file are called what no page should run."""
    folder = tmp_path_factory.mktemp("hostile")
    files.write(road_weave(12.5).resample(4.0), folder / f"{IMAGE}.csv")
    files.write(aircraft_weave(length=2000.0), folder / "air.csv")
    (folder / "campaign.toml").write_text(CAMPAIGN)
    return run_here(folder / "campaign.toml", folder / "results")


@pytest.fixture(scope="session")
def data(finished):
    return campaign_report(finished, Lanes(Here(), 1)).data


@pytest.fixture(scope="module")
def browser():
    from in_browser import started  # which skips all that needs selenium where there is none

    session = started()
    yield session
    session.quit()


@pytest.fixture(scope="module")
def address(finished, data, tmp_path_factory):
    """That of the page on what is `finished`."""
    file = tmp_path_factory.mktemp("page") / "report.html"
    write_html(finished, data, file)
    return file.as_uri()
