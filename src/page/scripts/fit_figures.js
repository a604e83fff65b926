/// The figures of a fit. Each function returns the function that draws its figure, or nothing without the data for it.

import {currentInks, isDark} from "./colours.js";
import {data} from "./data.js";
import {drawFigure, layoutOf, linearAxis, plotText} from "./figure.js";
import {blackDiagram, decadesToReference, deviationsOf, reducedSweeps, zeroCelsius} from "./fit_curves.js";
import {axes} from "./names.js";
import {display, minus, percent} from "./numbers.js";
import {extent, logarithmic} from "./sampling.js";
import {withUnit} from "./ticks.js";
import {decadesOfShift, lossModulus, relaxationModulus, shiftedSeries, storageModulus} from "./viscoelasticity.js";

const {fit, sweeps = [], samples} = data;

export function celsius(temperature) {
  return `${minus(Number((temperature - zeroCelsius).toFixed(1)))} °C`;
}

/// Cold is blue, hot is red.
function colourOf(sweep) {
  const share = sweeps.length === 1 ? 0 : sweeps.indexOf(sweep) / (sweeps.length - 1);
  return `hsl(${235 - 225 * share}, 70%, ${isDark() ? 62 : 42}%)`;
}

function nameOf({temperature_K: temperature}) {
  return temperature === null ? "measured" : celsius(temperature);
}

/// A trace of points of a sweep: filled for storage moduli, open for loss moduli, which have no entry in the legend.
function points(sweep, x, y, text, isLoss = false) {
  const color = colourOf(sweep);
  return {x, y, type: "scatter", mode: "markers", name: plotText(nameOf(sweep)), legendgroup: nameOf(sweep),
    showlegend: !isLoss, text, hovertemplate: "%{text}",
    marker: {color, size: 6, symbol: isLoss ? "circle-open" : "circle"}};
}

function line(x, y, name, dash = "solid") {
  return {x, y, type: "scatter", mode: "lines", name, line: {color: currentInks().ink, width: 1.6, dash},
    hoverinfo: "skip"};
}

const pascals = (values) => values.map((value) => withUnit(value, "Pa"));

/// The layout of a figure of points, which the reader looks at one by one.
function layoutOfPoints(quantity, curves) {
  return {...layoutOf(quantity, curves), hovermode: "closest"};
}

/// The range of sweeps and of the fit on the axis of the reader: `scale` is 1 for rad/s and 2 pi for Hz.
function axisOf(shown) {
  const scale = shown.axis === "frequency" ? 2 * Math.PI : 1;
  return {scale, ...axes[shown.axis]};
}

/// Storage and loss modulus over the reduced frequency, and the fit.
function drawMasterCurve(plot, shown) {
  const decades = decadesToReference(fit, shown.reference_K);
  const series = shiftedSeries(fit.series, 10 ** decades);
  const {scale, x, xUnit} = axisOf(shown);
  const reduced = reducedSweeps(sweeps, decades);
  const omegas = logarithmic(...extent(reduced.flatMap((sweep) => sweep.x)), 20);
  const storage = omegas.map((omega) => storageModulus(series, omega));
  const loss = omegas.map((omega) => lossModulus(series, omega));
  const at = omegas.map((omega) => omega / scale);
  const of = (values) => values.map((omega) => omega / scale);
  const {symbol} = fit;
  const where = sweeps.length > 1 ? `reduced ${x} at ${celsius(shown.reference_K)}` : x;
  const layout = layoutOfPoints({name: "dynamic", title: `${symbol}′, ${symbol}″`, x: where, xUnit, unit: "Pa"},
    [{x: at, y: storage}, ...reduced.flatMap((sweep) => [{x: of(sweep.x), y: sweep.storage_Pa},
      {x: of(sweep.x), y: sweep.loss_Pa}])]);
  const traces = reduced.flatMap((sweep, i) => [
    points(sweeps[i], of(sweep.x), sweep.storage_Pa, pascals(sweep.storage_Pa)),
    points(sweeps[i], of(sweep.x), sweep.loss_Pa, pascals(sweep.loss_Pa), true)]);
  return drawFigure(plot, [...traces, line(at, storage, `fit, ${symbol}′`), line(at, loss, `fit, ${symbol}″`, "dash")],
    layout);
}

/// The measurement over the time, and the fit; the modulus alone if the data are a Prony series.
function drawSamples(plot) {
  const isCreep = fit.measured === "creep";
  const name = isCreep ? `Creep compliance ${fit.compliance_symbol}(t)` : `Relaxation modulus ${fit.symbol}(t)`;
  const quantity = {name: "time", title: name, x: "time", xUnit: "s", unit: isCreep ? "1/Pa" : "Pa"};
  const times = samples?.time_s ?? logarithmic(...fit.times_s, 20);
  const fitted = samples?.fitted ?? times.map((time) => relaxationModulus(fit.series, time));
  const traces = [line(times, fitted, samples === undefined ? "the series" : "fit")];
  if (samples !== undefined) {
    traces.push({x: times, y: samples.value, type: "scatter", mode: "markers", name: "measured",
      hovertemplate: "%{text}", text: samples.value.map((value) => withUnit(value, quantity.unit)), marker: {color: "#0b63a5", size: 6}});
  }
  return drawFigure(plot, traces, layoutOfPoints(quantity, [{x: times, y: fitted},
    {x: times, y: samples?.value ?? []}]));
}

export function masterFigure(shown) {
  const plot = document.getElementById("master-plot");
  return {plot, draw: () => (sweeps.length > 0 ? drawMasterCurve(plot, shown) : drawSamples(plot))};
}

function shownPlot(section, plot, isThere) {
  document.getElementById(section).hidden = !isThere;
  return isThere ? document.getElementById(plot) : undefined;
}

export function deviationFigure(shown) {
  const plot = shownPlot("deviations", "deviation-plot", sweeps.length > 0 || samples !== undefined);
  if (plot === undefined) return () => {};
  const shares = (values) => values.map((value) => percent(value / 100));
  return () => {
    if (samples !== undefined) {
      const y = samples.fitted.map((value, i) => 100 * (value / samples.value[i] - 1));
      const quantity = {name: "deviation", title: "fit over data, less one", x: "time", xUnit: "s", unit: "%"};
      return drawFigure(plot, [{x: samples.time_s, y, type: "scatter", mode: "markers", text: shares(y),
        hovertemplate: "%{text}", name: "measured", marker: {size: 6}}],
      layoutOfPoints(quantity, [{x: samples.time_s, y}]));
    }
    const {scale, x, xUnit} = axisOf(shown);
    const lines = reducedSweeps(sweeps, 0).map((sweep, i) => ({sweep: sweeps[i],
      x: sweep.x.map((omega) => omega / scale), ...deviationsOf(fit.series, sweep)}));
    const where = sweeps.length > 1 ? `reduced ${x} at ${celsius(fit.reference_K)}` : x;
    const quantity = {name: "deviation", title: "fit over data, less one", x: where, xUnit, unit: "%"};
    return drawFigure(plot, lines.flatMap((one) => [points(one.sweep, one.x, one.storage, shares(one.storage)),
      points(one.sweep, one.x, one.loss, shares(one.loss), true)]),
    layoutOfPoints(quantity, lines.flatMap((one) => [{x: one.x, y: one.storage}, {x: one.x, y: one.loss}])));
  };
}

/// log10 a_T over the temperature, with its standard errors and the law.
export function shiftFigure(shown) {
  const plot = shownPlot("shifts", "shift-plot", sweeps.length > 1);
  if (plot === undefined) return () => {};
  return () => {
    const decades = decadesToReference(fit, shown.reference_K);
    const x = sweeps.map(({temperature_K: temperature}) => temperature - zeroCelsius);
    const y = sweeps.map(({log10_shift_factor: factor}) => factor - decades);
    const traces = [{x, y, type: "scatter", mode: "markers", name: "from the sweeps", hovertemplate: "%{y:.4f}",
      error_y: {type: "data", array: sweeps.map((sweep) => sweep.standard_error), thickness: 1.2,
        color: currentInks().ink},
      marker: {size: 8, color: sweeps.map(colourOf)}}];
    if (fit.law !== undefined) {
      const [first, last] = extent(x);
      const at = Array.from({length: 101}, (_, i) => first + (last - first) * i / 100);
      traces.push(line(at, at.map((one) => decadesOfShift(fit.law, one + zeroCelsius) - decades), "WLF"));
    }
    const quantity = {name: "shift", title: "log a", x: "temperature", xUnit: "°C", unit: ""};
    const layout = layoutOfPoints(quantity, [{x, y: [1]}]);
    layout.yaxis = {...linearAxis(`log₁₀ a_T from ${celsius(shown.reference_K)}`, "", y), tickCount: 6};
    return drawFigure(plot, traces, layout);
  };
}

export function blackFigure() {
  const plot = shownPlot("black", "black-plot", sweeps.length > 0);
  if (plot === undefined) return () => {};
  return () => {
    const {symbol, series} = fit;
    const diagrams = sweeps.map((sweep) => ({sweep, ...blackDiagram(sweep.storage_Pa, sweep.loss_Pa)}));
    const omegas = logarithmic(...extent(reducedSweeps(sweeps, 0).flatMap((sweep) => sweep.x)), 20);
    const fitted = blackDiagram(omegas.map((omega) => storageModulus(series, omega)),
      omegas.map((omega) => lossModulus(series, omega)));
    const curves = [...diagrams, fitted].map(({absolute: x, degrees: y}) => ({x, y}));
    const layout = layoutOfPoints({name: "black", title: "phase", x: `|${symbol}*|`, xUnit: "Pa", unit: ""}, curves);
    layout.yaxis = {...linearAxis("phase angle δ", "°", curves.flatMap(({y}) => y)), tickCount: 6};
    const text = ({absolute, degrees}) =>
      absolute.map((size, i) => `${display(size, "Pa")}, ${degrees[i].toFixed(1)}°`);
    return drawFigure(plot, [...diagrams.map((one) => points(one.sweep, one.absolute, one.degrees, text(one))),
      line(fitted.absolute, fitted.degrees, "fit")], layout);
  };
}

/// The sweeps over the frequency as it was measured.
export function rawFigure(shown) {
  const plot = shownPlot("sweeps", "sweep-plot", sweeps.length > 1);
  if (plot === undefined) return () => {};
  return () => {
    const {scale, x, xUnit} = axisOf(shown);
    const lines = sweeps.map((sweep) => ({sweep, x: sweep.angular_frequency_rad_per_s.map((omega) => omega / scale)}));
    const quantity = {name: "raw", title: `${fit.symbol}′, ${fit.symbol}″`, x, xUnit, unit: "Pa"};
    return drawFigure(plot, lines.flatMap(({sweep, x: at}) => [
      points(sweep, at, sweep.storage_Pa, pascals(sweep.storage_Pa)),
      points(sweep, at, sweep.loss_Pa, pascals(sweep.loss_Pa), true)]),
    layoutOfPoints(quantity, lines.flatMap(({sweep, x: at}) => [{x: at, y: sweep.storage_Pa},
      {x: at, y: sweep.loss_Pa}])));
  };
}

/// The terms of the series as bars over their relaxation times.
export function spectrumFigure(shown) {
  const plot = document.getElementById("spectrum-plot");
  return () => {
    const {terms} = shiftedSeries(fit.series, 10 ** decadesToReference(fit, shown.reference_K));
    const x = terms.map((term) => term.relaxation_time_s), y = terms.map((term) => term.modulus_Pa);
    const layout = layoutOfPoints({name: "spectrum", title: "modulus of a term", x: "relaxation time", xUnit: "s",
      unit: "Pa"}, [{x, y}]);
    const foot = 10 ** layout.yaxis.range[0];
    const stems = {x: x.flatMap((time) => [time, time, null]), y: y.flatMap((modulus) => [foot, modulus, null]),
      type: "scatter", mode: "lines", line: {color: currentInks().faint, width: 1.2}, hoverinfo: "skip", name: "terms",
      showlegend: false};
    return drawFigure(plot, [stems, {x, y, type: "scatter", mode: "markers", name: "terms", showlegend: false,
      text: pascals(y), hovertemplate: "%{text}", marker: {size: 7, color: "#0b63a5"}}], layout);
  };
}
