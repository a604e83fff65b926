/// The curves of the page of a fit, from the measured sweeps and the fitted series. Sweeps are {temperature_K,
/// angular_frequency_rad_per_s, storage_Pa, loss_Pa, log10_shift_factor}, of dynamic data at one temperature.

import {decadesOfShift, lossModulus, storageModulus} from "./viscoelasticity.js";

export const zeroCelsius = 273.15;

/// log10 a_T from the reference temperature of the fit to another one [K]; 0 without a law.
export function decadesToReference({law}, temperature) {
  return law === undefined ? 0 : decadesOfShift(law, temperature);
}

/// The law with another temperature as its reference (docs/theory.md, Eq. 28a).
export function lawAt({c1, c2_K, reference_K}, temperature) {
  const c2 = c2_K + temperature - reference_K;
  return {c1: c1 * c2_K / c2, c2_K: c2, reference_K: temperature};
}

/// The sweeps over the reduced angular frequency a_T omega [rad/s] at a reference that is `decades` from that of the
/// fit: [{...sweep, x}].
export function reducedSweeps(sweeps, decades) {
  return sweeps.map((sweep) => ({...sweep,
    x: sweep.angular_frequency_rad_per_s.map((omega) => omega * 10 ** (sweep.log10_shift_factor - decades))}));
}

/// Relative deviations of the fit from the data of a sweep [%], at its reduced frequencies x at the reference of the
/// fit.
export function deviationsOf(series, {x, storage_Pa: storage, loss_Pa: loss}) {
  return {storage: x.map((omega, i) => 100 * (storageModulus(series, omega) / storage[i] - 1)),
    loss: x.map((omega, i) => 100 * (lossModulus(series, omega) / loss[i] - 1))};
}

/// Absolute value [Pa] and phase angle [degrees] of complex moduli.
export function blackDiagram(storage, loss) {
  return {absolute: storage.map((real, i) => Math.hypot(real, loss[i])),
    degrees: storage.map((real, i) => Math.atan2(loss[i], real) * 180 / Math.PI)};
}
