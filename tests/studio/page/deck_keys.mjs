/// The keys of a deck, for tests of the reference: enough of TOML for the decks of this repository.

/// The paths of all keys of a deck; elements of arrays have the path of their array.
export function keyPaths(text) {
  const paths = [];
  let [at, table] = [0, []];
  const rest = () => text.slice(at);
  const take = (pattern) => {
    const [found] = pattern.exec(rest()) ?? [];
    if (found === undefined) throw new Error(`not expected: ${rest().slice(0, 40)}`);
    at += found.length;
    return found;
  };
  const skip = () => take(/^(\s|#[^\n]*|,)*/);
  const key = () => take(/^(?:"[^"]*"|[\w-]+)(?:\.(?:"[^"]*"|[\w-]+))*/).match(/"[^"]*"|[\w-]+/g)
    .map((part) => part.replaceAll('"', ""));
  const entry = (parent) => {
    const path = [...parent, ...key()];
    paths.push(path);
    take(/^\s*=\s*/);
    value(path);
  };
  const value = (path) => {
    if (text[at] !== "{" && text[at] !== "[") return take(/^("(\\.|[^"\\])*"|'[^']*'|[^\s,\]}#]+)/);
    const close = text[at] === "{" ? "}" : "]";
    at += 1;
    for (skip(); text[at] !== close; skip()) {
      if (close === "}") entry(path);
      else value(path);
    }
    return at += 1;
  };
  for (skip(); at < text.length; skip()) {
    if (text[at] === "[") {
      take(/^\[\[?\s*/);
      table = key();
      take(/^\s*\]\]?/);
      paths.push(...table.map((_, i) => table.slice(0, i + 1)));
    } else {
      entry(table);
    }
  }
  return paths;
}
