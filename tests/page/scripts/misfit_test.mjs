/// The fit of the page, to numbers whose solution is known.

import assert from "node:assert/strict";
import {test} from "node:test";

import {fitted, freeNumbers, misfitText, ofBestBoundary} from "../../../src/page/scripts/live_fit.js";
import {leastSquares, logarithmicRatios, rootMeanSquare} from "../../../src/page/scripts/misfit.js";
import {assertClose} from "./close.mjs";

const curve = {stage: "A", quantity: "shear", boundary: "periodic", x: [1, 10, 100], y: [1e6, 1e5, 1e4]};

test("ratios of curves on logarithmic axes", () => {
  const measured = [{stage: "A", quantity: "shear", x: [Math.sqrt(10), 1000], y: [2e5 * Math.sqrt(10) / 2, 1]},
    {stage: "B", quantity: "shear", x: [10], y: [1]}];
  const [first, outside, other] = logarithmicRatios([curve], measured);
  assertClose(Math.exp(first), 1, 1e-12, "between two points");
  assert.ok(Number.isNaN(outside) && Number.isNaN(other));
  assert.equal(rootMeanSquare([3, NaN, 4]), Math.sqrt(12.5));
});

test("least squares of a function with bounds", () => {
  // y = a exp(-b x) with a = 2, b = 0.5.
  const x = [0, 1, 2, 3, 4];
  const residuals = ([a, b]) => x.map((at) => a * Math.exp(-b * at) - 2 * Math.exp(-0.5 * at));
  const wide = [[0, 10], [0, 10]];
  leastSquares(residuals, [1, 1], wide).forEach((value, i) => assertClose(value, [2, 0.5][i], 1e-5, `value ${i}`));
  const [a, b] = leastSquares(residuals, [1, 1], [[0, 1.5], [0, 10]]);
  assert.equal(a, 1.5);
  // The best b for a = 1.5, by a search over a fine grid.
  const sum = (one) => x.reduce((all, at) => all + (1.5 * Math.exp(-one * at) - 2 * Math.exp(-0.5 * at)) ** 2, 0);
  const best = Array.from({length: 10001}, (_, i) => i / 1e4).reduce((least, one) => (sum(one) < sum(least) ? one : least));
  assertClose(b, best, 1e-3, "the other one");
  assert.equal(leastSquares(() => [NaN, NaN], [1, 1], wide), undefined);
});

test("least squares where a value has no effect, and where points get lost", () => {
  const [a] = leastSquares(([one]) => [one - 3, 2 * (one - 3)], [0, 0], [[-9, 9], [-9, 9]]);
  assertClose(a, 3, 1e-6, "the one that has");
  const [kept] = leastSquares(([one]) => [one - 3, one > 2 ? NaN : one - 5], [0], [[-9, 9]]);
  assert.ok(kept > 1 && kept <= 2, `no value beyond which less is known, got ${kept}`);
  const [gained] = leastSquares(([one]) => [one - 3, one > 1 ? 100 : NaN], [0], [[-9, 9]]);
  assertClose(gained, 3, 1e-6, "points that come in later do not count");
});

test("the spectrum of a material that relaxes", () => {
  // The composite is the material: G(t) = g exp(-t / tau), measured with half the time and three times the modulus.
  const material = {name: "binder", shear: {equilibrium_Pa: 0, terms: [{relaxation_time_s: 10, modulus_Pa: 1e6}]},
    bulk: {equilibrium_Pa: 0, terms: [{relaxation_time_s: 10, modulus_Pa: 3e6}]}};
  const x = Array.from({length: 21}, (_, i) => 10 ** (i / 10 - 1));
  const curvesWith = ({spectrum: {terms: [{relaxation_time_s: tau, modulus_Pa: g}]}}) =>
    [{...curve, x, y: x.map((t) => g * Math.exp(-t / tau))}];
  const measured = [{stage: "A", quantity: "shear", x: x.slice(2, -2), y: x.slice(2, -2).map((t) => 3e6 * Math.exp(-t / 5))}];
  assert.match(misfitText(curvesWith({spectrum: material.shear}), measured), /rms \(periodic\)/);
  const {spectrum, bulk, text} = fitted(freeNumbers({material}), curvesWith, measured);
  assertClose(spectrum.terms[0].relaxation_time_s, 5, 1e-4, "time");
  assertClose(spectrum.terms[0].modulus_Pa, 3e6, 1e-4, "modulus");
  assert.equal(text, "relaxation times × 0.5, moduli × 3 of those of the run");
  assertClose(bulk.terms[0].relaxation_time_s, 5, 1e-4, "time of the bulk modulus");
  assertClose(bulk.terms[0].modulus_Pa, 9e6, 1e-4, "a bulk modulus in proportion");
  // From a spectrum that the reader has given the factors are relative to that; a bulk modulus that does not relax stays.
  const pasted = {equilibrium_Pa: 0, terms: [{relaxation_time_s: 5, modulus_Pa: 1e6}]};
  const elastic = {...material, bulk: {equilibrium_Pa: 2e9, terms: []}};
  const second = fitted(freeNumbers({material: elastic, pasted}), curvesWith, measured);
  assert.equal(second.text, "relaxation times × 1, moduli × 3 of those of the spectrum above");
  assertClose(second.bulk.equilibrium_Pa, 2e9, 1e-12, "bulk");
});

test("the modulus of an elastic material, within what was sampled", () => {
  const material = {name: "interphase", shear: {equilibrium_Pa: 1e8, terms: []}, bulk: {equilibrium_Pa: 2e9, terms: []},
    ranges: {shear: [1e7, 1e9], bulk: [2e9, 2e9]}};
  const curvesWith = ({spectrum: {equilibrium_Pa}}) => [{...curve, y: curve.y.map((value) => value * (equilibrium_Pa / 1e8) ** 0.3)}];
  const measuredWith = (modulus) => [{stage: "A", quantity: "shear", x: [3, 30], y: [3, 30].map((t) => 1e6 / t * (modulus / 1e8) ** 0.3)}];
  assertClose(fitted(freeNumbers({material}), curvesWith, measuredWith(3e8)).spectrum.equilibrium_Pa, 3e8, 1e-4, "modulus");
  const end = fitted(freeNumbers({material}), curvesWith, measuredWith(5e9));
  assertClose(end.spectrum.equilibrium_Pa, 1e9, 1e-9, "its end");
  assert.equal(end.text, "shear modulus 1 GPa, at the end of what is allowed");
  assert.equal(freeNumbers({material: {...material, ranges: {shear: [1e8, 1.1e8], bulk: [2e9, 2e9]}}}), undefined);
});

test("the boundary that comes nearest to the material", () => {
  const curves = ["displacement", "traction"].map((boundary) => ({...curve, boundary}));
  assert.deepEqual(ofBestBoundary(curves).map(({boundary}) => boundary), ["displacement"]);
  assert.deepEqual(ofBestBoundary([...curves, curve]).map(({boundary}) => boundary), ["periodic"]);
  assert.equal(misfitText([], []), "");
});
