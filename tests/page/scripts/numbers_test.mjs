/// Numbers as text, and the numbers of axes.

import assert from "node:assert/strict";
import {test} from "node:test";

import {display, duration, minus, percent, percentOfWhole, shortNumber, unbroken} from "../../../src/page/scripts/numbers.js";
import {decades, extent, logarithmic, valueAt} from "../../../src/page/scripts/sampling.js";
import {evenTicks, logarithmicTicks, unitFor, withUnit} from "../../../src/page/scripts/ticks.js";
import {cases} from "./cases.mjs";
import {assertClose} from "./close.mjs";

/// A text of the page in the signs of the command line, which are those of ASCII.
const asPlainText = (text) => text.replace("−", "-").replace("µ", "u");

test("quantities, times and durations read as on the command line", () => {
  for (const {value, digits, text} of cases.display.quantities) {
    assert.equal(asPlainText(display(value, "Pa", digits)), text, `${value} to ${digits} digits`);
  }
  for (const {value, text} of cases.display.times) assert.equal(asPlainText(display(value, "s")), text);
  for (const {value, text} of cases.display.durations) assert.equal(asPlainText(duration(value)), text);
});

test("numbers that the page writes in its own way", () => {
  assert.deepEqual([display(2.5e6, "s"), display(Infinity, "s"), display(NaN, "s"), display(1.5e-20, "m")],
    ["2.5·10⁶ s", "∞", "–", "1.5·10⁻²⁰ m"]);
  assert.deepEqual([percent(4e-7), percent(0), percent(0.012345), percent(-0.5), percent(null), percent(undefined)],
    ["4·10⁻⁵ %", "0 %", "1.2 %", "−50 %", "", ""]);
  assert.deepEqual([shortNumber(-1e-20), shortNumber(1e5), shortNumber(12345), minus(-20), percentOfWhole(0.6501)],
    ["−1·10⁻²⁰", "10⁵", "12300", "−20", "65.0 %"]);
});

test("samples of curves", () => {
  assert.deepEqual(extent([3, NaN, -1, Infinity]), [-1, 3]);
  assert.deepEqual(extent([]), [0, 1]);
  assert.deepEqual(decades(1e-3, 0.5), [1e-3, 0.01, 0.1]);
  const times = logarithmic(1e-3, 10, 5);
  assert.deepEqual([times.length, times[0], times.at(-1)], [21, 1e-3, 10]);
  // A power of time is met between the samples, to rounding.
  const values = times.map((time) => 7 * time ** -0.3);
  assertClose(valueAt(times, values, 0.0123), 7 * 0.0123 ** -0.3, 1e-13, "between samples");
  assert.ok(Number.isNaN(valueAt(times, values, 0.9e-3)) && Number.isNaN(valueAt(times, values, 10.1)));
});

test("units of axes", () => {
  assert.deepEqual(unitFor("Pa", [2e6, 7e6]), {unit: "MPa", scale: 1e6});
  assert.deepEqual(unitFor("Pa", [1, 2e9]), {unit: "kPa", scale: 1e3});  // suits the upper decades
  assert.deepEqual(unitFor("1/Pa", [2e-6, 3e-7]), {unit: "1/MPa", scale: 1e-6});
  assert.deepEqual(unitFor("s", [1e-3, 0.05]), {unit: "ms", scale: 1e-3});
  assert.deepEqual(unitFor("%", [3, 4]), {unit: "%", scale: 1});
  assert.deepEqual(unitFor("Pa", []), {unit: "Pa", scale: 1});
});

test("compliances with their unit", () => {
  assert.deepEqual([2.3e-9, 2e-6, 0.45e-6, 0.9999e-6, 7].map((value) => withUnit(value, "1/Pa")),
    ["2.3 1/GPa", "2 1/MPa", "450 1/GPa", "1 1/MPa", "7 1/Pa"]);
  assert.deepEqual([withUnit(0, "1/Pa"), withUnit(NaN, "1/Pa"), withUnit(2.3e9, "Pa")], ["0 1/Pa", "–", "2.3 GPa"]);
});

test("ticks of axes", () => {
  const texts = (ticks) => ticks.map(({text}) => text).join(" ");
  assert.equal(texts(evenTicks(-0.05, 0.21, 6)), "−0.05 0.00 0.05 0.10 0.15 0.20");
  assert.equal(texts(evenTicks(0, 52, 12)), "0 5 10 15 20 25 30 35 40 45 50");
  const textOf = (value) => display(value, "s");
  assert.equal(texts(logarithmicTicks(-3, -1, 6, textOf)),
    "1 ms 2 ms   5 ms     10 ms 20 ms   50 ms     100 ms");
  assert.equal(texts(logarithmicTicks(-9, 3, 6, textOf)), " 10 ns  1 µs  100 µs  10 ms  1 s  100 s ");
  assert.equal(texts(logarithmicTicks(Math.log10(0.02), Math.log10(0.05), 6, textOf)),
    "20 ms 25 ms 30 ms 35 ms 40 ms 45 ms 50 ms");
});

test("lines do not end between a number and its unit", () => {
  assert.equal(unbroken("1.5 MPa ± 3 % at 1 ms, 3 times 2 grids of 7 mm"),
    "1.5\u00a0MPa ±\u00a03\u00a0% at 1\u00a0ms, 3 times 2 grids of 7\u00a0mm");
});
