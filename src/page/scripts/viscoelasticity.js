/// Linear viscoelasticity of Prony series. A series is {equilibrium_Pa, terms: [{relaxation_time_s, modulus_Pa}]}, as
/// in study.json: M(t) = M_inf + sum of M_i exp(-t / tau_i).

import {nonNegativeLeastSquares} from "./linear_algebra.js";
import {logarithmic} from "./sampling.js";

/// The relaxation modulus M(t) [Pa] at a time [s].
export function relaxationModulus(series, time) {
  let modulus = series.equilibrium_Pa;
  for (const term of series.terms) modulus += term.modulus_Pa * Math.exp(-time / term.relaxation_time_s);
  return modulus;
}

/// The Carson modulus s M~(s) [Pa] at a real Laplace variable s [1/s]. By the correspondence principle it replaces the
/// elastic modulus.
export function carsonModulus(series, s) {
  let modulus = series.equilibrium_Pa;
  for (const {relaxation_time_s: tau, modulus_Pa} of series.terms) modulus += (modulus_Pa * s * tau) / (1 + s * tau);
  return modulus;
}

/// The storage modulus M' [Pa] at an angular frequency [rad/s].
export function storageModulus(series, frequency) {
  let modulus = series.equilibrium_Pa;
  for (const {relaxation_time_s, modulus_Pa} of series.terms) {
    const x = (frequency * relaxation_time_s) ** 2;
    modulus += (modulus_Pa * x) / (1 + x);
  }
  return modulus;
}

/// The loss modulus M'' [Pa] at an angular frequency [rad/s].
export function lossModulus(series, frequency) {
  let modulus = 0;
  for (const {relaxation_time_s, modulus_Pa} of series.terms) {
    const x = frequency * relaxation_time_s;
    modulus += (modulus_Pa * x) / (1 + x * x);
  }
  return modulus;
}

/// The series with all relaxation times multiplied by the shift factor a_T (time-temperature superposition).
export function shiftedSeries(series, factor) {
  const terms = series.terms.map(({relaxation_time_s, modulus_Pa}) => ({
    relaxation_time_s: factor * relaxation_time_s, modulus_Pa}));
  return {equilibrium_Pa: series.equilibrium_Pa, terms};
}

/// log10 of the shift factor a_T at a temperature [K], by the law of Williams, Landel and Ferry {c1, c2_K, reference_K}
/// or a table {temperatures_K, log10_shift_factors}, beyond which it is not a number.
export function decadesOfShift(law, temperature) {
  const {temperatures_K: temperatures, log10_shift_factors: factors} = law;
  if (factors !== undefined) return onPolygon(temperatures, factors, temperature);
  const excess = temperature - law.reference_K;
  return (-law.c1 * excess) / (law.c2_K + excess);
}

/// The temperature [K] at which log10 of the shift factor has a value by the same law: infinite where the law of
/// Williams, Landel and Ferry never reaches it, not a number beyond a table.
export function temperatureOfShift(law, decades) {
  const {temperatures_K: temperatures, log10_shift_factors: factors} = law;
  if (factors !== undefined) return onPolygon(factors.toReversed(), temperatures.toReversed(), decades);
  return decades <= -law.c1 ? Infinity : law.reference_K - (law.c2_K * decades) / (law.c1 + decades);
}

/// The temperatures [K] between which a law has a meaning: those of a table, or well above T_ref - c2.
export function temperaturesOfLaw({temperatures_K: temperatures, reference_K: reference, c2_K: c2}) {
  const room = 10;
  return temperatures === undefined ? [reference - c2 + room, Infinity] : [temperatures[0], temperatures.at(-1)];
}

/// y at x on the polygon through points with rising x; not a number beyond them by more than rounding.
function onPolygon(xs, ys, x) {
  const rounding = 1e-6;
  const at = Math.min(Math.max(x, xs[0]), xs.at(-1));
  if (!(Math.abs(at - x) <= rounding)) return NaN;
  const right = Math.max(1, xs.findIndex((one) => one >= at));
  const share = (at - xs[right - 1]) / (xs[right] - xs[right - 1]);
  return (1 - share) * ys[right - 1] + share * ys[right];
}

/// The bulk modulus K of a solid with the shear modulus G from its modulus of equal strains along all axes of the box,
/// K + G/3 in two dimensions (plane strain) and K in three, all in [Pa]. It is valid for elastic moduli, and so for
/// Carson moduli at one Laplace variable.
export function bulkModulus(tested, shear, dimensions) {
  return dimensions === 3 ? tested : tested - shear / 3;
}

/// The series with the given Carson moduli [Pa] at rising Laplace variables [1/s]: a least-squares fit of the relative
/// deviations without negative terms.
export function seriesOfCarsonModuli(variables, moduli) {
  const beyond = 30;
  return fittedSeries([1 / (beyond * variables.at(-1)), beyond / variables[0]], variables, moduli,
    (s, tau) => (s * tau) / (1 + s * tau));
}

/// The series with the given relaxation moduli [Pa] at rising times [s], by the same fit.
export function seriesOfRelaxationModuli(times, moduli) {
  const before = 10, beyond = 30;
  return fittedSeries([times[0] / before, beyond * times.at(-1)], times, moduli, (t, tau) => Math.exp(-t / tau));
}

/// Fits a series with relaxation times in a range [s] to moduli at the given abscissas; `shape` is the value of a term
/// of modulus 1 at an abscissa.
function fittedSeries([shortest, longest], abscissas, moduli, shape) {
  // With thirty relaxation times a decade the two nearest represent one between them with an error of M(t) of some
  // 1e-4.
  const times = logarithmic(shortest, longest, 30);
  const columns = [abscissas.map((_, j) => 1 / moduli[j]),
    ...times.map((tau) => abscissas.map((x, j) => shape(x, tau) / moduli[j]))];
  const [equilibrium, ...strengths] = nonNegativeLeastSquares(columns, abscissas.map(() => 1));
  const terms = times.map((relaxation_time_s, i) => ({relaxation_time_s, modulus_Pa: strengths[i]}));
  return {equilibrium_Pa: equilibrium, terms: terms.filter((term) => term.modulus_Pa > 0)};
}
