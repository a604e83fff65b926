/// The prediction of composites with another matrix against that of the library.

import assert from "node:assert/strict";
import {test} from "node:test";

import {compositeModulus, respond, sampledRange} from "../../../src/report/page/response.js";
import {cases} from "./cases.mjs";
import {assertClose} from "./close.mjs";

test("modulus with an elastic matrix", () => {
  // The page factorises by Cholesky, the library by L D L'. Both are backward stable: the error is rounding, 1e-16, times
  // the condition number, some 1e7 here.
  for (const {response, elastic} of cases.responses) {
    for (const {shear, bulk, modulus} of elastic) {
      assertClose(compositeModulus(response, shear, bulk), modulus, 1e-9, `G = ${shear} Pa, K = ${bulk} Pa`);
    }
  }
});

test("moduli for which a response can be used", () => {
  // The same products of two numbers.
  for (const {response, sampled} of cases.responses) {
    const range = sampledRange(response);
    for (const name of ["shear", "bulk"]) {
      range[name].forEach((value, i) => assertClose(value, sampled[name][i], 1e-15, `${name} ${i}`));
    }
  }
  assert.deepEqual(cases.responses.map(({response}) => sampledRange(response).shear[0] === 0),
    [false, false, true, true], "which are sampled to where softer matrices are alike");
});

test("G(t) with viscoelastic matrices", () => {
  // The library has the exact spectrum, the page fits one: 2.3e-4 of the modulus of a term (viscoelasticity_test.mjs),
  // which in this broad spectrum is below twice G(t) when it relaxes.
  const tolerance = 5e-4;
  for (const {response, times_s, composites} of cases.responses) {
    const study = {times_s, stages: [{name: "A", matrix: "binder"}]};
    for (const {shear, bulk, relaxation} of composites) {
      const [{modulus, ...result}] = respond(study, {A: [response]}, {binder: {shear, bulk}});
      assert.deepEqual([result.stage, result.boundary, result.matrix], ["A", "displacement", "binder"]);
      for (const [time, expected] of relaxation) assertClose(modulus(time), expected, tolerance, `G(${time} s)`);
    }
  }
});
