/// The data that `breccia` has written into the page as JSON (docs/results.md). The page of a run has `study`
/// (study.json), `tables`, `pictures`, `fields`, `responses` and `histories`; that of a sweep has `sweep` (sweep.json),
/// `curves`, `measurements`, `measurements_in_frequency` and `tables`.

import {own} from "./records.js";

export const data = JSON.parse(document.getElementById("data").textContent);
export const {study, sweep} = data;

/// The rows of a table of the results as a list of objects; an empty list if there is no such table.
export function readTable(name) {
  const columns = Object.entries(own(data.tables, name) ?? {});
  const count = columns.length === 0 ? 0 : columns[0][1].length;
  return Array.from({length: count}, (_, row) =>
    Object.fromEntries(columns.map(([column, values]) => [column, values[row]])));
}
