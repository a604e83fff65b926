"use strict";

/// What the stored responses make of another matrix, stage by stage. At a real Laplace variable s the composite is an
/// elastic one whose matrix has the moduli s G~(s) and s K~(s); its compliance is e' (A + G B + K C)^-1 e.

function compositeModulus(response, shear, bulk) {
  const stiffness = response.filler_Pa.map((row, i) =>
    row.map((a, j) => a + shear * response.matrix_shear[i][j] + bulk * response.matrix_bulk[i][j]));
  return 1 / dot(response.load_forces, solveSymmetric(stiffness, response.load_forces));
}

/// The moduli of the matrix for which a response can be used: those of its snapshots and a little beyond, as in
/// `breccia respond`.
function sampledRange(response) {
  const shear = response.snapshots.map((snapshot) => snapshot.shear_Pa);
  const bulk = response.snapshots.map((snapshot) => snapshot.bulk_Pa);
  const offShear = 0.05, offBulk = 0.1;
  // All matrices that are that soft are alike but for a factor.
  const likeSofter = 1.4e-7;
  const holdsForSofter = response.snapshots.some(({shear_Pa, bulk_Pa}) => shear_Pa < likeSofter * bulk_Pa);
  return {
    shear: [holdsForSofter ? 0 : Math.min(...shear) * (1 - offShear), Math.max(...shear) * (1 + offShear)],
    bulk: [Math.min(...bulk) * (1 - offBulk), Math.max(...bulk) * (1 + offBulk)],
  };
}

/// The limit of vanishing cells of values on one grid or several (docs/theory.md, Eq. 21).
function limitOfCells(grids) {
  const [fine, coarse] = [...grids].sort((a, b) => b.cells - a.cells);
  if (coarse === undefined) return fine.value;
  return fine.value - ((coarse.value - fine.value) / (1 / coarse.cells - 1 / fine.cells)) / fine.cells;
}

/// The Carson moduli of a stage at Laplace variables under one load, on each of its grids: [{cells, moduli}].
function stageModuli(responses, load, variables, matrix) {
  return responses.filter((response) => response.load === load).map((response) => ({
    cells: response.cells,
    moduli: variables.map((_, j) => compositeModulus(response, matrix.shear[j], matrix.bulk[j]))}));
}

/// Value by value the limit of vanishing cells.
function limitsOfCells(grids) {
  return grids[0].moduli.map((_, j) => limitOfCells(grids.map(({cells, moduli}) => ({cells, value: moduli[j]}))));
}

/// From which of the rising variables on the moduli are those of a solid: positive, and rising no faster than s. The
/// limit of coarse grids is not at long times.
function firstSound(variables, moduli) {
  const rounding = 1e-6;
  const isSound = (j) => moduli[j] > 0 &&
    moduli[j + 1] / moduli[j] < (variables[j + 1] / variables[j]) * (1 + rounding);
  let first = moduli.length - 1;
  while (first > 0 && isSound(first - 1)) --first;
  return first;
}

/// The Laplace variables for whose times 1/s the moduli of a matrix leave what was sampled, as text; and the times that
/// remain.
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
        // The shear modulus falls with time: what is too stiff comes first.
        if (value > range[name][1]) begin = Math.max(begin, time * 1.0001);
        else end = Math.min(end, time / 1.0001);
      }
    });
  }
  return {window: [begin, end], refusal: refusals[0]};
}

/// G(t) of every stage and boundary with other materials (by name, {bulk, shear}): [{stage, boundary, window,
/// modulus}], the last a function of time, and where the matrix leaves the sampled range, `refusal`.
function respond(materials) {
  const margin = 30;
  const allVariables = logarithmic(1 / (margin * study.times_s[1]), margin / study.times_s[0], 10);
  const known = new Map();  // what stages have become, by stage and boundary
  const results = [];
  for (const stage of study.stages) {
    const ofStage = own(data.responses, stage.name) ?? [];
    for (const boundary of distinct(ofStage, "boundary")) {
      const matrix = matrixModuli(stage, boundary, allVariables, materials, known);
      if (matrix === undefined) continue;
      const variables = matrix.variables;
      const responses = ofStage.filter((response) => response.boundary === boundary);
      const {window, refusal} = timesInRange(responses, variables, matrix.moduli, matrix.window);
      const shear = stageModuli(responses, "shear", variables, matrix.moduli);
      const bulk = stageModuli(responses, "bulk", variables, matrix.moduli);
      if (shear.length > 0 && bulk.length > 0) {
        const g = limitsOfCells(shear), kappa = limitsOfCells(bulk);
        known.set(`${stage.name}|${boundary}`, stageAsMatrix(variables, g, kappa, window));
      }
      if (shear.length === 0) continue;
      results.push({stage: stage.name, boundary, matrix: stage.matrix, window, refusal,
        modulus: modulusInTime(variables, shear)});
    }
  }
  return results;
}

/// G(t) of the limit of vanishing cells. Each grid is taken back to time by itself: the limit alone may have no series
/// without negative terms.
function modulusInTime(variables, grids) {
  const series = grids.map(({cells, moduli}) => ({cells, series: seriesOfCarsonModuli(variables, moduli)}));
  return (time) => limitOfCells(series.map((one) => ({cells: one.cells, value: relaxationModulus(one.series, time)})));
}

/// What a stage has become, as far as its grids tell it. What is asked of it at a time takes some of what is after it.
function stageAsMatrix(variables, g, kappa, [begin, end]) {
  const after = 10;
  const first = Math.max(firstSound(variables, g), firstSound(variables, kappa));
  const reach = first === 0 ? end : Math.min(end, 1 / (after * variables[first]));
  return {
    variables: variables.slice(first), window: [begin, reach],
    moduli: {shear: g.slice(first), bulk: kappa.slice(first).map((k, j) => k - g[first + j] / 3)},
  };
}

/// The matrix of a stage under a boundary: a material, or what an earlier stage became.
function matrixModuli(stage, boundary, variables, materials, known) {
  const material = own(materials, stage.matrix);
  if (material === undefined) return known.get(`${stage.matrix}|${boundary}`);
  return {
    variables, window: study.times_s,
    moduli: {shear: variables.map((s) => carsonModulus(material.shear, s)),
      bulk: variables.map((s) => carsonModulus(material.bulk, s))},
  };
}
