/// The figure with the curves of the study, and the choice of what it shows.

import {currentInks, isDark} from "./colours.js";
import {bestGrid, gridsOfStudy} from "./curves.js";
import {data, study} from "./data.js";
import {deviationOf, deviationsFrom} from "./deviation.js";
import {chips, element} from "./elements.js";
import {drawFigure, layoutOf, saveFigure, tracesOf} from "./figure.js";
import {csvOf, csvOfTable, fileName, save} from "./files.js";
import {boundNames, gridName, methodNames, quantities} from "./names.js";
import {shortNumber} from "./numbers.js";
import {distinct, own} from "./records.js";

const dashes = {quasistatic: "solid", dynamic: "dash"};

/// Hues by boundary, as in modulus.svg: the upper bound is blue, the lower one red, between them green.
const hues = {displacement: 205, traction: 18, periodic: 160};

/// The colour of a curve. Later stages have more contrast to the background than earlier ones.
export function colourOf(curve) {
  if (curve.role === "measured") return currentInks().ink;
  if (curve.role === "matrix") return currentInks().faint;
  const stages = study.stages.map((stage) => stage.name);
  const rank = stages.length === 1 ? 1 : stages.indexOf(curve.stage) / (stages.length - 1);
  const hue = hues[curve.boundary] + (curve.load === "shear-xx-yy" ? 70 : 0);
  const lightness = isDark() ? 45 + 25 * rank : 70 - 32 * rank;
  return `hsl(${hue}, 85%, ${lightness}%)`;
}

function isShown(curve, shown) {
  if (curve.quantity !== shown.quantity.name) return false;
  if (curve.role === "matrix") return shown.extras.has("matrix");
  if (!shown.stages.has(curve.stage)) return false;
  if (curve.role === "measured") return shown.extras.has("measured");
  return shown.boundaries.has(curve.boundary) && shown.loads.has(curve.load) &&
    (curve.method === undefined || shown.methods.has(curve.method)) &&
    ((isOfBestGrid(curve) && shown.grids.has("best")) || shown.grids.has(curve.cells));
}

/// Curves of the Prony series have no grid: they are those of the best one.
function isOfBestGrid(curve) {
  return curve.cells === undefined || curve.cells === bestGrid(curve.stage);
}

function lineOf(curve) {
  const color = colourOf(curve);
  if (curve.role === "matrix") return {color, dash: "dot", width: 1.6};
  if (curve.role === "measured") return {color, width: 2.8};
  if (curve.part === "loss") return {color, dash: "dash"};
  return {color, dash: dashes[curve.method] ?? "solid", width: isOfBestGrid(curve) ? 2.2 : 1};
}

/// Fills the section and returns the function that draws the figure.
export function curvesFigure(curves) {
  const plot = document.getElementById("curve-plot");
  const shown = {
    quantity: quantities.find((quantity) => curves.some((curve) => curve.quantity === quantity.name)),
    stages: new Set(distinct(study.stages, "name")),
    boundaries: new Set(Object.keys(boundNames)),
    methods: new Set(Object.keys(methodNames)),
    loads: new Set(["shear", "shear-xx-yy", "bulk"]),
    grids: new Set(["best"]),
    extras: new Set(["measured", "matrix", "band", "domains"]),
    reference: "",
  };

  /// The curves that are shown, and their quantity.
  const contents = () => {
    const seen = curves.filter((curve) => isShown(curve, shown)).map((curve) => {
      const {band, ...plain} = curve;
      return shown.extras.has("band") ? curve : plain;
    });
    const reference = curves.find((curve) => curve.label === shown.reference && curve.quantity === shown.quantity.name);
    if (reference === undefined) return [seen, shown.quantity];
    const compared = seen.filter((curve) => curve.role !== "matrix");
    return [deviationsFrom(reference, compared), deviationOf(shown.quantity, reference.label)];
  };

  const draw = () => {
    const [seen, quantity] = contents();
    const layout = layoutOf(quantity, seen);
    if (shown.extras.has("domains") && shown.quantity.x === "time") addTimeDomains(layout, shown);
    const traces = seen.flatMap((curve) => tracesOf(curve, quantity, lineOf(curve)));
    const unknown = shown.quantity.x !== "time" ? " From the Prony series, of the grid and method that tell most." : "";
    document.getElementById("curve-note").textContent = noteOn(seen) + unknown;
    return drawFigure(plot, traces, layout);
  };

  document.getElementById("curve-choices").append(...choicesOf(curves, shown, draw));
  const name = () => `${study.title} ${contents()[1].title}`;
  document.getElementById("curve-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(...contents()), "text/csv")},
      "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"));
  listFiles(curves);
  return draw;
}

function noteOn(curves) {
  const notes = [];
  if (curves.some((curve) => curve.method === "dynamic")) notes.push("Dashed: dynamic method.");
  if (curves.some((curve) => curve.part === "loss")) notes.push("Solid: storage modulus, dashed: loss modulus.");
  if (curves.some((curve) => curve.role === "matrix")) notes.push("Dotted: matrix without particles.");
  if (curves.some((curve) => curve.band !== undefined)) {
    notes.push("Shaded: where the limit of vanishing cells is expected.");
  }
  return notes.join(" ");
}

/// The controls of the figure; each only if it has something to choose from.
function choicesOf(curves, shown, draw) {
  const tests = study.stages.flatMap((stage) => stage.tests);
  const rows = [];
  const reference = element("select", {id: "reference", ariaLabel: "compared with", onchange: () => {
    shown.reference = reference.value;
    draw();
  }});
  // The references are the curves of the shown quantity. The chosen one is kept if it is among them.
  const offerReferences = () => {
    const labels = curves.filter((curve) => curve.quantity === shown.quantity.name && curve.role !== "matrix")
      .map((curve) => curve.label);
    reference.replaceChildren(element("option", {value: ""}, "as it is"),
      ...labels.map((label) => element("option", {value: label}, `deviation from ${label}`)));
    shown.reference = labels.includes(shown.reference) ? shown.reference : "";
    reference.value = shown.reference;
  };
  const select = element("select", {id: "quantity", ariaLabel: "quantity", onchange: () => {
    shown.quantity = quantities.find((quantity) => quantity.name === select.value);
    offerReferences();
    draw();
  }}, ...quantities.filter((quantity) => curves.some((curve) => curve.quantity === quantity.name))
    .map((quantity) => element("option", {value: quantity.name}, quantity.title)));
  offerReferences();
  rows.push(select, reference);
  const add = (title, names, isOn) => {
    if (names.length > 1) rows.push(chips(title, names, isOn, draw));
  };
  const named = (values, names) => values.map((value) => [value, own(names, value) ?? value]);
  add("stage", named(distinct(study.stages, "name"), {}), shown.stages);
  add("bound", named(distinct(tests, "boundary"), boundNames), shown.boundaries);
  add("method", named(distinct(tests, "method"), methodNames), shown.methods);
  add("load", named(distinct(tests, "load").filter((load) => load !== "bulk"),
    {shear: "shear", "shear-xx-yy": "shear xx-yy"}), shown.loads);
  const several = study.stages.some((stage) => stage.cells.length > 1);
  const coarser = gridsOfStudy().filter((grid) => grid !== "extrapolated");
  if (several) add("grid", [["best", "all grids"], ...coarser.map((grid) => [grid, gridName(grid)])], shown.grids);
  const extras = [["matrix", "matrix"]];
  if (curves.some((curve) => curve.role === "measured")) extras.unshift(["measured", "measured"]);
  if (curves.some((curve) => curve.band !== undefined)) extras.push(["band", "band"]);
  if (tests.some((test) => test.time_domains !== undefined)) extras.push(["domains", "time domains"]);
  rows.push(chips("also", extras, shown.extras, draw));
  return rows;
}

/// Marks the times at which each run of a dynamic test is valid, with the density factor of the run. The test is the
/// first dynamic one of the last stage that is shown.
function addTimeDomains(layout, shown) {
  const stage = study.stages.findLast((one) => shown.stages.has(one.name) && shown.methods.has("dynamic") &&
    one.tests.some((test) => test.time_domains !== undefined));
  if (stage === undefined) return;
  const load = shown.quantity.name === "bulk" ? "bulk" : "shear";
  const test = stage.tests.find((one) => one.time_domains !== undefined && shown.boundaries.has(one.boundary) &&
    one.load === load);
  if (test === undefined) return;
  const isNarrow = document.body.clientWidth < 640;
  // Room for the labels above the curves.
  const [least, most] = layout.yaxis.range;
  if (!isNarrow) layout.yaxis.range = [least, most + 0.1 * (most - least)];
  test.time_domains.forEach(({valid_s: [begin, end], density_factor: factor}, i) => {
    layout.shapes.push({type: "rect", xref: "x", yref: "paper", x0: begin, x1: end, y0: 0, y1: 1, layer: "below",
      line: {width: 0}, fillcolor: i % 2 === 0 ? "#4477aa" : "#998866", opacity: 0.13});
    if (isNarrow) return;
    layout.annotations.push({xref: "x", yref: "paper", x: Math.log10(Math.sqrt(begin * end)),
      y: i % 2 === 0 ? 1 : 0.96, yanchor: "top", showarrow: false, text: `ρ × ${shortNumber(factor)}`,
      font: {size: 10, color: currentInks().faint}});
  });
}

/// Links to each curve and each table as a file.
function listFiles(curves) {
  const list = document.getElementById("curve-files");
  for (const quantity of quantities) {
    for (const curve of curves.filter((one) => one.quantity === quantity.name)) {
      const name = `${quantity.name}, ${curve.label}`;
      list.append(element("li", {}, element("a", {href: "#curves", onclick: (event) => {
        event.preventDefault();
        save(fileName(name, "csv"), csvOf([curve], quantity), "text/csv");
      }}, name)));
    }
  }
  for (const name of Object.keys(data.tables)) {
    list.append(element("li", {}, element("a", {href: "#curves", onclick: (event) => {
      event.preventDefault();
      save(name, csvOfTable(data.tables[name]), "text/csv");
    }}, `all of ${name}`)));
  }
}
