/// The whole stiffness at a time as a matrix and in words.

import {display, minus, percent, shortNumber} from "./numbers.js";
import {numberIfKnown} from "./records.js";
import {unitFor} from "./ticks.js";

const directions = {1: "xx", 2: "yy", 3: "zz", 4: "yz", 5: "zx", 6: "xy"};

/// Voigt's numbers of the strains in a row of stiffness.csv: 1, 2 and 6 in the plane.
function numbersOf(row) {
  return Object.keys(directions).filter((number) => `C${number}${number}_Pa` in row);
}

/// The constants of a row as a table of texts in one unit, with as many decimals as give the largest four digits and the
/// smallest of the diagonal three.
export function matrixOf(row) {
  const numbers = numbersOf(row);
  const constant = (i, j) => row[`C${Math.min(i, j)}${Math.max(i, j)}_Pa`];
  const largest = Math.max(...numbers.flatMap((i) => numbers.map((j) => Math.abs(constant(i, j)))));
  const {unit, scale} = unitFor("Pa", [largest]);
  const smallest = Math.min(...numbers.map((i) => constant(i, i)));
  const decimalsOf = (size, digits) => (size > 0 ? digits - 1 - Math.floor(Math.log10(size / scale)) : 0);
  const decimals = Math.min(8, Math.max(0, decimalsOf(largest, 4), decimalsOf(smallest, 3)));
  const text = (value) => minus((value / scale).toFixed(decimals)).replace(/^−(0\.0*|0)$/, "$1");
  return {unit, heads: [unit, ...numbers.map((number) => directions[number])],
    rows: numbers.map((i) => [directions[i], ...numbers.map((j) => text(constant(Number(i), Number(j))))])};
}

/// A sentence on how far a stiffness is from an isotropic one.
export function sentenceOnStiffness({time_s: time, bulk_modulus_Pa: bulk, shear_modulus_Pa: shear, anisotropy, error}) {
  const index = numberIfKnown(anisotropy), share = numberIfKnown(error);
  const known = Number.isFinite(share) ? `± ${percent(share)} of √(Cᵢᵢ Cⱼⱼ) is the error of a constant`
    : "the error of the constants is not known";
  const distance = Number.isFinite(index) ? `a universal index of anisotropy of ${shortNumber(index, 2)} (0: isotropic)`
    : "no index of anisotropy, since the stiffness is not positive definite";
  return `At ${display(time, "s")} the nearest isotropic stiffness has K = ${display(bulk, "Pa")} and G = ` +
    `${display(shear, "Pa")}, with ${distance}; ${known}.`;
}
