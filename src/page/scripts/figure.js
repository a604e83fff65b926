/// The functions that all figures use: axes, traces, drawing, printing. The global `Plotly` is the plotting library,
/// which is in the page before these modules.

import {currentInks, isPrinting, setPrinting} from "./colours.js";
import {fileName, save} from "./files.js";
import {perMillionAndKelvin} from "./names.js";
import {display, shortNumber} from "./numbers.js";
import {followZoom, withTicks} from "./plot_ticks.js";
import {extent} from "./sampling.js";
import {unitFor, withUnit} from "./ticks.js";

/// Text for a figure. Plotly would take <b> in it for bold.
export function plotText(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

/// The title of an axis with its unit.
export function axisTitle(title, unit) {
  return {text: plotText(unit === "" ? title : `${title} / ${unit}`), standoff: 8};
}

function commonAxis() {
  const {faint, line} = currentInks();
  return {gridcolor: line, linecolor: faint, ticks: "outside", tickcolor: faint, automargin: true,
    tickangle: 0, showline: true};
}

/// A logarithmic axis for values in a unit. Each tick of a time axis has its own unit, any other axis one in its title.
function logAxis(title, unit, values) {
  const positive = values.filter((value) => value > 0);
  const [least, most] = extent(positive.map(Math.log10));
  const room = 0.04 * (most - least) + 0.02;
  const shown = unit === "s" ? {unit: "", scale: 1} : unitFor(unit, positive);
  const textOf = (value) => unit === "s" ? display(value, "s") : shortNumber(value / shown.scale);
  return {...commonAxis(), type: "log", range: [least - room, most + room], title: axisTitle(title, shown.unit),
    zeroline: false, textOf};
}

/// A linear axis from the smallest to the largest value, zero included.
export function linearAxis(title, unit, values) {
  const [least, most] = extent([0, ...values]);
  const room = 0.05 * (most - least) || 1;
  const {unit: shown, scale} = unitFor(unit, values);
  return {...commonAxis(), type: "linear", range: [least - room, most + room], title: axisTitle(title, shown),
    zerolinecolor: currentInks().faint, scale};
}

/// The axis of abscissas: linear for temperatures, logarithmic for all others.
function abscissaAxis({x, xUnit}, values) {
  if (xUnit !== "°C") return logAxis(x, xUnit, values);
  const [least, most] = extent(values);
  const room = 0.03 * (most - least) || 1;
  return {...commonAxis(), type: "linear", range: [least - room, most + room], title: axisTitle(x, xUnit), scale: 1,
    zeroline: false};
}

/// Relative deviations, angles and thermal expansions have a linear axis, all other quantities a logarithmic one.
function valueAxis(quantity, curves) {
  const axis = ["%", "°", perMillionAndKelvin].includes(quantity.unit) ? linearAxis : logAxis;
  return axis(quantity.title, quantity.unit, curves.flatMap((curve) => curve.y));
}

/// A value of a quantity as text, with its unit.
export function valueText(value, quantity) {
  if (quantity.unit === "°") return `${shortNumber(value)}°`;
  if (quantity.unit === perMillionAndKelvin) return `${shortNumber(value)} ${perMillionAndKelvin}`;
  return quantity.unit === "%" ? `${shortNumber(value)} %` : withUnit(value, quantity.unit);
}

/// Whether a figure has the width of a phone.
export function isNarrow() {
  return !isPrinting() && document.body.clientWidth < 640;
}

/// The layout of a figure that shows curves of a quantity.
export function layoutOf(quantity, curves) {
  const {paper, ink, faint} = currentInks();
  const narrow = isNarrow();
  const xHover = {s: "%{x:.3~s}s", "rad/s": "%{x:.3~g} rad/s", Hz: "%{x:.3~g} Hz", "°C": "%{x:.1f} °C"};
  return {
    paper_bgcolor: paper, plot_bgcolor: paper, font: {color: ink, size: narrow ? 11 : 13},
    margin: {l: narrow ? 48 : 70, r: 12, t: 26, b: 48},
    xaxis: {...abscissaAxis(quantity, curves.flatMap((curve) => curve.x)),
      unifiedhovertitle: {text: xHover[quantity.xUnit] ?? "%{x}"}},
    yaxis: {...valueAxis(quantity, curves), tickCount: 8}, uirevision: `${quantity.name} ${quantity.title}`,
    hovermode: "x unified", hoverlabel: {bgcolor: paper, bordercolor: faint, font: {color: ink, size: 12}},
    legend: {orientation: "h", traceorder: "normal", y: -0.2, yanchor: "top", font: {size: narrow ? 10 : 12}},
    dragmode: narrow ? false : "zoom", shapes: [], annotations: [],
  };
}

const widthOfTick = 75;  // [pixels] that a text along the axis takes
const mostTicks = 12;

const plotOptions = {responsive: true, displaylogo: false,
  modeBarButtons: [["zoom2d", "pan2d", "zoomIn2d", "zoomOut2d", "resetScale2d"]]};

/// Draws a figure in its element, with the ticks of plot_ticks.js at any zoom and a description for screen readers.
export async function drawFigure(plot, traces, layout) {
  const ticks = Math.floor((plot.clientWidth - layout.margin.l - layout.margin.r) / widthOfTick);
  layout.xaxis.tickCount = Math.min(mostTicks, Math.max(3, ticks));
  const names = [...new Set(traces.filter((trace) => trace.showlegend !== false).map((trace) => trace.name))];
  plot.setAttribute("role", "img");
  plot.setAttribute("aria-label", `${layout.yaxis.title.text} against ${layout.xaxis.title.text}: ${names.join("; ")}`);
  plot.shownLayout = layout;
  // The library keeps the size that a figure had on the screen.
  if (isPrinting()) Object.assign(layout, {width: plot.clientWidth, height: plot.clientHeight});
  await Plotly.react(plot, traces, withTicks(layout), plotOptions);
  await followZoom(plot, layout);
  if (plot.followsZoom) return;
  plot.followsZoom = true;
  plot.on("plotly_relayout", (event) => {
    if (Object.keys(event).some((name) => /axis\d*\.(range|autorange)/.test(name))) followZoom(plot, plot.shownLayout);
  });
}

/// A colour, "#4477aa" or "hsl(...)", of which much behind it can be seen.
function transparent(colour) {
  return colour.startsWith("#") ? `${colour}2e` : colour.replace("hsl", "hsla").replace(")", ", 0.18)");
}

/// The traces of a curve: its band, if it has one, and its line, or its points where `mode` is "markers".
export function tracesOf(curve, quantity, line, mode = "lines") {
  const common = {x: curve.x, mode: "lines", type: "scatter", name: plotText(curve.label)};
  const traces = [];
  if (curve.band !== undefined) {
    const edge = {...common, hoverinfo: "skip", showlegend: false, line: {width: 0}};
    traces.push({...edge, y: curve.y.map((y, i) => Math.max(y - curve.band[i], 1e-3 * y))});
    traces.push({...edge, y: curve.y.map((y, i) => y + curve.band[i]), fill: "tonexty",
      fillcolor: transparent(line.color)});
  }
  traces.push({...common, mode, y: curve.y, text: curve.y.map((y) => valueText(y, quantity)), hovertemplate: "%{text}",
    line: {width: 2.2, ...line},
    marker: {color: line.color, size: 6, maxdisplayed: 40, symbol: curve.part === "loss" ? "circle-open" : "circle"}});
  return traces;
}

/// Saves a figure as SVG, in the colours of paper. `draw` draws it anew.
export async function saveFigure(plot, name, draw) {
  setPrinting(true);
  await draw();
  const url = await Plotly.toImage(plot, {format: "svg", width: 1000, height: 650});
  setPrinting(false);
  await draw();
  const picture = decodeURIComponent(url.slice(url.indexOf(",") + 1));
  const label = plotText(plot.getAttribute("aria-label")).replaceAll('"', "&quot;");
  save(fileName(name, "svg"), picture.replace("<svg ", `<svg role="img" aria-label="${label}" `), "image/svg+xml");
}

/// Draws figures now, and anew whenever their colours change: with the scheme of the screen, and for printing.
export function keepFigures(drawAll) {
  drawAll();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
  for (const [event, now] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(event, () => {
      setPrinting(now);
      // Figures are drawn before the page has the width of the paper, which their style then has.
      document.body.classList.toggle("printing", now);
      drawAll();
    });
  }
}
