/// The reliability of the results of a stage in sentences, from the error estimates of the run.

import {hasFilms, instantText, listed} from "./names.js";
import {display, percent, shortNumber} from "./numbers.js";
import {matrixStageOf} from "./stages.js";

/// The sentences on a stage of a study (study.json).
export function sentencesOnReliability(record, stage) {
  return [onModel(stage), onCrystals(stage), onDebonding(stage), onBounds(record, stage), onAnisotropy(record, stage.quality), onGaps(stage), onGrids(stage), onPacking(stage),
    onSeparation(record, stage)].filter((sentence) => sentence !== "");
}

/// A text on the bodies bonded to the matrix of a stage: the grains of an image or of a tessellation, or particles of
/// some shapes.
function textOnParticles({fillers = [], microstructure: made}) {
  if (made.pixels !== undefined) return "the grains of an image";
  if (Number.isFinite(made.film_m)) return "polygonal grains";
  const shapes = [...new Set(fillers.map(({shape}) => shape ?? "discs"))];
  return shapes.length > 0 ? listed(shapes) : "particles";
}

/// A sentence on each filler of crystals.
function onCrystals({microstructure: {crystals} = {}}) {
  return (crystals ?? []).map((words) => `${words[0].toUpperCase()}${words.slice(1)}.`).join(" ");
}

/// A sentence on films that are debonded.
function onDebonding({microstructure: {debonding} = {}}) {
  return debonding === undefined ? "" : `The bonds: ${debonding.words}.`;
}

function onModel(stage) {
  const bonded = stage.microstructure?.debonding === undefined ? "bonded" : "bonded as said below";
  const ofCube = stage.tests.some(({cells}) => cells === "films")
    ? `The model: a cube of polyhedral grains, each its cell made smaller, ${bonded} to films of nearly one thickness.`
    : "The model: a cube with its particles bonded to their matrix.";
  return stage.dimensions === 3 ? ofCube
    : `The model: a flat box in plane strain, with ${textOnParticles(stage)} ${bonded} to their ` +
      "matrix. Real particles are not endless cylinders; three dimensions are computed with dimensions = 3.";
}

function onBounds(record, {tests, quality}) {
  const boundaries = new Set(tests.map(({boundary}) => boundary));
  if (!(boundaries.has("displacement") && boundaries.has("traction"))) {
    return boundaries.has("periodic") ? "The boundary: periodic, the box repeats without end." : "";
  }
  const apart = (quality?.bounds ?? []).find(({load}) => load !== "bulk");
  const ends = record.frequencies_Hz === undefined ? ["first", "last"] : ["last", "first"];
  const distances = ends.map((end) => apart?.[end])
    .filter((end) => Number.isFinite(end?.relative_distance)).map((end) => `${distanceText(end.relative_distance)} at ` +
      instantText(record, end.time_s));
  const here = distances.length > 0 ? ` Here they are apart by ${listed(distances)}.` : "";
  return "The boundary: under displacement the sides of the box move as given, under traction they are loaded as " +
    `given, with the apparent moduli KUBC and SUBC. ${onWindow(quality)}${here} A larger box brings them together.`;
}

/// A sentence on what both apparent moduli say of a larger body.
function onWindow({filler_on_sides: share} = {}) {
  if (!Number.isFinite(share)) {
    return "No particle crosses the sides, so they are no bounds of the modulus of a larger body.";
  }
  const cut = share > 0 ? `The sides cut filler over ${percent(share)} of them, which moves with them under displacement ` +
    "and is free under traction: they" : "They";
  return `${cut} are an upper and a lower bound of the modulus of a larger body, on the average over such windows.`;
}

/// The distance of a modulus over another one.
function distanceText(distance) {
  return distance < 1 ? percent(distance) : `a factor of ${shortNumber(1 + distance, 2)}`;
}

function onGaps({microstructure: made, quality, tests = []}) {
  const cells = quality?.narrowest_gap_cells;
  if (!Number.isFinite(cells)) return "";
  const width = made.smallest_gap_m === null ? "" : `${display(made.smallest_gap_m, "m")}, `;
  const narrowest = `The gaps between particles decide the modulus at long times. The narrowest one is ${width}` +
    `${cellsText(cells)} wide`;
  const hasFlow = tests.some(({mixing}) => mixing === "flow");
  return hasFlow ? `${narrowest}; the matrix flows through gaps narrower than a cell, and the number of cells across ` +
    "the smallest particle counts: 12 or more."
    : `${narrowest}; below two or three cells the modulus comes out wrong, most of all at long times.`;
}

function cellsText(cells) {
  const number = shortNumber(cells, 2);
  return number === "1" ? "1 cell" : `${number} cells`;
}

/// The error of one grid; `grid_rule` is the range of the rule, or what has none.
function onOneGrid({expected_grid_error: error, grid_rule: rule, measuring_grids: grids}) {
  const known = Number.isFinite(error)
    ? `The grid: one, with an error of ${percent(error)} at most ${rule ?? "by a rule"}.`
    : `The grid: one, so its error is not known${rule === undefined ? "" : ` (${rule})`}.`;
  return `${known} ${onMeasuringGrids(grids)}`.trim();
}

/// A sentence on the shears whose mean is the modulus of a stage; empty where it is that of one shear.
export function onAnisotropy(record, quality) {
  if (quality?.anisotropy === undefined) return "";
  const at = ({time_s: time, relative_distance: distance}) => `${distanceText(distance)} at ${instantText(record, time, 2)}`;
  const {first, last} = quality.anisotropy;
  const ends = record.frequencies_Hz === undefined ? [first, last] : [last, first];
  return `The modulus is the mean of all shears of the box, which are apart by ${listed(ends.map(at))}.`;
}

/// A sentence on what two dimensions leave out of the modulus of a stage, by a rule where there is one; empty for cubes and
/// for a box without particles.
export function onSpace(record, {dimensions, microstructure, quality}) {
  if (dimensions !== 2 || microstructure === undefined) return "";
  if (quality?.spheres_over_discs === undefined) {
    return "This is the modulus of parallel cylinders, in two dimensions; particles in space have another one, and no rule " +
      "says which.";
  }
  const {ratio, time_s: time} = quality.spheres_over_discs;
  return "This is the modulus of discs in two dimensions; that of spheres would be up to about " +
    `${shortNumber(ratio, 2)} times as large (at ${instantText(record, time, 2)}).`;
}

/// A sentence on the grids that measure the error of one; empty where none do.
export function onMeasuringGrids(grids) {
  return grids === undefined ? "" : `Two grids, cells = [${grids.join(", ")}], measure it.`;
}

/// What to do next about the error of a stage's moduli: how to find it or, where it is large, to lower it; empty where
/// nothing is to be done, or nothing is known that helps.
export function nextStep(stage) {
  const {quality, tests = []} = stage;
  const {largest_error: error, largest_sample_error: ofPacking, measuring_grids: grids, error_asked: asked} = quality ?? {};
  if (hasFilms(stage)) return "";
  if (quality?.filler_on_sides !== undefined && tests.every(({boundary}) => boundary !== "periodic")) {
    return 'Next: boundaries = ["periodic"] in [tests], whose modulus comes nearest to that of the material.';
  }
  if (!Number.isFinite(error)) {
    if (quality?.grid_rule === "too few cells for a rule") return "Next: more cells; breccia check says how many the gaps take.";
    return grids === undefined ? "" : `Next: cells = [${grids.join(", ")}] in the deck measures the error of the grid.`;
  }
  const large = 0.05;
  if (error <= Math.max(large, asked ?? 0) || !(ofPacking > 0)) return "";
  return `Next: for half of this error, accuracy = "${percent(error / 2)}" in [tests], in place of box and cells; ` +
    "breccia check says how long that takes.";
}

/// A sentence on the error of the model of grains and films; empty where it is not known.
export function onFilms({expected_grid_error: error} = {}) {
  return Number.isFinite(error) ? `The model of films: an error of up to about ${percent(error)} by a rule.` : "";
}

function onGrids(stage) {
  const {cells, quality} = stage;
  if (hasFilms(stage)) return onFilms(quality);
  if (cells.length < 2) return onOneGrid(quality ?? {});
  const error = quality?.grid_error;
  return `The grid: ${listed(cells.map(String))} cells a side` +
    (!Number.isFinite(error) ? "." : error < 1 ? `, whose error is ${percent(error)} at most.`
      : ", which differ too much, or have nearly as many cells, to tell the error.");
}

function onPacking({microstructure: made, quality}) {
  if (!Number.isFinite(made.particles) || made.seed === undefined) return "";
  const rule = Number.isFinite(quality?.largest_sample_error)
    ? ` This one differs from the mean of all by up to about ${percent(quality.largest_sample_error)}, by a rule.` : "";
  return `The packing: ${made.particles} particles, placed at random once. Another seed packs them anew and gives ` +
    `other moduli; by how much, breccia run --seeds 3 shows.${rule}`;
}

/// A sentence on the separation of scales: a stage takes the one before as a uniform material, which is valid for far
/// larger particles only.
function onSeparation(record, stage) {
  const matrix = matrixStageOf(record, stage);
  const ratio = stage.microstructure.smallest_diameter_m / matrix?.microstructure.largest_diameter_m;
  if (!Number.isFinite(ratio)) return "";
  const factor = shortNumber(ratio, 2);
  return `The stages: the smallest particle of ${stage.name} is ${factor === "1" ? "" : `${factor} times `}as large as the ` +
    `largest of its matrix, ${matrix.name}, which the stage takes as uniform. ` +
    (ratio > 5 * (1 - 1e-9) ? "That holds well." : "That holds well for ratios above five; here it adds an error, up to tens of " +
      "per cent, which is not part of the errors above.");
}
