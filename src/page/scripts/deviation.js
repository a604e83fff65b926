/// Curves compared with a reference curve.

import {valueAt} from "./sampling.js";

/// The relative deviations of curves from a reference [%]: at the points of a measured one, and else at those points of
/// the curves at which the reference is known.
export function deviationsFrom(reference, curves) {
  return curves.map(({band, ...curve}) => {
    const isMeasured = reference.role === "measured";
    const value = curve.at ?? ((x) => valueAt(curve.x, curve.y, x));
    const ratios = isMeasured ? reference.x.map((x, i) => [x, value(x) / reference.y[i]])
      : curve.x.map((x, i) => [x, curve.y[i] / valueAt(reference.x, reference.y, x)]);
    const points = ratios.filter(([, ratio]) => Number.isFinite(ratio));
    return {...curve, x: points.map(([x]) => x), y: points.map(([, ratio]) => 100 * (ratio - 1))};
  });
}

/// The quantity of an axis that shows such deviations.
export function deviationOf(quantity, nameOfReference) {
  return {...quantity, title: `Deviation from ${nameOfReference}`, unit: "%"};
}
