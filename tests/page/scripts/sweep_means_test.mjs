/// Means over the seeds of a sweep, from data that stand in for those of a page: two gaps with three packings each.

import assert from "node:assert/strict";
import {test} from "node:test";

import {assertClose} from "./close.mjs";

const tasks = [1, 2].flatMap((gap) => [1, 2, 3].map((seed) => ({name: `${gap}-${seed}`, state: "done", values: {gap, "packing.seed": seed}})));
const data = {sweep: {title: "mix", keys: ["gap", "packing.seed"], quantities: {}, tasks}, curves: [], measurements: [], tables: {}};
globalThis.document = {getElementById: () => ({textContent: JSON.stringify(data)})};
globalThis.matchMedia = () => ({matches: false});
const {hasSeeds, meansOverSeeds} = await import("../../../src/page/scripts/sweep_means.js");
const {sweepChoice, sweepContents} = await import("../../../src/page/scripts/sweep_figure.js");

const curves = tasks.map(({values}, task) => ({task, values, quantity: "shear", stage: "mix", load: "shear",
  boundary: "periodic", method: "quasistatic", x: [1, 10], error: [0.1, 0.1],
  y: [1, 0.1].map((factor) => factor * values.gap * (1 + 0.1 * (values["packing.seed"] - 2)))}));

test("the mean of packings, their deviation and what that makes of the mean", () => {
  assert.ok(hasSeeds);
  const [one, two] = meansOverSeeds(curves);
  assert.equal(one.packings, 3);
  assert.deepEqual([one.values.gap, two.values.gap, one.values["packing.seed"]], [1, 2, "mean of 3"]);
  [1, 0.1].forEach((value, i) => {
    assertClose(one.y[i], value, 1e-12, "mean");
    assertClose(two.y[i], 2 * value, 1e-12, "mean");
    assertClose(one.band[i], 0.1 * value, 1e-12, "standard deviation of 0.9, 1 and 1.1");
    assertClose(one.error[i], 4.30 * 0.1 / Math.sqrt(3), 1e-12, "95 % by Student's t");
  });
});

test("a curve alone is its own mean, and times that one has not are left out", () => {
  assert.equal(meansOverSeeds(curves.slice(0, 1))[0], curves[0]);
  const [mean] = meansOverSeeds([curves[0], {...curves[1], x: [10], y: [0.1]}]);
  assert.deepEqual(mean.x, [10]);
});

test("the figure shows means first, and a line for each seed on demand", () => {
  const choice = sweepChoice(curves);
  assert.equal(choice.coloured.name, "gap", "seeds have no order");
  assert.deepEqual(sweepContents(curves, choice)[0].map(({label}) => label), ["gap 1, mean of 3", "gap 2, mean of 3"]);
  choice.values["packing.seed"].delete(3);
  assert.deepEqual(sweepContents(curves, choice)[0].map(({packings}) => packings), [2, 2], "of the chosen seeds");
  choice.means = false;
  assert.equal(sweepContents(curves, choice)[0].length, 4);
  choice.means = true;
  choice.reference = {dimension: choice.dimensions.find(({name}) => name === "gap"), value: 1};
  const [deviations] = sweepContents(curves, choice);
  assert.equal(deviations.length, 1);
  assertClose(deviations[0].y[0], 100, 1e-9, "of means");
});
