import struct
import zlib

import numpy as np
import pytest
from PIL import Image

from planners.errors import InputError
from planners.picture import cell_of, pixels_of, read_blocked, write_blocked


def test_a_mask_is_read_as_it_was_written(tmp_path):
    blocked = np.array([[True, False, False], [False, False, True]])
    write_blocked(blocked, tmp_path / "mask.png")
    assert (read_blocked(tmp_path / "mask.png", white_is_obstacle=False, place="here") == blocked).all()
    assert pixels_of(tmp_path / "mask.png", "here") == (3, 2)
    with Image.open(tmp_path / "mask.png") as picture:
        assert picture.getpixel((0, 1)) == 0  # black, in the south-west


@pytest.mark.parametrize("side", [5_001, 12_000, 30_000])
def test_a_small_file_cannot_take_all_memory(tmp_path, side):
    header = b"IHDR" + struct.pack(">IIBBBBB", side, side, 1, 0, 0, 0, 0)
    size, check = struct.pack(">I", len(header) - 4), struct.pack(">I", zlib.crc32(header))
    (tmp_path / "bomb.png").write_bytes(b"\x89PNG\r\n\x1a\n" + size + header + check)
    for read in (pixels_of, lambda file, place: read_blocked(file, True, place)):
        with pytest.raises(InputError, match=r"here: .*(has 5001 x 5001 pixels|has 12000 x 12000 pixels|bomb)"):
            read(tmp_path / "bomb.png", "here")


@pytest.mark.parametrize(
    ("name", "what"),
    [("none.png", "there is no such picture; check the path"), ("text.png", "it cannot be read as a picture")],
)
def test_a_file_that_is_no_picture_is_named_once(tmp_path, name, what):
    (tmp_path / "text.png").write_text("text")
    file = str(tmp_path / name)
    with pytest.raises(InputError, match=f"^{file}: {what}"):
        pixels_of(file, file)


def test_cells_are_square():
    assert cell_of((4, 2), (8.0, 4.004), "size", "a.png") == 2.0
    with pytest.raises(
        InputError, match=r"size: 8.0 x 4.1 over 4 x 2 pixels of a.png is not square; 8.0 wide it is 4 high"
    ):
        cell_of((4, 2), (8.0, 4.1), "size", "a.png")
