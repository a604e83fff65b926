/// The curves of a complex modulus over the angular frequency, one for each quantity that shows it.

import {complexOf} from "./complex_moduli.js";
import {logarithmic} from "./sampling.js";

const parts = [
  {quantity: "dynamic", part: "storage", letter: ", G′", of: ({storage}) => storage},
  {quantity: "dynamic", part: "loss", letter: ", G″", of: ({loss}) => loss},
  {quantity: "absolute", of: ({size}) => size},
  {quantity: "phase", of: ({phase}) => phase},
  {quantity: "loss-factor", of: ({storage, loss}) => loss / storage},
];

/// G', G'', |G*|, the phase and tan delta of complex moduli (complexOf) at rising angular frequencies x [rad/s], as
/// curves with the properties `common`, the label among them.
function curvesOf(common, x, moduli) {
  return parts.map(({quantity, part, letter = "", of}) => ({...common, quantity, ...(part && {part}),
    label: `${common.label ?? ""}${letter}`, x, y: moduli.map(of)}));
}

/// The same of sampled moduli [{storage, loss}].
export function sampledComplexCurves(common, x, moduli) {
  return curvesOf(common, x, moduli.map(({storage, loss}) => complexOf(storage, loss)));
}

/// The same of a function of the angular frequency, between two of them. Each curve also has `at`, its value at any
/// angular frequency, and `modulusAt`, the whole modulus there.
export function complexCurves(common, [first, last], modulusAt) {
  const x = logarithmic(first, last, 20);
  return curvesOf(common, x, x.map(modulusAt)).map((curve, i) => ({...curve, modulusAt,
    at: (omega) => parts[i].of(modulusAt(omega))}));
}

/// Curves over the frequency in Hz.
export function inHertz(curves) {
  return curves.map((curve) => ({...curve, x: curve.x.map((omega) => omega / (2 * Math.PI))}));
}
