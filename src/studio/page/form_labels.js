/// What the form calls tables, keys and the forms of a value.

import {firstSentence} from "./markdown.js";
import {firstKey} from "./key_reference.js";

const keyLabels = {
  bulk: "bulk modulus K", shear: "shear modulus G", young: "Young's modulus E", poisson: "Poisson's ratio",
  temperature_shift: "temperature shift", thermal_expansion: "thermal expansion", dimensions: "dimensions",
  fraction: "fraction", points_per_decade: "times per decade", film: "thickness of films", dark: "dark pixels",
  bright: "bright pixels", d10: "d10", d50: "d50", d90: "d90",
};

/// The words for a key.
export function labelOf(key) {
  return keyLabels[key] ?? key.replaceAll("_", " ");
}

const formLabels = {
  prony: "Prony series in a file", terms: "Prony series, term by term", measured: "measured data, fitted",
  curve: "points of a curve in a file", diameter: "one size", list: "a list of particles", fuller: "Fuller's curve",
  rosin_rammler: "Rosin and Rammler", lognormal: "lognormal", d10: "quantiles d10, d50, d90", from: "from … to",
  passing: "sieve table", mass: "by mass", volume: "by volume", aspect: "ellipses or ellipsoids", polygon: "polygons",
  seed: "random, with a seed",
};

const lawLabels = {
  '"2s2p1d"': "2S2P1D (bitumen)", '"fractional-zener"': "fractional Zener", '"power-law-creep"': "creep by a power law",
  '"logarithmic-creep"': "logarithmic creep (concrete)",
};

/// The words for a form of a value: {example, meaning}.
export function labelOfForm(form) {
  const law = form.example.table?.get("law")?.source;
  if (law !== undefined) return lawLabels[law] ?? law.replaceAll('"', "");
  const key = firstKey(form.example);
  if (key !== "") return formLabels[key] ?? labelOf(key);
  if (/elastic/.test(form.meaning)) return "elastic: one value";
  return /\.csv"$/.test(form.example.source) ? "a table in a file" : firstSentence(form.meaning) || form.example.source;
}

/// Whether a node of the deck has a form.
export function hasForm(node, form) {
  if (form.example.table === null) return node.type !== "table";
  if (node.type !== "table") return false;
  const value = (key) => node.entries.find((one) => one.key === key)?.value;
  const law = form.example.table.get("law")?.source;
  if (law !== undefined) return law === `"${value("law")?.value}"`;
  return value(firstKey(form.example)) !== undefined;
}
