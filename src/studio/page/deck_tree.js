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

/// A path as `--set` and the messages of the program have it: "stages.composite.filler.fraction".
export function dottedPath(tree, path) {
  let node = tree;
  const parts = path.map((part) => {
    const isArray = node?.type === "array";
    node = isArray ? node.items[part] : entry(node, part);
    const text = isArray ? nameOf(node, String(part)) : part;
    return /^[\w-]+$/.test(text) ? text : `"${text}"`;
  });
  return parts.join(".");
}
