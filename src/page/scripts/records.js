/// Lists of objects, such as the rows of a table.

/// The value of a property of the object itself; undefined if it has none. Names come from the deck, and a stage called
/// "constructor" must not be taken for the property that every object inherits.
export function own(object, name) {
  return Object.hasOwn(object, name) ? object[name] : undefined;
}

/// The number in an entry of a table. JSON has no infinity; tables write it as the text "inf".
export function numberOf(value) {
  return value === "inf" ? Infinity : Number(value);
}

/// Groups rows whose values agree in the given columns. Groups and their rows keep the order of the rows.
export function groupsOf(rows, columns) {
  const groups = new Map();
  for (const row of rows) {
    const key = JSON.stringify(columns.map((column) => row[column]));
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(row);
  }
  return [...groups.values()];
}

/// The different values that the objects of a list have for a property, in the order of the list.
export function distinct(list, name) {
  return [...new Set(list.map((item) => item[name]))];
}

/// A number in a column of texts; NaN where it is not known, and in tables of earlier versions without the column.
export function numberIfKnown(text) {
  return text === undefined || text === "" ? NaN : Number(text);
}
