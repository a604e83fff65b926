/// The viscoelasticity of the page against that of the library.

import {test} from "node:test";

import {limitOfCells} from "../../../src/page/scripts/extrapolation.js";
import {shareOfLoad} from "../../../src/page/scripts/strain_ramp.js";
import {bulkModulus, carsonModulus, decadesOfShift, lossModulus, relaxationModulus, seriesOfCarsonModuli,
  seriesOfRelaxationModuli, shiftedSeries, storageModulus} from "../../../src/page/scripts/viscoelasticity.js";
import {cases} from "./cases.mjs";
import {assertClose} from "./close.mjs";

/// Both sides evaluate the same closed formula, so they differ by rounding only: the sums have up to 23 terms of one
/// sign, each with a few roundings of 1e-16; an exponential magnifies the rounding of t/tau by t/tau, at most 40 where
/// it matters.
const rounding = 1e-14;

test("relaxation, complex and Carson moduli of Prony series", () => {
  for (const {series, relaxation, complex, carson} of cases.series) {
    for (const [time, modulus] of relaxation) {
      assertClose(relaxationModulus(series, time), modulus, rounding, `M(${time} s)`);
    }
    for (const [frequency, storage, loss] of complex) {
      assertClose(storageModulus(series, frequency), storage, rounding, `M'(${frequency} rad/s)`);
      assertClose(lossModulus(series, frequency), loss, rounding, `M''(${frequency} rad/s)`);
    }
    for (const [s, modulus] of carson) assertClose(carsonModulus(series, s), modulus, rounding, `s M~(${s} 1/s)`);
  }
});

/// The page fits 30 relaxation times a decade, the library has the true ones. The two nearest times represent one
/// between them with an error of up to h^2/8 max |x (x - 1) exp(-x)| = 2.3e-4 of the modulus of its term, where
/// h = ln(10) / 30 and x = t / tau. In these cases the modulus of a term that relaxes at t is up to six times M(t).
const errorOfFit = 6 * 2.3e-4;

test("from Carson moduli back to time", () => {
  for (const {carson, relaxation} of cases.interconversions) {
    const series = seriesOfCarsonModuli(carson.map(([s]) => s), carson.map(([, modulus]) => modulus));
    for (const [time, modulus] of relaxation) {
      assertClose(relaxationModulus(series, time), modulus, errorOfFit, `M(${time} s)`);
    }
  }
});

test("series of relaxation moduli", () => {
  for (const {relaxation} of cases.interconversions) {
    const fitted = relaxation.filter((_, i) => i % 2 === 0);
    const series = seriesOfRelaxationModuli(fitted.map(([time]) => time), fitted.map(([, modulus]) => modulus));
    for (const [time, modulus] of relaxation) {
      assertClose(relaxationModulus(series, time), modulus, errorOfFit, `M(${time} s)`);
    }
  }
});

test("temperature shift by the law of Williams, Landel and Ferry", () => {
  for (const {law, at} of cases.shifts.laws) {
    for (const {temperature_K, factor, binder} of at) {
      const decades = decadesOfShift(law, temperature_K);
      // A power of ten magnifies the rounding of its exponent, up to 60 decades here, by ln 10.
      assertClose(10 ** decades, factor, 1e-13, `a_T at ${temperature_K} K`);
      const shifted = shiftedSeries(cases.shifts.binder, factor);
      assertClose(relaxationModulus(shifted, 1e-3), binder, rounding, `M at ${temperature_K} K`);
    }
  }
});

test("load over the ramp of a dynamic run", () => {
  // Both evaluate one formula; at the start of the ramp its parts, of order 1, cancel, so the tolerance is absolute.
  for (const {ramp, time, share} of cases.ramps) {
    assertClose(1 + shareOfLoad(time, ramp), 1 + share, 5e-16, `share of the load at ${time} s of ${ramp} s`);
  }
});

test("limit of vanishing cells", () => {
  // Rounding of 1e-16, magnified by the cells of the finer grid over their difference, at most 51.
  for (const {grids, limit} of cases.limits) {
    assertClose(limitOfCells(grids), limit, 1e-13, JSON.stringify(grids));
    assertClose(limitOfCells(grids.slice().reverse()), limit, 1e-13, "grids in another order");
  }
  assertClose(limitOfCells([{cells: 24, value: 7}]), 7, 0, "one grid");
});

test("bulk modulus from the plane-strain bulk modulus", () => {
  assertClose(bulkModulus(3, 1, 3), 3, 0, "in three dimensions the test of equal strains has K itself");
  for (const {plane_strain_bulk, shear, bulk} of cases.bulk_moduli) {
    assertClose(bulkModulus(plane_strain_bulk, shear, 2), bulk, rounding, `K from ${plane_strain_bulk} and ${shear} Pa`);
  }
});
