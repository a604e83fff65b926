/// The controls of the figure with the curves; each only if it has something to choose from. They change `shown` and
/// then call `draw` (curves_figure.js).

import {gridsOfStudy} from "./curves.js";
import {study} from "./data.js";
import {chips, element} from "./elements.js";
import {gridName, methodNames, quantities} from "./names.js";
import {distinct, own} from "./records.js";
import {lawOf} from "./temperature_axis.js";

/// The choice of the quantity, of the abscissa, and of the curve that it is compared with.
export function quantityChoices(curves, shown, draw) {
  const axis = axisChoice(curves, shown, draw);
  const reference = element("select", {id: "reference", ariaLabel: "compared with", onchange: () => {
    shown.reference = reference.value;
    draw();
  }});
  // The references are the curves of the shown quantity. The chosen one is kept if it is among them.
  const offerReferences = () => {
    const labels = curves.filter((curve) => curve.quantity === shown.quantity.name && curve.role !== "matrix")
      .map((curve) => curve.label);
    reference.replaceChildren(element("option", {value: ""}, "no comparison"),
      ...labels.map((label) => element("option", {value: label}, `deviation from ${label}`)));
    shown.reference = labels.includes(shown.reference) ? shown.reference : "";
    reference.value = shown.reference;
  };
  const select = element("select", {id: "quantity", ariaLabel: "quantity", onchange: () => {
    shown.quantity = quantities.find((quantity) => quantity.name === select.value);
    offerReferences();
    axis.offer();
    draw();
  }}, ...quantities.filter((quantity) => curves.some((curve) => curve.quantity === quantity.name))
    .map((quantity) => element("option", {value: quantity.name}, quantity.title)));
  select.value = shown.quantity.name;
  offerReferences();
  axis.offer();
  return [select, ...axis.elements, reference];
}

/// The choice of the axis, and of the time or frequency at which a quantity is shown over the temperature.
function axisChoice(curves, shown, draw) {
  const hasLaw = study.stages.some((stage) => lawOf(study, stage.name) !== undefined);
  const select = element("select", {id: "axis", ariaLabel: "axis", onchange: () => {
    shown.axis = select.value;
    showField();
    draw();
  }});
  const unit = element("span", {});
  const input = element("input", {id: "abscissa", type: "number", step: "any", ariaLabel: "time or frequency",
    onchange: () => {
      const value = Number(input.value) * sizeOfUnit();
      if (!(value > 0 && Number.isFinite(value))) return showField();
      shown.abscissa[shown.quantity.xUnit] = value;
      draw();
    }});
  const field = element("label", {className: "abscissa"}, "at ", input, " ", unit);
  const sizeOfUnit = () => (shown.quantity.xUnit === "s" ? 1 : 2 * Math.PI);
  const showField = () => {
    field.hidden = shown.axis !== "temperature";
    input.value = Number((shown.abscissa[shown.quantity.xUnit] / sizeOfUnit()).toPrecision(6));
    unit.textContent = shown.quantity.xUnit === "s" ? "s" : "Hz";
  };
  /// Offers the axes of the quantity. The chosen one is kept if it is among them.
  const offer = () => {
    const options = shown.quantity.x === "time" ? [["time", "over time"]]
      : [["frequency", "over frequency in Hz"], ["angular-frequency", "over angular frequency in rad/s"]];
    if (hasLaw) options.push(["temperature", "over temperature"]);
    select.replaceChildren(...options.map(([value, text]) => element("option", {value}, text)));
    shown.axis = options.some(([value]) => value === shown.axis) ? shown.axis : options[0][0];
    select.value = shown.axis;
    select.hidden = options.length < 2;
    showField();
  };
  return {elements: [select, field], offer};
}

/// The choice of stages, boundaries, methods, loads and grids, and of other curves to draw.
export function testChoices(curves, shown, draw) {
  const tests = study.stages.flatMap((stage) => stage.tests);
  const rows = [];
  const add = (title, names, isOn) => {
    if (names.length > 1) rows.push(chips(title, names, isOn, draw));
  };
  const named = (values, names) => values.map((value) => [value, own(names, value) ?? value]);
  add("stage", named(distinct(study.stages, "name"), {}), shown.stages);
  add("boundary", distinct(tests, "boundary").map((name) => [name, name]), shown.boundaries);
  add("method", named(distinct(tests, "method"), methodNames), shown.methods);
  add("load", distinct(tests, "load").filter((load) => load !== "bulk").map((load) => [load, load.replace("-", " ")]),
    shown.loads);
  const several = study.stages.some((stage) => stage.cells.length > 1);
  const coarser = gridsOfStudy().filter((grid) => grid !== "extrapolated");
  if (several) add("grid", [["best", "all grids"], ...coarser.map((grid) => [grid, gridName(grid)])], shown.grids);
  const extras = [["matrix", "binder"]];
  if (curves.some((curve) => curve.role === "measured")) extras.unshift(["measured", "measured"]);
  if (curves.some((curve) => curve.band !== undefined)) extras.push(["band", "band"]);
  if (tests.some((test) => test.time_domains !== undefined)) extras.push(["domains", "time domains"]);
  rows.push(chips("also", extras, shown.extras, draw));
  return rows;
}
