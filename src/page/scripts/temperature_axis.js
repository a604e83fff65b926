/// Curves over the temperature at one time or frequency, as an analyser (DMA) shows them: M(t, T) = M(t / a_T, T_0) and
/// M*(omega, T) = M*(a_T omega, T_0) (docs/theory.md, Eq. 28b), T_0 being the temperature of the study. Each sample of
/// a curve over time or frequency is one of the curve over temperature, so nothing is interpolated.

import {binderOf} from "./stages.js";
import {decadesOfShift, temperatureOfShift} from "./viscoelasticity.js";

const zeroCelsius = 273.15;
const hottest = 200;  // [K] above the temperature of the study; beyond it the law does not describe a real binder

function isElastic({bulk, shear}) {
  return bulk.terms.length === 0 && shear.terms.length === 0;
}

/// The shift law of a stage or of a material that serves as a matrix; undefined where the moduli at other temperatures
/// are not known, because the binder has no law or another material of the composite relaxes, too.
export function lawOf(study, name) {
  const stage = study.stages.find((one) => one.name === name);
  const binder = stage === undefined ? study.materials.find((material) => material.name === name)
    : binderOf(study, name);
  const {materials = [], coatings = []} = stage?.filler_of_the_whole ?? {};
  const others = [...materials, ...coatings].map((share) => study.materials.find(({name}) => name === share.material));
  return others.every(isElastic) ? binder?.temperature_shift : undefined;
}

/// A curve over the temperature [degC], rising, at a time [s] or an angular frequency [rad/s] `at`; `xUnit` is the unit
/// of its own axis, "s" or "rad/s".
export function overTemperature(curve, law, xUnit, at) {
  const ofStudy = decadesOfShift(law, law.temperature_K);
  const samples = curve.x.map((x, i) => {
    const decades = Math.log10(xUnit === "s" ? at / x : x / at);
    return {celsius: temperatureOfShift(law, decades + ofStudy) - zeroCelsius, y: curve.y[i], band: curve.band?.[i]};
  }).filter(({celsius}) => celsius < law.temperature_K - zeroCelsius + hottest);  // false where it is not a number
  samples.sort((one, other) => one.celsius - other.celsius);
  const column = (name) => samples.map((sample) => sample[name]);
  return {...curve, x: column("celsius"), y: column("y"), ...(curve.band && {band: column("band")})};
}

/// A time [s] or angular frequency [rad/s] for which the temperature of the study is among those of the curve: a whole
/// power of ten in the displayed unit, seconds or Hz.
export function usualAbscissa(times, xUnit) {
  const middle = Math.sqrt(times[0] * times[1]);
  if (xUnit === "s") return 10 ** Math.round(Math.log10(middle));
  const hertz = [times[1], times[0]].map((time) => 1 / (2 * Math.PI * time));
  const usual = hertz[0] < 1 && hertz[1] > 1 ? 1 : 10 ** Math.round(Math.log10(Math.sqrt(hertz[0] * hertz[1])));
  return 2 * Math.PI * usual;
}
