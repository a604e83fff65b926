#!/usr/bin/env python3
"""Work, memory and messages of a deck by the number of processes, as a table; the curves are compared with those of the
first number.

    bench/processes.py DECK [--processes N ...] [--set KEY=VALUE ...] [--threads N]

The program is `breccia` of the path, or BRECCIA of the environment; `libmpi_traffic.so` of the preset `release` counts the
messages and the processor time in MPI, most of which a process waits for others. The work is the processor time of the
whole program without that. The messages of MUMPS are not counted."""

import argparse
import csv
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BRECCIA = os.environ.get("BRECCIA", "breccia")
COUNTER = ROOT / "build" / "release" / "bench" / "libmpi_traffic.so"
MEASURE = "--measure-one-process"


def measure_one_process(record, *command):
    """Runs a command as one of the processes, and appends its processor time and memory to a file."""
    code = subprocess.run(command, check=False).returncode
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(record, "a") as file:
        file.write(f"{usage.ru_utime + usage.ru_stime} {1024 * usage.ru_maxrss}\n")
    return code


def numbers(path):
    return [[float(word) for word in line.split()] for line in path.read_text().splitlines()] if path.exists() else []


def last_columns(path):
    with open(path, newline="") as file:
        return [float(row[-1]) for row in list(csv.reader(file))[1:]]


class Run:
    """What a deck took on some processes, and its curves."""

    def __init__(self, deck, processes, options, threads, work):
        results, record, traffic = work / f"{processes}", work / f"{processes}.usage", work / f"{processes}.traffic"
        command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-x", f"MPI_TRAFFIC={traffic}", "-x",
                   "OMPI_MCA_mpi_yield_when_idle=1", "-n", str(processes)]
        if os.geteuid() == 0:
            command.insert(1, "--allow-run-as-root")
        command += [sys.executable, __file__, MEASURE, str(record)]
        if COUNTER.exists():
            command += ["env", f"LD_PRELOAD={COUNTER}"]
        command += [BRECCIA, "run", deck, "--out", str(results), "--quiet", "--threads", str(threads)] + options
        if subprocess.run(command, check=False).returncode != 0:
            sys.exit(f"{' '.join(command)}: failed")
        usage = numbers(record)
        self.seconds = sum(seconds for seconds, _ in usage)
        self.work = self.seconds - sum(line[5] for line in numbers(traffic))
        self.memory = max(memory for _, memory in usage)
        self.sent = max((line[1] for line in numbers(traffic)), default=0.0)
        self.moduli = last_columns(results / "curves.csv")
        stages = json.loads((results / "study.json").read_text())["stages"]
        efforts = [test["linear"] for stage in stages for test in stage["tests"] if "linear" in test]
        self.iterations = sum(effort["iterations"] for effort in efforts)
        self.most_iterations = [effort["most_iterations"] for effort in efforts]

    def difference(self, other):
        return max(abs(mine / theirs - 1.0) for mine, theirs in zip(self.moduli, other.moduli, strict=True))


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("deck")
    parser.add_argument("--processes", nargs="+", type=int, default=[1, 2, 3, 4, 8])
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    options = [word for key in arguments.set for word in ("--set", key)]
    print("| processes | largest difference | iterations, most of each test | processor time | work | ... over one | "
          "memory of the largest | ... times processes over one | sent by a process, an iteration |")
    print("|---" * 9 + "|")
    first = None
    with tempfile.TemporaryDirectory() as work:
        for processes in arguments.processes:
            run = Run(arguments.deck, processes, options, arguments.threads, Path(work))
            first = first or run
            share = processes / arguments.processes[0]
            print(f"| {processes} | {run.difference(first):.0e} | {run.iterations}, "
                  f"{' '.join(str(n) for n in run.most_iterations)} | {run.seconds:.1f} s | "
                  f"{run.work:.1f} s | {run.work / first.work:.2f} | {run.memory / 1e6:.0f} MB | "
                  f"{share * run.memory / first.memory:.2f} | {run.sent / max(1, run.iterations):.0f} B |", flush=True)


if __name__ == "__main__":
    sys.exit(measure_one_process(*sys.argv[2:]) if sys.argv[1:2] == [MEASURE] else main())
