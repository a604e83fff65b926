/// Keys that a table cannot have beside what the deck has, so that the form does not offer them.

import {entry, nodeAt, stagesOf} from "./deck_tree.js";
import {fillersOf} from "./suited_values.js";

const random = ["random", "lubachevsky-stillinger", "random-sequential", "laguerre"];
const moduli = ["bulk", "shear", "young", "poisson"];
/// Keys of one table of which each takes the place of the others.
const alternatives = [["box", "particles"], ["cells", "resolution"], ["fraction", "amount"], ["times", "frequencies"],
  ["debonded", "films"], ["seed", "sites"], ["seed", "normal"], ["seed", "films"], ["normal", "films"], ["film", "sites"],
  ["ramp", "ramp_transits"], ["ramp", "creep_ramp_transits"]];
/// Keys of a filler that a method of packing does not take.
const notOfMethod = {
  regular: ["fraction", "amount", "gap", "from", "to", "shape"],
  explicit: ["fraction", "amount", "gap", "from", "to", "shape", "sizes"],
  laguerre: ["gap", "coating", "shape", "amount"],
  "lubachevsky-stillinger": ["shape"],
};

/// Whether the table at a path cannot have a key besides.
export function excludes(tree, path, key) {
  const node = path.length === 0 ? tree : nodeAt(tree, path);
  const has = (name) => entry(node, name) !== undefined;
  if (path[0] !== "measurements" && alternatives.some((keys) => keys.includes(key) && keys.some((one) => one !== key && has(one)))) {
    return true;
  }
  if (path[0] === "materials" && path.length === 2) return excludesInMaterial(node, key);
  if (path.length === 0) return key === "sweep" && !stagesOf(tree).some((stage) => random.includes(methodOf(stage)));
  if (path[0] === "measurements") return key === "equilibrium" || (moduli.includes(key) && moduli.some(has));
  if (path[0] === "tests") return excludesInTests(tree, path, key);
  if (path[0] !== "stages") return false;
  const stage = stagesOf(tree)[path[1]];
  if (path.length === 2) return excludesInStage(tree, stage, key);
  if (path[2] === "filler" && path.length <= 4) return excludesInFiller(tree, stage, node, key);
  if (path[3] === "labels") return path.length === 4 ? ["value", "material"].includes(key) : ["dark", "bright"].includes(key);
  return path[2] === "packing" && path.length === 3 && excludesInPacking(tree, stage, node, key);
}

function excludesInMaterial(material, key) {
  const values = moduli.map((one) => entry(material, one)).filter((one) => one !== undefined);
  const isCrystal = entry(material, "stiffness") !== undefined;
  const relaxes = values.some((value) => ["prony", "terms", "measured", "law"].some((name) => entry(value, name) !== undefined));
  if (key === "stiffness") return values.length > 0;
  if (moduli.includes(key)) return isCrystal || values.length > 1;
  return ["temperature_shift", "factors"].includes(key) && !relaxes;
}

function excludesInTests(tree, path, key) {
  const tests = entry(tree, "tests");
  const is = (name, value) => entry(tests, name)?.value === value;
  if (path.length === 2 && path[1] === "quasistatic") {
    return key === "steps_per_decade" ? !is("solver", "stepping") : ["range", "vary"].includes(key) && is("solver", "stepping");
  }
  if (key === "films") return !is("model", "films");
  if (key === "model") return stagesOf(tree).every((stage) => methodOf(stage) !== "laguerre");
  return ["accuracy", "budget"].includes(key) && path.length === 1 && stagesOf(tree).every(hasBoxAndGrid);
}

/// Whether a stage leaves nothing to choose for an accuracy.
function hasBoxAndGrid(stage) {
  const has = (name) => entry(stage, name) !== undefined;
  return methodOf(stage) === "image" || has("cells") || has("resolution");
}

function excludesInStage(tree, stage, key) {
  const method = methodOf(stage);
  if (key === "bonds") return entry(entry(tree, "tests"), "model")?.value !== "films" || method !== "laguerre";
  if (key === "packing") return entry(stage, "filler") === undefined;
  if (key === "filler") return method === "image";
  if (key === "box") return entry(entry(stage, "packing"), "pixel") !== undefined;
  return key === "particles" && (["image", "regular", "explicit"].includes(method) || entry(stage, "filler") === undefined);
}

function excludesInFiller(tree, stage, filler, key) {
  if (notOfMethod[methodOf(stage)]?.includes(key)) return true;
  const has = (name) => entry(filler, name) !== undefined;
  const sizes = entry(filler, "sizes");
  if (key === "fraction" && methodOf(stage) === "laguerre") return entry(entry(stage, "packing"), "film") !== undefined;
  if (key === "fraction" || key === "amount") return entry(sizes, "list") !== undefined || !goesWithAmounts(tree, stage, key);
  if (key === "from" || key === "to") return sizes === undefined || ["diameter", "list"].some((one) => entry(sizes, one) !== undefined);
  if (key === "coating") return has("amount") || entry(filler, "material")?.value === "void";
  const material = entry(entry(tree, "materials"), entry(filler, "material")?.value);
  return key === "orientations" && entry(material, "stiffness") === undefined;
}

/// All fillers have amounts, or none has.
function goesWithAmounts(tree, stage, key) {
  const others = stagesOf(tree).flatMap(fillersOf);
  const count = others.filter((filler) => entry(filler, "amount") !== undefined).length;
  return key === "amount" ? others.length === 1 || count > 0 : count === 0;
}

function excludesInPacking(tree, stage, packing, key) {
  const isCube = entry(tree, "dimensions")?.value === 3;
  const file = entry(packing, "file")?.value ?? "";
  switch (key) {
    case "pixel": return entry(stage, "box") !== undefined;
    case "film": return fillersOf(stage).some((filler) => entry(filler, "fraction") !== undefined);
    case "smooth": return entry(packing, "threshold") === undefined;
    case "threshold": return entry(entry(packing, "labels"), "dark") === undefined;
    case "page": return isCube || /\.png$/i.test(file);
    case "columns": case "rows": case "polygons": case "discs": return isCube;
    case "lattice": case "repeats": return !isCube;
    default: return false;
  }
}

function methodOf(stage) {
  return entry(entry(stage, "packing"), "method")?.value;
}
