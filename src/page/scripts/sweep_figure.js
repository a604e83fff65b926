/// The figure with the curves of all tasks. Its choice is also that of the figure against a key (key_figure.js).

import {currentInks, isDark} from "./colours.js";
import {sweep} from "./data.js";
import {deviationOf, deviationsFrom} from "./deviation.js";
import {chips, chooser, element} from "./elements.js";
import {drawFigure, layoutOf, saveFigure, tracesOf} from "./figure.js";
import {csvOf, fileName, save} from "./files.js";
import {loadsShownFirst} from "./loads.js";
import {distinct, groupsOf} from "./records.js";
import {dimensionsOf, partnerOf, sweepQuantities, sweptKeys} from "./sweep_curves.js";
import {hasSeeds, meansOverSeeds} from "./sweep_means.js";
import {measuredCurves} from "./sweep_measurements.js";

/// Colours that are easily distinguished, for values without an order.
const palette = ["#4477aa", "#cc6677", "#228833", "#aa8800", "#7755bb", "#009999", "#bb5500", "#777777"];

/// The choice of the shown curves: the dimensions, the shown `values` of each, the dimension that the colours
/// represent, the `reference` with which the curves are compared, the quantity, and whether packings that differ in their
/// seeds alone are shown by their `means`.
export function sweepChoice(curves) {
  const dimensions = dimensionsOf(curves);
  const ofKeys = dimensions.filter(({name}) => sweep.keys.includes(name));
  const coloured = ofKeys.findLast((one) => !isSeed(one)) ?? ofKeys.at(-1) ?? dimensions.at(-1);
  const shownFirst = {stage: (stages) => stages.slice(-1), load: loadsShownFirst};
  const values = Object.fromEntries(dimensions.map((one) => [one.name,
    new Set(shownFirst[one.name]?.(one.values) ?? one.values)]));
  return {dimensions, values, coloured, reference: undefined, means: hasSeeds,
    quantity: firstQuantity(curves)};
}

/// Whether a dimension is a swept seed.
function isSeed({name}) {
  return sweptKeys.some((key) => key.path === name && key.isSeed);
}

/// The quantity that is shown first: the absolute value of the complex modulus where the deck gives frequencies.
function firstQuantity(curves) {
  const known = sweepQuantities.filter(({name}) => curves.some(({quantity}) => quantity === name));
  return known.find(({name}) => name === "absolute") ?? known[0];
}

/// The curves that are shown, by themselves or as deviations from the reference, and their quantity.
export function sweepContents(curves, choice) {
  const {dimensions, values, quantity, reference} = choice;
  const chosen = (some, ofDimensions) => some.filter((curve) => curve.quantity === quantity.name &&
    ofDimensions.every((one) => values[one.name].has(one.of(curve))));
  const ofChoice = choice.means ? meansOverSeeds : (some) => some;
  const seen = ofChoice(chosen(curves, dimensions))
    .map((curve) => ({...curve, label: labelOfSweepCurve(curve, dimensions, values)}));
  if (reference === undefined) return [seen, quantity];
  if (reference.measured !== undefined) {
    const {stage, name} = reference.measured;
    const deviations = measuredCurves()
      .filter((one) => one.stage === stage && one.name === name && one.quantity === quantity.name)
      .flatMap((one) => deviationsFrom(one, seen.filter((curve) => curve.stage === stage && curve.part === one.part)));
    return [deviations, deviationOf(quantity, `measured, ${name}`)];
  }
  const {dimension, value} = reference;
  const all = ofChoice(chosen(curves, dimensions.filter(isSeed)));
  const compared = seen.filter((curve) => dimension.of(curve) !== value).flatMap((curve) => {
    const partner = partnerOf(curve, dimension, value, all, dimensions);
    return partner === undefined ? [] : deviationsFrom(partner, [curve]);
  });
  return [compared, deviationOf(quantity, nameOfValue(dimension, value))];
}

/// The measurements of the shown quantity; none where deviations are shown.
export function shownMeasurements(seen, {quantity, reference}) {
  const stages = distinct(seen, "stage");
  return reference !== undefined ? [] : measuredCurves().filter((curve) => curve.quantity === quantity.name &&
    stages.includes(curve.stage));
}

function nameOfValue(dimension, value) {
  return typeof value === "string" ? dimension.textOf(value) : `${dimension.label} ${value}`;
}

/// The label of a curve: the values in which the shown curves differ.
export function labelOfSweepCurve(curve, dimensions, values) {
  const parts = dimensions.filter(({name}) => values[name].size > 1)
    .map((one) => nameOfValue(one, one.of(curve)));
  const label = [...new Set(parts)].join(", ") || sweep.title;
  return label + ({storage: ", G′", loss: ", G″"}[curve.part] ?? "");
}

function colourOfSweepCurve(curve, {coloured}) {
  if (coloured === undefined) return palette[0];
  const i = Math.max(coloured.values.indexOf(coloured.of(curve)), 0);  // a mean over seeds has none of them
  const hasOrder = sweptKeys.some((key) => key.path === coloured.name && key.numbers !== undefined);
  if (!hasOrder && coloured.values.length <= palette.length) return palette[i];
  return `hsl(${260 - 235 * i / (coloured.values.length - 1)}, 70%, ${isDark() ? 62 : 42}%)`;
}

/// The line of a curve: colour by choice, dashes by method, dots for a loss modulus, width by boundary.
export function lineOfSweepCurve(curve, choice) {
  return {color: colourOfSweepCurve(curve, choice), dash: curve.part === "loss" ? "dot" : curve.method === "dynamic" ? "dash" : "solid",
    width: {displacement: 2.2, periodic: 1.6, traction: 1.1}[curve.boundary]};
}

function noteOnSweep(curves, measured) {
  const notes = [];
  if (measured.length > 0) notes.push("Points: measured.");
  if (curves.some(({part}) => part === "loss")) notes.push("Dotted, and open circles: loss modulus.");
  if (curves.some(({packings}) => packings > 1)) notes.push("Bands: standard deviation of one packing.");
  if (distinct(curves, "method").length > 1) notes.push("Dashed: dynamic method.");
  if (distinct(curves, "boundary").length > 1) notes.push("Thick: displacement; thin: traction.");
  return notes.join(" ");
}

/// Fills the section and returns the function that draws the figure.
export function sweepFigure(curves, choice, drawAll) {
  const plot = document.getElementById("curve-plot");
  const draw = () => {
    const [seen, quantity] = sweepContents(curves, choice);
    const measured = shownMeasurements(seen, choice);
    document.getElementById("curve-note").textContent = noteOnSweep(seen, measured);
    return drawFigure(plot, [
      ...seen.flatMap((curve) => tracesOf(curve, quantity, lineOfSweepCurve(curve, choice))),
      ...measured.flatMap((curve) => tracesOf(curve, quantity, {color: currentInks().ink}, "markers")),
    ], layoutOf(quantity, [...seen, ...measured]));
  };
  document.getElementById("curve-choices").append(...sweepChoices(curves, choice, drawAll));
  const name = () => `${sweep.title} ${sweepContents(curves, choice)[1].title}`;
  document.getElementById("curve-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(...sweepContents(curves, choice)),
      "text/csv")}, "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"));
  return draw;
}

/// The controls of the figure; each only if it has something to choose from.
function sweepChoices(curves, choice, drawAll) {
  const {dimensions, values} = choice;
  const rows = [];
  const shownQuantities = sweepQuantities.filter(({name}) => curves.some((curve) => curve.quantity === name));
  if (shownQuantities.length > 1) {
    const select = chooser("quantity", "quantity", shownQuantities.map((one) => [one, one.title]), (quantity) => {
      choice.quantity = quantity;
      drawAll();
    });
    select.selectedIndex = shownQuantities.indexOf(choice.quantity);
    rows.push(select);
  }
  if (hasSeeds) {
    rows.push(chooser("seeds", "seeds", [[true, "mean over the seeds"], [false, "a line for each seed"]], (means) => {
      choice.means = means;
      drawAll();
    }));
  }
  const hasPartners = (dimension, value) => curves.some((curve) => dimension.of(curve) !== value &&
    partnerOf(curve, dimension, value, curves, dimensions) !== undefined);
  const references = dimensions.filter((one) => !isSeed(one)).flatMap((dimension) => dimension.values
    .filter((value) => hasPartners(dimension, value))
    .map((value) => [{dimension, value}, `deviation from ${nameOfValue(dimension, value)}`]));
  references.push(...groupsOf(measuredCurves(), ["stage", "name"]).map(([measured]) =>
    [{measured}, `deviation from measured, ${measured.name}`]));
  rows.push(chooser("reference", "compared with", [[undefined, "no comparison"], ...references], (reference) => {
    choice.reference = reference;
    drawAll();
  }));
  if (dimensions.length > 1) {
    const select = chooser("colour", "colours tell", dimensions.map((one) => [one, `colours: ${one.label}`]),
      (dimension) => {
        choice.coloured = dimension;
        drawAll();
      });
    select.selectedIndex = dimensions.indexOf(choice.coloured);
    rows.push(select);
  }
  for (const one of dimensions) {
    rows.push(chips(one.label, one.values.map((value) => [value, one.textOf(value)]), values[one.name], drawAll));
  }
  return rows;
}
