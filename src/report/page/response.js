/// Predicts the composites of a run with other matrices, from the stored reduced responses: the same prediction as that
/// of `breccia respond`. At a real Laplace variable s the composite is elastic and its matrix has the Carson moduli s
/// G~(s) and s K~(s) (correspondence principle); its compliance is e' (A + G B + K C)^-1 e (docs/theory.md, Eq. 18).
/// The command goes back to time by the exact poles of this function of G, the page by a fit of the Carson moduli of
/// the composite.

import {limitOfCells} from "./extrapolation.js";
import {dot, solveSymmetric} from "./linear_algebra.js";
import {distinct, own} from "./records.js";
import {logarithmic} from "./sampling.js";
import {bulkModulus, carsonModulus, relaxationModulus, seriesOfCarsonModuli, seriesOfRelaxationModuli} from
  "./viscoelasticity.js";

/// The modulus of the composite [Pa] with an elastic matrix of the shear modulus G and the bulk modulus K [Pa].
export function compositeModulus(response, shear, bulk) {
  const stiffness = response.filler_Pa.map((row, i) =>
    row.map((a, j) => a + shear * response.matrix_shear[i][j] + bulk * response.matrix_bulk[i][j]));
  return 1 / dot(response.load_forces, solveSymmetric(stiffness, response.load_forces));
}

/// The moduli of the matrix [Pa] for which a response can be used, {shear: [least, most], bulk: [least, most]}: those
/// of its snapshots and a little beyond. The same limits as in src/quasistatic/sampled_moduli.cpp.
export function sampledRange(response) {
  const shear = response.snapshots.map((snapshot) => snapshot.shear_Pa);
  const bulk = response.snapshots.map((snapshot) => snapshot.bulk_Pa);
  const offShear = 0.05, offBulk = 0.1;
  // With a matrix that is so soft in shear, the composite answers as with any softer one but for a factor.
  const incompressible = 1e-7, spacing = 1.4;
  const softest = response.snapshots.reduce((least, one) => (one.shear_Pa < least.shear_Pa ? one : least));
  const holdsForSofter = softest.shear_Pa / spacing < incompressible * softest.bulk_Pa;
  return {
    shear: [holdsForSofter ? 0 : Math.min(...shear) * (1 - offShear), Math.max(...shear) * (1 + offShear)],
    bulk: [Math.min(...bulk) * (1 - offBulk), Math.max(...bulk) * (1 + offBulk)],
  };
}

/// The Carson moduli of a stage under one load at Laplace variables, on each of its grids: [{cells, moduli}].
function moduliOnGrids(responses, load, variables, matrix) {
  return responses.filter((response) => response.load === load).map((response) => ({
    cells: response.cells,
    moduli: variables.map((_, j) => compositeModulus(response, matrix.shear[j], matrix.bulk[j]))}));
}

/// The part of a time window in which a matrix stays within the sampled moduli of all responses, and the first modulus
/// outside of them: {window, refusal: {name, value, range}}; `refusal` is undefined if there is none. The moduli at the
/// Laplace variable s count at the time 1/s.
function timesInRange(responses, variables, matrix, window) {
  const refusals = [];
  let [begin, end] = window;
  const rounding = 1e-9;
  for (const response of responses) {
    const range = sampledRange(response);
    variables.forEach((s, j) => {
      const time = 1 / s;
      if (time < window[0] * (1 - rounding) || time > window[1] * (1 + rounding)) return;
      for (const name of ["shear", "bulk"]) {
        const value = matrix[name][j];
        if (value >= range[name][0] && value <= range[name][1]) continue;
        refusals.push({name, value, range: range[name]});
        // The moduli fall with time: those above the range are at its beginning, those below it at its end.
        if (value > range[name][1]) begin = Math.max(begin, time * 1.0001);
        else end = Math.min(end, time / 1.0001);
      }
    });
  }
  return {window: [begin, end], refusal: refusals[0]};
}

/// Predicts G(t) of every stage under every boundary.
///
/// study: {times_s, stages: [{name, matrix}]}, as in study.json
/// responses: the stored responses of each stage by its name, as in the data of the page
/// materials: {shear, bulk} of each material by its name, both Prony series
///
/// Returns [{stage, boundary, matrix, window, refusal, modulus}]: `modulus` is G as a function of time, `window` the
/// times at which it can be used, and `refusal`, as in timesInRange(), why these are not all times of the study.
export function respond(study, responses, materials) {
  const margin = 30;
  const variables = logarithmic(1 / (margin * study.times_s[1]), margin / study.times_s[0], 10);
  const composites = new Map();  // the stages as matrices, by stage and boundary
  const results = [];
  for (const stage of study.stages) {
    const ofStage = own(responses, stage.name) ?? [];
    for (const boundary of distinct(ofStage, "boundary")) {
      const material = own(materials, stage.matrix);
      const matrix = material === undefined ? composites.get(`${stage.matrix}|${boundary}`)
        : materialAsMatrix(material, variables, study.times_s);
      if (matrix === undefined) continue;
      const {composite, result} = respondOfStage(ofStage.filter((one) => one.boundary === boundary), matrix);
      if (composite !== undefined) composites.set(`${stage.name}|${boundary}`, composite);
      if (result !== undefined) results.push({stage: stage.name, boundary, matrix: stage.matrix, ...result});
    }
  }
  return results;
}

/// The answer of one stage under one boundary: {composite, result}. `composite` is the stage as the matrix of another
/// one, which takes both loads; `result` has G(t).
function respondOfStage(responses, matrix) {
  const {variables} = matrix;
  const {window, refusal} = timesInRange(responses, variables, matrix.moduli, matrix.window);
  const shear = moduliOnGrids(responses, "shear", variables, matrix.moduli);
  const planeStrainBulk = moduliOnGrids(responses, "bulk", variables, matrix.moduli);
  if (shear.length === 0) return {};
  const modulus = modulusInTime(variables, shear);
  const composite = planeStrainBulk.length === 0 ? undefined : stageAsMatrix(variables, window,
    matrixModulus(variables, shear, modulus, window),
    matrixModulus(variables, planeStrainBulk, modulusInTime(variables, planeStrainBulk), window));
  return {composite, result: {window, refusal, modulus}};
}

/// The modulus as a function of time, in the limit of vanishing cells. Each grid is taken back to time by itself,
/// because the Carson moduli of the limit may belong to no series without negative terms.
function modulusInTime(variables, grids) {
  const series = grids.map(({cells, moduli}) => ({cells, series: seriesOfCarsonModuli(variables, moduli)}));
  return (time) => limitOfCells(series.map((one) => ({cells: one.cells, value: relaxationModulus(one.series, time)})));
}

/// A modulus of a stage that serves as a matrix: its Carson moduli, and the last time at which it can be used,
/// {carson, last}. After the window the limit of coarse grids need not be the modulus of a solid, and the Carson moduli
/// would have a part of that; so the limit is fitted within the window, as `breccia respond` does.
function matrixModulus(variables, grids, modulus, [begin, end]) {
  if (grids.length === 1) return {carson: grids[0].moduli, last: end};
  const before = 1e-3;
  const {series, last} = seriesOfSolid(logarithmic(before * begin, end, 10), modulus);
  return {carson: variables.map((s) => carsonModulus(series, s)), last};
}

/// The series of a modulus at rising times, up to the last time at which one without negative terms can follow it:
/// {series, last}; `last` is 0 if there is no such time.
function seriesOfSolid(times, modulus) {
  const tolerance = 0.01;
  const moduli = times.map(modulus);
  let count = moduli.findIndex((value) => !(value > 0));
  if (count === -1) count = times.length;
  while (count > 1) {
    const series = seriesOfRelaxationModuli(times.slice(0, count), moduli.slice(0, count));
    const errors = moduli.slice(0, count).map((value, i) => Math.abs(relaxationModulus(series, times[i]) / value - 1));
    const worst = Math.max(...errors);
    if (worst <= tolerance) return {series, last: times[count - 1]};
    count = errors.indexOf(worst);
  }
  return {series: {equilibrium_Pa: 0, terms: []}, last: 0};
}

/// A stage as the matrix of another one: {variables, window, moduli}.
function stageAsMatrix(variables, [begin, end], shear, planeStrainBulk) {
  return {
    variables, window: [begin, Math.min(end, shear.last, planeStrainBulk.last)],
    moduli: {shear: shear.carson, bulk: planeStrainBulk.carson.map((value, j) => bulkModulus(value, shear.carson[j]))},
  };
}

/// A material as a matrix, likewise.
function materialAsMatrix(material, variables, window) {
  return {
    variables, window,
    moduli: {shear: variables.map((s) => carsonModulus(material.shear, s)),
      bulk: variables.map((s) => carsonModulus(material.bulk, s))},
  };
}
