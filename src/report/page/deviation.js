"use strict";

/// Curves against one of them.

/// How far curves are above a reference, in per cent of it, at the times at which both are known.
function deviationsFrom(reference, curves) {
  return curves.map(({band, ...curve}) => {
    const deviation = (x, y) => 100 * (y / valueAt(reference.x, reference.y, x) - 1);
    const points = curve.x.map((x, i) => [x, deviation(x, curve.y[i])]).filter(([, y]) => Number.isFinite(y));
    return {...curve, x: points.map(([x]) => x), y: points.map(([, y]) => y)};
  });
}

function deviationOf(quantity, name) {
  return {...quantity, title: `Deviation from ${name}`, unit: "%"};
}
