"use strict";

/// What `breccia` has put into the page (docs/results.md): of a run `study` (study.json), of a sweep `sweep` (sweep.json),
/// `tables` (the CSV files), and more.
const data = JSON.parse(document.getElementById("data").textContent);
const study = data.study;

/// The value that an object of JSON has under a name; undefined where it has none. Stages and materials may be called
/// "constructor", which every object inherits.
function own(object, name) {
  return Object.hasOwn(object, name) ? object[name] : undefined;
}

/// The rows of a table as a list of objects, none where there is no such table.
function readTable(name) {
  const columns = Object.entries(own(data.tables, name) ?? {});
  const count = columns.length === 0 ? 0 : columns[0][1].length;
  return Array.from({length: count}, (_, row) =>
    Object.fromEntries(columns.map(([column, values]) => [column, values[row]])));
}

/// A number of a table, in which infinity is text.
function numberOf(value) {
  return value === "inf" ? Infinity : Number(value);
}

/// Rows that agree in some columns, in the order in which they first appear.
function groupsOf(rows, columns) {
  const groups = new Map();
  for (const row of rows) {
    const key = JSON.stringify(columns.map((column) => row[column]));
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(row);
  }
  return [...groups.values()];
}

/// The values of a list of objects under one name, each once.
function distinct(list, name) {
  return [...new Set(list.map((item) => item[name]))];
}
