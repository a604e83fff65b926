/// The result of a study in sentences: the modulus of a stage at its first, middle and last time, compared with its
/// binder and a measurement.

import {display, displayRange, percent, ratioText} from "./numbers.js";
import {listed} from "./names.js";
import {valueAt} from "./sampling.js";

/// The first time of curves, a whole power of ten in the middle of the decades, and the last time [s]. Every curve is
/// known at all three. Where the curves have no times in common, the first time of the last curve.
export function threeTimes(curves) {
  const first = Math.max(...curves.map((curve) => curve.x[0]));
  const last = Math.min(...curves.map((curve) => curve.x.at(-1)));
  if (!(first < last)) return [first];
  const middle = 10 ** Math.round(Math.log10(Math.sqrt(first * last)));
  return middle > first && middle < last ? [first, middle, last] : [first, last];
}

/// The smallest and the largest value of curves at a time.
function rangeAt(curves, time) {
  const values = curves.map((curve) => valueAt(curve.x, curve.y, time)).filter(Number.isFinite);
  return [Math.min(...values), Math.max(...values)];
}

/// The boundary conditions of curves, the softest of which comes first: "traction to displacement boundary".
export function textOnBoundaries(curves) {
  return `${[...new Set(curves.map(({boundary}) => boundary))].join(" to ")} boundary`;
}

/// Whether the modulus under traction is above that under displacement at one of these times, by more than rounding.
export function areCrossed(curves, times) {
  const at = (boundary, time) => {
    const curve = curves.find((one) => one.boundary === boundary);
    return curve === undefined ? NaN : valueAt(curve.x, curve.y, time);
  };
  return times.some((time) => at("traction", time) > at("displacement", time) * (1 + 1e-9));
}

/// In place of the boundaries where the moduli cross.
export const crossedText = "the modulus under displacement is below that under traction: use neither";

/// Below this share of its unrelaxed modulus a binder has flowed away, and no ratio to it is shown.
const relaxedAway = 1e-6;

/// Whether a binder {at} has flowed away at a time [s].
export function hasFlowedAway(binder, time) {
  return !(binder.at(time) > relaxedAway * binder.at(0));
}

/// The whole error of a single curve at a time, "± 3.4 %"; empty for several curves, and where it is not known.
function errorText(curves, time) {
  const share = curves.length === 1 && curves[0].error !== undefined
    ? valueAt(curves[0].x, curves[0].error.whole, time) : NaN;
  return Number.isFinite(share) ? ` ± ${percent(share)}` : "";
}

/// The sentences. `symbol` is that of the modulus, `curves` are those of the stage, one for each boundary; `error` is a
/// text on the error; `binder` {at} and `measured` {name, x, y} may be undefined.
export function resultSentences({stage, symbol, curves, error, binder, measured}) {
  const times = threeTimes(curves);
  const moduli = times.map((time) => `${displayRange(...rangeAt(curves, time), "Pa")}${errorText(curves, time)} at ` +
    display(time, "s"));
  const boundaries = areCrossed(curves, times) ? crossedText : textOnBoundaries(curves);
  const sentences = [`${symbol} of ${stage} is ${listed(moduli)} (${[boundaries, error].filter(Boolean).join("; ")}).`];
  if (binder !== undefined) {
    const ratios = [times[0], times.at(-1)].filter((time) => !hasFlowedAway(binder, time))
      .map((time) => `${ratioText(rangeAt(curves, time).map((value) => value / binder.at(time)))} times its binder at ` +
        display(time, "s"));
    if (ratios.length > 0) sentences.push(`That is ${listed([...new Set(ratios)])}.`);
  }
  if (measured !== undefined) sentences.push(...sentenceOnMeasurement(curves, measured));
  return sentences;
}

/// The ratio of each curve to the measurement, at the times of the measurement. `modulus` is what the curves are of.
export function sentenceOnMeasurement(curves, measured, modulus = "the modulus") {
  const seen = [];
  const parts = curves.flatMap((curve) => {
    const ratios = measured.x.map((time, i) => [time, valueAt(curve.x, curve.y, time) / measured.y[i]])
      .filter(([, ratio]) => Number.isFinite(ratio));
    if (ratios.length === 0) return [];
    seen.push(...ratios.map(([time]) => time));
    const values = ratios.map(([, ratio]) => ratio);
    return [`${modulus} under the ${curve.boundary} boundary is ${ratioText([Math.min(...values), Math.max(...values)])} times`];
  });
  if (parts.length === 0) return [];
  const [from, to] = [Math.min(...seen), Math.max(...seen)].map((time) => display(time, "s", 2));
  return [`From ${from} to ${to} ${listed(parts)} what was measured (${measured.name}).`,
    ...sentenceOnPlace(curves, measured)];
}

/// A sentence on the measurement relative to the moduli under traction and displacement: the windows of time in which
/// it is below, between or above them. No sentence without both, and for moduli that cross.
function sentenceOnPlace(curves, measured) {
  const both = ["traction", "displacement"].map((name) => curves.find(({boundary}) => boundary === name));
  if (both.includes(undefined) || areCrossed(curves, measured.x)) return [];
  const stretches = [];
  measured.x.forEach((time, i) => {
    const [least, most] = both.map(({x, y}) => valueAt(x, y, time));
    if (![least, most, measured.y[i]].every(Number.isFinite)) return;
    const place = measured.y[i] < least ? "below both" : measured.y[i] > most ? "above both"
      : "between both";
    if (stretches.at(-1)?.place !== place) stretches.push({place, from: time});
    stretches.at(-1).to = time;
  });
  const most = 4;
  if (stretches.length === 0) return [];
  if (stretches.length > most) return ["The measurement goes in and out between both."];
  const parts = stretches.map(({place, from, to}, i) => {
    if (stretches.length === 1) return `${place} at all of these times`;
    if (i === 0) return `${place} up to ${display(to, "s", 2)}`;
    const [begin, end] = [from, to].map((time) => display(time, "s", 2));
    if (i === stretches.length - 1) return `${place} from ${begin} on`;
    return begin === end ? `${place} at ${begin}` : `${place} from ${begin} to ${end}`;
  });
  return [`The measurement lies ${listed(parts)}.`];
}
