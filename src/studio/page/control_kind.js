/// Which control suits a value of a deck.

import {isFile} from "./starting_values.js";

/// "group" for a table, "list" for an array of tables, "rows" for one of small equal tables, and for single values
/// "check", "many", "choice", "name", "rename", "file", "pair" (from … to) or "typed".
export function controlKind(node, key) {
  if (node.type === "table") return "group";
  if (node.type === "array" && node.items.length > 0 && node.items.every(({type}) => type === "table")) {
    return node.items.every(isSmallTable) && key?.key !== "filler" ? "rows" : "list";
  }
  if (key === null) return node.type === "boolean" ? "check" : "typed";
  if (key.section === "stages.*" && key.key === "name") return "rename";
  if (/^two increasing/.test(key.type) && node.type === "array" && node.items.length === 2) return "pair";
  if (key.choices.length > 0 && /^of |array of/.test(key.type)) return "many";
  if (["material", "matrix", "stage", "dark", "bright"].includes(key.key) && node.type === "text") return "name";
  if (hasWordsAlone(key) && node.type !== "array") return "choice";
  if (node.type === "boolean") return "check";
  if (node.type === "text" && (isFile(key) || (key.key === "sizes" && /\.\w+$/.test(node.value)))) return "file";
  return "typed";
}

function isSmallTable({inline, entries}) {
  return inline && entries.length > 0 && entries.length <= 4
    && entries.every(({value}) => !["table", "array"].includes(value.type));
}

/// Whether a key takes nothing but the words of its choices.
function hasWordsAlone({type, choices}) {
  return choices.length > 0 && /^[\s,]*(or)?[\s,]*$/.test(type.replace(/"[\w-]+"/g, ""));
}

const orders = new Map([
  ["", ["title", "dimensions"]],
  ["materials.*", ["shear", "young", "bulk", "poisson", "stiffness", "temperature_shift", "factors", "density"]],
  ["stages.*", ["name", "matrix", "filler", "packing", "bonds", "box", "particles", "cells", "resolution"]],
  ["stages.*.filler", ["material", "fraction", "amount", "sizes", "from", "to", "shape", "gap", "coating"]],
  ["stages.*.packing", ["method"]],
  ["tests", ["times", "frequencies", "loads", "boundaries", "accuracy", "budget", "model", "mixing", "method"]],
  ["measurements.*", ["name", "stage"]],
]);

/// The entries of a table in the order in which one thinks of them; others follow as the deck has them.
export function ordered(entries, section) {
  const order = orders.get(section) ?? [];
  const rank = ({key}) => order.includes(key) ? order.indexOf(key) : order.length;
  return [...entries].sort((a, b) => rank(a) - rank(b));
}
