"""What notebooks show of results: a plot of G(t), its values at whole decades, the microstructure, warnings."""

from __future__ import annotations

import html
import math
import numpy as np
from numpy.typing import NDArray

from . import _native
from ._drawings import (complex_drawing, creep_fit_drawing, engineering_drawing, is_in_frequency, label_of,
                        master_curve_drawing, preferred_tests, relaxation_fit_drawing, result_drawing, series_drawing,
                        stage_drawing, test_drawing)
from ._plot import Curve, Drawing, Floats, plain, svg_of, svg_over_temperature


def _three_digits(value: float, unit: str) -> str:
    """A value with an SI prefix."""
    if not math.isfinite(value) or value == 0.0:
        return f"{value:g} {unit}"
    power = min(max(3 * math.floor(math.log10(abs(value)) / 3), -15), 12)
    prefix = {-15: "f", -12: "p", -9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}[power]
    return f"{value / 10.0**power:.3g} {prefix}{unit}"


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
        rows.append(f'<tr><th style="text-align:left">{label_of(test, tests)}</th>{cells}</tr>')
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


def _warnings(stage: _native.StageResult) -> str:
    return "".join(f'<li style="color:#8a4b08">{html.escape(warning)}</li>' for warning in stage.warnings)


def _moduli(stage: _native.StageResult, drawing: Drawing) -> str:
    """The moduli of a stage that was tested: a drawing, and tables of its values."""
    tests = preferred_tests(stage)
    if not is_in_frequency(tests):
        return f"<div>Relaxation modulus, {html.escape(tests[0].load)}</div>{svg_of(drawing)}{_table(tests)}"
    tables = "".join((f"<div>{html.escape(label_of(test, tests))}</div>" if len(tests) > 1 else "") +
                     _frequency_table(test.in_frequency) for test in tests)
    return f"<div>Complex modulus, {html.escape(tests[0].load)}</div>{svg_of(drawing)}{tables}"


def _stage(stage: _native.StageResult, drawing: Drawing | None) -> str:
    parts = []
    if stage.microstructure is not None:
        box = stage.microstructure
        content = box.kind if box.kind == "image" else f"{box.particles} {box.kind}"
        parts.append(f"<div>{content}, {100 * box.fraction:.2f} % of a box of {_three_digits(box.side, 'm')}</div>")
    if drawing is not None:
        parts.append(_moduli(stage, drawing))
    elif stage.microstructure is not None:
        parts.append(microstructure_html(stage.microstructure))
    if stage.accuracy:
        parts.append(f"<div>This box: {html.escape(stage.accuracy)}</div>")
    if stage.warnings:
        parts.append(f"<ul>{_warnings(stage)}</ul>")
    return f"<div><b>{html.escape(stage.name)}</b>{''.join(parts)}</div>"


def stage_html(stage: _native.StageResult) -> str:
    """A stage for a notebook."""
    return _stage(stage, stage_drawing(stage) if stage.tests else None)


def result_html(result: _native.Result) -> str:
    """A result for a notebook: the last stage in full, beside the binder, the others on demand."""
    *earlier, last = result.stages
    folded = "".join(f"<details><summary>{html.escape(stage.name)}</summary>{stage_html(stage)}</details>"
                     for stage in earlier)
    shown = _stage(last, result_drawing(result) if last.tests else None)
    return f"<div><div>{html.escape(result.title)}</div>{folded}{shown}</div>"


def series_html(series: _native.PronySeries) -> str:
    """A Prony series for a notebook."""
    drawn = svg_of(series_drawing(series))
    return f"<div>{html.escape(repr(series))}</div>{drawn}" if drawn else html.escape(repr(series))


def microstructure_html(box: _native.Microstructure) -> str:
    """A microstructure for a notebook, 360 pixels wide."""
    return f'<div style="width:360px">{box.svg()}</div>'


def test_html(test: _native.TestResult) -> str:
    """A test for a notebook."""
    return f"<div>{html.escape(repr(test))}</div>{svg_of(test_drawing(test))}{_table([test])}"


def complex_html(moduli: _native.ComplexModuli) -> str:
    """A complex modulus for a notebook: G' and G'' over the frequency in Hz, and its table."""
    heading = f"<div>{html.escape(repr(moduli))}</div>"
    return heading + svg_of(complex_drawing(moduli)) + _frequency_table(moduli) if len(moduli) else heading


def relaxation_fit_html(fit: _native.RelaxationFit) -> str:
    """A fit of a Prony series for a notebook: the data and the fit."""
    return f"<div>{html.escape(repr(fit))}</div>{svg_of(relaxation_fit_drawing(fit))}"


def creep_fit_html(fit: _native.CreepFit) -> str:
    """A fit of a creep compliance for a notebook: the data and the fit, in 1/Pa."""
    return f"<div>{html.escape(repr(fit))}</div>{svg_of(creep_fit_drawing(fit))}"


def master_curve_html(curve: _native.MasterCurve) -> str:
    """A master curve for a notebook: the shifted data and their fit."""
    return f"<div>{html.escape(repr(curve))}</div>{svg_of(master_curve_drawing(curve))}"


def engineering_html(moduli: _native.EngineeringModuli) -> str:
    """The moduli of a uniaxial test for a notebook: E, G and K over time, and Poisson's ratio in words."""
    first, last = _three_digits(moduli.time[0], "s"), _three_digits(moduli.time[-1], "s")
    ratio = f"Poisson's ratio {moduli.poisson[0]:.4g} at {first}, {moduli.poisson[-1]:.4g} at {last}"
    known = np.isfinite(moduli.young_error)
    if not known.any():
        ratio += "; errors unknown"
    else:
        young, poisson = moduli.young_error[known].max(), moduli.poisson_error[known].max()
        ratio += f"; error of E up to {100 * young:.2g} %, of the ratio {poisson:.2g}"
        ratio += "" if known.all() else ", not known at all times"
    drawn = svg_of(engineering_drawing(moduli))
    return f"<div>{html.escape(repr(moduli))}</div>{drawn}<div>{html.escape(ratio)}</div>"


def isochrone_html(modulus: NDArray[np.complex128], temperature: Floats, name: str, heading: str) -> str:
    """Complex moduli over the temperature for a notebook: storage and loss modulus, and the loss tangent."""
    celsius = temperature - 273.15
    moduli = svg_over_temperature([Curve(f"{name}\u2032", celsius, modulus.real, 0),
                                   Curve(f"{name}\u2033", celsius, modulus.imag, 1)], f"{name}\u2032, {name}\u2033")
    tangent = svg_over_temperature([Curve("tan \u03b4", celsius, modulus.imag / modulus.real, 2)], "tan \u03b4", plain)
    return f"<div>{html.escape(heading)}</div><div style=\"display:flex;flex-wrap:wrap\">{moduli}{tangent}</div>"
