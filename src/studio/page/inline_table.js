/// Reads the values that a document about decks gives as examples, such as `{ terms = [{ time = "10 ms" }, ...] }`.
/// It is tolerant: `...` may stand wherever a value, an element or an entry may. Decks themselves are read by the server.

/// An example value: {source, table: Map | null, items: [] | null}, or null where the text is no value.
export function readExample(text) {
  const reader = {text, at: 0};
  const value = readValue(reader);
  skipBlanks(reader);
  return value !== null && reader.at === text.length ? value : null;
}

/// The example without its `...`, which TOML does not know.
export function sourceWithoutDots(value) {
  if (value.table !== null) {
    const entries = [...value.table].filter(([, one]) => one.source !== "...");
    return `{ ${entries.map(([key, one]) => `${key} = ${sourceWithoutDots(one)}`).join(", ")} }`;
  }
  if (value.items !== null) {
    return `[${value.items.filter(({source}) => source !== "...").map(sourceWithoutDots).join(", ")}]`;
  }
  return value.source;
}

function readValue(reader) {
  skipBlanks(reader);
  const start = reader.at;
  const sign = reader.text[start];
  let [table, items] = [null, null];
  if (sign === "{") {
    table = readEntries(reader);
    if (table === null) return null;
  } else if (sign === "[") {
    items = readItems(reader);
    if (items === null) return null;
  } else {
    const scalar = /^("[^"]*"|\.\.\.|[\w.+-]+)/.exec(reader.text.slice(start));
    if (scalar === null) return null;
    reader.at += scalar[0].length;
  }
  return {source: reader.text.slice(start, reader.at), table, items};
}

function readEntries(reader) {
  const entries = new Map();
  reader.at += 1;
  for (;;) {
    skipSeparators(reader);
    if (reader.text[reader.at] === "}") {
      reader.at += 1;
      return entries;
    }
    const entry = /^(\.\.\.|([\w-]+)\s*=)/.exec(reader.text.slice(reader.at));
    if (entry === null) return null;
    reader.at += entry[0].length;
    if (entry[2] === undefined) continue;
    const value = readValue(reader);
    if (value === null) return null;
    entries.set(entry[2], value);
  }
}

function readItems(reader) {
  const items = [];
  reader.at += 1;
  for (;;) {
    skipSeparators(reader);
    if (reader.text[reader.at] === "]") {
      reader.at += 1;
      return items;
    }
    const value = readValue(reader);
    if (value === null) return null;
    items.push(value);
  }
}

function skipBlanks(reader) {
  while (/\s/.test(reader.text[reader.at] ?? "")) reader.at += 1;
}

function skipSeparators(reader) {
  while (/[\s,]/.test(reader.text[reader.at] ?? "")) reader.at += 1;
}
