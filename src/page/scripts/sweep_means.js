/// The means of curves over packings that differ in their seeds alone.

import {groupsOf} from "./records.js";
import {sweptKeys} from "./sweep_curves.js";

/// The paths of the swept seeds.
const seeds = sweptKeys.filter(({isSeed, values}) => isSeed && values.length > 1).map(({path}) => path);

/// Whether the tasks of the sweep differ in seeds.
export const hasSeeds = seeds.length > 0;

/// The curves with those that differ in their seeds alone as one, their mean: its `band` is the standard deviation of one
/// of them, `packings` their number, and `error` the half width of the interval that holds the mean of all packings in 95
/// of 100 cases, over it. A seed of it is "mean of 5". Places that not all curves have are left out.
export function meansOverSeeds(curves) {
  const columns = ["quantity", "stage", "load", "boundary", "method", "part", ...sweptKeys.map(({path}) => path)
    .filter((path) => !seeds.includes(path))];
  const rows = curves.map((curve) => ({...curve.values, ...curve, curve}));
  return groupsOf(rows, columns).map((group) => meanOf(group.map(({curve}) => curve)));
}

/// The number of standard deviations of a mean of some numbers to which 95 % of Student's distribution reach.
function studentFactor(count) {
  const factors = [12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26];
  return factors[count - 2] ?? 2.2;
}

function meanOf(curves) {
  if (curves.length === 1) return curves[0];
  const [{at, modulusAt, ...first}] = curves;
  const valuesAt = (place) => curves.map(({x, y}) => y[x.findIndex((one) => Math.abs(one / place - 1) < 1e-9)]);
  const common = first.x.filter((place) => !valuesAt(place).includes(undefined));
  const y = [], band = [], error = [];
  for (const place of common) {
    const values = valuesAt(place);
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
    y.push(mean);
    band.push(Math.sqrt(squares / (curves.length - 1)));
    error.push(studentFactor(curves.length) * band.at(-1) / Math.sqrt(curves.length) / mean);
  }
  const ofMean = Object.fromEntries(seeds.map((path) => [path, `mean of ${curves.length}`]));
  return {...first, values: {...first.values, ...ofMean}, x: common, y, band, error,
    packings: curves.length};
}
