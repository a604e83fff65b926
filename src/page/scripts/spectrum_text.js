/// A relaxation spectrum that the reader types or pastes.

import {numberOf} from "./records.js";

/// Reads a spectrum, one term a line: relaxation time [s] and modulus [Pa], separated by a comma, a semicolon or
/// spaces; the time "inf" marks the modulus at infinite time. The names of columns and lines that begin with # are
/// skipped. Returns a Prony series; throws an Error with the line and the expected text.
export function readSpectrum(text) {
  const terms = [];
  let equilibrium_Pa = 0;
  text.split(/\r?\n/).forEach((line, i) => {
    const cells = line.trim().split(/[,;\s]+/).filter((cell) => cell !== "");
    if (cells.length === 0 || line.trim().startsWith("#")) return;
    const [time, modulus] = cells.map(numberOf);
    if (terms.length === 0 && Number.isNaN(time)) return;  // the names of the columns
    if (cells.length !== 2 || !(time > 0) || !(modulus >= 0) || !Number.isFinite(modulus)) {
      throw new Error(`line ${i + 1}: expected a relaxation time above 0 and a modulus not below 0, ` +
        `got "${line.trim()}"`);
    }
    if (time === Infinity) equilibrium_Pa += modulus;
    else terms.push({relaxation_time_s: time, modulus_Pa: modulus});
  });
  if (!(terms.reduce((sum, term) => sum + term.modulus_Pa, equilibrium_Pa) > 0)) {
    throw new Error("expected at least one term with a modulus above 0");
  }
  return {equilibrium_Pa, terms};
}
