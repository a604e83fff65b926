"use strict";

/// What `breccia` has put into the page (docs/results.md): of a run `study` (study.json), of a sweep `sweep` (sweep.json),
/// `tables` (the CSV files), and more.
const data = JSON.parse(document.getElementById("data").textContent);
const study = data.study;

/// A CSV file of ours as a list of objects, of which some columns hold numbers.
function readTable(name, numbers) {
  const text = data.tables[name];
  if (text === undefined) return [];
  const lines = text.split("\n").filter((line) => line !== "" && !line.startsWith("#"));
  const columns = lines[0].split(",");
  return lines.slice(1).map((line) => {
    const row = {};
    line.split(",").forEach((value, i) => {
      row[columns[i]] = numbers.includes(columns[i]) ? numberOf(value) : value;
    });
    return row;
  });
}

function numberOf(text) {
  return text === "inf" ? Infinity : Number(text);
}

/// Rows that agree in some columns, in the order in which they first appear.
function groupsOf(rows, columns) {
  const groups = new Map();
  for (const row of rows) {
    const key = columns.map((column) => row[column]).join("|");
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(row);
  }
  return [...groups.values()];
}

/// The values of a list of objects under one name, each once.
function distinct(list, name) {
  return [...new Set(list.map((item) => item[name]))];
}
