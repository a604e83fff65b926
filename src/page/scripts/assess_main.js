/// The page of an assessment.

import {currentInks, isDark} from "./colours.js";
import {data} from "./data.js";
import {chooser, element} from "./elements.js";
import {drawFigure, keepFigures, layoutOf, plotText, saveFigure, valueText} from "./figure.js";
import {axes} from "./names.js";
import {display, percent} from "./numbers.js";
import {table} from "./table.js";

const {assessment} = data;
const {inputs, curves} = assessment;
const shown = {curve: curves[0]};

const axis = axes[assessment.abscissa];
const quantityOf = (curve) => ({name: curve.name, title: curve.name, ...axis, unit: curve.unit});
const placeText = (place) => display(place, axis.xUnit);

/// An interval of values as text; "not known" without its ends.
function intervalText(lower, upper, quantity) {
  if (lower === null || upper === null) return "not known";
  return `${valueText(lower, quantity)} to ${valueText(upper, quantity)}`;
}

/// The input that causes most of the variance at an index, with its share.
function foremost(curve, i) {
  if (!curve.has_shares[i]) return "nothing";
  const shares = curve.alone.map((share) => share[i]);
  const most = shares.indexOf(Math.max(...shares));
  return `${inputs[most].short} (${percent(shares[most])})`;
}

function showAnswer() {
  document.getElementById("title").textContent = assessment.title;
  const [curve] = curves, quantity = quantityOf(curve), last = curve.x.length - 1;
  const at = (i) => `${intervalText(curve.inputs_lower[i], curve.inputs_upper[i], quantity)} at ${placeText(curve.x[i])}`;
  const ends = `95 % of ${curve.name} by the inputs: ${at(0)}, ${at(last)}.`;
  const matters = `What matters most: ${foremost(curve, 0)} at ${placeText(curve.x[0])}, ${foremost(curve, last)} at ` +
    `${placeText(curve.x[last])}.`;
  const model = curve.whole_lower.includes(null)
    ? " The error of grid and sample is not known and not in these intervals." : "";
  document.getElementById("summary").append(element("p", {id: "answer"}, element("strong", {}, ends), ` ${matters}${model}`));
  const boxes = assessment.boxes > 1 ? `, ${assessment.boxes} boxes` : "";
  document.getElementById("origin").textContent = `breccia ${assessment.version}, ${assessment.source}${boxes}.`;
}

function showWarnings() {
  const list = document.getElementById("warnings");
  list.hidden = assessment.warnings.length === 0;
  list.append(...assessment.warnings.map((warning) => element("li", {}, warning)));
}

/// A line of a band; those of edges have no entry in the legend.
function line(curve, y, name, style, isShown = true) {
  return {x: curve.x, y, type: "scatter", mode: "lines", name: plotText(name), showlegend: isShown,
    text: y.map((value) => (value === null ? "" : valueText(value, quantityOf(curve)))), hovertemplate: "%{text}",
    ...style};
}

/// The median of a curve, the band of its inputs, and its ends with the error of the model.
function drawBands(plot) {
  const {curve} = shown, {ink} = currentInks();
  const fill = isDark() ? "rgba(106, 176, 230, 0.30)" : "rgba(11, 99, 165, 0.20)";
  const colour = isDark() ? "#6ab0e6" : "#0b63a5";
  const edge = {line: {width: 0}};
  const whole = {line: {width: 1.3, color: ink, dash: "dot"}};
  const traces = [
    line(curve, curve.inputs_lower, "95 % by the inputs, lower end", edge, false),
    line(curve, curve.inputs_upper, "95 % by the inputs", {...edge, fill: "tonexty", fillcolor: fill}),
    line(curve, curve.median, "median", {line: {width: 2.4, color: colour}})];
  if (curve.whole_lower.some((end) => end !== null)) {
    traces.push(line(curve, curve.whole_lower, "with the error of the model, lower end", whole, false),
      line(curve, curve.whole_upper, "with the error of the model", whole));
  }
  if (curve.measured.length > 0) {
    traces.push({x: curve.measured.map(({x}) => x), y: curve.measured.map(({y}) => y), type: "scatter", mode: "markers",
      name: "measured", text: curve.measured.map(({y}) => valueText(y, quantityOf(curve))), hovertemplate: "%{text}",
      marker: {color: ink, size: 7}});
  }
  const known = (values) => ({x: curve.x, y: values.filter((value) => value !== null)});
  return drawFigure(plot, traces, layoutOf(quantityOf(curve),
    [known(curve.inputs_lower), known(curve.inputs_upper), known(curve.whole_lower), known(curve.whole_upper),
    {x: curve.measured.map(({x}) => x), y: curve.measured.map(({y}) => y)}]));
}

/// The shares of the inputs, one on the other, up to 100 %.
function drawShares(plot) {
  const {curve} = shown;
  const parts = inputs.map((input, i) => [input.short, curve.alone[i], `hsl(${(205 + 83 * i) % 360}, 55%, ${isDark() ? 50 : 62}%)`]);
  if (inputs.length > 1) parts.push(["interactions", curve.interactions, currentInks().line]);
  const traces = parts.map(([name, shares, fillcolor]) => ({x: curve.x, y: shares.map((share, i) => (curve.has_shares[i] ? 100 * share : 0)),
    type: "scatter", mode: "lines", stackgroup: "shares", name: plotText(name), fillcolor, line: {width: 0},
    text: shares.map((share) => percent(share)), hovertemplate: "%{text}"}));
  const quantity = {name: "shares", title: "share of the variance", ...axis, unit: "%"};
  const layout = layoutOf(quantity, [{x: curve.x, y: [0, 100]}]);
  layout.yaxis.range = [0, 100];
  return drawFigure(plot, traces, layout);
}

function showTables() {
  const {curve} = shown, quantity = quantityOf(curve);
  const heads = [axis.x, "median", "95 % by the inputs", "and with the model", ...inputs.map(({short}) => short)];
  document.getElementById("value-table").replaceChildren(table(heads, curve.decades.map((i) => [
    placeText(curve.x[i]), valueText(curve.median[i], quantity),
    intervalText(curve.inputs_lower[i], curve.inputs_upper[i], quantity),
    intervalText(curve.whole_lower[i], curve.whole_upper[i], quantity),
    ...curve.alone.map((share) => (curve.has_shares[i] ? percent(share[i]) : "–"))])));
  const isKnown = curve.whole_lower.some((end) => end !== null);
  document.getElementById("band-note").textContent = "Band: 95 % of the curves by the inputs alone." +
    (isKnown ? " Dotted: with the error of grid, sample and solver that the run states." : "") +
    (curve.measured.length > 0 ? " Points: measured." : "");
  const missed = Math.max(0, ...curve.unexplained.filter((_, i) => curve.has_shares[i])), note = document.getElementById("share-note");
  note.hidden = missed < 0.01;
  note.textContent = `Polynomials in the inputs leave up to ${percent(missed)} of the variance unexplained: shares below ` +
    "that mean nothing.";
}

function showInputs() {
  document.getElementById("input-table").append(table(["input", "what is known of it", "answered by"],
    inputs.map(({name, known, is_of_box: isOfBox}) => [name, known, isOfBox ? "a box for each value" : "one box"])));
  const {found} = assessment;
  if (found === undefined) return;
  document.getElementById("found").hidden = false;
  document.getElementById("found-table").append(table(["input", "found", "95 % interval", "learned", "before"],
    found.estimates.map(({name, value, interval, learned, before}) => [name, value, interval, percent(learned), before])));
  document.getElementById("found-remarks").append(...found.remarks.map((remark) => element("li", {}, remark)));
}

showAnswer();
showWarnings();
showInputs();
const bands = document.getElementById("band-plot"), shares = document.getElementById("share-plot");
const drawAll = () => {
  showTables();
  drawBands(bands);
  drawShares(shares);
};
if (curves.length > 1) {
  document.getElementById("curve-choices").append(chooser("curve", "curve", curves.map((curve) => [curve, curve.name]),
    (curve) => {
      shown.curve = curve;
      drawAll();
    }));
}
document.getElementById("band-buttons").append(element("button", {onclick: () =>
  saveFigure(bands, `${assessment.title} ${shown.curve.name}`, () => drawBands(bands))}, "This figure as SVG"));
keepFigures(drawAll);
