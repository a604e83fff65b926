#!/usr/bin/env bash
# Runs all cases of docs/studies/pbx9501-films.md: PBX-9501 from grains and films of binder
# (tests.model = "films"), for several seeds, numbers of grains, boundaries, meshes, fractions and sizes. About a quarter
# of an hour of processor time, at most 3 GB. What is done already is not run again.
#
#   examples/films/run.sh [RESULTS]      by default results/films
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

results=${1:-results/films}
breccia=${BRECCIA:-build/demo/bin/breccia}
[[ -x $breccia ]] || scripts/build demo

# run NAME OPTIONS...
run() {
  local name=$1
  shift
  "$breccia" run examples/pbx9501-films.toml --out "$results/$name" --resume --quiet \
    --set 'tests.quasistatic.range="times"' --set tests.quasistatic.tolerance=1e-4 --set tests.fields=none "$@"
}

# sizes NAME FROM TO BOX OPTIONS...: grains with the sizes of HMX
sizes() {
  local name=$1 from=$2 to=$3 box=$4
  shift 4
  run "$name" --set 'stages.0.filler.sizes="../data/hmx_sizes.csv"' --set "stages.0.filler.from=\"$from\"" \
    --set "stages.0.filler.to=\"$to\"" --set "stages.0.box=\"$box\"" "$@"
}

# Numbers of grains and boundaries: boxes of 25, 100, 400 and 1000 grains of one size
for case in 25:443 100:886 400:1772 1000:2800; do
  count=${case%:*}
  box=${case#*:}
  seeds=10
  [[ $count == 1000 ]] && seeds=4
  for ((seed = 1; seed <= seeds; ++seed)); do
    of_box=(--set "stages.0.box=\"$box um\"" --set "stages.0.packing.seed=$seed")
    run "periodic-$count-seed$seed" "${of_box[@]}"
    run "bounds-$count-seed$seed" "${of_box[@]}" --set 'stages.0.packing.walls="cut"'
  done
done

# Elements half as long
run mesh-400 --set 'stages.0.box="1772 um"' --set tests.films.face_share=0.15
run mesh-sizes --set tests.films.face_share=0.15 --set 'stages.0.filler.sizes="../data/hmx_sizes.csv"' \
  --set 'stages.0.filler.from="50 um"' --set 'stages.0.filler.to="500 um"' --set 'stages.0.box="2 mm"'

# Fractions
for fraction in 0.90 0.92 0.95; do
  run "fraction-$fraction" --set 'stages.0.box="1772 um"' --set "stages.0.filler.fraction=$fraction"
done

# Sizes of HMX, periodic, and both bounds
for ((seed = 1; seed <= 10; ++seed)); do
  sizes "sizes-50-seed$seed" "50 um" "500 um" "2 mm" --set "stages.0.packing.seed=$seed"
  sizes "bounds-50-seed$seed" "50 um" "500 um" "2 mm" --set "stages.0.packing.seed=$seed" --set 'stages.0.packing.walls="cut"'
done
for ((seed = 1; seed <= 3; ++seed)); do
  sizes "sizes-20-seed$seed" "20 um" "1 mm" "2.75 mm" --set "stages.0.packing.seed=$seed"
done
sizes sizes-10 "10 um" "1 mm" "2.75 mm"

examples/films/evaluate.py "$results"
