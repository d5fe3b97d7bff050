#!/usr/bin/env python3
"""Runs the Python of docs/results.md in a result folder, and holds what it reads to summary.json.

    venv/bin/pip install h5py pandas pyvista
    venv/bin/python tests/python/results_page.py RESULT_DIR

Exits with 1 where a block fails or reads another number; with 0 where all agree.
"""

import json
import os
import re
import sys
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "results.md"


def close(what, found, expected):
    """Exits where two numbers differ by more than rounding."""
    if abs(found - expected) > 1e-9 * max(abs(expected), 1e-300):
        sys.exit(f"{what}: {found}, summary.json has {expected}")


def main():
    os.chdir(sys.argv[1])
    summary = json.loads(Path("summary.json").read_text())
    blocks = re.findall(r"^## (\w+)\n\n```python\n(.*?)```", PAGE.read_text(), re.DOTALL | re.MULTILINE)
    read = {}
    for program, block in blocks:
        lines = block.strip().splitlines()
        if len(lines) > 5:
            sys.exit(f"{program}: {len(lines)} lines, the page promises five")
        names = {}
        exec(compile(block, f"{PAGE} ({program})", "exec"), names)
        read[program] = names
    pandas, h5py, pyvista = read["pandas"], read["h5py"], read["PyVista"]
    close("highest tension", pandas["highest_n"], summary["tension"]["max_n"])
    nodes = summary["model"]["nodes"]
    if h5py["positions_m"].shape != (len(h5py["times_s"]), nodes, 3):
        sys.exit(f"positions have the shape {h5py['positions_m'].shape} for {nodes} nodes")
    last, shown = h5py["tensions_n"][-1], pyvista["last_tensions_n"]
    if last.shape != shown.shape or ((last != shown) & (last == last)).any():
        sys.exit("PyVista shows other tensions at the end than h5py")
    print(f"{len(blocks)} blocks of {PAGE.name} agree with summary.json")


main()
