#!/usr/bin/env python3
"""Prints the tables of docs/reproducing-the-paper.md from the results of the figure decks.

    examples/paper/evaluate.py RESULTS [FIGURE...]

RESULTS holds a directory for each deck, fig01 and so on; all of them by default."""

import sys
from math import exp, inf, pi
from pathlib import Path

from results import Curves, digits, modulus_at, percent, runs, study, table, wall_time

MS = 1e-3
METHODS = ("quasistatic", "dynamic")


def in_unit(pascal, unit):
    return digits(pascal / {"kPa": 1e3, "MPa": 1e6}[unit])


def fig01(directory):
    curves = Curves(directory)
    difference = curves.largest_difference({"method": "dynamic"}, {"method": "quasistatic"})
    domain, history = runs(directory, "model")[0]
    begin, end = domain["valid_s"]
    rings = max(abs(g / curves.at(t, method="quasistatic") - 1) for t, g in history if max(begin, 2 * MS) < t < 3 * MS)
    return (f"Valid from {begin / MS:.3g} ms. Largest deviation from the quasi-static curve: {percent(rings)} % of single "
            f"samples from 2 to 3 ms, {percent(difference)} % of the curve, smoothed, from 2 to 20 ms.\n")


def fig02(directory):
    curves, text = Curves(directory), ""
    resolutions = ("8 /mm", "16 /mm", "32 /mm", "64 /mm")
    times = (1, 3, 10, 30, 50, 100)
    for volumetric in ("standard", "averaged"):
        at = lambda r, t: curves.at(t * MS, resolution=r, volumetric=volumetric, method="quasistatic")
        dynamic = {r: curves.largest_difference({"method": "dynamic"}, {"method": "quasistatic"}, resolution=r,
                                                volumetric=volumetric) for r in resolutions}
        text += f"\n`{volumetric}`, G in kPa, quasi-static:\n\n" + table(
            ["points / mm", *(f"{t} ms" for t in times), "dynamic within"],
            [[r[:-4], *(in_unit(at(r, t), "kPa") for t in times), percent(dynamic[r]) + " %"] for r in resolutions])
        rows = []
        for name, limit in (("above 64 / mm", lambda t: at("64 /mm", t)),
                            ("above the limit", lambda t: 2 * at("64 /mm", t) - at("32 /mm", t))):
            above = {r: [at(r, t * 1.0) / limit(t) - 1 for t in times] for r in resolutions}
            for r in resolutions[:3]:
                rows.append([name, r[:-4], *(percent(value) + " %" for value in above[r])])
            for a, b in (("8 /mm", "16 /mm"), ("16 /mm", "32 /mm")):
                rows.append([name, f"ratio {a[:-4]} : {b[:-4]}",
                             *(digits(x / y, 3) for x, y in zip(above[a], above[b]))])
        text += "\n" + table(["deviation", "points / mm", *(f"{t} ms" for t in times)], rows)
    return text


def fig03(directory):
    curves, times = Curves(directory), (1, 10, 30, 50, 100)
    rows = []
    for method in METHODS:
        def above(stage, resolution, reference, t):
            at = lambda r: curves.at(t * MS, stage=stage, resolution=f"{r} /mm", method=method)
            return at(resolution) / at(reference) - 1
        for r in (8, 16, 32):
            rows.append([method, f"2 mm, {r} / mm", *(percent(above("2mm", r, 64, t)) + " %" for t in times)])
            rows.append([method, f"1 mm, {2 * r} / mm", *(percent(above("1mm", 2 * r, 128, t)) + " %" for t in times)])
        rows.append([method, "1 mm, 32 / mm, above 64 / mm",
                     *(percent(above("1mm", 32, 64, t)) + " %" for t in times)])
    return table(["method", "discs, resolution", *(f"{t} ms" for t in times)], rows)


def fig04(directory):
    curves, times = Curves(directory), (1, 3, 10, 30, 50, 100)
    rows = []
    for volumetric in ("standard", "averaged"):
        for method in METHODS:
            values = {t: [curves.at(t * MS, seed=s, volumetric=volumetric, method=method) for s in (1, 2, 3)] for t in times}
            for s in (1, 2, 3):
                rows.append([volumetric, method, f"seed {s}", *(in_unit(values[t][s - 1], "kPa") for t in times)])
            rows.append([volumetric, method, "highest over lowest",
                         *(f"+{percent(max(values[t]) / min(values[t]) - 1)} %" for t in times)])
    return table(["points", "method", "", *(f"{t} ms" for t in times)], rows)


def fig05(directory):
    curves, times = Curves(directory), (1, 3, 10, 20, 30, 50)
    rows = []
    for case in ("regular", "random"):
        for method in METHODS:
            at = lambda kind, t: curves.at(t * MS, stage=f"{case}-{kind}", load="shear", method=method)
            rows.append([case, method, *(f"{100 * (at('two-stage', t) / at('resolved', t) - 1):+.1f} %" for t in times)])
    return table(["discs", "method", *(f"{t} ms" for t in times)], rows)


def fig06(directory):
    curves, times = Curves(directory), (3, 5, 10, 30, 50, 100)
    rows = []
    for domain, history in runs(directory, "2mm"):
        begin = domain["valid_s"][0]
        history = [point for point in history if point[0] > 0]

        def deviation(t):
            share = modulus_at(history, t * MS) / curves.at(t * MS, method="quasistatic") - 1
            return f"{100 * share:+.2f} %" if t * MS > begin else f"({100 * share:+.2f} %)"
        rows.append([digits(domain["density_factor"]), f"{begin / MS:.3g} ms", domain["steps"], *map(deviation, times)])
    return "In brackets: before the run counts.\n\n" + table(["density", "valid from", "steps", *(f"{t} ms" for t in times)], rows)


def fig07(directory):
    rows = []
    model = 4 * pi * 2e-3 / 6e-3**2
    for stage in study(directory)["stages"]:
        made = stage["microstructure"]
        rows.append([stage["name"], made["particles"], f"{100 * made['fraction']:.1f} %",
                     f"{made['smallest_gap_m'] * 1e6:.3g} µm", f"{100 * made['size_distribution_deviation']:.1f} %",
                     digits(made["interface_per_area_1_per_m"] / model, 3)])
    return table(["stage", "particles", "fraction", "smallest gap", "sizes drawn off by at most",
                  "interface / area over that of the model composite"], rows)


def fig08(directory):
    curves = Curves(directory)
    fine = directory.with_name(directory.name + "-600")
    finest = Curves(fine) if fine.exists() else None
    rows = []
    for cells in (50, 100, 150, 200, 300, 600):
        row = [cells, round(2 * cells / 0.048)]
        for volumetric in ("standard", "averaged"):
            for method in METHODS:
                if cells < 600:
                    row.append(in_unit(curves.at(10 * MS, cells=cells, volumetric=volumetric, method=method), "MPa"))
                elif finest is None or method == "dynamic":
                    row.append("")
                else:
                    row.append(in_unit(finest.at(10 * MS, volumetric=volumetric), "MPa"))
        rows.append(row)
    return table(["cells", "points / mm", *(f"{v}, {m}" for v in ("standard", "averaged") for m in METHODS)], rows)


def fig09(directory):
    curves = Curves(directory)
    test = next(one for one in study(directory)["stages"][0]["tests"] if "time_domains" in one)
    rows = []
    for i, domain in enumerate(test["time_domains"]):
        begin, end = domain["valid_s"]
        overlap = f"{percent(test['overlaps'][i]['mismatch'])} %" if i < len(test["overlaps"]) else ""
        rows.append([f"{domain['density_factor']:.0e}", f"{begin:.2g} s", f"{end:.2g} s", domain["steps"], overlap])
    difference = curves.largest_difference({"method": "dynamic"}, {"method": "quasistatic"})
    return table(["density", "valid from", "to", "steps", "overlap with the next within"], rows) + \
        f"\nLargest difference from the quasi-static curve: {percent(difference)} %.\n"


def fig10(directory):
    curves = Curves(directory)
    times = [10.0**k for k in range(-8, -1)]
    measured = [measured_modulus(t) for t in times]
    rows = [["measured", "", "", *(in_unit(g, "MPa") for g in measured)]]

    def add(what, of, **wanted):
        for boundary, bound in (("displacement", "upper"), ("traction", "lower")):
            values = [of.at(t, stage="PBX-9501", load="shear", boundary=boundary, **wanted) for t in times]
            ratios = (f"{in_unit(g, 'MPa')} ({g / m:.2f})" for g, m in zip(values, measured))
            rows.append([bound, what, wanted["method"], *ratios])
    for method in METHODS:
        add("standard", curves, method=method)
    limit = directory.with_name(directory.name + "-limit")
    if limit.exists():
        add("averaged, vanishing cells", Curves(limit), method="quasistatic", cells="extrapolated")
    return table(["", "points", "method", *("10 ns", "100 ns", "1 µs", "10 µs", "100 µs", "1 ms", "10 ms")], rows)


def measured_modulus(time):
    """G(t) [Pa] of the measured Prony series."""
    total = 0.0
    path = Path(__file__).parent / "../../data/pbx9501_measured_relaxation.csv"
    lines = [line.split(",") for line in path.read_text().splitlines() if line and not line.startswith("#")]
    column = [name.strip() for name in lines[0]].index("relaxation_time_s")
    for line in lines[1:]:
        tau, modulus = float(line[column]), float(line[1 - column])
        total += modulus if tau == inf else modulus * exp(-time / tau)
    return total


def main():
    results = Path(sys.argv[1])
    figures = sys.argv[2:] or [f"fig{i:02}" for i in range(1, 11)]
    for name in figures:
        directory = results / name
        print(f"## {name}\n")
        print(globals()[name](directory))
        seconds = wall_time(directory)
        print(f"Wall time {seconds:.0f} s.\n" if seconds else "")


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main()
