/// How a deck names a modulus that was measured.

import {quoted} from "./toml_source.js";

/// What the deck takes from a fit: a list of [key, source] for the material. A deck cannot name the columns of a file, so
/// where the user has done so it takes the series that the fit has written, and the shift law that it has printed.
export function entriesOfFit(key, file, {reference_temperature: reference = "", columns = []}, {page, output}) {
  if (columns.length === 0 || !page) {
    const ofReference = reference === "" ? "" : `, reference_temperature = ${quoted(reference)}`;
    return [[key, `{ measured = ${quoted(file)}${ofReference} }`]];
  }
  const directory = page.replace(/^files\//, "").replace(/\/[^/]*$/, "");
  const shift = /^temperature_shift = (\{.*\})$/m.exec(output)?.[1];
  return [[key, `{ prony = ${quoted(`${directory}/prony.csv`)} }`],
    ...shift === undefined ? [] : [["temperature_shift", shift]]];
}

/// The columns as they are typed, one a line: QUANTITY=NAME.
export function columnsOf(text) {
  return text.split("\n").map((line) => line.trim()).filter((line) => line !== "");
}

/// The kind of modulus that a fit says it has found: "shear", "young", "bulk", or "" where it does not say.
export function kindOfFit(output) {
  if (/--modulus young or bulk says otherwise/.test(output)) return "";
  const kinds = [["young", /\bYoung|"youngs_|"tensile|"E['"′]/], ["bulk", /\bbulk (?:modulus|relaxation)|"bulk_/],
    ["shear", /"shear_|"G['"′]|\bshear modulus/]];
  return kinds.find(([, pattern]) => pattern.test(output))?.[0] ?? "";
}
