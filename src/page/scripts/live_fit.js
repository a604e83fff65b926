/// The numbers of the changed material by which the live curves are nearest to what was measured.

import {hasModuliToMove, isWide} from "./material_choice.js";
import {leastSquares, logarithmicRatios, rootMeanSquare} from "./misfit.js";
import {display, percent, shortNumber} from "./numbers.js";

/// The curves of results under one boundary: the periodic one, which comes nearest to the material, or else the first.
export function ofBestBoundary(curves) {
  const boundary = curves.find((one) => one.boundary === "periodic")?.boundary ?? curves[0]?.boundary;
  return curves.filter((one) => one.boundary === boundary);
}

/// "12 % rms (periodic)": how far predicted curves are from measured ones; empty where nothing is known.
export function misfitText(predicted, measured) {
  const best = ofBestBoundary(predicted);
  const ratios = logarithmicRatios(best, measured).filter(Number.isFinite);
  if (ratios.length === 0) return "";
  return `${percent(rootMeanSquare(ratios))} rms (${best[0].boundary})`;
}

/// What can be fitted of a material: {materialAt, start, ranges, text}, of decadic logarithms of its shear modulus or, where
/// it relaxes, of factors of its relaxation times and of its moduli. `materialAt` returns its {spectrum, bulk} with these
/// numbers, `text` puts them into words. The factors are relative to the material of the run or, where the reader has
/// `pasted` a spectrum, to that. Undefined where the run has sampled one modulus of an elastic material alone.
export function freeNumbers({material, pasted}) {
  const own = pasted ?? material.shear;
  if (own.terms.length > 0) {
    const most = 3;
    // Where Poisson's ratio does not change with time the bulk modulus goes with the shear modulus.
    const bulkFollows = pasted === undefined && areProportional(own, material.bulk);
    return {start: [0, 0], ranges: [[-most, most], [-most, most]],
      materialAt: ([times, moduli]) => ({spectrum: scaled(own, 10 ** times, 10 ** moduli),
        bulk: scaled(material.bulk, 10 ** times, bulkFollows ? 10 ** moduli : 1)}),
      text: ([times, moduli]) => `relaxation times × ${shortNumber(10 ** times)}, moduli × ${shortNumber(10 ** moduli)} ` +
        `of those of ${pasted === undefined ? "the run" : "the spectrum above"}`};
  }
  if (pasted !== undefined || !hasModuliToMove(material) || !isWide(material.ranges.shear)) return undefined;
  const [least, most] = material.ranges.shear;
  return {start: [Math.log10(own.equilibrium_Pa)], ranges: [[Math.log10(Math.max(least, 1e-9 * most)), Math.log10(most)]],
    materialAt: ([modulus]) => ({spectrum: {equilibrium_Pa: 10 ** modulus, terms: []}}),
    text: ([modulus]) => `shear modulus ${display(10 ** modulus, "Pa")}`};
}

function scaled({equilibrium_Pa, terms}, times, moduli) {
  return {equilibrium_Pa: equilibrium_Pa * moduli, terms: terms.map(({relaxation_time_s, modulus_Pa}) =>
    ({relaxation_time_s: relaxation_time_s * times, modulus_Pa: modulus_Pa * moduli}))};
}

/// Whether two Prony series differ in a factor alone.
function areProportional(one, other) {
  if (one.terms.length !== other.terms.length) return false;
  const factor = other.terms[0].modulus_Pa / one.terms[0].modulus_Pa;
  const isSame = (a, b) => Math.abs(a - b) <= 1e-6 * Math.abs(b);
  return isSame(one.equilibrium_Pa * factor, other.equilibrium_Pa) && one.terms.every((term, i) =>
    isSame(term.relaxation_time_s, other.terms[i].relaxation_time_s) && isSame(term.modulus_Pa * factor, other.terms[i].modulus_Pa));
}

/// The material that fits best, {spectrum, bulk, text}; `curvesWith` returns the predicted curves with {spectrum, bulk}.
/// Undefined where too few measured points are within the curves.
export function fitted(numbers, curvesWith, measured) {
  const residualsAt = (values) => logarithmicRatios(ofBestBoundary(curvesWith(numbers.materialAt(values))), measured);
  const values = leastSquares(residualsAt, numbers.start, numbers.ranges);
  if (values === undefined) return undefined;
  const isAtEnd = values.some((value, i) => numbers.ranges[i].some((end) => Math.abs(value - end) < 1e-6));
  return {...numbers.materialAt(values), text: numbers.text(values) + (isAtEnd ? ", at the end of what is allowed" : "")};
}
