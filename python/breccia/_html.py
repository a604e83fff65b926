"""What notebooks show of results: a plot of G(t), its values at whole decades, the microstructure, warnings."""

from __future__ import annotations

import html
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._plot import Band, Curve, Floats, plain, plot, plot_over_temperature


def _three_digits(value: float, unit: str) -> str:
    """A value with an SI prefix."""
    if not math.isfinite(value) or value == 0.0:
        return f"{value:g} {unit}"
    power = min(max(3 * math.floor(math.log10(abs(value)) / 3), -15), 12)
    prefix = {-15: "f", -12: "p", -9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}[power]
    return f"{value / 10.0**power:.3g} {prefix}{unit}"


def _preferred(stage: _native.StageResult, load: str) -> list[_native.TestResult]:
    """The preferred test of each boundary condition and method."""
    keys = list(dict.fromkeys((test.boundary, test.method) for test in stage.tests if test.load == load))
    return [stage.test(load, boundary, method) for boundary, method in keys]


def _label(test: _native.TestResult, tests: list[_native.TestResult]) -> str:
    methods = {one.method for one in tests}
    return test.boundary + (f", {test.method}" if len(methods) > 1 else "")


def _decades(test: _native.TestResult) -> Floats:
    """Whole decades within a curve, at most nine [s]."""
    first, last = np.log10(test.time[0]), np.log10(test.time[-1])
    whole = np.arange(math.ceil(first - 1e-9), math.floor(last + 1e-9) + 1)
    return 10.0 ** whole[:: max(1, math.ceil(len(whole) / 9))]


def _error(share: float) -> str:
    """The error of a modulus; nothing where it is not known."""
    return f" \u00b1 {100 * share:.2g} %" if math.isfinite(share) else ""


def _table(tests: list[_native.TestResult]) -> str:
    times = _decades(tests[0])
    head = "".join(f'<th style="text-align:right">{_three_digits(time, "s")}</th>' for time in times)
    rows = []
    for test in tests:
        values = np.exp(np.interp(np.log(times), np.log(test.time), np.log(test.modulus)))
        errors = np.interp(np.log(times), np.log(test.time), test.error) if len(test.error) else np.full(len(times), np.nan)
        cells = "".join(f'<td style="text-align:right">{_three_digits(value, "Pa")}{_error(error)}</td>'
                        for value, error in zip(values, errors))
        rows.append(f'<tr><th style="text-align:left">{_label(test, tests)}</th>{cells}</tr>')
    return f"<table><tr><th></th>{head}</tr>{''.join(rows)}</table>"


def _row_text(values: list[str], tag: str = "td") -> str:
    return "<tr>" + "".join(f'<{tag} style="text-align:right">{value}</{tag}>' for value in values) + "</tr>"


def _frequency_table(moduli: _native.ComplexModuli) -> str:
    """|G*| with its error, phase, G', G'' and tan delta at whole decades of hertz, or at the ends where there are none."""
    first, last = np.log10(moduli.frequency[0]), np.log10(moduli.frequency[-1])
    whole = np.arange(math.ceil(first - 1e-9), math.floor(last + 1e-9) + 1)
    shown = 10.0 ** whole[:: max(1, math.ceil(len(whole) / 9))] if len(whole) > 1 else moduli.frequency[[0, -1]]
    rows = []
    for frequency in shown:
        modulus = moduli.at(2 * math.pi * frequency)
        error = moduli.error[np.argmin(np.abs(np.log(moduli.frequency / frequency)))]
        rows.append(_row_text([_three_digits(frequency, "Hz"), _three_digits(abs(modulus), "Pa") + _error(error),
                               f"{math.degrees(np.angle(modulus)):.3g}\u00b0", _three_digits(modulus.real, "Pa"),
                               _three_digits(modulus.imag, "Pa"), f"{modulus.imag / modulus.real:.3g}"]))
    head = _row_text(["frequency", "|G*|", "phase", "G\u2032", "G\u2033", "tan \u03b4"], "th")
    return f"<table>{head}{''.join(rows)}</table>"


def _measurements(stage: _native.StageResult) -> list[dict[str, Any]]:
    """A comparison with each measured shear modulus, that of one of its tests."""
    return list({comparison["measurement"]: comparison for comparison in stage.comparisons
                 if comparison["kind"] == "shear"}.values())


def _in_frequency(stage: _native.StageResult, tests: list[_native.TestResult]) -> str:
    """The complex moduli of a study whose deck gives frequencies, with what was measured."""
    curves, tables = [], []
    for number, test in enumerate(tests):
        moduli, label = test.in_frequency, _label(test, tests)
        curves += [Curve(f"G\u2032, {label}", moduli.frequency, moduli.storage, 2 * number),
                   Curve(f"G\u2033, {label}", moduli.frequency, moduli.loss, 2 * number + 1)]
        tables.append((f"<div>{html.escape(label)}</div>" if len(tests) > 1 else "") + _frequency_table(moduli))
    for comparison in _measurements(stage):
        hertz, measured = comparison["angular_frequency"] / (2 * math.pi), comparison["complex_measured"]
        if len(hertz) > 0:
            curves += [Curve(f"G\u2032, {comparison['measurement']}", hertz, measured.real, 0, marks=True),
                       Curve(f"G\u2033, {comparison['measurement']}", hertz, measured.imag, 1, marks=True)]
    return plot(curves, abscissa="Frequency / Hz") + "".join(tables)


def _plot_of(stage: _native.StageResult, tests: list[_native.TestResult]) -> str:
    curves = [Curve(_label(test, tests), test.time, test.modulus, number) for number, test in enumerate(tests)]
    bounds = {test.boundary: test for test in tests}
    bands = []
    if {"displacement", "traction"} <= set(bounds):
        upper, lower = bounds["displacement"], bounds["traction"]
        if np.array_equal(upper.time, lower.time):
            bands.append(Band(upper.time, lower.modulus, upper.modulus))
    elif len(tests) == 1 and np.isfinite(tests[0].error).all() and len(tests[0].error):
        error = np.minimum(tests[0].error, 0.999)
        bands.append(Band(tests[0].time, tests[0].modulus * (1 - error), tests[0].modulus * (1 + error)))
    for number, comparison in enumerate(_measurements(stage), 5):
        curves.append(Curve(comparison["measurement"], comparison["time"], comparison["measured"], number, marks=True))
    return plot(curves, bands)


def _warnings(stage: _native.StageResult) -> str:
    return "".join(f'<li style="color:#8a4b08">{html.escape(warning)}</li>' for warning in stage.warnings)


def stage_html(stage: _native.StageResult) -> str:
    """A stage for a notebook."""
    loads = [test.load for test in stage.tests]
    parts = []
    if stage.microstructure is not None:
        box = stage.microstructure
        content = box.kind if box.kind == "image" else f"{box.particles} {box.kind}"
        parts.append(f"<div>{content}, {100 * box.fraction:.2f} % of a box of {_three_digits(box.side, 'm')}</div>")
    if loads:
        load = next((one for one in ("isotropic", "shear") if one in loads), loads[0])
        tests = _preferred(stage, load)
        is_in_frequency = all(test.in_frequency.is_of_deck for test in tests)
        name = "Complex" if is_in_frequency else "Relaxation"
        drawn = _in_frequency(stage, tests) if is_in_frequency else _plot_of(stage, tests) + _table(tests)
        parts.append(f"<div>{name} modulus, {html.escape(load)}</div>{drawn}")
    elif stage.microstructure is not None:
        parts.append(microstructure_html(stage.microstructure))
    if stage.accuracy:
        parts.append(f"<div>This box: {html.escape(stage.accuracy)}</div>")
    if stage.warnings:
        parts.append(f"<ul>{_warnings(stage)}</ul>")
    return f"<div><b>{html.escape(stage.name)}</b>{''.join(parts)}</div>"


def result_html(result: _native.Result) -> str:
    """A result for a notebook: the last stage in full, the others on demand."""
    *earlier, last = result.stages
    folded = "".join(f"<details><summary>{html.escape(stage.name)}</summary>{stage_html(stage)}</details>"
                     for stage in earlier)
    return f"<div><div>{html.escape(result.title)}</div>{folded}{stage_html(last)}</div>"


def series_html(series: _native.PronySeries) -> str:
    """A Prony series for a notebook."""
    if series.is_elastic:
        return html.escape(repr(series))
    times = series.relaxation_times
    time = np.geomspace(times[-1] / 30, times[0] * 30, 200)
    return f"<div>{html.escape(repr(series))}</div>" + plot([Curve("M(t)", time, series.at(time))])


def microstructure_html(box: _native.Microstructure) -> str:
    """A microstructure for a notebook, 360 pixels wide."""
    return f'<div style="width:360px">{box.svg()}</div>'


def test_html(test: _native.TestResult) -> str:
    """A test for a notebook."""
    return f"<div>{html.escape(repr(test))}</div>" + plot([Curve(_label(test, [test]), test.time, test.modulus)]) + _table(
        [test])


def complex_html(moduli: _native.ComplexModuli) -> str:
    """A complex modulus for a notebook: G' and G'' over the frequency in Hz, and its table."""
    heading = f"<div>{html.escape(repr(moduli))}</div>"
    if len(moduli) == 0:
        return heading
    return heading + plot([Curve("G\u2032", moduli.frequency, moduli.storage, 0),
                           Curve("G\u2033", moduli.frequency, moduli.loss, 1)],
                          abscissa="Frequency / Hz") + _frequency_table(moduli)


def relaxation_fit_html(fit: _native.RelaxationFit) -> str:
    """A fit of a Prony series for a notebook: the data and the fit."""
    heading = f"<div>{html.escape(repr(fit))}</div>"
    if len(fit.angular_frequency) > 0:
        storage, loss = np.split(fit.measured, 2)
        return heading + _dynamic_plot(fit.angular_frequency, storage, loss, fit.series)
    time = np.geomspace(fit.time[0], fit.time[-1], 200)
    return heading + plot([Curve("M(t), measured", fit.time, fit.measured, 0, marks=True),
                           Curve("M(t), fitted", time, fit.series.at(time), 0)])


def creep_fit_html(fit: _native.CreepFit) -> str:
    """A fit of a creep compliance for a notebook: the data and the fit, in 1/Pa."""
    time = np.geomspace(fit.time[0], fit.time[-1], 200)
    drawn = plot([Curve("J(t) Pa, measured", fit.time, fit.measured, 0, marks=True),
                  Curve("J(t) Pa, fitted", time, fit.compliance.at(time), 0)], ordinate=plain)
    return f"<div>{html.escape(repr(fit))}</div>{drawn}"


def master_curve_html(curve: _native.MasterCurve) -> str:
    """A master curve for a notebook: the shifted data and their fit."""
    drawn = _dynamic_plot(curve.angular_frequency, curve.storage, curve.loss, curve.series)
    return f"<div>{html.escape(repr(curve))}</div>{drawn}"


def _dynamic_plot(measured_at: Floats, storage: Floats, loss: Floats, series: _native.PronySeries) -> str:
    """Dynamic moduli and the series that was fitted to them."""
    frequency = np.geomspace(measured_at[0], measured_at[-1], 200)
    fitted = series.complex_modulus(frequency)
    return plot([Curve("M\u2032, measured", measured_at, storage, 0, marks=True),
                 Curve("M\u2033, measured", measured_at, loss, 1, marks=True),
                 Curve("M\u2032, fitted", frequency, fitted.real, 0),
                 Curve("M\u2033, fitted", frequency, fitted.imag, 1)], abscissa="Angular frequency / (rad/s)")


def engineering_html(moduli: _native.EngineeringModuli) -> str:
    """The moduli of a uniaxial test for a notebook: E, G and K over time, and Poisson's ratio in words."""
    drawn = plot([Curve("E", moduli.time, moduli.young, 0), Curve("G", moduli.time, moduli.shear, 1),
                  Curve("K", moduli.time, moduli.bulk, 2)])
    first, last = _three_digits(moduli.time[0], "s"), _three_digits(moduli.time[-1], "s")
    ratio = f"Poisson's ratio {moduli.poisson[0]:.4g} at {first}, {moduli.poisson[-1]:.4g} at {last}"
    young, poisson = moduli.young_error.max(), moduli.poisson_error.max()
    ratio += "; errors unknown" if np.isnan(young) else f"; error of E up to {100 * young:.2g} %, of the ratio {poisson:.2g}"
    return f"<div>{html.escape(repr(moduli))}</div>{drawn}<div>{html.escape(ratio)}</div>"


def isochrone_html(modulus: NDArray[np.complex128], temperature: Floats, name: str, heading: str) -> str:
    """Complex moduli over the temperature for a notebook: storage and loss modulus, and the loss tangent."""
    celsius = temperature - 273.15
    moduli = plot_over_temperature([Curve(f"{name}\u2032", celsius, modulus.real, 0),
                                    Curve(f"{name}\u2033", celsius, modulus.imag, 1)])
    tangent = plot_over_temperature([Curve("tan \u03b4", celsius, modulus.imag / modulus.real, 2)], plain)
    return f"<div>{html.escape(heading)}</div><div style=\"display:flex;flex-wrap:wrap\">{moduli}{tangent}</div>"
