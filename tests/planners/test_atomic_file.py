import pytest

from planners.atomic_file import atomic
from planners.errors import InputError, TrackworthyError


def test_appears_whole(tmp_path):
    file = tmp_path / "a.txt"
    with atomic(file) as temporary:
        assert temporary.parent == tmp_path
        temporary.write_text("whole")
        assert not file.exists()
    assert file.read_text() == "whole"
    assert list(tmp_path.iterdir()) == [file]


def test_a_failure_leaves_the_old_file(tmp_path):
    file = tmp_path / "a.txt"
    file.write_text("old")

    def fail():
        with atomic(file) as temporary:
            temporary.write_text("half")
            raise ValueError("broken")

    with pytest.raises(ValueError, match="broken"):
        fail()
    assert file.read_text() == "old"
    assert list(tmp_path.iterdir()) == [file]


def test_refuses_a_missing_folder_and_a_folder(tmp_path):
    with pytest.raises(InputError, match="does not exist"), atomic(tmp_path / "no" / "a.txt"):
        pass
    with pytest.raises(InputError, match="is a folder"), atomic(tmp_path):
        pass


def test_a_disk_that_refuses_is_no_traceback(tmp_path):
    with pytest.raises(TrackworthyError, match="cannot be written"), atomic(tmp_path / "a.txt"):
        raise OSError(28, "No space left on device")
