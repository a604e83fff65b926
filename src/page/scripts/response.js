/// Predicts the composites of a run with other materials from the stored reduced responses, as `breccia respond` does.
/// At a real Laplace variable s the composite is elastic and its phases have the Carson
/// moduli s G~(s) and s K~(s) (correspondence principle); its compliance is e' K^-1 e with the stiffness K = K_0 + sum
/// of p_i K_i (docs/theory.md, Eq. 18a), where the p_i are the shear and bulk moduli of the phases that vary: the
/// matrix, then those in `phases`. The command goes back to time by the exact poles of this function, the page by a fit
/// of the Carson moduli of the composite.

import {limitOfCells} from "./extrapolation.js";
import {dot, solveSymmetric} from "./linear_algebra.js";
import {shearOf, shearsOf} from "./loads.js";
import {distinct, groupsOf, own} from "./records.js";
import {logarithmic} from "./sampling.js";
import {bulkModulus, carsonModulus, lossModulus, relaxationModulus, seriesOfCarsonModuli, seriesOfRelaxationModuli,
  storageModulus} from "./viscoelasticity.js";

/// The stiffness parts and the snapshots of each phase that varies, the matrix first: [{shear, bulk, snapshots}].
function phasesOf(response) {
  const {matrix_shear: shear, matrix_bulk: bulk, snapshots, phases = []} = response;
  return [{shear, bulk, snapshots}, ...phases];
}

/// The solution K^-1 e of the reduced problem with elastic phases of these moduli [Pa], [{shear, bulk}] by phase.
function reducedSolution(response, moduli) {
  const phases = phasesOf(response);
  const stiffness = response.filler_Pa.map((row, i) => row.map((constant, j) => phases.reduce(
    (sum, phase, k) => sum + moduli[k].shear * phase.shear[i][j] + moduli[k].bulk * phase.bulk[i][j], constant)));
  return solveSymmetric(stiffness, response.load_forces);
}

/// The modulus of the composite [Pa] with elastic phases of these moduli [Pa], [{shear, bulk}] by phase.
export function compositeModulus(response, moduli) {
  return 1 / dot(response.load_forces, reducedSolution(response, moduli));
}

/// The estimate of the relative error of that modulus, from the residual of the reduced solution: the same as
/// ReducedResponse::error_estimate. Known where several phases vary.
export function errorEstimate(response, moduli) {
  const solution = reducedSolution(response, moduli);
  const parameters = moduli.flatMap(({shear, bulk}) => [shear, bulk]);
  const weights = [1, ...parameters].flatMap((p) => solution.map((x) => p * x));
  weights.push(-1);
  let squared = 0;
  response.residual_products.forEach((row, i) => row.forEach((product, j) => {
    squared += (j === 0 ? 1 : 2) * weights[i] * weights[i + j] * product;
  }));
  const softest = Math.min(...moduli.map(({shear}) => shear));
  return response.residual_scale * Math.max(0, squared) / (softest * dot(response.load_forces, solution));
}

/// The moduli of a phase [Pa] for which a response can be used, {shear: [least, most], bulk: [least, most]}: those of
/// its snapshots and a little beyond, with the limits of src/quasistatic/reduced/sampled_moduli.cpp.
export function sampledRange(response, phase = 0) {
  const {snapshots} = phasesOf(response)[phase];
  const shear = snapshots.map((snapshot) => snapshot.shear_Pa);
  const bulk = snapshots.map((snapshot) => snapshot.bulk_Pa);
  const offShear = 0.05, offBulk = 0.1;
  // With a phase so soft in shear, the response of the composite is that with any softer phase but for a factor.
  const incompressible = 1e-7, spacing = 1.4;
  const softest = snapshots.reduce((least, one) => (one.shear_Pa < least.shear_Pa ? one : least));
  const holdsForSofter = softest.shear_Pa / spacing < incompressible * softest.bulk_Pa;
  return {
    shear: [holdsForSofter ? 0 : Math.min(...shear) * (1 - offShear), Math.max(...shear) * (1 + offShear)],
    bulk: [Math.min(...bulk) * (1 - offBulk), Math.max(...bulk) * (1 + offBulk)],
  };
}

/// The moduli of the phases at the Laplace variable with an index, [{shear, bulk}].
function moduliAt(phases, j) {
  return phases.map(({moduli}) => ({shear: moduli.shear[j], bulk: moduli.bulk[j]}));
}

/// The Carson moduli of a stage at Laplace variables, the mean over responses under several loads, on each of its grids:
/// [{cells, moduli}].
function moduliOnGrids(responses, variables, phases) {
  return groupsOf(responses, ["cells"]).map((ofGrid) => ({
    cells: ofGrid[0].cells,
    moduli: variables.map((_, j) => meanModulus(ofGrid, moduliAt(phases, j)))}));
}

/// The mean modulus, under tractions that of the mean compliance (docs/theory.md, Eqs. 13a and 13b).
function meanModulus(responses, phases) {
  const moduli = responses.map((response) => compositeModulus(response, phases));
  const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  return responses[0].boundary === "traction" ? 1 / mean(moduli.map((modulus) => 1 / modulus)) : mean(moduli);
}

/// The part of a time window in which the phases stay within the sampled moduli of all responses, and the first modulus
/// outside of them: {window, refusal: {material, name, value, range}}; `refusal` is undefined if there is none. The
/// moduli at a Laplace variable s are taken to be those at the time 1/s.
function timesInRange(responses, variables, phases, window) {
  const refusals = [];
  let [begin, end] = window;
  const times = variables.map((s) => 1 / s).filter((time) => isWithin(time, window));
  const first = Math.min(...times), last = Math.max(...times);
  const check = (material, name, value, range, time) => {
    if (value >= range[0] && value <= range[1]) return;
    refusals.push({material, name, value, range});
    // The moduli fall with time: those above the range are at its beginning, those below it at its end.
    if (value > range[1]) begin = Math.max(begin, time === last ? window[1] : time * 1.0001);
    else end = Math.min(end, time === first ? window[0] : time / 1.0001);
  };
  for (const response of responses) {
    phases.forEach(({material, moduli}, place) => {
      const range = sampledRange(response, place);
      variables.forEach((s, j) => {
        if (!isWithin(1 / s, window)) return;
        for (const name of ["shear", "bulk"]) check(material, name, moduli[name][j], range[name], 1 / s);
      });
    });
  }
  return {window: [begin, end], refusal: refusals[0]};
}

function isWithin(time, [begin, end]) {
  const rounding = 1e-9;
  return time >= begin * (1 - rounding) && time <= end * (1 + rounding);
}

/// Materials that are covered one by one may not be covered together: the refusal {error} where the estimate of the
/// error is above 1 % at a time of the window, as `breccia respond` refuses them; otherwise undefined.
function jointRefusal(responses, variables, phases, window) {
  const most = 0.01;
  if (phases.length < 2) return undefined;
  const errors = responses.flatMap((response) => variables.flatMap((s, j) =>
    isWithin(1 / s, window) ? [errorEstimate(response, moduliAt(phases, j))] : []));
  const error = Math.max(...errors);
  return error > most ? {error} : undefined;
}

/// Predicts G(t) of every stage under every boundary.
///
/// study: {times_s, stages: [{name, matrix, dimensions, tests: [{load, mean_of}]}]}, as in study.json
/// responses: the stored responses of each stage by its name, as in the data of the page
/// materials: {shear, bulk} of each material by its name, both Prony series
///
/// Returns [{stage, load, boundary, matrix, window, refusal, modulus, complexModulus}]: `modulus` is G as a function of time, `window` the
/// times at which it can be used, `complexModulus` G* {storage, loss} as a function of the angular frequency, and `refusal`, as in timesInRange() or jointRefusal(), why these are not all times of
/// the study.
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
      const {phases: others = []} = ofStage[0];
      const phases = [{material: stage.matrix, moduli: matrix.moduli}, ...others.map((phase) => ({
        material: phase.material, moduli: materialAsMatrix(own(materials, phase.material), variables).moduli}))];
      const {composite, result} = respondOfStage(
        ofStage.filter((one) => one.boundary === boundary), shearsOf(stage), matrix, phases, stage.dimensions);
      if (composite !== undefined) composites.set(`${stage.name}|${boundary}`, composite);
      if (result !== undefined) results.push({stage: stage.name, load: shearOf(stage), boundary, matrix: stage.matrix, ...result});
    }
  }
  return results;
}

/// The response of one stage under one boundary: {composite, result}. `composite` is the stage as the matrix of another
/// one, which takes shear and bulk; `result` has G(t), the mean under the shears.
function respondOfStage(responses, shears, {variables, window: known}, phases, dimensions) {
  const {window: covered, refusal: ofOne} = timesInRange(responses, variables, phases, known);
  const ofAll = jointRefusal(responses, variables, phases, covered);
  const window = ofAll === undefined ? covered : [covered[0], covered[0]];
  const under = (loads) => moduliOnGrids(responses.filter(({load}) => loads.includes(load)), variables, phases);
  const shear = under(shears), bulk = under(["bulk"]);
  if (shear.length === 0) return {};
  const modulus = modulusInTime(variables, shear);
  const composite = bulk.length === 0 ? undefined : stageAsMatrix(variables, window, dimensions,
    matrixModulus(variables, shear, modulus, window),
    matrixModulus(variables, bulk, modulusInTime(variables, bulk), window));
  return {composite, result: {window, refusal: ofOne ?? ofAll, modulus,
    complexModulus: modulusInFrequency(variables, shear)}};
}

/// The complex modulus {storage, loss} as a function of the angular frequency, likewise.
function modulusInFrequency(variables, grids) {
  const series = grids.map(({cells, moduli}) => ({cells, series: seriesOfCarsonModuli(variables, moduli)}));
  const limit = (part, omega) => limitOfCells(series.map((one) => ({cells: one.cells, value: part(one.series, omega)})));
  return (omega) => ({storage: limit(storageModulus, omega), loss: limit(lossModulus, omega)});
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
function stageAsMatrix(variables, [begin, end], dimensions, shear, bulk) {
  return {
    variables, window: [begin, Math.min(end, shear.last, bulk.last)],
    moduli: {shear: shear.carson,
      bulk: bulk.carson.map((value, j) => bulkModulus(value, shear.carson[j], dimensions))},
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
