/// Where in the form a mistake of the deck is shown.

import {entry, nameOf, nodeAt, walk} from "./deck_tree.js";

/// The path of the field to which a mistake {line, message} belongs, or null if it is of the deck as a whole. The
/// message begins with the path of the deck, and the line shows what of it is meant: a key that is not known, or one
/// value of several.
export function placeOf(tree, {line, message}) {
  if (tree === null || tree === undefined) return null;
  const named = namedPath(tree, message);
  const onLine = [];
  walk(tree, (node, path) => {
    if (node.line === line) onLine.push(path);
  });
  const below = onLine.filter((path) => named.every((part, i) => path[i] === part));
  const words = [...message.matchAll(/"([^"]*)"/g)].map(([, word]) => word);
  const quoted = below.find((path) => words.includes(path.at(-1)) && path.length === named.length + 1);
  if (quoted !== undefined) return quoted;
  if (named.length > 0) return named;
  return onLine[0] ?? null;
}

/// The longest path at the beginning of a message that the deck has: "stages.HB-1.filler.gap: …".
function namedPath(tree, message) {
  const text = /^((?:"[^"]*"|[^\s":])+):(?:\s|$)/.exec(message)?.[1] ?? "";
  const path = [];
  for (const [part] of text.matchAll(/"[^"]*"|[^.]+/g)) {
    const name = part.replaceAll('"', "");
    const node = nodeAt(tree, path);
    const index = node?.type === "array" ? indexOf(node, name) : -1;
    if (index >= 0) path.push(index);
    else if (entry(node, name) !== undefined) path.push(name);
    else break;
  }
  return path;
}

function indexOf(array, name) {
  const byName = array.items.findIndex((item) => nameOf(item, null) === name);
  if (byName >= 0) return byName;
  return /^\d+$/.test(name) && Number(name) < array.items.length ? Number(name) : -1;
}

/// The mistakes of each field: a map from the path as JSON to the mistakes; those without a place are under "null".
export function mistakesByPlace(tree, mistakes) {
  const places = new Map();
  for (const mistake of mistakes) {
    const place = JSON.stringify(placeOf(tree, mistake));
    places.set(place, [...places.get(place) ?? [], mistake]);
  }
  return places;
}
