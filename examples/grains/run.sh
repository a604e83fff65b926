#!/usr/bin/env bash
# Runs all cases of docs/studies/pbx9501-grains.md: PBX-9501 from grains that interlock, for several seeds, numbers of grains,
# cells a film, boundaries, sizes and stages. About three quarters of an hour of processor time, at most 5 GB. What is done
# already is not run again.
#
#   examples/grains/run.sh [RESULTS]      by default results/grains
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

results=${1:-results/grains}
breccia=build/demo/bin/breccia
[[ -x $breccia ]] || scripts/build demo

# run NAME DECK OPTIONS...
run() {
  local name=$1 deck=$2
  shift 2
  "$breccia" run "$deck" --out "$results/$name" --resume --set 'tests.fields="none"' "$@"
}

# equal NAME CELLS BOX_IN_UM SEED OPTIONS...: grains of one size, 100 um
equal() {
  local name=$1 cells=$2 box=$3 seed=$4
  shift 4
  run "$name" examples/pbx9501-grains-quick.toml --set "stages.0.cells=$cells" --set "stages.0.box=\"$box um\"" \
    --set "stages.0.packing.seed=$seed" "$@"
}

bounds=(--set 'tests.boundaries=["displacement", "traction"]')

for seed in 1 2 3 4 5 6 7 8; do equal "equal-32-seed$seed" 420 500 "$seed"; done
for seed in 1 2; do equal "equal-128-seed$seed" 840 1000 "$seed"; done
equal equal-512-seed1 1680 2000 1

# Twice the cells a film
equal equal-32-840 840 500 1

# Bounds
equal equal-32-bounds 420 500 1 "${bounds[@]}"
equal equal-128-bounds 840 1000 1 "${bounds[@]}"

# Sizes of HMX in one stage, and all sizes in two and three stages
for seed in 1 2; do run "sizes-seed$seed" examples/pbx9501-grains.toml --set "stages.0.packing.seed=$seed"; done
run sizes-wide examples/pbx9501-grains.toml --set 'stages.0.filler.from="20 um"' --set 'stages.0.filler.to="1 mm"' \
  --set 'stages.0.box="2.75 mm"' --set stages.0.cells=2350 --set 'tests.quasistatic.range="times"' \
  --set tests.quasistatic.tolerance=1e-4 --set tests.quasistatic.linear_tolerance=1e-8
run two-stages examples/grains/two-stages.toml
for seed in 1 2; do run "three-stages-seed$seed" examples/grains/three-stages.toml --set "stages.*.packing.seed=$seed"; done

examples/grains/evaluate.py "$results"
