#!/usr/bin/env bash
# A sweep by hand: the same shot at several spreads, a line of numbers for each. Run it from the root of the project.
set -euo pipefail
for spread in 20 30 35 40 50; do
    cargo run --release --quiet -- run examples/13_drone_net/drone_net.toml --quiet \
        --set launch.spread="$spread deg" --out "results/spread_$spread"
    python3 - "$spread" "results/spread_$spread/summary.json" <<'PYTHON'
import json, sys
spread, run = sys.argv[1], json.load(open(sys.argv[2]))
opening, place, tension = run["opening"], run["places"]["opening"], run["tension"]
show = lambda value, unit: "-" if value is None else f"{value:.3g} {unit}"
print(spread, "deg:", show(opening["area_max_m2"], "m2"), show(opening["effective_from_s"], "s"),
      show(opening["effective_duration_s"], "s"), show(place["travel_m"], "m"), show(tension["max_n"], "N"), sep="\t")
PYTHON
done
