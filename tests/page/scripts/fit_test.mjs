/// The curves on the page of a fit.

import assert from "node:assert/strict";
import {test} from "node:test";

import {blackDiagram, decadesToReference, deviationsOf, lawAt, reducedSweeps} from
  "../../../src/page/scripts/fit_curves.js";
import {decadesOfShift} from "../../../src/page/scripts/viscoelasticity.js";
import {assertClose} from "./close.mjs";

const law = {c1: 6.5, c2_K: 120, reference_K: 292.15};

test("the law with another reference gives the same ratios of shift factors", () => {
  const moved = lawAt(law, 310);
  assertClose(decadesOfShift(moved, 350), decadesOfShift(law, 350) - decadesOfShift(law, 310), 1e-12, "decades");
  assert.equal(decadesOfShift(moved, 310) + 0, 0);
});

test("sweeps over the reduced frequency", () => {
  // The shift at 10 K above the reference is log10 a_T = -6.5 * 10 / 130 = -0.5.
  const sweep = {temperature_K: 302.15, angular_frequency_rad_per_s: [10, 100], log10_shift_factor: -0.5};
  const [atReference] = reducedSweeps([sweep], 0);
  assertClose(atReference.x[1], 100 / Math.sqrt(10), 1e-12, "reduced frequency");
  const [atItsOwn] = reducedSweeps([sweep], decadesToReference({law}, 302.15));
  assertClose(atItsOwn.x[0], 10, 1e-12, "frequency at the temperature of the sweep");
  assert.equal(decadesToReference({}, 350), 0);
});

test("deviations and the Black diagram of one Maxwell element", () => {
  // Both moduli are half of the spring's at omega tau = 1.
  const series = {equilibrium_Pa: 0, terms: [{relaxation_time_s: 0.1, modulus_Pa: 4e6}]};
  const {storage, loss} = deviationsOf(series, {x: [10], storage_Pa: [2e6], loss_Pa: [1e6]});
  assert.ok(Math.abs(storage[0]) < 1e-9);
  assertClose(loss[0], 100, 1e-12, "deviation");
  const {absolute, degrees} = blackDiagram([3, 1], [4, 1]);
  assertClose(absolute[0], 5, 1e-12, "absolute value");
  assertClose(degrees[1], 45, 1e-12, "phase angle");
});
