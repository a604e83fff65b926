"use strict";

/// What the stored responses make of another matrix, stage by stage. At a real Laplace variable s the composite is an
/// elastic one whose matrix has the moduli s G~(s) and s K~(s); its compliance is e' (A + G B + K C)^-1 e.

function compositeModulus(response, shear, bulk) {
  const stiffness = response.filler_Pa.map((row, i) =>
    row.map((a, j) => a + shear * response.matrix_shear[i][j] + bulk * response.matrix_bulk[i][j]));
  return 1 / dot(response.load_forces, solveSymmetric(stiffness, response.load_forces));
}

/// The moduli of the matrix for which a response was sampled: extremes of both.
function sampledRange(response) {
  const shear = response.snapshots.map((snapshot) => snapshot.shear_Pa);
  const bulk = response.snapshots.map((snapshot) => snapshot.bulk_Pa);
  // A bulk modulus off the sampled path costs little, as in `breccia respond`.
  const rounding = 1e-9, offPath = 0.1;
  return {
    shear: [Math.min(...shear) * (1 - rounding), Math.max(...shear) * (1 + rounding)],
    bulk: [Math.min(...bulk) * (1 - offPath), Math.max(...bulk) * (1 + offPath)],
  };
}

/// The limit of vanishing cells of values on one grid or several (docs/theory.md, Eq. 21).
function limitOfCells(grids) {
  const [fine, coarse] = [...grids].sort((a, b) => b.cells - a.cells);
  if (coarse === undefined) return fine.value;
  return fine.value - ((coarse.value - fine.value) / (1 / coarse.cells - 1 / fine.cells)) / fine.cells;
}

/// A stage under one boundary: its Carson moduli at Laplace variables, {shear, bulk: K + G/3}, each where it was tested.
function stageModuli(responses, boundary, variables, matrix) {
  const moduli = {};
  for (const load of distinct(responses, "load")) {
    const ofLoad = responses.filter((response) => response.load === load && response.boundary === boundary);
    if (ofLoad.length === 0) continue;
    moduli[load] = variables.map((_, j) => limitOfCells(ofLoad.map((response) => ({
      cells: response.cells, value: compositeModulus(response, matrix.shear[j], matrix.bulk[j])}))));
  }
  return moduli;
}

/// The Laplace variables for whose times 1/s the moduli of a matrix leave what was sampled, as text; and the times that
/// remain.
function timesInRange(responses, boundary, variables, matrix, window) {
  const refusals = [];
  let [begin, end] = window;
  const rounding = 1e-9;
  for (const response of responses.filter((one) => one.boundary === boundary)) {
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

/// G(t) of every stage and boundary with other materials (by name, {bulk, shear}): [{stage, boundary, window, series}],
/// and where the matrix leaves the sampled range, `refusal`.
function respond(materials) {
  const margin = 30;
  const variables = logarithmic(1 / (margin * study.times_s[1]), margin / study.times_s[0], 10);
  const known = new Map();  // Carson moduli of the stages so far, by stage and boundary
  const results = [];
  for (const stage of study.stages) {
    const responses = data.responses[stage.name];
    if (responses === undefined) continue;
    for (const boundary of distinct(responses, "boundary")) {
      const matrix = matrixModuli(stage, boundary, variables, materials, known);
      if (matrix === undefined) continue;
      const inRange = timesInRange(responses, boundary, variables, matrix.moduli, matrix.window);
      const moduli = stageModuli(responses, boundary, variables, matrix.moduli);
      const refusal = inRange.refusal ?? matrix.refusal;
      if (moduli.shear !== undefined && moduli.bulk !== undefined) {
        const bulk = moduli.bulk.map((kappa, j) => kappa - moduli.shear[j] / 3);
        known.set(`${stage.name}|${boundary}`, {moduli: {shear: moduli.shear, bulk}, window: inRange.window, refusal});
      }
      if (moduli.shear === undefined) continue;
      results.push({stage: stage.name, boundary, matrix: stage.matrix, window: inRange.window, refusal: inRange.refusal,
        series: seriesOfCarsonModuli(variables, moduli.shear)});
    }
  }
  return results;
}

/// The matrix of a stage under a boundary: a material, or what an earlier stage became.
function matrixModuli(stage, boundary, variables, materials, known) {
  const material = materials[stage.matrix];
  if (material === undefined) return known.get(`${stage.matrix}|${boundary}`);
  return {
    moduli: {shear: variables.map((s) => carsonModulus(material.shear, s)),
      bulk: variables.map((s) => carsonModulus(material.bulk, s))},
    window: study.times_s,
  };
}
