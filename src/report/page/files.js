"use strict";

/// What the reader can keep.

/// Hands the reader a file.
function save(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], {type}));
  element("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

function fileName(text, ending) {
  return `${text.replace(/[^A-Za-z0-9]+/g, "-").replace(/^-|-$/g, "")}.${ending}`;
}

/// A curve as CSV.
function csvOf(curves, quantity) {
  const unit = {Pa: "_Pa", "1/Pa": "_1_per_Pa", "%": "_percent"}[quantity.unit] ?? "";
  const x = quantity.x === "time" ? "time_s" : "angular_frequency_1_per_s";
  const lines = curves.flatMap((curve) => curve.x.map((at, i) => `"${curve.label}",${at},${curve.y[i]}`));
  return [`curve,${x},value${unit}`, ...lines, ""].join("\n");
}
