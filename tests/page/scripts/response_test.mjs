/// The prediction of composites with another matrix against that of the library.

import assert from "node:assert/strict";
import {test} from "node:test";

import {compositeModulus, errorEstimate, respond, sampledRange} from "../../../src/page/scripts/response.js";
import {cases} from "./cases.mjs";
import {assertClose} from "./close.mjs";

test("modulus with an elastic matrix", () => {
  // The page factorises by Cholesky, the library by L D L'. Both are backward stable: the error is rounding, 1e-16,
  // times the condition number, some 1e7 here.
  for (const {response, elastic} of cases.responses) {
    for (const {shear, bulk, modulus} of elastic) {
      assertClose(compositeModulus(response, [{shear, bulk}]), modulus, 1e-9, `G = ${shear} Pa, K = ${bulk} Pa`);
    }
  }
});

test("moduli for which a response can be used", () => {
  // Both compute the same products of two numbers.
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

test("the mean of all shears of a box", () => {
  const {response, times_s, composites: [{shear, bulk}]} = cases.responses[0];
  // Another shear of the same box, of twice the modulus: a unit strain that is larger by the root of two.
  const stiffer = {...response, load: "shear-xx-yy", load_forces: response.load_forces.map((force) => force / Math.SQRT2)};
  const stage = {name: "A", matrix: "binder"};
  const answer = (tests, responses) => respond({times_s, stages: [{...stage, tests}]}, {A: responses},
    {binder: {shear, bulk}})[0];
  const one = answer([{load: "shear"}], [response, stiffer]);
  assert.equal(one.load, "shear");
  const mean = answer([{load: "shear"}, {load: "isotropic", mean_of: ["shear", "shear-xx-yy"]}], [response, stiffer]);
  assert.equal(mean.load, "isotropic");
  for (const time of times_s) assertClose(mean.modulus(time), 1.5 * one.modulus(time), 1e-3, `G(${time} s)`);
});

test("a composite in which the moduli of an interphase vary too", () => {
  const {response, at, sampled, times_s, materials, relaxation} = cases.coated;
  for (const {moduli, modulus, error} of at) {
    assertClose(compositeModulus(response, moduli), modulus, 1e-9, JSON.stringify(moduli));
    assertClose(errorEstimate(response, moduli), error, 1e-6, JSON.stringify(moduli));
  }
  for (const name of ["shear", "bulk"]) {
    sampledRange(response, 1)[name].forEach((value, i) => assertClose(value, sampled[name][i], 1e-15, `${name} ${i}`));
  }
  // The error estimate of the response is artificial and therefore left out.
  const exact = {...response, residual_scale: 0};
  const study = {times_s, stages: [{name: "A", matrix: "binder"}]};
  const [{modulus, refusal}] = respond(study, {A: [exact]}, materials);
  assert.equal(refusal, undefined);
  for (const [time, expected] of relaxation) assertClose(modulus(time), expected, 5e-4, `G(${time} s)`);
});

test("refusals of an interphase", () => {
  const {response, times_s, materials} = cases.coated;
  const study = {times_s, stages: [{name: "A", matrix: "binder"}]};
  const elastic = (value) => ({equilibrium_Pa: value, terms: []});
  const respondWith = (changed, interphase) =>
    respond(study, {A: [changed]}, {...materials, interphase})[0];
  const rigid = respondWith({...response, residual_scale: 0}, {shear: elastic(1e12), bulk: elastic(2e9)});
  assert.deepEqual([rigid.refusal.material, rigid.refusal.name, rigid.refusal.value], ["interphase", "shear", 1e12]);
  assert.ok(!(rigid.window[0] < rigid.window[1]), "at no time");
  const beside = respondWith({...response, residual_scale: 1e30}, materials.interphase);
  assert.ok(beside.refusal.error > 0.01);
  assert.ok(!(beside.window[0] < beside.window[1]), "at no time");
});

test("a limit of grids that is no solid at long times", () => {
  // The coarse grid locks: it adds 0.1 MPa to the modulus of the matrix, 1 MPa exp(-t / 1 ms). The limit of vanishing
  // cells takes 0.1 MPa away, and is negative from t = ln(10) ms on.
  const response = (load, cells, locking, stiffness) => ({load, boundary: "displacement", cells, filler_Pa: [[locking]],
    matrix_shear: [[1]], matrix_bulk: [[stiffness]], load_forces: [1],
    snapshots: [{shear_Pa: 1e-3, bulk_Pa: 1e9}, {shear_Pa: 1e9, bulk_Pa: 1e9}]});
  const responses = {
    A: [response("shear", 24, 0, 0), response("shear", 12, 1e5, 0), response("bulk", 24, 0, 1),
      response("bulk", 12, 0, 1)],
    B: [response("shear", 24, 0, 0)],
  };
  const study = {times_s: [1e-4, 1e-1], stages: [{name: "A", matrix: "binder"}, {name: "B", matrix: "A"}]};
  const shear = {equilibrium_Pa: 0, terms: [{relaxation_time_s: 1e-3, modulus_Pa: 1e6}]};
  const [, ofB] = respond(study, responses, {binder: {shear, bulk: {equilibrium_Pa: 1e9, terms: []}}});
  assert.equal(ofB.window[0], 1e-4);
  assert.ok(ofB.window[1] > 2e-4 && ofB.window[1] < Math.log(10) * 1e-3, `B up to ${ofB.window[1]} s`);
  // Stage B is its matrix, stage A, to the per cent within which a series must follow the limit.
  for (const time of [1e-4, 2e-4, ofB.window[1]]) {
    assertClose(ofB.modulus(time), 1e6 * Math.exp(-time / 1e-3) - 1e5, 0.011, `G(${time} s) of B`);
  }
});
