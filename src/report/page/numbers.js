"use strict";

const prefixes = [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"],
  [1e-12, "p"], [1e-15, "f"]];

/// A number as people write it: display(1.234e-6, "s") is "1.23 µs". Nobody speaks of kiloseconds: "1000 s", "2·10⁶ s".
function display(value, unit, digits = 3) {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "–";
  if (value === 0) return `0 ${unit}`;
  const rounded = Number(value.toPrecision(digits));
  if (unit === "s" && Math.abs(rounded) >= 1000) return `${shortNumber(rounded, digits)} s`;
  const fitting = prefixes.find(([size]) => Math.abs(rounded) >= size * (1 - 1e-12));
  if (fitting === undefined) return `${shortNumber(rounded, digits)} ${unit}`;
  const [scale, prefix] = fitting;
  return `${minus(Number((rounded / scale).toPrecision(digits)))} ${prefix}${unit}`;
}

/// How long a calculation has taken: "2.4 s", "50 min".
function duration(seconds) {
  const unit = [["h", 3600], ["min", 60]].find(([, size]) => seconds >= 2 * size);
  return unit === undefined ? display(seconds, "s") : `${Number((seconds / unit[1]).toPrecision(3))} ${unit[0]}`;
}

/// A number with a minus sign in the place of a hyphen.
function minus(number) {
  return String(number).replace("-", "−");
}

/// "1.23 %"; small shares as powers of ten.
function percent(share) {
  if (share === null || share === undefined) return "";
  const value = 100 * share;
  return `${Math.abs(value) < 1e-3 ? shortNumber(value, 1) : minus(Number(value.toPrecision(2)))} %`;
}

/// To three digits: "0.0103", "1.03·10⁵".
function shortNumber(value, digits = 3) {
  const isPlain = value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e5);
  if (isPlain) return minus(Number(value.toPrecision(digits)));
  const [factor, power] = value.toExponential(digits - 1).split("e");
  const superscript = [...String(Number(power))].map((sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]).join("");
  return Number(factor) === 1 ? `10${superscript}` : `${minus(Number(factor))}·10${superscript}`;
}

/// The smallest and the largest of any number of finite values; [0, 1] of none.
function extent(values) {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return least <= most ? [least, most] : [0, 1];
}

/// Rising numbers from one to another, evenly spaced in their logarithms.
function logarithmic(first, last, perDecade) {
  const count = Math.max(1, Math.ceil(perDecade * Math.log10(last / first)));
  return Array.from({length: count + 1}, (_, i) => first * Math.pow(last / first, i / count));
}

/// Whole powers of ten within two positive numbers.
function decades(first, last) {
  const rounding = 1e-9;
  const list = [];
  for (let k = Math.ceil(Math.log10(first) - rounding); k <= Math.log10(last) + rounding; ++k) list.push(10 ** k);
  return list;
}

/// The value of a curve at a time, a power of time between its samples; NaN outside of them.
function valueAt(times, values, time) {
  const rounding = 1e-9;
  if (time < times[0] * (1 - rounding) || time > times.at(-1) * (1 + rounding)) return NaN;
  const right = Math.max(1, times.findIndex((t) => t >= time * (1 - rounding)));
  const share = Math.log(time / times[right - 1]) / Math.log(times[right] / times[right - 1]);
  return values[right - 1] * Math.pow(values[right] / values[right - 1], share);
}
