from campaigns.comparison import Comparison
from campaigns.gate import VERDICT, WORSE, Check, Finding
from reports.pages.check_data import check_data
from reports.pages.pdf import write_pdf
from reports.pages.report_data import Report, report_of


def compared(case, worse=0.17, **changes):
    usual = {"metric": "cross_track_p95", "unit": "m", "old": 0.05, "new": 0.05 + worse, "worse": worse, "limit": 0.002}
    return Comparison(case, regressed=worse > 0, improved=worse < 0, trial=16, seed=7, **(usual | changes))


def finding(case):
    return Finding(WORSE, case, "cross_track_p95 is worse", compared(case), 16, 7, "trackworthy run a.toml")


def test_worse_changed_and_better_are_told_with_their_units():
    turned = Finding(VERDICT, "b", "was trackworthy, is not-trackworthy", None, 2, 9, "run")
    told = check_data(Check("c", (), (finding("a"), turned), (compared("d", -0.02),)))
    assert not told["good"]
    (worse,) = told["worse"]
    assert (worse["case"], worse["old"], worse["new"], worse["by"]) == ("a", "0.05 m", "0.22 m", "0.17 m")
    assert told["changed"][0]["shown"] == "worst in trial 2 (seed 9)"
    assert (told["better"][0]["by"], told["better_count"]) == ("0.02 m", 1)


def test_as_good_as_it_was():
    told = check_data(Check("c", (compared("a", 0.0),), (), ()))
    assert told["good"]
    assert told["conclusion"].startswith("AS GOOD AS THE BASELINE")


def test_many_findings_are_counted_and_the_page_holds(tmp_path):
    told = check_data(Check("c", (), tuple(finding(f"case {i} #x $y$") for i in range(99)), ()))
    assert (len(told["worse"]), told["worse_count"]) == (30, 99)
    data = report_of([], "Gate").data | {"check": told}
    write_pdf(Report(data, [], []), tmp_path, tmp_path / "a.pdf")
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF-")
