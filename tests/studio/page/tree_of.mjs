/// The tree of a deck, as the server answers it, from an object: for tests of what the page makes of decks.

export function treeOf(value) {
  if (Array.isArray(value)) return {type: "array", items: value.map(treeOf)};
  if (typeof value === "object") {
    return {type: "table", inline: false, entries: Object.entries(value).map(([key, one]) => ({key, value: treeOf(one)}))};
  }
  if (typeof value === "string") return {type: "text", value};
  if (typeof value === "boolean") return {type: "boolean", value};
  return {type: Number.isInteger(value) ? "integer" : "number", value};
}
