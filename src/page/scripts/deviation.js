/// Curves compared with a reference curve.

import {valueAt} from "./sampling.js";

/// The relative deviations of curves from a reference [%], at those of their times at which the reference is known.
export function deviationsFrom(reference, curves) {
  return curves.map(({band, ...curve}) => {
    const deviation = (x, y) => 100 * (y / valueAt(reference.x, reference.y, x) - 1);
    const points = curve.x.map((x, i) => [x, deviation(x, curve.y[i])]).filter(([, y]) => Number.isFinite(y));
    return {...curve, x: points.map(([x]) => x), y: points.map(([, y]) => y)};
  });
}

/// The quantity of an axis that shows such deviations.
export function deviationOf(quantity, nameOfReference) {
  return {...quantity, title: `Deviation from ${nameOfReference}`, unit: "%"};
}
