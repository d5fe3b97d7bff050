"""Throws webs out of every packing pattern, over seeded imperfections, and prints the table of docs/packing.md.

    python3 docs/packing_table.py --netcast target/release/netcast --seeds 20

Each cell is the median over the seeds, and the 10-90 % band in brackets.
"""

import argparse
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
}
# without traction ropes a pattern would put tractors into the pack
TRACTION = {"polygon": '"1 m"', "diamond": '"1 m"'}


def run(netcast, web, pattern, seed, extra):
    """The summary of one run, or what went wrong."""
    imperfection = f',imperfection={{scatter="5 mm",twist="10 deg",seed={seed}}}' if seed else ""
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


def quantities(summary):
    opening, tension, mouth = summary["opening"], summary["tension"], summary["mouth"]
    return {
        "largest area": (100 * opening["area_max_m2"] / opening["reference_area_m2"], "%", 0),
        "at": (1e3 * opening["area_max_time_s"], "ms", 0),
        "peak tension": (1e-3 * tension["max_n"], "kN", 1),
        "asymmetry": (100 * (mouth["asymmetry_at_area_max"] or 0), "%", 1),
    }


def band(values, digits):
    median = f"{statistics.median(values):.{digits}f}"
    if len(values) < 2:
        return median
    tenths = statistics.quantiles(values, n=10, method="inclusive")
    return f"{median} ({tenths[0]:.{digits}f} to {tenths[-1]:.{digits}f})"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--netcast", default="netcast", help="the program")
    options.add_argument("--seeds", type=int, default=0, help="imperfections a case; 0: one run without")
    options.add_argument("--jobs", type=int, default=1, help="runs at a time")
    options.add_argument("--webs", nargs="*", default=list(WEBS), choices=list(WEBS))
    options.add_argument("--set", action="append", default=[], help="a further override of every run")
    options = options.parse_args()
    seeds = range(1, options.seeds + 1) if options.seeds else [0]
    header = None
    with ThreadPoolExecutor(options.jobs) as pool:
        for web in options.webs:
            for pattern in PATTERNS:
                cases = list(pool.map(lambda seed: run(options.netcast, web, pattern, seed, options.set), seeds))
                good = [quantities(case) for case in cases if isinstance(case, dict)]
                failed = [case for case in cases if isinstance(case, str)]
                if good and header is None:
                    header = [f"{name}, {unit}" for name, (_, unit, _) in good[0].items()]
                    print(f"| web | pattern | {' | '.join(header)} | failed |\n|---|---|{'---|' * len(header)}---|")
                cells = [band([case[name][0] for case in good], good[0][name][2]) for name in good[0]] if good else []
                cells = cells or [""] * 4
                print(f"| {web} | {pattern} | {' | '.join(cells)} | {failed[0] if failed else ''} |", flush=True)


if __name__ == "__main__":
    main()
