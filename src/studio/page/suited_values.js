/// What a new part of a deck begins with, so that it goes with what the deck has: sizes like those that are there,
/// fractions for which there is room.

import {entry, materialNames, nodeAt, stagesOf} from "./deck_tree.js";
import {lengthOf, lengthText} from "./quantities.js";
import {quoted} from "./toml_source.js";

/// The fillers of a stage, as tables.
export function fillersOf(stage) {
  const filler = entry(stage, "filler");
  return filler?.type === "array" ? filler.items : filler === undefined ? [] : [filler];
}

/// All lengths in a node: those of a list of sizes, of a sieve table, of the ends of a distribution.
function lengthsIn(node) {
  if (node === undefined) return [];
  if (node.type === "text") return [lengthOf(node.value)].filter((length) => length !== null);
  if (node.type === "array") return node.items.flatMap(lengthsIn);
  return node.type === "table" ? node.entries.flatMap(({value}) => lengthsIn(value)) : [];
}

/// The smallest and the largest diameter of a filler [m], as far as the deck says them, or null.
export function diametersOf(filler) {
  const ends = ["from", "to"].flatMap((key) => lengthsIn(entry(filler, key)));
  const all = [...ends, ...ends.length === 2 ? [] : lengthsIn(entry(filler, "sizes"))];
  return all.length === 0 ? null : {smallest: Math.min(...all), largest: Math.max(...all)};
}

/// The diameters of all fillers of some stages [m], or null.
function diametersIn(stages) {
  const known = stages.flatMap(fillersOf).map(diametersOf).filter((one) => one !== null);
  if (known.length === 0) return null;
  return {smallest: Math.min(...known.map(({smallest}) => smallest)), largest: Math.max(...known.map(({largest}) => largest))};
}

/// The diameter that a particle of a stage is likely to have [m].
export function diameterFor(tree, i) {
  const stages = stagesOf(tree);
  const [own, others] = [diametersIn(stages.slice(i, i + 1)), diametersIn(stages)];
  const box = lengthOf(entry(stages[i], "box")?.value);
  return own?.smallest ?? (box === null ? null : box / 10) ?? others?.smallest ?? 1e-3;
}

/// The fraction of a filler as a number; 0 where it is not known.
export function fractionOf(filler) {
  const value = entry(filler, "fraction")?.value;
  return typeof value === "number" ? value : Number.parseFloat(value ?? "") / 100 || 0;
}

/// A fraction for one filler more, for which there is room beside the others.
function fractionThatFits(fillers) {
  const room = Math.max(0.6 - fillers.reduce((sum, filler) => sum + fractionOf(filler), 0), 0.02);
  return Number(Math.min(room / 2, 0.2).toPrecision(1));
}

/// One filler more for a stage: of a material that the stage does not have yet if there is one, of a size that fits into
/// its box, and of a fraction for which there is room. `without` names keys that it is not to have.
export function newFiller(tree, i, without = []) {
  const stage = stagesOf(tree)[i];
  const fillers = fillersOf(stage);
  const names = materialNames(tree);
  const used = [entry(stage, "matrix")?.value, ...fillers.map((filler) => entry(filler, "material")?.value)];
  const material = quoted(names.findLast((name) => !used.includes(name)) ?? used.at(-1) ?? names.at(-1) ?? "particle");
  const diameter = diameterFor(tree, i);
  const amount = fillers.map((filler) => entry(filler, "amount")).find((one) => one?.type === "table")?.entries[0]?.key;
  const share = amount === undefined ? `fraction = ${fractionThatFits(fillers)}`
    : `amount = { ${amount} = "1 %" }`;
  const gap = fillers.map((filler) => lengthOf(entry(filler, "gap")?.value)).find((one) => one !== null) ?? diameter / 20;
  const parts = [["material", `material = ${material}`], ["fraction", share],
    ["sizes", `sizes = { diameter = ${quoted(lengthText(diameter))} }`], ["gap", `gap = ${quoted(lengthText(gap))}`]];
  return `{ ${parts.filter(([key]) => !without.includes(key)).map(([, source]) => source).join(", ")} }`;
}

/// One stage more: its matrix is the last stage, and its particles are larger than those of the stages before.
export function newStage(tree, name) {
  const stages = stagesOf(tree);
  const names = materialNames(tree);
  const last = entry(stages.at(-1), "name")?.value;
  const present = diametersIn(stages);
  const diameter = present === null ? 1e-3 : 5 * present.largest;
  const matrix = last ?? names[0] ?? "binder";
  return `{ name = ${quoted(name)}, matrix = ${quoted(matrix)}, filler = { material = ${quoted(names.at(-1) ?? "particle")}, `
    + `fraction = 0.2, sizes = { diameter = ${quoted(lengthText(diameter))} }, gap = ${quoted(lengthText(diameter / 20))} }, `
    + `packing = { method = "random", seed = 1 } }`;
}

/// The ends that the distribution of a filler has of its own, as lengths [m].
function endsOf(filler) {
  const found = lengthsIn(entry(filler, "sizes"));
  return found.length === 0 ? null : {from: Math.min(...found), to: Math.max(...found)};
}

/// Time-temperature superposition that changes nothing as long as both temperatures are the same: by the law of the
/// measured data where there are some, else with the common constants of polymers.
function newShift(material) {
  const measured = material?.entries?.map(({value}) => value).find((value) => entry(value, "measured") !== undefined
    && entry(value, "reference_temperature") !== undefined);
  if (measured !== undefined) {
    return `{ law = "measured", temperature = ${quoted(entry(measured, "reference_temperature").value)} }`;
  }
  return '{ law = "wlf", c1 = 8.86, c2 = "101.6 K", reference = "20 degC", temperature = "20 degC" }';
}

/// The temperature of a shift that changes nothing yet.
function temperatureOf(shift) {
  return quoted(["reference", "temperature"].map((key) => entry(shift, key)?.value).find((one) => one !== undefined) ?? "20 degC");
}

/// The side of the box of a stage [m]: that of the deck, or one for about sixty particles.
function boxOf(tree, i) {
  return lengthOf(entry(stagesOf(tree)[i], "box")?.value) ?? 10 * (diametersIn(stagesOf(tree).slice(i, i + 1))?.largest
    ?? diameterFor(tree, i));
}

/// The source of a value of a key that follows from the rest of the deck, in the table at a path; null for other keys.
export function suitedValue(key, tree, path) {
  const isInStage = path[0] === "stages" && path.length > 1;
  const table = path.length === 0 ? tree : nodeAt(tree, path);
  const length = (value) => quoted(lengthText(value));
  switch (key.key) {
    case "temperature_shift": return newShift(table);
    case "reference": case "temperature": return path.at(-1) === "temperature_shift" ? temperatureOf(table) : null;
    case "factors": return "{ times = 1, modulus = 1 }";
    case "stage": return quoted(entry(stagesOf(tree).at(-1), "name")?.value ?? "");
    case "matrix": return quoted(materialNames(tree)[0] ?? "binder");
    case "material": return quoted(materialNames(tree).at(-1) ?? "particle");
    default: return isInStage ? valueInStage(key, {tree, i: path[1], table, length}) : null;
  }
}

function valueInStage(key, {tree, i, table, length}) {
  const stage = stagesOf(tree)[i];
  switch (key.key) {
    case "filler": return newFiller(tree, i);
    case "box": return length(boxOf(tree, i));
    case "resolution": return quoted(`${Number((100 / boxOf(tree, i) / 1000).toPrecision(2))} /mm`);
    case "sizes": return `{ diameter = ${length(diameterFor(tree, i))} }`;
    case "gap": return length((diametersOf(table)?.smallest ?? diameterFor(tree, i)) / 20);
    case "film": return length(diameterFor(tree, i) / 50);
    case "coating": return newCoating(tree, i, table, length);
    case "from": case "to": return key.section.endsWith("filler") ? length((endsOf(table) ?? {})[key.key] ?? diameterFor(tree, i)) : null;
    case "fraction": return String(fractionThatFits(fillersOf(stage)));
    case "counts": return `[${(entry(table, "list")?.items ?? [1]).map(() => 1).join(", ")}]`;
    default: return null;
  }
}

/// A thin coating for which there is room between the particles.
function newCoating(tree, i, filler, length) {
  const stage = stagesOf(tree)[i];
  const diameter = diametersOf(filler)?.smallest ?? diameterFor(tree, i);
  const densest = 0.72;   // share of the box that particles fill with their coatings and half of the gaps around them
  const share = fillersOf(stage).reduce((sum, one) => sum + fractionOf(one), 0) || densest / 2;
  const room = (diameter * (Math.sqrt(densest / share) - 1) - (lengthOf(entry(filler, "gap")?.value) ?? diameter / 10)) / 2;
  const thickness = Math.max(Math.min(diameter / 20, room), diameter / 100);
  const names = materialNames(tree);
  const used = [entry(stage, "matrix")?.value, ...fillersOf(stage).map((one) => entry(one, "material")?.value)];
  // A phase of the stage is called "matrix", so that a coating of a material of this name is refused.
  const material = names.findLast((name) => !used.includes(name)) ?? names.find((name) => name === used[0] && name !== "matrix")
    ?? used.at(-1) ?? "binder";
  return `{ material = ${quoted(material)}, thickness = ${length(thickness)} }`;
}
