"use strict";

/// A Prony series is {equilibrium_Pa, terms: [{relaxation_time_s, modulus_Pa}]}, as in study.json.

/// M(t) = M_inf + sum of M_i exp(-t / tau_i)
function relaxationModulus(series, time) {
  let modulus = series.equilibrium_Pa;
  for (const term of series.terms) modulus += term.modulus_Pa * Math.exp(-time / term.relaxation_time_s);
  return modulus;
}

/// s M~(s), what the correspondence principle puts in the place of an elastic modulus.
function carsonModulus(series, s) {
  let modulus = series.equilibrium_Pa;
  for (const {relaxation_time_s: tau, modulus_Pa} of series.terms) modulus += (modulus_Pa * s * tau) / (1 + s * tau);
  return modulus;
}

/// M'(w) and M''(w)
function storageModulus(series, frequency) {
  let modulus = series.equilibrium_Pa;
  for (const {relaxation_time_s, modulus_Pa} of series.terms) {
    const x = (frequency * relaxation_time_s) ** 2;
    modulus += (modulus_Pa * x) / (1 + x);
  }
  return modulus;
}

function lossModulus(series, frequency) {
  let modulus = 0;
  for (const {relaxation_time_s, modulus_Pa} of series.terms) {
    const x = frequency * relaxation_time_s;
    modulus += (modulus_Pa * x) / (1 + x * x);
  }
  return modulus;
}

/// The series with all relaxation times multiplied by a_T.
function shiftedSeries(series, factor) {
  const terms = series.terms.map(({relaxation_time_s, modulus_Pa}) => ({
    relaxation_time_s: factor * relaxation_time_s, modulus_Pa}));
  return {equilibrium_Pa: series.equilibrium_Pa, terms};
}

/// log10 a_T of the law of Williams, Landel and Ferry, temperatures in K.
function decadesOfShift(law, temperature) {
  const excess = temperature - law.reference_K;
  return (-law.c1 * excess) / (law.c2_K + excess);
}

/// The series whose Carson moduli are those given, at Laplace variables that rise: a fit with relative weights and no
/// negative term.
function seriesOfCarsonModuli(variables, moduli) {
  // A few close times stand well for one between them: errors in time are some 1e-4.
  const beyond = 30, perDecade = 30;
  const times = logarithmic(1 / (beyond * variables.at(-1)), beyond / variables[0], perDecade);
  const columns = [variables.map((_, j) => 1 / moduli[j]),
    ...times.map((tau) => variables.map((s, j) => (s * tau) / (1 + s * tau) / moduli[j]))];
  const [equilibrium, ...strengths] = nonNegativeLeastSquares(columns, variables.map(() => 1));
  const terms = times.map((relaxation_time_s, i) => ({relaxation_time_s, modulus_Pa: strengths[i]}));
  return {equilibrium_Pa: equilibrium, terms: terms.filter((term) => term.modulus_Pa > 0)};
}
