#!/usr/bin/env python3
"""Composites that were measured, predicted with nothing fitted: runs the decks of this directory and prints the table of
docs/validation.md.

    examples/materials/evaluate.py [MATERIAL ...]

MATERIAL is concrete, asphalt, asphalt-of-spheres, polyethylene, glass or polystyrene; all of them unless told, but for asphalt-of-spheres, which
takes hours. The program is `breccia` of the path, or BRECCIA of the environment; results are in `results/materials`, or the
directory RESULTS of the environment; runs of the same decks that are there already are taken as they are. The rules by
which each deck was written are in docs/validation.md."""

import cmath
import csv
import json
import math
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
RESULTS = Path(os.environ.get("RESULTS", "results/materials"))
BRECCIA = os.environ.get("BRECCIA", "breccia")
DAY = 86400.0


def rows_of(path):
    """The rows of a table, without its comments."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def solved(name, deck, *settings):
    """The directory of a run. One of the same deck is continued, or taken where it is complete; another is replaced."""
    run = RESULTS / name
    options = [part for setting in settings for part in ("--set", setting)]
    command = [BRECCIA, "run", HERE / deck, *options, "--out", run, "--quiet"]
    is_there = (run / "study.json").exists()
    if not is_there or subprocess.run([*command, "--resume"], stderr=subprocess.DEVNULL).returncode != 0:
        subprocess.run([*command, "--overwrite"], check=True)
    return run


def interpolated(points, at):
    """The value at a place of a curve of (place, value), linear in the logarithms."""
    points = sorted(points)
    for (left, below), (right, above) in zip(points, points[1:]):
        if left <= at * (1.0 + 1e-9) and at <= right * (1.0 + 1e-9):
            share = math.log(at / left) / math.log(right / left)
            return below * (above / below) ** share
    raise ValueError(f"{at} is outside of {points[0][0]} to {points[-1][0]}")


def of_stage(run, table, stage):
    """The rows of a stage in a table of a run."""
    return [row for row in rows_of(run / table) if row["stage"] == stage]


HEAD = ("| composite | quantity | predicted over measured | at | deck |", "|---|---|---|---|---|")


class Table:
    """The table of predictions over measurements, a line for each composite."""

    def __init__(self):
        self.lines = []

    def add(self, composite, quantity, run, ratios):
        """Takes the ratios of predicted to measured values by place, in words such as "0.02 d"."""
        at = ", ".join(f"{ratio:.3g} at {place}" for place, ratio in ratios.items())
        deck = json.loads((run / "study.json").read_text(encoding="utf-8"))["hash"]
        self.lines.append(f"| {composite} | {quantity} | {min(ratios.values()):.3g} to {max(ratios.values()):.3g} | {at} | {deck} |")

    def begin(self, title):
        """Begins another table, below a title."""
        self.lines += ["", title, "", *HEAD]

    def show(self):
        print("\n".join([*HEAD, *self.lines]))


def concrete(table):
    """Le Roy's two mixes; the fraction of aggregate from 68 to 72 %, and another gap."""
    cases = {"70 %": (), "68 %": ("stages.mortar.filler.amount.volume=27 %",),
             "72 %": ("stages.mortar.filler.amount.volume=31 %",), "70 %, half of the gap": ("stages.*.filler.gap=5 %",)}
    for mix in ("P28-10", "P50-0"):
        measured = {float(row["time_day"]): float(row["youngs_compliance_1_per_TPa"])
                    for row in rows_of(HERE / "concrete" / f"concrete_{mix}.csv")}
        for name, settings in cases.items():
            run = solved(f"concrete-{mix}-{name.replace(',', '').replace(' ', '-').replace('%', 'percent')}", "concrete/concrete.toml",
                         f"materials.paste.young.measured=paste_{mix}.csv",
                         f"measurements.0.young.measured=concrete_{mix}.csv", *settings)
            predicted = [(float(row["time_s"]) / DAY, 1e12 * float(row["tensile_compliance_1_per_Pa"]))
                         for row in of_stage(run, "engineering.csv", "concrete")]
            table.add(f"concrete {mix}, {name}", "J", run, {
                f"{day:g} d": interpolated(predicted, day) / interpolated(measured.items(), day)
                for day in (0.02, 0.1, 1.0, 10.0, 50.0, 90.0)})


def polyethylene(table):
    """The storage modulus with 10 % by mass of silica."""
    run = solved("polyethylene", "polyethylene-silica/polyethylene-silica.toml")
    rows = of_stage(run, "engineering_dynamic.csv", "composite")
    for quantity, column in (("E'", "youngs_storage_modulus"), ("E''", "youngs_loss_modulus")):
        predicted = [(float(row["angular_frequency_rad_per_s"]) / math.tau, float(row[f"{column}_Pa"]) / 1e6) for row in rows]
        measured = {float(row["frequency_Hz"]): float(row[f"{column}_MPa"])
                    for row in rows_of(HERE / "polyethylene-silica" / "composite.csv")}
        table.add("polyethylene with 4.6 % of silica", quantity, run, {
            f"{hertz:g} Hz": interpolated(predicted, hertz) / value for hertz, value in measured.items()})


def glass(table):
    """Young's modulus of epoxy with glass spheres, with two values of Poisson's ratio of the epoxy."""
    measured = {float(row["volume_fraction"]): float(row["youngs_modulus_MPa"])
                for row in rows_of(HERE / "glass-epoxy" / "composite.csv") if float(row["volume_fraction"]) > 0.0}
    # The default gap does not pack at 0.5; the box that the program chooses for half of it takes too long.
    dense = ("stages.0.filler.gap=5 %", "stages.0.cells=100", "stages.0.box=0.34 mm")
    for poisson in (0.19, 0.35):
        ratios = {}
        for fraction, modulus in measured.items():
            run = solved(f"glass-{poisson}-{fraction}", "glass-epoxy/glass-epoxy.toml", f"materials.epoxy.poisson={poisson}",
                         f"stages.0.filler.fraction={fraction}", *(dense if fraction > 0.45 else ()))
            row = of_stage(run, "engineering.csv", "composite")[-1]
            ratios[f"{fraction:g}"] = float(row["youngs_modulus_Pa"]) / (1e6 * modulus)
        table.add(f"epoxy with glass spheres, Poisson's ratio {poisson}", "E", run, ratios)


def polystyrene(table):
    """A negative control: |G*| of a melt with a network of nanoparticles."""
    run = solved("polystyrene", "polystyrene-silica/polystyrene-silica.toml")
    for name in ("untreated", "treated"):
        rows = [row for row in rows_of(run / "comparison_dynamic.csv") if row["measurement"] == name]
        table.add(f"polystyrene with 5 % of {name} silica", "\\|G*\\|", run, {
            f"{float(row['frequency_Hz']):.3g} Hz": float(row["ratio"]) for row in rows})


def modulus_of(law, omega):
    """The complex modulus of 2S2P1D [MPa]."""
    tau, p = float(law["time_s"]), 1j * omega
    low, high = float(law["static_MPa"]), float(law["glassy_MPa"])
    return low + (high - low) / (1.0 + float(law["delta"]) * (p * tau) ** -float(law["k"]) + (p * tau) ** -float(law["h"])
                                 + 1.0 / (p * float(law["beta"]) * tau))


def bitumen_file(law, name, times=1.0, equilibrium=0.0):
    """A file with the bitumen of a sample, for `breccia respond`; its times by a factor, its shear modulus with another
    equilibrium [Pa] added."""
    path = RESULTS / f"bitumen-{name}.toml"
    static, time = float(law["static_MPa"]) + 3e-6 * equilibrium, float(law["time_s"]) * times
    path.write_text('density = "1.04 g/cm^3"\nbulk = "2.5 GPa"\nyoung = { law = "2s2p1d", ' + ", ".join(
        [f'static = "{static:.9g} MPa"', f'glassy = "{law["glassy_MPa"]} MPa"', f'time = "{time:.9g} s"']
        + [f"{key} = {law[key]}" for key in ("delta", "k", "h", "beta")]) + " }\n", encoding="utf-8")
    return path


def answered(run, bitumen, name):
    """The directory of the answer of a run with another bitumen; None where it is beyond what the run has sampled."""
    response = RESULTS / name
    answer = subprocess.run([BRECCIA, "respond", run, "--material", f"bitumen={bitumen}", "--out", response, "--overwrite",
                             "--quiet"], stderr=subprocess.PIPE, text=True)
    if answer.returncode == 0:
        return response
    print(answer.stderr, file=sys.stderr)
    if "the responses hold from" not in answer.stderr:
        sys.exit(f"{name}: the answer failed")
    return None


def add_mixture(table, name, run, response, law):
    """Adds |E*| and the phase of a mixture to the table."""
    if response is None:
        table.lines.append(f"| {name} | \\|E*\\| | | beyond what the run has sampled | |")
        return
    rows = of_stage(response, "engineering_dynamic.csv", "mixture")
    absolute, phase = {}, {}
    for omega in (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 300.0):
        parts = [interpolated([(float(row["angular_frequency_rad_per_s"]), float(row[f"youngs_{part}_modulus_Pa"]))
                               for row in rows], omega) / 1e6 for part in ("storage", "loss")]
        measured = modulus_of(law, omega)
        absolute[f"{omega:g} rad/s"] = abs(complex(*parts)) / abs(measured)
        phase[f"{omega:g} rad/s"] = cmath.phase(complex(*parts)) / cmath.phase(measured)
    table.add(name, "\\|E*\\|", run, absolute)
    table.add(name, "phase", run, phase)


def found_on_one_mixture(run):
    """Two numbers of the bitumen that `breccia calibrate` finds on the mixture H0 alone: the factor of its relaxation times,
    and its equilibrium shear modulus [Pa]."""
    found = RESULTS / "asphalt-calibrated"
    subprocess.run([BRECCIA, "calibrate", run, "--measured", HERE / "asphalt" / "mixture_H0.csv",
                    "--unknown", 'bitumen.equilibrium={ from = "0.01 Pa", to = "1 MPa" }',
                    "--unknown", "bitumen.times={ value = 1, factor = 30 }", "--out", found, "--overwrite"], check=True,
                   stdout=sys.stderr)
    values = {row["unknown"]: float(row["value"]) for row in rows_of(found / "estimates.csv")}
    return values["bitumen.times"], values["bitumen.equilibrium"]


SAMPLES = ("H0", "H3", "H9", "W0", "W3", "W6")


def laws_of_samples():
    """The 2S2P1D models of each sample, as binder and as mixture."""
    return {(row["sample"], row["what"]): row for row in rows_of(HERE / "asphalt" / "parameters.csv")}


def mixtures_as(model, table):
    """Six mixtures, from one run with the bitumen H0 whose response answers the others; returns the run."""
    laws = laws_of_samples()
    run = solved(f"asphalt-{model}", f"asphalt/{model}.toml")
    for sample in SAMPLES:
        response = run
        if sample != "H0":
            response = answered(run, bitumen_file(laws[sample, "binder"], sample), f"asphalt-{model}-{sample}")
        add_mixture(table, f"asphalt {sample} as {model}", run, response, laws[sample, "mixture"])
    return run


def asphalt_of_spheres(table):
    """The mixtures as spheres in stages."""
    mixtures_as("spheres", table)


def asphalt(table):
    """The mixtures as grains with films; then the same with what the mixture H0 shows of its bitumen."""
    run = mixtures_as("grains", table)
    laws = laws_of_samples()
    times, equilibrium = found_on_one_mixture(run)
    table.begin(f"With what the mixture H0 shows of its bitumen, times by a factor {times:.3g} and an equilibrium shear modulus "
                f"of {equilibrium / 1e6:.3g} MPa, in all bitumens:")
    for sample in SAMPLES:
        bitumen = bitumen_file(laws[sample, "binder"], f"{sample}-calibrated", times, equilibrium)
        response = answered(run, bitumen, f"asphalt-grains-{sample}-calibrated")
        add_mixture(table, f"asphalt {sample} as grains, calibrated on H0", run, response, laws[sample, "mixture"])


MATERIALS = {"concrete": concrete, "polyethylene": polyethylene, "glass": glass, "polystyrene": polystyrene, "asphalt": asphalt,
             "asphalt-of-spheres": asphalt_of_spheres}


def main():
    chosen = sys.argv[1:] or [name for name in MATERIALS if name != "asphalt-of-spheres"]
    unknown = [name for name in chosen if name not in MATERIALS]
    if unknown:
        sys.exit(f"unknown material {', '.join(unknown)}; expected some of {', '.join(MATERIALS)}")
    RESULTS.mkdir(parents=True, exist_ok=True)
    table = Table()
    for name in chosen:
        MATERIALS[name](table)
    table.show()


if __name__ == "__main__":
    main()
