/// Curves over the temperature, and the names at the ends of curves.

import assert from "node:assert/strict";
import {test} from "node:test";

import {parted} from "../../../src/page/scripts/end_labels.js";
import {lawOf, overTemperature, usualAbscissa} from "../../../src/page/scripts/temperature_axis.js";
import {decadesOfShift, temperatureOfShift, temperaturesOfLaw} from "../../../src/page/scripts/viscoelasticity.js";
import {assertClose} from "./close.mjs";

const law = {c1: 6.5, c2_K: 120, reference_K: 292.15, temperature_K: 293.15};

test("the temperature of a shift factor", () => {
  for (const temperature of [250, 292.15, 350]) {
    assertClose(temperatureOfShift(law, decadesOfShift(law, temperature)), temperature, 1e-12, "temperature");
  }
  assert.equal(temperatureOfShift(law, -7), Infinity);
});

test("a curve over the temperature", () => {
  // Computed by hand: log10 a_T = -6.5 * 10 / 130 = -0.5 at 10 degrees above the reference, -6.5 / 121 at 1 degree.
  const shift = -0.5 + 6.5 / 121;
  const frequency = 2 * Math.PI;
  const dynamic = overTemperature({x: [1e-3, frequency * 10 ** shift, 1e12], y: [1, 2, 3], band: [0.1, 0.2, 0.3]}, law,
    "rad/s", frequency);
  const place = dynamic.y.indexOf(2);
  assertClose(dynamic.x[place], 29, 1e-9, "temperature of the frequency");
  assert.equal(dynamic.band[place], 0.2);
  assert.deepEqual(dynamic.x, [...dynamic.x].sort((a, b) => a - b));
  const inTime = overTemperature({x: [1 / 10 ** shift], y: [5]}, law, "s", 1);
  assertClose(inTime.x[0], 29, 1e-9, "temperature of the time");
  // There is no shift at the temperature of the study.
  assertClose(overTemperature({x: [3], y: [1]}, law, "s", 3).x[0], 20, 1e-9, "temperature of the study");
});

test("only composites that relax by their binder alone", () => {
  const elastic = {terms: []}, relaxing = {terms: [{relaxation_time_s: 1, modulus_Pa: 1}]};
  const materials = [{name: "b", shear: relaxing, bulk: elastic, temperature_shift: law},
    {name: "f", shear: elastic, bulk: elastic}, {name: "v", shear: relaxing, bulk: elastic}];
  const stages = [{name: "A", matrix: "b", filler_of_the_whole: {materials: [{material: "f"}]}},
    {name: "B", matrix: "A", filler_of_the_whole: {materials: [{material: "f"}], coatings: [{material: "v"}]}}];
  const study = {materials, stages};
  assert.equal(lawOf(study, "A"), law);
  assert.equal(lawOf(study, "B"), undefined);
  assert.equal(lawOf(study, "b"), law);
  assert.equal(lawOf(study, "f"), undefined);
});

test("the usual frequency is 1 Hz where the study has it", () => {
  assertClose(usualAbscissa([1e-3, 10], "rad/s"), 2 * Math.PI, 1e-12, "1 Hz");
  assertClose(usualAbscissa([1e-8, 1e-4], "rad/s"), 2 * Math.PI * 1e5, 1e-12, "100 kHz");
  assertClose(usualAbscissa([1e-3, 10], "s"), 0.1, 1e-12, "100 ms");
});

test("names do not cover one another", () => {
  assert.deepEqual(parted([{at: 10, height: 12}, {at: 50, height: 12}], 100), [10, 50]);
  assert.deepEqual(parted([{at: 50, height: 20}, {at: 45, height: 20}], 100), [65, 45]);
  assert.deepEqual(parted([{at: 95, height: 20}, {at: 96, height: 20}], 100), [70, 90]);
});

test("the temperatures at which a law has a meaning", () => {
  assert.deepEqual(temperaturesOfLaw({c1: 6.5, c2_K: 120, reference_K: 292}), [182, Infinity]);
  // The law of Arrhenius is that of WLF with c2 = T_ref: down to absolute zero.
  assert.deepEqual(temperaturesOfLaw({c1: 30, c2_K: 300, reference_K: 300}), [10, Infinity]);
  assert.deepEqual(temperaturesOfLaw({temperatures_K: [232, 260, 332], reference_K: 292}), [232, 332]);
});
