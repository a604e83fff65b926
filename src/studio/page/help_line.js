/// What the reference says of a key: its first sentence, and all of it on demand.

import {element} from "../../page/scripts/elements.js";
import {firstSentence} from "./markdown.js";

/// Short words on keys that the reference names only in passing.
const inPassing = new Map([
  ["packing.method", "how the particles are placed"], ["packing.seed", "another seed gives another random packing"],
  ["packing.walls", "false: a periodic box; true: all particles inside; cut: a window in a larger body"],
  ["packing.columns", "particles along x"], ["packing.rows", "particles along y"],
  ["packing.film", "thickness of the films between grains"], ["packing.particles", "a table of places and sizes"],
  ["packing.sites", "a table of the sites of grains"], ["packing.lattice", "the lattice of a regular array in space"],
  ["packing.repeats", "cubes of the lattice along each side"],
  ["modulus.equilibrium", "modulus at infinite time"],
  ["modulus.terms", "one row for each term, modulus × exp(−t / time)"],
  ["modulus.prony", "a table of relaxation times and moduli"],
  ["modulus.measured", "a table of measured values, which is fitted"],
  ["modulus.curve", "a table of times and moduli"], ["modulus.law", "formula"],
  ["modulus.reference_temperature", "the temperature of one of the sweeps, for the master curve"],
  ["modulus.static", "modulus at infinite time, E00"], ["modulus.glassy", "modulus at time zero, E0"],
  ["modulus.unrelaxed", "modulus at time zero"], ["modulus.instantaneous", "compliance at time zero"],
  ["modulus.creep", "compliance that the creep adds"], ["modulus.time", "characteristic time"],
  ["sizes.diameter", "one diameter for all"], ["sizes.d10", "10 % of the volume is smaller"],
  ["sizes.d50", "half of the volume is smaller"], ["sizes.d90", "90 % of the volume is smaller"],
  ["sizes.fuller", "the largest diameter"], ["sizes.rosin_rammler", "63.2 % of the volume is smaller"],
  ["sizes.passing", "shares that pass sieves"], ["sizes.list", "the diameters of all particles"],
  ["sizes.counts", "how many there are of each of the list"], ["amount.mass", "share of the mass of the whole composite"],
  ["amount.volume", "share of the volume of the whole composite"], ["coating.material", "material of the layer"],
  ["coating.thickness", "thickness of the layer, outside of the diameter"],
  ["factors.times", "multiplies all relaxation times"],
  ["factors.modulus", "multiplies all moduli"], ["stiffness.symmetry", "symmetry of the crystal"],
]);

const ownWords = (key) => inPassing.get(`${key.section.split(".").at(-1)}.${key.key}`);

/// The words of the reference on a key, as one text.
export function wordsOn(key) {
  const parts = [key.meaning, key.type === "" || key.type === "see below" ? "" : `Takes: ${key.type}.`,
    key.default === "" ? "" : `Without it: ${key.default}.`];
  return parts.filter((text) => text !== "").join(" ");
}

/// A line of help for a key; empty where the reference does not know it.
export function helpLine(key) {
  if (key === null) return element("p", {className: "help"}, "not in the reference of decks");
  const short = ownWords(key) ?? firstSentence(key.meaning).replace(/[;,]? see below\.?$|^see .*/, "");
  const all = wordsOn(key);
  const isUnit = key.type !== "" && key.type.length < 40 && !/table|see below|^text$|^modulus$/.test(key.type);
  const line = [short, isUnit && short.length < 80 ? `(${key.type})` : ""].filter((text) => text !== "").join(" ");
  if (line === "") return element("p", {className: "help"}, "");
  if (all.length <= line.length + 12) return element("p", {className: "help"}, line);
  const choices = key.choices.filter(({meaning}) => meaning !== "").map(({source, meaning}) =>
    element("p", {}, element("b", {}, source.replaceAll('"', "")), ` ${meaning}`));
  return element("details", {className: "help"}, element("summary", {}, line), element("p", {}, all), ...choices);
}
