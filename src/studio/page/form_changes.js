/// What another form of a value asks for: a modulus of the same size as the one before, sizes like those before, and
/// the keys beside it that the form needs or excludes.

import {entry, nodeAt, stagesOf} from "./deck_tree.js";
import {firstKey, isModulus} from "./key_reference.js";
import {lengthOf, lengthText, modulusOf, modulusText} from "./quantities.js";
import {valueOfForm} from "./starting_values.js";
import {diameterFor, diametersOf, fractionOf} from "./suited_values.js";
import {quoted} from "./toml_source.js";

/// The changes with which the value at a path has another form; `file` is the name of that of a form which is one.
export function changesOfForm(sections, tree, {path, key, form, file = null}) {
  const value = (source) => [{path, value: source}];
  if (file !== null) return value(valueOfForm(sections, form, file));
  if (isModulus(key) && path[0] === "materials") return value(modulusInForm(form, modulusBefore(tree, path)));
  if (path[0] === "stages" && path.at(-1) === "sizes") return changesOfSizes(tree, path, form);
  return value(valueOfForm(sections, form));
}

/// The largest modulus of a node [Pa], or null.
function largestModulus(node) {
  if (node?.type === "text") return modulusOf(node.value);
  const parts = node?.type === "table" ? node.entries.map(({value}) => value) : node?.type === "array" ? node.items : [];
  const found = parts.map(largestModulus).filter((one) => one !== null);
  return found.length === 0 ? null : Math.max(...found);
}

/// The modulus that a value has, or one that goes with the other modulus of its material [Pa].
function modulusBefore(tree, path) {
  const own = largestModulus(nodeAt(tree, path));
  if (own !== null) return own;
  const material = nodeAt(tree, path.slice(0, -1));
  const others = material.entries.filter(({key}) => ["bulk", "shear", "young"].includes(key) && key !== path.at(-1))
    .map(({value}) => largestModulus(value)).filter((one) => one !== null);
  return others.length === 0 ? 1e9 : others[0] * (path.at(-1) === "bulk" ? 2 : 0.5);
}

function modulusInForm(form, modulus) {
  const share = (part) => quoted(modulusText(part * modulus));
  const compliance = (part) => quoted(`${(part * 1e6 / modulus).toPrecision(2)} /MPa`);
  switch (form.example.table?.get("law")?.source.replaceAll('"', "")) {
    case "2s2p1d": return `{ law = "2s2p1d", static = ${share(0.001)}, glassy = ${share(1)}, delta = 2.2, time = "1 s", `
      + "k = 0.2, h = 0.6, beta = 50 }";
    case "fractional-zener": return `{ law = "fractional-zener", equilibrium = ${share(0.01)}, unrelaxed = ${share(1)}, `
      + 'time = "1 s", exponent = 0.5 }';
    case "power-law-creep": case "logarithmic-creep": return `{ law = ${form.example.table.get("law").source}, `
      + `instantaneous = ${compliance(1)}, creep = ${compliance(0.5)}, time = "1 s", exponent = 0.5 }`;
    default:
  }
  if (firstKey(form.example) === "terms") {
    return `{ equilibrium = ${share(0.1)}, terms = [{ time = "1 s", modulus = ${share(0.9)} }] }`;
  }
  return share(1);
}

/// A form of the sizes of a filler, with the ends and the fraction that it needs beside it.
function changesOfSizes(tree, path, form) {
  const around = path.slice(0, -1);
  const filler = nodeAt(tree, around);
  const mean = Math.sqrt(product(diametersOf(filler) ?? {smallest: diameterFor(tree, path[1]), largest: diameterFor(tree, path[1])}));
  const known = diametersOf(filler) ?? {smallest: mean, largest: mean};
  // One size becomes a narrow distribution around it.
  const [from, to] = known.largest > 1.05 * known.smallest ? [known.smallest, known.largest] : [0.85 * mean, 1.2 * mean];
  const length = (one) => quoted(lengthText(one));
  const [value, ends] = sizesInForm(firstKey(form.example), {from, to, mean, length, tree, path, filler});
  const changes = [{path, value}];
  for (const [key, end] of [["from", from], ["to", to]]) {
    if (ends.includes(key)) changes.push({path: [...around, key], value: length(end)});
    else if (entry(filler, key) !== undefined) changes.push({path: [...around, key], value: null});
  }
  return [...changes, ...changesOfShare(tree, around, filler, firstKey(form.example))];
}

const product = ({smallest, largest}) => smallest * largest;

/// The source of sizes, and which of the ends the filler needs beside it.
function sizesInForm(name, {from, to, mean, length, tree, path, filler}) {
  switch (name) {
    case "diameter": return [`{ diameter = ${length(mean)} }`, []];
    case "list": return [`{ list = [${length(mean)}], counts = [${countIn(tree, path[1], filler, mean)}] }`, []];
    case "passing": return [`{ passing = [{ size = ${length(from)}, passing = "0 %" }, { size = ${length(mean)}, passing = `
      + `"50 %" }, { size = ${length(to)}, passing = "100 %" }] }`, []];
    case "d10": return [`{ d10 = ${length(Math.sqrt(from * mean))}, d50 = ${length(mean)}, d90 = ${length(Math.sqrt(mean * to))} }`,
      ["from", "to"]];
    case "fuller": return [`{ fuller = ${length(to)}, exponent = 0.5 }`, ["from"]];
    case "rosin_rammler": return [`{ rosin_rammler = ${length(mean)}, exponent = 1.2 }`, ["from", "to"]];
    case "lognormal": return [`{ lognormal = [{ weight = 1, median = ${length(mean)}, sigma = 0.3 }] }`, ["from", "to"]];
    default: return [`{ from = ${length(from)}, to = ${length(to)} }`, []];
  }
}

/// So many particles that a list has about the fraction of the filler.
function countIn(tree, i, filler, diameter) {
  const box = lengthOf(entry(stagesOf(tree)[i], "box")?.value) ?? 10 * diameter;
  const isCube = entry(tree, "dimensions")?.value === 3;
  const share = fractionOf(filler) || 0.2;
  const ofOne = isCube ? Math.PI / 6 * (diameter / box) ** 3 : Math.PI / 4 * (diameter / box) ** 2;
  return Math.max(1, Math.floor(share / ofOne));
}

/// A list of particles has its fraction, all other sizes need one; a number of particles is not for a list.
function changesOfShare(tree, around, filler, name) {
  const has = (key) => entry(filler, key) !== undefined;
  if (name === "list") return ["fraction", "amount"].filter(has).map((key) => ({path: [...around, key], value: null}));
  const packing = entry(stagesOf(tree)[around[1]], "packing");
  const needsNone = has("fraction") || has("amount") || entry(packing, "method")?.value === "regular" || entry(packing, "film");
  return needsNone ? [] : [{path: [...around, "fraction"], value: "0.2"}];
}

/// Why a value cannot have a form beside the rest of the deck, or "".
export function whyNotForm(tree, path, form) {
  const method = entry(entry(stagesOf(tree)[path[1]], "packing"), "method")?.value;
  const isSizes = path[0] === "stages" && path.at(-1) === "sizes";
  if (isSizes && method === "regular" && firstKey(form.example) !== "diameter") return "not in a regular array";
  return isSizes && method === "laguerre" && firstKey(form.example) === "list" ? "not for grains" : "";
}
