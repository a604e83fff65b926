/// The curves of the tasks of a sweep, each {quantity, task, stage, load, boundary, method, values, x, y}; `values` are
/// those of the swept keys, by the path of the key. Where there are several grids only the best one is kept.

import {data, sweep} from "./data.js";
import {methodNames} from "./names.js";
import {distinct, groupsOf, own} from "./records.js";

/// The swept keys: {path, label, values, isSeed, numbers, unit}; `numbers` are the values in one unit if all have one.
export const sweptKeys = sweep.keys.map((path) => {
  const values = [...new Set(sweep.tasks.map((task) => task.values[path]))];
  return {path, label: labelOfKey(path), values, isSeed: path.split(".").at(-1) === "seed", ...numbersOf(path, values)};
});

/// The last part of the path of a key, or all of it if another swept key has the same last part.
export function labelOfKey(path) {
  const last = (text) => text.split(".").at(-1);
  return sweep.keys.filter((other) => last(other) === last(path)).length === 1 ? last(path) : path;
}

/// The values of a key as numbers, {numbers, unit}, or {} if they are no numbers. The numbers of quantities are in
/// sweep.json, in the unit of the first one.
function numbersOf(path, values) {
  const quantity = own(sweep.quantities ?? {}, path);
  if (quantity === undefined) return values.every(Number.isFinite) ? {numbers: values, unit: ""} : {};
  const taskWith = (value) => sweep.tasks.findIndex((task) => task.values[path] === value);
  return {numbers: values.map((value) => quantity.numbers[taskWith(value)]), unit: quantity.unit};
}

function isBetterGrid(cells, other) {
  return other !== "extrapolated" && (cells === "extrapolated" || Number(cells) > Number(other));
}

const testFields = ["quantity", "stage", "load", "boundary", "method"];

/// The curves of all tasks that are done.
export function sweepCurves() {
  const all = data.curves.map((curve) => ({...curve, quantity: curve.load === "bulk" ? "bulk" : "shear",
    values: sweep.tasks[curve.task].values, x: curve.time_s, y: curve.modulus_Pa}));
  return groupsOf(all, ["task", ...testFields]).map((grids) =>
    grids.reduce((best, one) => (isBetterGrid(one.cells, best.cells) ? one : best)));
}

/// The dimensions in which the curves differ, properties of tests and swept keys: [{name, label, values, textOf, of}],
/// where `of` returns the value of a curve and `textOf` its text. A property of the test is a dimension only if a task
/// has several values of it; otherwise a swept key changes it.
export function dimensionsOf(curves) {
  const names = {method: methodNames};
  const tasks = groupsOf(curves, ["task"]);
  const isFree = (name) => name !== "quantity" && tasks.some((task) => distinct(task, name).length > 1);
  const fields = testFields.filter(isFree).map((name) => ({name, label: name, values: distinct(curves, name),
    textOf: (value) => names[name]?.[value] ?? value, of: (curve) => curve[name]}));
  const keys = sweptKeys.map(({path, label, values}) => ({name: path, label, values, textOf: String,
    of: (curve) => curve.values[path]}));
  return [...fields, ...keys].filter(({values}) => values.length > 1);
}

/// The curve that has the given value in one dimension and agrees with another curve in all others.
export function partnerOf(curve, dimension, value, curves, dimensions) {
  return curves.find((other) => other.quantity === curve.quantity && dimensions.every((one) =>
    one.of(other) === (one.name === dimension.name ? value : one.of(curve))));
}
