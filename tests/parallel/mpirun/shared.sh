# What the tests in this directory share. Each of them runs decks by several processes and is called as
#
#   NAME BRECCIA MPIRUN EXAMPLES
#
# where EXAMPLES is the directory of the decks.

breccia=$1 mpirun=$2 examples=$3
deck=$examples/model-composite.toml
in_space=$(dirname "${BASH_SOURCE[0]}")/beads.toml # a cube
# Root in a container, more processes than cores, cores that are busy with other work, and no network are all fine for a
# test. Processes that wait let others run.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl=self,vader OMPI_MCA_hwloc_base_binding_policy=none OMP_NUM_THREADS=1

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run() { # NAME PROCESSES [OPTIONS]
  local name=$1 processes=$2
  shift 2
  "$mpirun" -n "$processes" "$breccia" run "$deck" --out "$work/$name" --quiet --set 'stages.0.cells=24' "$@"
}

most=1e-8 # largest relative difference of curves that is taken for rounding

# Largest relative difference of the last column of two tables; they must have the same rows.
largest_difference() {
  paste -d, "$1" "$2" | awk -F, -v most="$most" '
    FNR > 1 {
      half = NF / 2
      for (i = 1; i < half - 1; i++) if ($i != $(i + half)) { print "different rows"; is_other = 1; exit }
      d = $NF / $half - 1
      if (d < 0) d = -d
      if (d > largest) largest = d
    }
    END { printf "%.1e\n", largest; exit is_other || NR < 2 || !(largest <= most) }'
}

# Prints the largest difference of two tables, and ends the test where it is too large.
compare() { # WORDS TABLE TABLE
  local difference
  difference=$(largest_difference "$2" "$3") || { echo "$1: $difference" >&2; exit 1; }
  echo "$1: $difference"
}

# Runs until the first moment at which the run can be interrupted.
cut() { # NAME PROCESSES [OPTIONS]
  local code=0
  run "$@" --time-limit '1 us' 2> /dev/null || code=$?
  [[ $code == 130 ]] || { echo "$1: exit code $code where a run is cut off" >&2; exit 1; }
}

# Runs to the end by one process; and begun by four, gone on with by two, brought to its end by three.
run_by_others() { # NAME [OPTIONS]
  local name=$1
  shift
  run "$name-1" 1 "$@"
  cut "$name" 4 "$@"
  cut "$name" 2 "$@" --resume
  run "$name" 3 "$@" --resume
}
