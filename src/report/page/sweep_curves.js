"use strict";

/// The curves of all tasks, each {quantity, task, stage, load, boundary, method, values, label, x, y}, `values` being those
/// of the swept keys. Of several grids there is only the one that tells most.

const sweep = data.sweep;

/// The swept keys: {path, label, values, numbers}, `numbers` only where all values are numbers in one unit.
const sweptKeys = sweep.keys.map((path) => {
  const values = [...new Set(sweep.tasks.map((task) => task.values[path]))];
  return {path, label: labelOfKey(path), values, isSeed: path.split(".").at(-1) === "seed", ...numbersOf(path, values)};
});

/// The last step of a path, or all of it where another key ends like it.
function labelOfKey(path) {
  const last = (text) => text.split(".").at(-1);
  return sweep.keys.filter((other) => last(other) === last(path)).length === 1 ? last(path) : path;
}

/// Quantities of different units are numbers in that of the first.
function numbersOf(path, values) {
  const quantity = sweep.quantities?.[path];
  if (quantity !== undefined) {
    const taskWith = (value) => sweep.tasks.findIndex((task) => task.values[path] === value);
    return {numbers: values.map((value) => quantity.numbers[taskWith(value)]), unit: quantity.unit};
  }
  const read = values.map((value) => /^([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(.*)$/.exec(String(value)));
  const units = new Set(read.map((match) => match?.[2]));
  if (read.includes(null) || units.size > 1) return {};
  return {numbers: read.map((match) => Number(match[1])), unit: read[0][2]};
}

function isBetterGrid(cells, other) {
  return other !== "extrapolated" && (cells === "extrapolated" || Number(cells) > Number(other));
}

const testFields = ["quantity", "stage", "load", "boundary", "method"];

function sweepCurves() {
  const all = data.curves.map((curve) => ({...curve, quantity: curve.load === "bulk" ? "bulk" : "shear",
    values: sweep.tasks[curve.task].values, x: curve.time_s, y: curve.modulus_Pa}));
  return groupsOf(all, ["task", ...testFields]).map((grids) =>
    grids.reduce((best, one) => (isBetterGrid(one.cells, best.cells) ? one : best)));
}

/// What curves can differ in: the fields of a test and the swept keys, each {name, label, values}. A field that is the
/// same throughout each task says only what a key says.
function dimensionsOf(curves) {
  const names = {boundary: boundNames, method: methodNames};
  const tasks = groupsOf(curves, ["task"]);
  const isFree = (name) => name !== "quantity" && tasks.some((task) => distinct(task, name).length > 1);
  const fields = testFields.filter(isFree).map((name) => ({name, label: name === "boundary" ?
    "bound" : name, values: distinct(curves, name), textOf: (value) => names[name]?.[value] ?? value,
    of: (curve) => curve[name]}));
  const keys = sweptKeys.map(({path, label, values}) => ({name: path, label, values, textOf: String,
    of: (curve) => curve.values[path]}));
  return [...fields, ...keys].filter(({values}) => values.length > 1);
}

/// The curve that differs from another in one dimension alone, where it has a given value.
function partnerOf(curve, dimension, value, curves, dimensions) {
  return curves.find((other) => other.quantity === curve.quantity && dimensions.every((one) =>
    one.of(other) === (one.name === dimension.name ? value : one.of(curve))));
}
