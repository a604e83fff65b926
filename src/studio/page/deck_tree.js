/// The tree of a deck as the server reads it: tables, arrays and values, each with its line.

/// The value of a key of a table, or undefined.
export function entry(node, key) {
  return node?.type === "table" ? node.entries.find((one) => one.key === key)?.value : undefined;
}

/// The node at a path of keys and indices, or undefined.
export function nodeAt(tree, path) {
  return path.reduce((node, part) => typeof part === "number" ? node?.items?.[part] : entry(node, part), tree);
}

/// Calls visit(node, path) for every node below a table, from the outermost to the innermost.
export function walk(node, visit, path = []) {
  const parts = node?.type === "table" ? node.entries.map(({key, value}) => [key, value])
    : node?.type === "array" ? node.items.map((item, i) => [i, item]) : [];
  for (const [part, value] of parts) {
    visit(value, [...path, part]);
    walk(value, visit, [...path, part]);
  }
}

/// The names of the materials of a deck.
export function materialNames(tree) {
  return (entry(tree, "materials")?.entries ?? []).map(({key}) => key);
}

/// The stages of a deck, as tables.
export function stagesOf(tree) {
  return (entry(tree, "stages")?.items ?? []).filter(({type}) => type === "table");
}

/// The name of a stage, a measurement, or any other table that has one; else the text in place of it.
export function nameOf(table, otherwise) {
  const name = entry(table, "name");
  return name?.type === "text" && name.value !== "" ? name.value : otherwise;
}
