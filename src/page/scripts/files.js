/// Files that the reader of the page can keep.

import {element} from "./elements.js";
import {perMillionAndKelvin} from "./names.js";

/// Offers the reader a file with a text for download.
export function save(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], {type}));
  element("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/// A safe name of a file: letters and digits of a text, joined by hyphens.
export function fileName(text, ending) {
  return `${text.replace(/[^A-Za-z0-9]+/g, "-").replace(/^-|-$/g, "") || "breccia"}.${ending}`;
}

/// A value of a CSV file, in double quotes where it needs them; quotes in it are doubled.
function csvText(value) {
  const text = String(value);
  return /[",#\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/// Curves of a quantity as the text of a CSV file.
export function csvOf(curves, quantity) {
  const unit = {Pa: "_Pa", "1/Pa": "_1_per_Pa", "%": "_percent",
    [perMillionAndKelvin]: "_1e-6_per_K"}[quantity.unit] ?? "";
  const x = {s: "time_s", "rad/s": "angular_frequency_rad_per_s", Hz: "frequency_Hz", "°C": "temperature_degC"};
  const lines = curves.flatMap((curve) => curve.x.map((at, i) => `${csvText(curve.label)},${at},${curve.y[i]}`));
  return [`curve,${x[quantity.xUnit]},value${unit}`, ...lines, ""].join("\n");
}

/// A table, an object with a list of values for each column, as the text of a CSV file.
export function csvOfTable(table) {
  const columns = Object.entries(table);
  const rows = columns[0][1].map((_, row) => columns.map(([, values]) => csvText(values[row])).join(","));
  return [columns.map(([column]) => csvText(column)).join(","), ...rows, ""].join("\n");
}
