/// How far predicted curves are from measured ones, and the numbers of a material by which they are nearest.

import {solveSymmetric} from "./linear_algebra.js";
import {valueAt} from "./sampling.js";

/// The logarithms of the ratios predicted / measured at all measured points, NaN where a curve is not known. `predicted`
/// and `measured` are curves {stage, quantity, part, x, y}, `at` of a predicted one its value at any x; the points of a
/// measured curve are those of the predicted one of its stage, quantity and part.
export function logarithmicRatios(predicted, measured) {
  return measured.flatMap((points) => {
    const curve = predicted.find((one) => ["stage", "quantity", "part"].every((key) => one[key] === points[key]));
    return points.x.map((x, i) => {
      if (curve === undefined || x < curve.x[0] * (1 - 1e-9) || x > curve.x.at(-1) * (1 + 1e-9)) return NaN;
      const value = curve.at === undefined ? valueAt(curve.x, curve.y, x) : curve.at(x);
      return Math.log(value / points.y[i]);
    });
  });
}

/// The root of the mean square of the numbers that are known; NaN where none is.
export function rootMeanSquare(numbers) {
  const known = numbers.filter(Number.isFinite);
  return Math.sqrt(known.reduce((sum, one) => sum + one * one, 0) / known.length);
}

/// The values within `ranges` [[least, most]] at which a list of residuals has the least mean square, from `start`: by
/// Gauss and Newton's method with the damping of Levenberg and Marquardt and differences for derivatives. The residuals
/// that are known (not NaN) at the start count, and values that make one of these unknown are not taken. Undefined where
/// fewer are known than there are values.
export function leastSquares(residualsAt, start, ranges) {
  const iterations = 40, step = 1e-4, least = 1e-6, smallest = 1e-12;
  const within = (values) => values.map((value, i) => Math.min(Math.max(value, ranges[i][0]), ranges[i][1]));
  const product = (one, other) => one.reduce((sum, number, j) => {
    const part = number * other[j];
    return Number.isFinite(part) ? sum + part : sum;
  }, 0);
  let values = within(start);
  const first = residualsAt(values);
  const places = [...first.keys()].filter((i) => Number.isFinite(first[i]));
  const knownAt = (some) => { const all = residualsAt(some); return places.map((i) => all[i]); };
  if (places.length < values.length) return undefined;
  let residuals = places.map((i) => first[i]);
  let damping = 1e-3;
  for (let i = 0; i < iterations; ++i) {
    const columns = values.map((value, k) => {
      const length = value + step > ranges[k][1] ? -step : step;
      const moved = knownAt(values.map((one, j) => (j === k ? one + length : one)));
      return moved.map((one, j) => (Number.isFinite(one - residuals[j]) ? (one - residuals[j]) / length : 0));
    });
    const matrix = columns.map((one, k) => columns.map((other, l) =>
      product(one, other) * (k === l ? 1 + damping : 1) + (k === l ? smallest : 0)));
    const move = solveSymmetric(matrix, columns.map((one) => -product(residuals, one)));
    const next = within(values.map((value, k) => value + move[k]));
    const changed = knownAt(next);
    if (changed.every(Number.isFinite) && rootMeanSquare(changed) <= rootMeanSquare(residuals)) {
      const moved = Math.max(...next.map((value, k) => Math.abs(value - values[k])));
      [values, residuals, damping] = [next, changed, damping / 10];
      if (moved < least) break;
    } else {
      damping *= 10;
      if (damping > 1e8) break;
    }
  }
  return values;
}
