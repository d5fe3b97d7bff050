"""Throws webs out of every packing pattern, over seeded imperfections, and prints the table of docs/packing.md.

    python3 docs/packing_table.py --netcast target/release/netcast --seeds 20

Each cell is the median over the seeds, and the 10-90 % band in brackets; of those times that there are. `open` counts
the runs that reach 80 % of the flat web's area. `--keep` writes what each run gave, and finds there what was run before.
"""

import argparse
import csv
import json
import statistics
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WEBS = {
    "traditional": "examples/01_traditional_web/traditional_web.toml",
    "topological": "examples/02_topological_web/topological_web.toml",
    "space": "examples/03_space_web/space_web.toml",
    "polygon": "crates/scenario/templates/polygon.toml",
    "diamond": "crates/scenario/templates/diamond.toml",
}
CONTAINER = 'container={cylinder={radius="0.4 m",height="0.8 m"}}'
PATTERNS = {
    "bag": 'bag={radius="0.4 m"}',
    "zigzag, rings": f"zigzag={{{CONTAINER}}}",
    "zigzag, lines": f'zigzag={{along="lines",{CONTAINER}}}',
    "star": f"star={{{CONTAINER}}}",
    "roll": f"roll={{{CONTAINER}}}",
    "layers": f"layers={{{CONTAINER}}}",
    "prescribed": 'prescribed={radius="0.4 m",depth="0.6 m"}',
}
# without traction ropes a pattern would put tractors into the pack
TRACTION = {"polygon": '"1 m"', "diamond": '"1 m"'}


IMPERFECTION = 'scatter="5 mm",twist="10 deg"'


def run(netcast, web, pattern, seed, imperfection, extra):
    """The summary of one run, or what went wrong."""
    imperfection = f",imperfection={{{imperfection},seed={seed}}}" if seed else ""
    overrides = [f"stow={{{PATTERNS[pattern]}{imperfection}}}", 'solve.on_energy_error="flag"', *extra]
    if web in TRACTION:
        overrides.append(f"traction_rope={{length={TRACTION[web]}}}")
    with tempfile.TemporaryDirectory() as folder:
        command = [netcast, "run", str(ROOT / WEBS[web]), "--json", "--threads", "1", "--out", f"{folder}/out"]
        for override in overrides:
            command += ["--set", override]
        ended = subprocess.run(command, capture_output=True, text=True)
    if ended.returncode:
        return ended.stderr.strip().splitlines()[0][:200]
    return json.loads(ended.stdout)


# name: unit, digits, value in a summary
QUANTITIES = {
    "80 % open at": ("ms", 0, lambda of: scaled(1e3, of["opening"]["effective_from_s"])),
    "largest area": ("%", 0, lambda of: 100 * of["opening"]["area_max_m2"] / of["opening"]["reference_area_m2"]),
    "at": ("ms", 0, lambda of: 1e3 * of["opening"]["area_max_time_s"]),
    "peak tension": ("kN", 1, lambda of: 1e-3 * of["tension"]["max_n"]),
    "asymmetry": ("%", 1, lambda of: scaled(100, of["mouth"]["asymmetry_at_area_max"])),
}


def scaled(factor, value):
    return None if value is None else factor * value


def band(values, digits):
    values = [value for value in values if value is not None]
    if not values:
        return ""
    median = f"{statistics.median(values):.{digits}f}"
    if len(values) < 2:
        return median
    tenths = statistics.quantiles(values, n=10, method="inclusive")
    return f"{median} ({tenths[0]:.{digits}f} to {tenths[-1]:.{digits}f})"


class Kept:
    """What runs gave, by web, pattern and seed; in a CSV file where one is named."""

    def __init__(self, path):
        self.path, self.rows = path, {}
        if path and Path(path).exists():
            with open(path, newline="") as file:
                for web, pattern, seed, *values in csv.reader(file):
                    self.rows[web, pattern, int(seed)] = [float(value) if value else None for value in values]

    def add(self, case, values):
        self.rows[case] = values
        if self.path:
            with open(self.path, "a", newline="") as file:
                csv.writer(file).writerow([*case, *("" if value is None else value for value in values)])


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--netcast", default="netcast", help="the program")
    options.add_argument("--seeds", type=int, default=0, help="imperfections a case; 0: one run without")
    options.add_argument("--imperfection", default=IMPERFECTION, help=f"of each but its seed; default: {IMPERFECTION}")
    options.add_argument("--jobs", type=int, default=1, help="runs at a time")
    options.add_argument("--webs", nargs="*", default=list(WEBS), choices=list(WEBS))
    options.add_argument("--patterns", nargs="*", default=list(PATTERNS), choices=list(PATTERNS))
    options.add_argument("--set", action="append", default=[], help="a further override of every run")
    options.add_argument("--keep", help="CSV file of what each run gave")
    options = options.parse_args()
    seeds = range(1, options.seeds + 1) if options.seeds else [0]
    kept = Kept(options.keep)

    def case(web, pattern, seed):
        """The quantities of a case, or what went wrong."""
        if (web, pattern, seed) not in kept.rows:
            summary = run(options.netcast, web, pattern, seed, options.imperfection, options.set)
            if isinstance(summary, str):
                return summary
            kept.add((web, pattern, seed), [value(summary) for _, _, value in QUANTITIES.values()])
        return kept.rows[web, pattern, seed]

    header = [f"{name}, {unit}" for name, (unit, _, _) in QUANTITIES.items()]
    print(f"| web | pattern | open | {' | '.join(header)} | failed |\n|---|---|---|{'---|' * len(header)}---|")
    with ThreadPoolExecutor(options.jobs) as pool:
        for web in options.webs:
            for pattern in options.patterns:
                cases = list(pool.map(lambda seed: case(web, pattern, seed), seeds))
                good = [values for values in cases if not isinstance(values, str)]
                failed = [values for values in cases if isinstance(values, str)]
                is_open = sum(values[0] is not None for values in good)
                digits = [digits for _, digits, _ in QUANTITIES.values()]
                cells = [band([values[k] for values in good], digits[k]) for k in range(len(QUANTITIES))]
                cells = [web, pattern, f"{is_open} of {len(cases)}", *cells, failed[0] if failed else ""]
                print(f"| {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
