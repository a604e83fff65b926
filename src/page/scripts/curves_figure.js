/// The figure with the curves of the study: at first the results, and the measurement.

import {colourBetween, colourOf, isOfBestGrid, lineOf} from "./curve_style.js";
import {inHertz} from "./complex_curves.js";
import {quantityChoices, testChoices} from "./curve_choices.js";
import {listFiles} from "./curve_files.js";
import {study} from "./data.js";
import {deviationOf, deviationsFrom} from "./deviation.js";
import {element} from "./elements.js";
import {addEndLabels} from "./end_labels.js";
import {drawFigure, layoutOf, saveFigure, tracesOf} from "./figure.js";
import {csvOf, fileName, save} from "./files.js";
import {loadsShownFirst} from "./loads.js";
import {axes, boundaryNames, methodNames, quantities} from "./names.js";
import {display, shortNumber} from "./numbers.js";
import {groupsOf} from "./records.js";
import {binderOf, stagesOfInterest} from "./stages.js";
import {lawOf, overTemperature, usualAbscissa} from "./temperature_axis.js";
import {addTimeDomains} from "./time_domains.js";

const mostLabels = 8;

function isShown(curve, shown) {
  if (curve.quantity !== shown.quantity.name) return false;
  if (curve.role === "matrix") return shown.extras.has("matrix") && isBinderOfShown(curve, shown);
  if (!shown.stages.has(curve.stage)) return false;
  if (curve.role === "measured") return shown.extras.has("measured");
  return shown.boundaries.has(curve.boundary) && shown.loads.has(curve.load) &&
    (curve.method === undefined || shown.methods.has(curve.method)) &&
    ((isOfBestGrid(curve) && shown.grids.has("best")) || shown.grids.has(curve.cells));
}

function isBinderOfShown(curve, shown) {
  return [...shown.stages].some((stage) => binderOf(study, stage)?.name === curve.stage);
}

/// The curves over the temperature at the time or frequency that the reader has chosen; curves without a temperature
/// shift are left out.
function onTemperatureAxis(curves, shown) {
  const at = shown.abscissa[shown.quantity.xUnit];
  return curves.flatMap((curve) => {
    const law = lawOf(study, curve.stage);
    const moved = law === undefined ? undefined : overTemperature(curve, law, shown.quantity.xUnit, at);
    return moved === undefined || moved.x.length < 2 ? [] : [moved];
  });
}

/// Curves and their quantity, on the axis that the reader has chosen.
function onChosenAxis(curves, quantity, shown) {
  const axis = axes[shown.axis];
  if (shown.axis === "temperature") return [onTemperatureAxis(curves, shown), {...quantity, ...axis}];
  return [shown.axis === "frequency" ? inHertz(curves) : curves, {...quantity, ...axis}];
}

/// The areas between the moduli under displacement and traction, as traces. Loss moduli, loss factors and ratios have
/// none: they are not in order.
function areasBetween(curves, quantity) {
  const isOrdered = !["absolute", "phase", "loss-factor", "young-loss-factor", "poisson"].includes(quantity.name);
  const ordered = curves.filter((curve) => isOrdered && curve.role === "stage" && curve.part !== "loss");
  return groupsOf(ordered, ["stage", "load", "method", "cells", "part"]).flatMap((group) => {
    const [upper, lower] = ["displacement", "traction"].map((name) => group.find(({boundary}) => boundary === name));
    if (upper === undefined || lower === undefined) return [];
    return [{x: [...upper.x, ...lower.x.toReversed()], y: [...upper.y, ...lower.y.toReversed()], type: "scatter",
      mode: "lines", fill: "toself", fillcolor: colourBetween(), line: {width: 0}, hoverinfo: "skip",
      showlegend: false, name: "between displacement and traction"}];
  });
}

/// The name of a curve at its end, without the properties that all shown curves have.
function endLabel(curve, seen) {
  const stages = new Set(seen.filter(({role}) => role === "stage").map(({stage}) => stage));
  if (curve.role === "matrix") return `${curve.label.split(", G")[0]} alone${curve.label.slice(curve.stage.length)}`;
  const isAlone = stages.size === 1 && curve.label.startsWith(`${curve.stage}, `);
  return curve.role === "stage" && isAlone ? curve.label.slice(curve.stage.length + 2) : curve.label;
}

/// The quantity that is shown first: complex moduli where the deck gives frequencies, and those of Young's modulus where
/// it alone was measured.
function firstQuantity(curves) {
  const has = (wanted, name) => curves.some(({role, quantity}) => role === wanted && quantity === name);
  const [ofShear, ofYoung] = study.frequencies_Hz === undefined ? ["shear", "young"] : ["dynamic", "young-dynamic"];
  const first = has("measured", ofYoung) && !has("measured", ofShear) ? ofYoung : ofShear;
  const wanted = quantities.find(({name}) => name === first && has("stage", name));
  return wanted ?? quantities.find((quantity) => curves.some((curve) => curve.quantity === quantity.name));
}

/// Fills the section and returns the function that draws the figure.
export function curvesFigure(curves) {
  const plot = document.getElementById("curve-plot");
  const shown = {
    quantity: firstQuantity(curves),
    axis: "time",
    abscissa: {s: usualAbscissa(study.times_s, "s"), "rad/s": usualAbscissa(study.times_s, "rad/s")},
    stages: new Set(stagesOfInterest(study).map(({name}) => name)),
    boundaries: new Set(boundaryNames),
    methods: new Set(Object.keys(methodNames)),
    loads: new Set(loadsShownFirst(curves.map(({load}) => load))),
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
    if (reference === undefined) return onChosenAxis(seen, shown.quantity, shown);
    const compared = seen.filter((curve) => curve.role !== "matrix" && curve.part === reference.part);
    return onChosenAxis(deviationsFrom(reference, compared), deviationOf(shown.quantity, reference.label), shown);
  };

  const draw = () => {
    const [seen, quantity] = contents();
    const layout = layoutOf(quantity, seen);
    if (shown.extras.has("domains") && shown.axis === "time") addTimeDomains(layout, shown);
    const traces = [...areasBetween(seen, quantity), ...seen.flatMap((curve) => tracesOf(curve, quantity, lineOf(curve),
      curve.role === "measured" ? "markers" : "lines"))];
    if (seen.length <= mostLabels) {
      const labels = seen.map((curve) => ({text: endLabel(curve, seen), color: colourOf(curve), x: curve.x.at(-1),
        y: curve.y.at(-1)}));
      addEndLabels(layout, labels, plot.clientHeight);
    }
    document.getElementById("curve-note").textContent = noteOn(seen, quantity, shown);
    return drawFigure(plot, traces, layout);
  };

  document.getElementById("curve-choices").append(...quantityChoices(curves, shown, draw));
  document.getElementById("test-choices").append(...testChoices(curves, shown, draw));
  const name = () => `${study.title} ${contents()[1].title}`;
  document.getElementById("curve-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(...contents()), "text/csv")},
      "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"));
  listFiles(curves);
  return draw;
}

/// The meaning of the lines and areas, and the sources of the curves.
function noteOn(curves, quantity, shown) {
  const notes = [];
  if (areasBetween(curves, quantity).length > 0) notes.push("Filled: between displacement and traction.");
  if (curves.some((curve) => curve.role === "measured")) notes.push(noteOnPoints(curves, shown));
  if (curves.some((curve) => curve.method === "dynamic")) notes.push("Dashed: dynamic method.");
  if (curves.some(({role, part}) => role !== "measured" && part === "loss")) notes.push("Solid: storage modulus, dashed: loss modulus.");
  if (curves.some((curve) => curve.role === "matrix")) notes.push("Dotted: the binder without particles.");
  const withBand = curves.filter((curve) => curve.band !== undefined);
  if (withBand.length > 0) {
    const isWhole = withBand.every((curve) => curve.error.whole.every(Number.isFinite));
    notes.push(`Shaded about a curve: its error${isWhole ? "" : ", that of the grid alone where the rest is not known"}.`);
  }
  if (shown.quantity.x !== "time") notes.push("From the Prony series, of the grid and method that tell most.");
  if (shown.axis === "temperature") notes.push(noteOnTemperatures(curves, shown));
  if (study.stages.some(({dimensions}) => dimensions !== 3)) {
    notes.push("Computed in two dimensions (plane strain): particles are cross-sections of cylinders.");
  }
  return notes.join(" ");
}

function noteOnPoints(curves, shown) {
  const isLoss = curves.some(({role, part}) => role === "measured" && part === "loss");
  const letter = shown.quantity.name.startsWith("young") ? "E" : "G";
  const symbols = isLoss ? `Points: measured, ${letter}″ as open circles` : "Points: measured";
  return shown.axis === "temperature" ? `${symbols}, moved by the shift of the binder.` : `${symbols}.`;
}

function noteOnTemperatures(curves, shown) {
  if (curves.length > 0) {
    return "By the shift of the binder, without a vertical one, as far as the times of the study reach.";
  }
  const [begin, end] = study.times_s;
  const covered = shown.quantity.xUnit === "s" ? `the times from ${display(begin, "s")} to ${display(end, "s")}`
    : `frequencies from ${[end, begin].map((time) => shortNumber(1 / (2 * Math.PI * time))).join(" to ")} Hz`;
  return `No temperature brings this into what the study covers, ${covered}.`;
}
