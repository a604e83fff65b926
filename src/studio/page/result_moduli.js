/// The moduli of a result at its first and last time, with their errors, from errors.csv or curves.csv.

import {display, percent} from "../../page/scripts/numbers.js";

/// The rows of a table as records.
export function recordsOf(text) {
  const [head, ...lines] = text.split("\n").map((line) => line.trim())
    .filter((line) => line !== "" && !line.startsWith("#"));
  if (head === undefined) return [];
  const names = head.split(",");
  return lines.map((line) => Object.fromEntries(line.split(",").map((value, i) => [names[i], value])));
}

/// {symbol, first: {time, modulus, error}, last} of the last stage, from the text of errors.csv, or that of curves.csv
/// where there is none; null without rows. The curve is that of the mean of the shears, or of the first load in shear.
export function moduliOf(errors, curves) {
  const withErrors = recordsOf(errors ?? "");
  const all = withErrors.length > 0 ? withErrors : recordsOf(curves ?? "");
  const stage = all.at(-1)?.stage;
  const ofStage = all.filter((row) => row.stage === stage);
  if (ofStage.length === 0) return null;
  const loads = [...new Set(ofStage.map(({load}) => load))];
  const load = loads.find((one) => one === "isotropic") ?? loads.find((one) => one !== "bulk") ?? loads[0];
  const ofLoad = ofStage.filter((row) => row.load === load);
  const rank = ({boundary}) => ["periodic", "displacement", "traction"].indexOf(boundary);
  const best = ofLoad.reduce((found, row) => rank(row) < rank(found) ? row : found);
  const ofTest = ofLoad.filter(({boundary, method}) => boundary === best.boundary && method === best.method);
  const finest = ofTest.reduce((found, row) => finenessOf(row) > finenessOf(found) ? row : found).cells;
  const rows = ofTest.filter(({cells}) => cells === finest);
  const point = ({time_s: time, modulus_Pa: modulus, error}) => ({time: Number(time), modulus: Number(modulus),
    error: error === undefined || error === "" ? null : Number(error)});
  const symbol = load === "bulk" ? "K + G/3" : "G";
  return {symbol, boundary: best.boundary, first: point(rows[0]), last: point(rows.at(-1))};
}

function finenessOf({cells}) {
  return /^\d+$/.test(cells) ? Number(cells) : Infinity;
}

/// A modulus with its error and time as text: "927 kPa ± 6.4 % at 1 ms".
export function textOfModulus({time, modulus, error}) {
  const ofError = error === null ? "" : ` ± ${percent(error)}`;
  return `${display(modulus, "Pa")}${ofError} at ${display(time, "s")}`;
}
