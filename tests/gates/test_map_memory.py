"""A map of any number of poses needs the memory of one tile: a thousand million fit into 1 GB."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
#: Prints the most memory that a process had, in MB, after it mapped COLUMNS x ROWS poses.
MAP = """
import re, sys
from pathlib import Path
from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.map_tally import tally
from turnbuckle.codegen.pose_map import PoseMap, target_grid
from turnbuckle.model.reading import load_machine
machine = load_machine("machines/yoon2023.toml")
generated = Generated(machine, Path("generated/yoon2023"), "double")
columns, rows = int(sys.argv[1]), int(sys.argv[2])
tiles = PoseMap(generated).tiles(target_grid(machine, columns, rows))
if sys.argv[3] == "kept":
    tiles = list(tiles)
assert tally(machine, tiles).poses == columns * rows
# not ru_maxrss: that begins with what the parent had
peak = re.search(r"VmHWM:\\s*(\\d+) kB", Path("/proc/self/status").read_text())
print(int(peak[1]) / 1024)
"""
SMALL, LARGE = (1000, 1000), (1000, 8000)
#: What the allocator may differ by from run to run, MB; the maps differ by 107 MB.
SCATTER = 10.0


def megabytes(size: tuple[int, int], treatment: str) -> float:
    done = subprocess.run(
        [sys.executable, "-c", MAP, *map(str, size), treatment],
        cwd=ROOT,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=True,
    )
    return float(done.stdout)


def test_eight_times_the_poses_need_no_more_memory() -> None:
    small, large = (megabytes(size, "tallied") for size in (SMALL, LARGE))
    assert abs(large - small) < SCATTER
    assert large < 1000


def test_a_map_that_is_kept_would_be_noticed() -> None:
    assert megabytes(LARGE, "kept") - megabytes(SMALL, "tallied") > 5 * SCATTER
