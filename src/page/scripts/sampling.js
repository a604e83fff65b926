/// Sampled curves and the numbers along a logarithmic axis.

/// The smallest and the largest of the finite values of a list; [0, 1] if there are none.
export function extent(values) {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return least <= most ? [least, most] : [0, 1];
}

/// Numbers from first to last, both included, evenly spaced in their logarithms, at least `perDecade` in a decade.
export function logarithmic(first, last, perDecade) {
  const count = Math.max(1, Math.ceil(perDecade * Math.log10(last / first)));
  return Array.from({length: count + 1}, (_, i) => first * Math.pow(last / first, i / count));
}

/// The whole powers of ten between two positive numbers, both included.
export function decades(first, last) {
  const rounding = 1e-9;
  const list = [];
  for (let k = Math.ceil(Math.log10(first) - rounding); k <= Math.log10(last) + rounding; ++k) list.push(10 ** k);
  return list;
}

/// The value of a sampled curve at a time: between two samples it is a power of time, or linear in its logarithm where one
/// of them is not positive; outside of the samples it is NaN.
export function valueAt(times, values, time) {
  const rounding = 1e-9;
  if (time < times[0] * (1 - rounding) || time > times.at(-1) * (1 + rounding)) return NaN;
  if (times.length === 1) return values[0];
  const right = Math.max(1, times.findIndex((t) => t >= time * (1 - rounding)));
  const share = Math.log(time / times[right - 1]) / Math.log(times[right] / times[right - 1]);
  const [before, after] = [values[right - 1], values[right]];
  return before > 0 && after > 0 ? before * Math.pow(after / before, share) : before + share * (after - before);
}

/// The smallest and the largest ratio of a curve to a measured one, at the times of both; undefined if there are
/// none.
export function ratioRange(curve, measured) {
  const ratios = measured.x.map((time, i) => valueAt(curve.x, curve.y, time) / measured.y[i]).filter(Number.isFinite);
  return ratios.length === 0 ? undefined : [Math.min(...ratios), Math.max(...ratios)];
}
