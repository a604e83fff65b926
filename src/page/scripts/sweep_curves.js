/// The curves of the tasks of a sweep, each {quantity, task, stage, load, boundary, method, values, x, y}; `values` are
/// those of the swept keys, by the path of the key. Where there are several grids only the best one is kept. Of a sweep
/// whose deck gives frequencies there are those of the complex modulus in shear, too, over the frequency in hertz.

import {inHertz, sampledComplexCurves} from "./complex_curves.js";
import {data, sweep} from "./data.js";
import {axes, methodNames, quantities} from "./names.js";
import {distinct, groupsOf, own} from "./records.js";
import {valueAt} from "./sampling.js";

/// The swept keys: {path, label, values, isSeed, numbers, unit}; `numbers` are the values in one unit if all have one.
export const sweptKeys = sweep.keys.map((path) => {
  const values = [...new Set(sweep.tasks.map((task) => task.values[path]))];
  return {path, label: labelOfKey(path), values, isSeed: path.split(".").at(-1) === "seed", ...numbersOf(path, values)};
});

/// The last part of the path of a key, with the name of a list before the number of its element, or all of it if another
/// swept key has the same last part.
export function labelOfKey(path) {
  const last = (text) => text.match(/[^.]+(\.\d+)*$/)[0].replaceAll(".", " ");
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

/// The quantities of the page of a sweep, those over frequency in hertz.
export const sweepQuantities = quantities.map((quantity) =>
  (quantity.xUnit === "rad/s" ? {...quantity, ...axes.frequency} : quantity));

/// The curves of all tasks that are done.
export function sweepCurves() {
  const all = data.curves.map((curve) => withError({...curve, quantity: curve.load === "bulk" ? "bulk" : "shear",
    values: sweep.tasks[curve.task].values, x: curve.time_s, y: curve.modulus_Pa}));
  const inTime = groupsOf(all, ["task", ...testFields]).map((grids) =>
    grids.reduce((best, one) => (isBetterGrid(one.cells, best.cells) ? one : best)));
  return [...inTime.flatMap(complexCurvesOf), ...inTime];
}

/// A curve with its `error`, a share of y at each x, and the `band` that it makes; without them where it is not known.
function withError({error, ...curve}) {
  if (error.length === 0 || error.includes(null)) return curve;
  return {...curve, error, band: curve.y.map((y, i) => error[i] * y)};
}

/// The curves of the complex modulus of a test in shear; none where the sweep is in time. The absolute value has the error
/// of the relaxation modulus at the time 1/omega.
function complexCurvesOf({storage_modulus_Pa: storage, loss_modulus_Pa: loss, error, band, ...common}) {
  if (storage === undefined || common.load === "bulk") return [];
  const frequencies = common.angular_frequency_rad_per_s;
  const shares = error && frequencies.map((omega) => valueAt(common.x, error, within(common.x, 1 / omega)));
  return inHertz(sampledComplexCurves(common, frequencies, storage.map((value, i) => ({storage: value, loss: loss[i]})))
    .map((curve) => (curve.quantity === "absolute" && shares ? withError({...curve, error: shares}) : curve)));
}

/// The number nearest to this one between the first and the last of a rising list: 1/omega may lie beside it by rounding.
function within(list, number) {
  return Math.min(Math.max(number, list[0]), list.at(-1));
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
  return curves.find((other) => other.quantity === curve.quantity && other.part === curve.part && dimensions.every((one) =>
    one.of(other) === (one.name === dimension.name ? value : one.of(curve))));
}
