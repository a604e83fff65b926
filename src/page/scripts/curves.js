/// The curves of the study, each {quantity, stage, load, boundary, method, cells, role, label, x, y}. `role` is "stage"
/// (a result of the run), "matrix" (a material that serves as one) or "measured". A curve whose error is known has
/// `error`, the shares {whole, grid, sample, solver, matrix} of y at each x, NaN where one is not known, and a `band`,
/// half the width of which is given at each x: the whole error or, where that is not known, the one of the grid.

import {complexCurves, sampledComplexCurves} from "./complex_curves.js";
import {complexOf} from "./complex_moduli.js";
import {readTable, study} from "./data.js";
import {mainLoad, shearOf} from "./loads.js";
import {gridName, methodNames} from "./names.js";
import {distinct, groupsOf, numberIfKnown, numberOf} from "./records.js";
import {logarithmic} from "./sampling.js";
import {lossModulus, relaxationModulus, storageModulus} from "./viscoelasticity.js";

const testColumns = ["stage", "load", "boundary", "method", "cells"];

function labelOf(stage, curve) {
  const parts = [stage];
  if (curve.boundary !== undefined) parts.push(curve.boundary);
  parts.push(...nameOfLoad(curve.load));
  if (curve.method !== undefined && methodsOfStudy().length > 1) parts.push(methodNames[curve.method]);
  if (curve.cells !== undefined && curve.cells !== bestGrid(stage)) parts.push(gridName(curve.cells));
  return parts.join(", ");
}

/// The name of a load, unless it is the shear that every study has: [] or ["xx-yy"].
function nameOfLoad(load) {
  const loads = study.stages.flatMap(({tests}) => tests.map((test) => test.load));
  if (load === "bulk" || load === mainLoad(loads)) return [];
  return [load === "shear" ? "xy" : load.replace("shear-", "")];
}

function methodsOfStudy() {
  return distinct(study.stages.flatMap((stage) => stage.tests), "method");
}

/// The grids of all stages.
export function gridsOfStudy() {
  return distinct(study.stages.flatMap((stage) => stage.tests), "cells").map(String);
}

function stageNamed(name) {
  return study.stages.find((stage) => stage.name === name);
}

/// The best grid of a stage: the limit of vanishing cells if there are several grids, else the only one.
export function bestGrid(stageName) {
  const grids = stageNamed(stageName).cells;
  return grids.length > 1 ? "extrapolated" : String(grids[0]);
}

function curvesInTime(table, column) {
  const rows = readTable(table);
  return groupsOf(rows, testColumns).map((group) => {
    const {stage, load, boundary, method, cells} = group[0];
    const isBulk = load === "bulk";
    const quantity = column !== "modulus_Pa" ? "compliance" : isBulk ? "bulk" : "shear";
    const curve = {role: "stage", quantity, stage, load, boundary, method, cells,
      x: group.map((row) => row.time_s), y: group.map((row) => row[column])};
    curve.label = labelOf(stage, curve) + (quantity === "compliance" && isBulk ? ", bulk" : "");
    return curve;
  });
}

/// Adds the errors of the grid alone to the results of several grids: those of earlier versions have no others.
function addErrorsOfGrids(curves) {
  for (const group of groupsOf(readTable("extrapolation.csv"), ["stage", "load", "boundary", "method"])) {
    const curve = curves.find((one) => one.quantity !== "compliance" && one.cells === "extrapolated" &&
      ["stage", "load", "boundary", "method"].every((column) => one[column] === group[0][column]));
    if (curve === undefined) continue;
    curve.band = group.map((row) => row.half_band_Pa);
    const grid = group.map((row) => row.half_band_Pa / row.modulus_Pa), unknown = grid.map(() => NaN);
    curve.error = {whole: unknown, grid, sample: unknown, solver: unknown, matrix: unknown};
  }
}

function addErrors(curves) {
  if (readTable("errors.csv").length === 0) return addErrorsOfGrids(curves);
  for (const group of groupsOf(readTable("errors.csv"), testColumns)) {
    const curve = curves.find((one) => one.quantity !== "compliance" &&
      testColumns.every((column) => one[column] === group[0][column]));
    if (curve === undefined || curve.x.length !== group.length) continue;
    const of = (column) => group.map((row) => numberIfKnown(row[column]));
    curve.error = {whole: of("error"), grid: of("grid_error"), sample: of("sample_error"), solver: of("solver_error"),
      matrix: of("matrix_error")};
    const shown = [curve.error.whole, curve.error.grid].find((shares) => shares.every(Number.isFinite));
    if (shown !== undefined) curve.band = shown.map((part, i) => part * curve.y[i]);
  }
}

/// The curves of a complex modulus as those of Young's modulus.
function ofYoungsModulus(curves) {
  const quantities = {dynamic: "young-dynamic", "loss-factor": "young-loss-factor"};
  return curves.filter(({quantity}) => quantity in quantities).map((curve) =>
    ({...curve, quantity: quantities[curve.quantity], label: curve.label.replace(/, G([′″])$/, ", E$1")}));
}

/// The measured moduli as curves of the quantity that was measured. What the figures have no curve of is left out: the
/// bulk modulus in the plane, where the bulk test gives K + G/3, and complex bulk moduli.
function measuredCurves() {
  const groups = (table) => groupsOf(readTable(table), ["measurement", "stage"]);
  const isDrawn = ([{stage, modulus}]) => modulus !== "bulk" || stageNamed(stage).dimensions === 3;
  const common = ([{measurement, stage}]) => ({role: "measured", stage, label: `measured, ${measurement}`});
  const inTime = groups("comparison.csv").filter(isDrawn).map((group) => {
    const measured = new Map(group.map((row) => [row.time_s, row.measured_Pa]));
    return {...common(group), quantity: group[0].modulus ?? "shear", x: [...measured.keys()], y: [...measured.values()]};
  });
  const inFrequency = groups("comparison_dynamic.csv").filter(([{modulus}]) => modulus !== "bulk").flatMap((group) => {
    const measured = new Map(group.map((row) => [row.angular_frequency_rad_per_s,
      {storage: row.measured_storage_modulus_Pa, loss: row.measured_loss_modulus_Pa}]));
    const curves = sampledComplexCurves(common(group), [...measured.keys()], [...measured.values()]);
    return group[0].modulus === "young" ? ofYoungsModulus(curves) : curves;
  });
  return [...inTime, ...inFrequency];
}

/// The materials of the study that serve as matrices.
export function materialsInUse() {
  const names = distinct(study.stages, "matrix");
  return study.materials.filter((material) => names.includes(material.name));
}

/// Their moduli over the times of the study.
function matrixCurves() {
  const times = logarithmic(...study.times_s, 20);
  return materialsInUse().flatMap((material) => {
    const common = {role: "matrix", stage: material.name, label: material.name};
    return [{...common, quantity: "shear", x: times, y: times.map((t) => relaxationModulus(material.shear, t))},
      ...curvesInFrequency(material.shear, common)];
  });
}

/// The curves of the complex modulus of a Prony series, at the angular frequencies 1/t of the times of the study.
function curvesInFrequency(series, common) {
  return complexCurves(common, [1 / study.times_s[1], 1 / study.times_s[0]], (omega) =>
    complexOf(storageModulus(series, omega), lossModulus(series, omega)));
}

function curvesOfProny() {
  const rows = readTable("prony.csv").filter((row) => row.load !== "bulk");
  return groupsOf(rows, ["stage", "load", "boundary"]).flatMap((group) => {
    const {stage, load, boundary} = group[0];
    const isFinite = (row) => Number.isFinite(numberOf(row.relaxation_time_s));
    const equilibrium_Pa = group.filter((row) => !isFinite(row)).reduce((sum, row) => sum + row.modulus_Pa, 0);
    const label = [stage, boundary, ...nameOfLoad(load)].join(", ");
    return curvesInFrequency({equilibrium_Pa, terms: group.filter(isFinite)}, {role: "stage", stage, load, boundary,
      label});
  });
}

/// A curve with its errors, in the unit of its values, NaN where one is not known; with a band where all are.
function withErrors(curve, errors) {
  if (!errors.some(Number.isFinite)) return curve;
  const unknown = errors.map(() => NaN), whole = errors.map((error, i) => Math.abs(error / curve.y[i]));
  return {...curve, ...(errors.every(Number.isFinite) && {band: errors}),
    error: {whole, grid: unknown, sample: unknown, solver: unknown, matrix: unknown}};
}

/// Young's modulus and Poisson's ratio of the stages that were tested in shear and in bulk.
function engineeringCurves() {
  const curvesIn = (table, x, columns) =>
    groupsOf(readTable(table), ["stage", "boundary", "method", "cells"]).flatMap((group) => {
      const {stage, boundary, method} = group[0];
      return columns.map(([quantity, column, {letter = "", part = undefined, errorOf = () => NaN, shares = undefined} = {}]) => {
        const curve = {role: "stage", quantity, part, stage, load: shearOf(stageNamed(stage)), boundary, method,
          label: `${stage}, ${boundary}${letter}`, x: group.map((row) => row[x]), y: group.map((row) => row[column]),
          ...(shares && {shares: group.map((row) => numberIfKnown(row[shares]))})};
        return withErrors(curve, group.map(errorOf));
      });
    });
  const shareOfYoung = (column) => (row) => numberIfKnown(row.youngs_modulus_error) * row[column];
  return [
    ...curvesIn("engineering.csv", "time_s", [
      ["young", "youngs_modulus_Pa", {errorOf: shareOfYoung("youngs_modulus_Pa")}],
      ["poisson", "poisson_ratio", {errorOf: (row) => numberIfKnown(row.poisson_ratio_error)}],
      ["tensile-compliance", "tensile_compliance_1_per_Pa", {errorOf: shareOfYoung("tensile_compliance_1_per_Pa")}]]),
    ...curvesIn("engineering_dynamic.csv", "angular_frequency_rad_per_s", [
      ["young-dynamic", "youngs_storage_modulus_Pa", {letter: ", E′", part: "storage", shares: "youngs_modulus_error"}],
      ["young-dynamic", "youngs_loss_modulus_Pa", {letter: ", E″", part: "loss"}], ["young-loss-factor", "youngs_loss_tangent"]]),
  ];
}

/// The thermal expansion of the stages, in 10⁻⁶/K.
function expansionCurves() {
  return groupsOf(readTable("thermal_expansion.csv"), testColumns).map((group) => {
    const {stage, boundary, method} = group[0];
    const curve = {role: "stage", quantity: "thermal-expansion", stage, load: shearOf(stageNamed(stage)), boundary,
      method, label: `${stage}, ${boundary}`, x: group.map((row) => row.time_s),
      y: group.map((row) => 1e6 * row.thermal_expansion_1_per_K)};
    return withErrors(curve, group.map((row) => 1e6 * numberIfKnown(row.error_1_per_K)));
  });
}

/// The curves of all kinds.
export function allCurves() {
  const tested = [...curvesInTime("curves.csv", "modulus_Pa"),
    ...curvesInTime("compliance.csv", "compliance_1_per_Pa")];
  addErrors(tested);
  return [...tested, ...curvesOfProny(), ...engineeringCurves(), ...expansionCurves(), ...measuredCurves(), ...matrixCurves()];
}
