import pytest

from reports.words.names import listed, spoken


@pytest.mark.parametrize(
    ("name", "in_a_list", "in_a_sentence"),
    [
        ("cross_track_max", "cross-track error, max", "cross-track error"),
        ("cross_track_p95", "cross-track error, 95 %", "95 % cross-track error"),
        ("cross_track_rms", "cross-track error, RMS", "RMS cross-track error"),
        ("clearance_min", "clearance, min", "clearance"),
        ("lateral_acceleration_max", "lateral acceleration, max", "lateral acceleration"),
        ("turn_angle_max_flown", "turn angle, flown", "turn angle, flown"),
        ("frechet", "Fréchet distance", "Fréchet distance"),
        ("something_new", "something new", "something new"),
        ("", "", ""),
    ],
)
def test_names(name, in_a_list, in_a_sentence):
    assert listed(name) == in_a_list
    assert spoken(name) == in_a_sentence
