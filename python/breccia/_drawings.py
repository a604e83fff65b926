"""What is drawn of results: the curves of each object, for the pictures of notebooks and for axes of Matplotlib."""

from __future__ import annotations

import math
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import InputError
from ._plot import Band, Curve, Drawing, Floats

SECONDS, HERTZ = "Time / s", "Frequency / Hz"


def preferred_tests(stage: _native.StageResult, load: str | None = None) -> list[_native.TestResult]:
    """The preferred test of each boundary condition and method, under the load that answers for the stage by default."""
    loads = [test.load for test in stage.tests]
    if not loads:
        raise InputError(f"stage {stage.name}: it was not tested")
    load = load or next((one for one in ("isotropic", "shear") if one in loads), loads[0])
    keys = list(dict.fromkeys((test.boundary, test.method) for test in stage.tests if test.load == load))
    return [stage.test(load, boundary, method) for boundary, method in keys]


def label_of(test: _native.TestResult, tests: list[_native.TestResult]) -> str:
    """The boundary of a test, with its method where there are several."""
    methods = {one.method for one in tests}
    return test.boundary + (f", {test.method}" if len(methods) > 1 else "")


def symbol_of(test: _native.TestResult) -> str:
    """The symbol of the modulus of a test: M for one in bulk, which is K or, in the plane, K + G/3."""
    return "M" if test.load == "bulk" else "G"


def is_in_frequency(tests: list[_native.TestResult]) -> bool:
    """Whether the tests are of a study whose deck gives frequencies."""
    return all(test.in_frequency.is_of_deck for test in tests)


def error_band(x: Floats, y: Floats, shares: Floats, colour: int) -> list[Band]:
    """The band of a curve whose errors, shares of it, are known everywhere."""
    if len(shares) == 0 or not np.isfinite(shares).all():
        return []
    shares = np.minimum(shares, 0.999)
    return [Band(x, np.asarray(y * (1 - shares)), np.asarray(y * (1 + shares)), colour)]


def _measurements(stage: _native.StageResult, kind: str) -> list[dict[str, Any]]:
    """A comparison with each measured modulus of a kind, that of one of its tests."""
    return list({comparison["measurement"]: comparison for comparison in stage.comparisons
                 if comparison["kind"] == kind}.values())


def stage_drawing(stage: _native.StageResult) -> Drawing:
    """The moduli of a stage with their errors or bounds and what was measured: those of its main load, or E where E alone
    was measured."""
    tests = preferred_tests(stage)
    if _measurements(stage, "young") and not _measurements(stage, "shear"):
        return _youngs_modulus(stage, tests)
    return _in_frequency(stage, tests) if is_in_frequency(tests) else _in_time(stage, tests)


def _youngs_modulus(stage: _native.StageResult, tests: list[_native.TestResult]) -> Drawing:
    in_frequency = is_in_frequency(tests)
    curves, bands = [], []
    for number, boundary in enumerate(dict.fromkeys(test.boundary for test in tests)):
        moduli = stage.engineering(boundary)
        if in_frequency:
            curves += _complex_curves("E", boundary, moduli.frequency, moduli.complex_young, 2 * number)
        else:
            curves.append(Curve(boundary, moduli.time, moduli.young, number))
            bands += error_band(moduli.time, moduli.young, moduli.young_error, number)
    for number, comparison in enumerate(_measurements(stage, "young"), 5):
        curves += _measured_curves("E", comparison, in_frequency, number)
    if in_frequency:
        return Drawing(curves, abscissa=HERTZ, ordinate="E\u2032, E\u2033")
    return Drawing(curves, bands, ordinate="E(t)")


def _complex_curves(symbol: str, label: str, hertz: Floats, modulus: NDArray[np.complex128], colour: int) -> list[Curve]:
    return [Curve(f"{symbol}\u2032, {label}", hertz, modulus.real, colour),
            Curve(f"{symbol}\u2033, {label}", hertz, modulus.imag, colour + 1)]


def _measured_curves(symbol: str, comparison: dict[str, Any], in_frequency: bool, colour: int) -> list[Curve]:
    """What was measured, as marks."""
    label = comparison["measurement"]
    if not in_frequency:
        known = len(comparison["time"]) > 0
        return [Curve(label, comparison["time"], comparison["measured"], colour, marks=True)] if known else []
    hertz, measured = comparison["angular_frequency"] / (2 * math.pi), comparison["complex_measured"]
    return [Curve(f"{symbol}\u2032, {label}", hertz, measured.real, 0, marks=True),
            Curve(f"{symbol}\u2033, {label}", hertz, measured.imag, 1, marks=True)] if len(hertz) > 0 else []


def _in_frequency(stage: _native.StageResult, tests: list[_native.TestResult]) -> Drawing:
    curves, symbol = [], symbol_of(tests[0])
    for number, test in enumerate(tests):
        moduli = test.in_frequency
        curves += _complex_curves(symbol, label_of(test, tests), moduli.frequency, moduli.storage + 1j * moduli.loss, 2 * number)
    for comparison in _measurements(stage, "shear") if symbol == "G" else []:
        curves += _measured_curves("G", comparison, True, 0)
    return Drawing(curves, abscissa=HERTZ, ordinate=f"{symbol}\u2032, {symbol}\u2033")


def _in_time(stage: _native.StageResult, tests: list[_native.TestResult]) -> Drawing:
    curves = [Curve(label_of(test, tests), test.time, test.modulus, number) for number, test in enumerate(tests)]
    bounds = {test.boundary: test for test in tests}
    bands = []
    if {"displacement", "traction"} <= set(bounds):
        upper, lower = bounds["displacement"], bounds["traction"]
        if np.array_equal(upper.time, lower.time):
            bands.append(Band(upper.time, lower.modulus, upper.modulus))
    elif len(tests) == 1:
        bands = error_band(tests[0].time, tests[0].modulus, tests[0].error, 0)
    for number, comparison in enumerate(_measurements(stage, "shear") if symbol_of(tests[0]) == "G" else [], 5):
        curves += _measured_curves("G", comparison, False, number)
    return Drawing(curves, bands, ordinate=f"{symbol_of(tests[0])}(t)")


def result_drawing(result: _native.Result) -> Drawing:
    """The moduli of the last stage, with that of the binder in shear dashed."""
    drawing = stage_drawing(result.stages[-1])
    binder = next((material for material in result.materials if material.name == result.binder), None)
    if binder is None or not drawing.curves or not drawing.ordinate.startswith("G"):
        return drawing
    x = drawing.curves[0].x
    if drawing.abscissa == SECONDS:
        drawing.curves.append(Curve(binder.name, x, binder.shear.at(x), 3, dashes="5 4"))
    else:
        modulus = binder.shear.complex_modulus(2 * math.pi * x)
        drawing.curves += [Curve(f"G\u2032, {binder.name}", x, modulus.real, 3, dashes="5 4"),
                           Curve(f"G\u2033, {binder.name}", x, modulus.imag, 4, dashes="5 4")]
    return drawing


def test_drawing(test: _native.TestResult) -> Drawing:
    """The relaxation modulus of a test, with its error."""
    return Drawing([Curve(test.boundary, test.time, test.modulus)], error_band(test.time, test.modulus, test.error, 0),
                   ordinate=f"{symbol_of(test)}(t)")


def complex_drawing(moduli: _native.ComplexModuli) -> Drawing:
    """Storage and loss modulus over the frequency in Hz."""
    return Drawing([Curve("G\u2032", moduli.frequency, moduli.storage, 0), Curve("G\u2033", moduli.frequency, moduli.loss, 1)],
                   abscissa=HERTZ, ordinate="G\u2032, G\u2033")


def engineering_drawing(moduli: _native.EngineeringModuli) -> Drawing:
    """E, G and K over time, E with its error."""
    curves = [Curve("E", moduli.time, moduli.young, 0), Curve("G", moduli.time, moduli.shear, 1),
              Curve("K", moduli.time, moduli.bulk, 2)]
    return Drawing(curves, error_band(moduli.time, moduli.young, moduli.young_error, 0), ordinate="E, G, K")


def series_drawing(series: _native.PronySeries) -> Drawing:
    """M(t) over all relaxation times; nothing for an elastic series."""
    if series.is_elastic:
        return Drawing([])
    times = series.relaxation_times
    time = np.geomspace(times[-1] / 30, times[0] * 30, 200)
    return Drawing([Curve("M(t)", time, series.at(time))], ordinate="M(t)")


def relaxation_fit_drawing(fit: _native.RelaxationFit) -> Drawing:
    """The data and the fit."""
    if len(fit.angular_frequency) > 0:
        storage, loss = np.split(fit.measured, 2)
        return _dynamic(fit.angular_frequency, storage, loss, fit.series)
    time = np.geomspace(fit.time[0], fit.time[-1], 200)
    return Drawing([Curve("M(t), measured", fit.time, fit.measured, 0, marks=True),
                    Curve("M(t), fitted", time, fit.series.at(time), 0)], ordinate="M(t)")


def creep_fit_drawing(fit: _native.CreepFit) -> Drawing:
    """The data and the fit of a creep compliance."""
    time = np.geomspace(fit.time[0], fit.time[-1], 200)
    return Drawing([Curve("J(t), measured", fit.time, fit.measured, 0, marks=True),
                    Curve("J(t), fitted", time, fit.compliance.at(time), 0)], ordinate="J(t)", unit="1/Pa")


def master_curve_drawing(curve: _native.MasterCurve) -> Drawing:
    """The shifted data and their fit."""
    return _dynamic(curve.angular_frequency, curve.storage, curve.loss, curve.series)


def _dynamic(measured_at: Floats, storage: Floats, loss: Floats, series: _native.PronySeries) -> Drawing:
    """Dynamic moduli and the series that was fitted to them."""
    frequency = np.geomspace(measured_at[0], measured_at[-1], 200)
    fitted = series.complex_modulus(frequency)
    return Drawing([Curve("M\u2032, measured", measured_at, storage, 0, marks=True),
                    Curve("M\u2033, measured", measured_at, loss, 1, marks=True),
                    Curve("M\u2032, fitted", frequency, fitted.real, 0),
                    Curve("M\u2033, fitted", frequency, fitted.imag, 1)],
                   abscissa="Angular frequency / (rad/s)", ordinate="M\u2032, M\u2033")


#: What is drawn of the objects of each class.
DRAWINGS: dict[type, Callable[[Any], Drawing]] = {
    _native.Result: result_drawing, _native.StageResult: stage_drawing, _native.TestResult: test_drawing,
    _native.ComplexModuli: complex_drawing, _native.EngineeringModuli: engineering_drawing,
    _native.PronySeries: series_drawing, _native.RelaxationFit: relaxation_fit_drawing,
    _native.CreepFit: creep_fit_drawing, _native.MasterCurve: master_curve_drawing,
}
