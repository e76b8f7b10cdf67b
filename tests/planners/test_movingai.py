"""MovingAI's benchmark files as scenarios, with lengths as their .scen publishes them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grid_maps import distances, free_cells, maze, random_grid, rooms
from planners.all_planners import make_planner, plan_with
from planners.errors import InputError
from planners.movingai import read_map, read_problem
from planners.planner import NO_PATH
from planners.scenario import load_scenario, stem_of

GRIDS = {
    "a tenth": lambda rng: random_grid(rng, 64, 48, 0.1),
    "a quarter": lambda rng: random_grid(rng, 64, 48, 0.25),
    "a third": lambda rng: random_grid(rng, 64, 48, 0.33),
    "rooms": lambda rng: rooms(rng, 6, 7),
    "maze": lambda rng: maze(rng, 24),
}


def map_text(blocked, ground=".", wall="@"):
    """The .map of a grid whose first row is the northernmost."""
    rows, columns = blocked.shape
    lines = ["".join(wall if cell else ground for cell in row) for row in blocked]
    return "\n".join(["type octile", f"height {rows}", f"width {columns}", "map", *lines, ""])


def write(folder, blocked, pairs, name="arena.map"):
    """Both files, with a line for each pair of start, goal (row, column) and length; the .scen's path."""
    (folder / name).write_text(map_text(blocked))
    rows, columns = blocked.shape
    lines = [
        f"{int(length / 4)}\t{name}\t{columns}\t{rows}\t{start[1]}\t{start[0]}\t{goal[1]}\t{goal[0]}\t{length:.8f}"
        for start, goal, length in pairs
    ]
    scen = folder / f"{name}.scen"
    scen.write_text("\n".join(["version 1", *lines, ""]))
    return scen


@pytest.mark.parametrize("grid", GRIDS)
def test_eight_way_astar_has_the_published_lengths(grid, tmp_path):
    rng = np.random.default_rng(5)
    blocked = GRIDS[grid](rng)
    start, *goals = free_cells(rng, blocked, 21)
    known = distances(blocked, start)
    pairs = [(start, goal, known[goal]) for goal in goals if np.isfinite(known[goal])]
    scen = write(tmp_path, blocked, pairs)
    assert len(pairs) > 10 or grid == "rooms"
    for number, (_, _, length) in enumerate(pairs, 1):
        found = load_scenario(f"{scen}:{number}")
        path = plan_with(make_planner("astar-eight"), found, 0).paths[0]
        assert path.length == pytest.approx(length, abs=1e-6)
        assert read_problem(f"{scen}:{number}").length == pytest.approx(length, abs=1e-6)
        assert (path.xy % 1.0 == 0.5).all()


def test_what_is_walled_in_has_no_path(tmp_path):
    blocked = np.zeros((5, 9), dtype=bool)
    blocked[:, 4] = True
    scen = write(tmp_path, blocked, [((2, 1), (2, 7), 6.0)])
    assert plan_with(make_planner("astar-eight"), load_scenario(f"{scen}:1"), 0).outcome == NO_PATH


@settings(max_examples=40)
@given(cells=st.lists(st.lists(st.booleans(), min_size=7, max_size=7), min_size=1, max_size=9))
def test_a_map_comes_back_as_it_was(cells, tmp_path_factory):
    blocked = np.array(cells)
    file = tmp_path_factory.mktemp("maps") / "one.map"
    file.write_text(map_text(blocked))
    assert (read_map(file) == blocked[::-1]).all()


def test_y_counts_down_from_the_north(tmp_path):
    found = load_scenario(f"{write(tmp_path, np.zeros((4, 6), dtype=bool), [((0, 1), (3, 5), 5.24264069)])}:1")
    assert found.name == "arena 1"
    assert found.size == (6.0, 4.0)
    assert found.unit == 1.0
    assert found.starts.tolist() == [[1.5, 3.5]]
    assert found.goals.tolist() == [[5.5, 0.5]]
    assert [file.name for file in found.files] == ["arena.map.scen", "arena.map"]


def test_ground_and_swamp_are_free_and_water_and_trees_are_not(tmp_path):
    file = tmp_path / "one.map"
    file.write_bytes(b"type octile\r\nheight 1\r\nwidth 7\r\nmap\r\n.GS@OTW\r\n")
    assert read_map(file).tolist() == [[False, False, False, True, True, True, True]]


def test_a_map_is_found_where_the_file_says_and_beside_it(tmp_path):
    scen = write(tmp_path, np.zeros((2, 2), dtype=bool), [((0, 0), (1, 1), 1.41421356)])
    text = scen.read_text()
    scen.write_text(text.replace("arena.map", "maps/dao/arena.map").replace("\t", " "))
    assert load_scenario(f"{scen}:1").files[1] == tmp_path / "arena.map"
    (tmp_path / "maps" / "dao").mkdir(parents=True)
    (tmp_path / "arena.map").rename(tmp_path / "maps" / "dao" / "arena.map")
    assert load_scenario(f"{scen}:1").files[1] == tmp_path / "maps" / "dao" / "arena.map"
    (tmp_path / "maps" / "dao" / "arena.map").unlink()
    with pytest.raises(InputError, match=r"arena\.map: no such file"):
        load_scenario(f"{scen}:1")


LINE = "0\tarena.map\t3\t2\t0\t0\t2\t1\t2.41421356"


@pytest.mark.parametrize(("line", "what"), [
    ("0\tarena.map\t6\t4\t0\t0\t2\t1\t2.4", r"scen: line 2: its map is 6 x 4, and .*arena\.map is 3 x 2"),
    ("0\tarena.map\t3\t2\t0\t2\t2\t1\t2.4", r"scen: line 2: the start \(0, 2\) is off the map"),
    ("0\tarena.map\t3\t2\t0\t0\t1\t0\t2.4", r"scen: line 2: the goal \(1, 0\) is in a blocked cell of .*arena\.map"),
    ("0\tarena.map\t3\t2\t0\t0\t2\t1", "scen: line 2: it has 8 columns; give 9: bucket, map"),
    ("0\tarena.map\t3\t2\t-1\t0\t2\t1\t2.4", "scen: line 2: start x is '-1'; give a whole number"),
    ("0\tarena.map\t3\t2\t0\t0\t2\t1\tfar", "scen: line 2: optimal length is 'far'; give a number"),
])  # fmt: skip
def test_a_bad_problem_is_named_by_its_line(line, what, tmp_path):
    scen = write(tmp_path, np.array([[False, True, False], [False, False, False]]), [])
    scen.write_text(f"version 1\n{line}\n")
    with pytest.raises(InputError, match=what):
        load_scenario(f"{scen}:1")


@pytest.mark.parametrize(("text", "what"), [
    ("type tile\nheight 1\nwidth 1\nmap\n.\n", "line 1: 'type tile' is not its type"),
    ("type octile\nwidth 1\nheight 1\nmap\n.\n", "line 2: 'width 1' is not its height"),
    ("type octile\nheight 1\nwidth one\nmap\n.\n", "line 3: width is 'one'; give a whole number"),
    ("type octile\nheight 1\nwidth 1\n.\n", "line 4: '.' is not its map"),
    ("type octile\nheight 1", "line 3: '' is not its width"),
    ("type octile\nheight 2\nwidth 1\nmap\n.\n", "line 2: the height is 2, and there are 1 rows"),
    ("type octile\nheight 2\nwidth 2\nmap\n..\n.\n", "line 6: the row has 1 cells, and the width is 2"),
    ("type octile\nheight 2\nwidth 2\nmap\n..\n.x\n", "line 6: 'x' is no terrain"),
    ("type octile\nheight 1\nwidth 2\nmap\n.\N{LATIN SMALL LETTER E WITH ACUTE}\n", "line 5: '\u00e9' is no terrain"),
    ("", "line 1: '' is not its type"),
])  # fmt: skip
def test_a_bad_map_is_named_by_its_line(text, what, tmp_path):
    file = tmp_path / "one.map"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=f"one.map: {what}"):
        read_map(file)


@pytest.mark.parametrize(("name", "what"), [
    ("arena.map", r"a map alone has no start and no goal; name a problem by its number, as .*arena\.map\.scen:1"),
    ("arena.map.scen", r"it holds many problems; name a problem by its number, as .*arena\.map\.scen:1"),
    ("arena.map.scen:0", "there is no problem 0; it has those from 1 to 1"),
    ("arena.map.scen:2", "there is no problem 2; it has those from 1 to 1"),
    ("other.map.scen:1", "no such file"),
])  # fmt: skip
def test_a_problem_is_named_by_its_number(name, what, tmp_path):
    write(tmp_path, np.zeros((2, 2), dtype=bool), [((0, 0), (1, 1), 1.41421356)])
    with pytest.raises(InputError, match=what):
        load_scenario(tmp_path / name)


def test_another_version_is_bad_input(tmp_path):
    scen = write(tmp_path, np.zeros((2, 2), dtype=bool), [((0, 0), (1, 1), 1.41421356)])
    scen.write_text(scen.read_text().replace("version 1", "version 2"))
    with pytest.raises(InputError, match="line 1: 'version 2' is not 'version 1'"):
        load_scenario(f"{scen}:1")


def test_problems_of_one_file_have_names_of_their_own():
    assert stem_of("maps/arena.map.scen:12") == "arena 12"
    assert stem_of("maps/arena.toml") == "arena"
