/// The numbers of the changed material by which the live curves are nearest to what was measured.

import {hasModuliToMove, isWide} from "./material_choice.js";
import {leastSquares, logarithmicRatios, rootMeanSquare} from "./misfit.js";
import {percent, shortNumber} from "./numbers.js";

/// The curves of results under one boundary: the periodic one, which comes nearest to the material, or else the first.
export function ofBestBoundary(curves) {
  const boundary = curves.find((one) => one.boundary === "periodic")?.boundary ?? curves[0]?.boundary;
  return curves.filter((one) => one.boundary === boundary);
}

/// "12 % rms (periodic, 17 points)": how far predicted curves are from measured ones; empty where nothing is known.
export function misfitText(predicted, measured) {
  const best = ofBestBoundary(predicted);
  const ratios = logarithmicRatios(best, measured).filter(Number.isFinite);
  if (ratios.length === 0) return "";
  return `${percent(rootMeanSquare(ratios))} rms (${best[0].boundary}, ${ratios.length} points)`;
}

/// What can be fitted of a material: {spectrumAt, start, ranges, text}, of decadic logarithms of its shear modulus or, where
/// it relaxes, of factors of its relaxation times and of its moduli in shear. `text` puts them into words. Undefined where
/// the run has sampled one modulus of an elastic material alone.
export function freeNumbers({material, spectrum}) {
  const own = spectrum ?? material.shear;
  if (own.terms.length > 0) {
    const most = 3;
    return {start: [0, 0], ranges: [[-most, most], [-most, most]],
      spectrumAt: ([times, moduli]) => scaled(own, 10 ** times, 10 ** moduli),
      text: ([times, moduli]) => `relaxation times × ${shortNumber(10 ** times)}, moduli × ${shortNumber(10 ** moduli)}`};
  }
  if (!hasModuliToMove(material) || !isWide(material.ranges.shear)) return undefined;
  const [least, most] = material.ranges.shear;
  return {start: [Math.log10(own.equilibrium_Pa)], ranges: [[Math.log10(Math.max(least, 1e-9 * most)), Math.log10(most)]],
    spectrumAt: ([modulus]) => ({equilibrium_Pa: 10 ** modulus, terms: []}), text: () => ""};
}

function scaled({equilibrium_Pa, terms}, times, moduli) {
  return {equilibrium_Pa: equilibrium_Pa * moduli, terms: terms.map(({relaxation_time_s, modulus_Pa}) =>
    ({relaxation_time_s: relaxation_time_s * times, modulus_Pa: modulus_Pa * moduli}))};
}

/// The spectrum that fits best, {spectrum, text}; `curvesWith` returns the predicted curves with a spectrum. Undefined where
/// no measured point is within the curves.
export function fitted(numbers, curvesWith, measured) {
  const residualsAt = (values) => logarithmicRatios(ofBestBoundary(curvesWith(numbers.spectrumAt(values))), measured);
  const values = leastSquares(residualsAt, numbers.start, numbers.ranges);
  return values === undefined ? undefined : {spectrum: numbers.spectrumAt(values), text: numbers.text(values)};
}
