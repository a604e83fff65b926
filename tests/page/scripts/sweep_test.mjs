/// The curves of the page of a sweep, from data that stand in for those of a page: two fractions on two grids in frequency,
/// one Maxwell element each, measured at one frequency.

import assert from "node:assert/strict";
import {test} from "node:test";

import {assertClose} from "./close.mjs";

const perCycle = 2 * Math.PI;

function curve(task, modulus, {load = "shear", cells = "20", error = [0.1, 0.2]} = {}) {
  const frequencies = [1, 10];  // [rad/s], of a relaxation time of 1 s
  return {task, stage: "mix", load, boundary: "periodic", method: "quasistatic", cells, time_s: [0.1, 1],
    modulus_Pa: [modulus, 0.5 * modulus], error, angular_frequency_rad_per_s: frequencies,
    storage_modulus_Pa: frequencies.map((x) => modulus * x * x / (1 + x * x)),
    loss_modulus_Pa: frequencies.map((x) => modulus * x / (1 + x * x))};
}

const key = "stages.*.filler.fraction", path = "tests.frequencies.0";
const data = {
  sweep: {title: "mix", keys: [key, path], quantities: {},
    tasks: [0.2, 0.3].map((fraction) => ({name: `fraction-${fraction}`, state: "done", values: {[key]: fraction, [path]: "1 Hz"}}))},
  curves: [curve(0, 1e6, {cells: "10"}), curve(0, 2e6), curve(1, 4e6, {error: [0.1, null]}), curve(1, 8e6, {load: "bulk"})],
  measurements: [{stage: "mix", measurement: "Bennett", time_s: [0.5], measured_Pa: [1e6]}],
  measurements_in_frequency: [{stage: "mix", measurement: "DMA", angular_frequency_rad_per_s: [1],
    measured_storage_modulus_Pa: [3e5], measured_loss_modulus_Pa: [4e5]}],
  tables: {},
};
globalThis.document = {getElementById: () => ({textContent: JSON.stringify(data)})};
const {dimensionsOf, labelOfKey, partnerOf, sweepCurves, sweptKeys} = await import("../../../src/page/scripts/sweep_curves.js");
const {measuredCurves, ratioColumns} = await import("../../../src/page/scripts/sweep_measurements.js");

const curves = sweepCurves();
const of = (quantity, task, part) => curves.find((one) => one.quantity === quantity && one.task === task && one.part === part);

test("a sweep has the best grid of each test, and complex moduli in shear over hertz", () => {
  assert.equal(curves.filter(({quantity}) => quantity === "shear").length, 2);
  assert.equal(of("shear", 0).y[0], 2e6);
  assert.equal(of("bulk", 1).y[0], 8e6);
  assert.equal(curves.filter(({quantity}) => quantity === "absolute").length, 2, "none of the bulk modulus");
  const absolute = of("absolute", 0);
  assertClose(absolute.x[0], 1 / perCycle, 1e-12);
  assertClose(absolute.y[0], 2e6 / Math.SQRT2, 1e-12);
  assertClose(of("dynamic", 0, "storage").y[1], 2e6 * 100 / 101, 1e-12);
  assertClose(of("loss-factor", 0).y[1], 0.1, 1e-12);
});

test("the error of an absolute value is that of the relaxation modulus at the time 1/omega", () => {
  const absolute = of("absolute", 0);
  assertClose(absolute.error[0], 0.2, 1e-12);
  assertClose(absolute.error[1], 0.1, 1e-12);
  assertClose(absolute.band[0], 0.2 * absolute.y[0], 1e-12);
  assertClose(of("shear", 0).band[1], 0.2 * 1e6, 1e-12);
  for (const quantity of ["shear", "absolute"]) assert.equal(of(quantity, 1).band, undefined, "not known at all times");
  assert.equal(of("dynamic", 0, "loss").band, undefined);
});

test("curves of other values have the same part", () => {
  const dimensions = dimensionsOf(curves), fraction = dimensions.find(({name}) => name === key);
  const partner = partnerOf(of("dynamic", 0, "loss"), fraction, 0.3, curves, dimensions);
  assert.equal(partner, of("dynamic", 1, "loss"));
});

test("keys have short labels, elements of lists with their list", () => {
  assert.equal(labelOfKey(key), "fraction");
  assert.equal(labelOfKey(path), "frequencies 0");
});

test("the table of tasks compares absolute values where the sweep is in frequency", () => {
  assert.deepEqual(measuredCurves().map(({quantity}) => quantity).slice(0, 2), ["shear", "dynamic"]);
  const columns = ratioColumns(curves);
  assert.deepEqual(columns.map(({head}) => head), ["|G*| of mix over measured, DMA, periodic"]);
  // |G*| is 2e6 / sqrt(2) and 4e6 / sqrt(2), and measured 5e5.
  assert.deepEqual([0, 1].map((task) => columns[0].of(task)), ["2.83", "5.66"]);
});

test("against a swept key storage and loss modulus are lines of their own", async () => {
  globalThis.matchMedia = () => ({matches: false});
  const {linesAgainst} = await import("../../../src/page/scripts/key_figure.js");
  const dimensions = dimensionsOf(curves);
  const choice = {dimensions, values: Object.fromEntries(dimensions.map((one) => [one.name, new Set(one.values)]))};
  const seen = curves.filter(({quantity}) => quantity === "dynamic");
  const lines = linesAgainst(sweptKeys.find((one) => one.path === key), 1 / perCycle, seen, choice);
  assert.deepEqual(lines.map(({x, y}) => [x, y.map((value) => Math.round(value))]),
    [[[0.2, 0.3], [1e6, 2e6]], [[0.2, 0.3], [1e6, 2e6]]]);
});
