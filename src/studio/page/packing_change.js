/// What another method of packing asks of a stage besides: keys of the earlier method go, those of the new one come, and
/// the filler gets or loses what follows from its particles.

import {entry, materialNames, stagesOf} from "./deck_tree.js";
import {lengthOf, lengthText} from "./quantities.js";
import {diameterFor, fillersOf, fractionOf, newFiller} from "./suited_values.js";
import {quoted} from "./toml_source.js";

const random = ["random", "lubachevsky-stillinger", "random-sequential"];
const ofBoth = {false: ["columns", "rows"], true: ["lattice", "repeats"]};   // by whether the box is a cube
const keysOfMethods = new Map([...random.map((method) => [method, ["walls", "seed"]]),
  ["explicit", ["particles", "polygons", "discs", "walls"]], ["laguerre", ["walls", "seed", "sites", "film"]],
  ["image", ["file", "pixel", "labels", "threshold", "smooth", "crop", "periodic", "page"]]]);
/// Keys of a filler which the places of its particles decide.
const ofDrawnParticles = ["fraction", "amount", "gap", "from", "to", "shape"];

/// Keys of a filler that a method does not take.
const dropped = {explicit: ["sizes", ...ofDrawnParticles], regular: ofDrawnParticles, laguerre: ["gap", "shape", "coating"],
  "lubachevsky-stillinger": ["shape"]};

/// The methods for which a file is asked for first.
export const methodsOfFiles = ["explicit", "image"];

/// Why a method is not for the fillers that a stage has, or "".
export function whyNotMethod(tree, i, method) {
  return fillersOf(stagesOf(tree)[i]).length > 1 ? whyNotMethodOfSeveral(method) : "";
}

function whyNotMethodOfSeveral(method) {
  return method === "regular" || method === "laguerre" ? "for one filler alone" : "";
}

/// Whether a stage can have one filler more.
export function takesFiller(tree, i) {
  const stage = stagesOf(tree)[i];
  const method = entry(entry(stage, "packing"), "method")?.value;
  return method !== "image" && (fillersOf(stage).length === 0 || whyNotMethodOfSeveral(method) === "");
}

/// The changes with which the stage at an index has another method; `file` is the name of that of a list or an image.
export function packingChanges(tree, i, method, file = null) {
  const at = ["stages", i];
  const stage = stagesOf(tree)[i];
  const packing = entry(stage, "packing");
  const isCube = entry(tree, "dimensions")?.value === 3;
  const own = keysOfMethods.get(method) ?? ofBoth[isCube];
  const changes = [{path: [...at, "packing", "method"], value: quoted(method)}];
  const set = (path, value) => changes.push({path: [...at, ...path], value});
  const remove = (path, table, keys) => keys.filter((key) => entry(table, key) !== undefined)
    .forEach((key) => set([...path, key], null));

  remove(["packing"], packing, (packing?.entries ?? []).map(({key}) => key).filter((key) => key !== "method" && !own.includes(key)));
  if (method === "image") {
    changeToImage();
    return changes;
  }
  const fillers = fillersOf(stage);
  if (fillers.length === 0) set(["filler"], newFiller(tree, i, dropped[method]));
  fillers.forEach((filler, j) => changeFiller(filler, entry(stage, "filler").type === "array" ? ["filler", j] : ["filler"]));
  if (method === "explicit") {
    set(["packing", "particles"], quoted(file));
    remove([], stage, ["particles"]);
  }
  if (method === "regular") changeToRegular();
  if (!random.includes(method) && method !== "laguerre" && !hasGrid()) set(["cells"], "64");
  if (random.includes(method) && ["box", "particles"].every((key) => entry(stage, key) === undefined) && hasGrid()) {
    set(["particles"], "60");
  }
  return changes;

  function hasGrid() {
    return ["cells", "resolution"].some((key) => entry(stage, key) !== undefined);
  }

  function changeFiller(filler, path) {
    remove(path, filler, dropped[method] ?? []);
    if (method === "explicit") return;
    const hasDiameter = entry(entry(filler, "sizes"), "diameter") !== undefined;
    if (entry(filler, "sizes") === undefined || (method === "regular" && !hasDiameter)) {
      set([...path, "sizes"], `{ diameter = ${quoted(lengthText(diameterFor(tree, i)))} }`);
    }
    const hasShare = ["fraction", "amount"].some((key) => entry(filler, key) !== undefined);
    const hasFilm = method === "laguerre" && entry(packing, "film") !== undefined;
    // Grains fill more of a box than particles can.
    if (random.includes(method) && fractionOf(filler) > 0.7) set([...path, "fraction"], "0.5");
    if (method !== "regular" && !hasShare && !hasFilm) set([...path, "fraction"], shareOfArray());
  }

  /// The share of an array in columns and rows, or a small one where it is not known.
  function shareOfArray() {
    const numbers = ["columns", "rows"].map((key) => entry(packing, key)?.value);
    const [box, diameter] = [lengthOf(entry(stage, "box")?.value), diameterFor(tree, i)];
    const share = Math.PI / 4 * diameter ** 2 * numbers[0] * numbers[1] / box ** 2;
    return String(box !== null && share > 0 && share < 0.7 ? Number(share.toPrecision(2)) : 0.2);
  }

  /// So many columns that the fraction of the filler stays about the same.
  function changeToRegular() {
    const diameter = diameterFor(tree, i);
    const share = Math.min(fractionOf(fillersOf(stage)[0]) || 0.2, isCube ? 0.45 : 0.7);
    const pitch = isCube ? diameter * Math.cbrt(Math.PI / 6 / share) : diameter * Math.sqrt(Math.PI / 4 / share);
    const box = lengthOf(entry(stage, "box")?.value);
    const count = box === null ? 4 : Math.max(1, Math.min(Math.round(box / pitch), Math.floor(0.97 * box / diameter)));
    if (box === null) set(["box"], quoted(lengthText(count * pitch)));
    remove([], stage, ["particles"]);
    for (const [key, value] of isCube ? [["lattice", '"sc"'], ["repeats", count]] : [["columns", count], ["rows", count]]) {
      set(["packing", key], String(value));
    }
  }

  /// An image has neither filler nor particles. Its darker pixels are taken for the matrix.
  function changeToImage() {
    remove([], stage, ["filler", "particles", "bonds"]);
    const matrix = entry(stage, "matrix")?.value ?? "binder";
    const material = entry(fillersOf(stage)[0], "material")?.value ?? materialNames(tree).findLast((name) => name !== matrix)
      ?? matrix;
    set(["packing", "file"], quoted(file));
    if (entry(stage, "box") === undefined && entry(packing, "pixel") === undefined) set(["packing", "pixel"], '"1 um"');
    set(["packing", "threshold"], '"otsu"');
    set(["packing", "labels"], `{ dark = ${quoted(matrix)}, bright = ${quoted(material)} }`);
  }
}
