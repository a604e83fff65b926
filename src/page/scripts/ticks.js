/// Units and ticks of axes. Each tick can be read by itself: "1 ms" and "10 ms" on a time axis, 0.40 and 0.42 on one of
/// fractions; on an axis of moduli all numbers have the unit in the title. (The plotting library would write 1m, 400m
/// and 10M.)

import {display, minus, prefixes, shortNumber} from "./numbers.js";
import {extent} from "./sampling.js";

/// The unit with the SI prefix that suits the values of an axis: {unit, scale}, value / scale being the number of these
/// units. `unit` is "Pa", "1/Pa" or "s"; any other takes no prefix.
export function unitFor(unit, values) {
  const sizes = values.map(Math.abs).filter((value) => value > 0 && Number.isFinite(value));
  const [least, most] = extent(sizes.map(Math.log10));
  // On an axis of many decades the unit is chosen for the upper ones.
  const typical = 10 ** Math.max((least + most) / 2, most - 4);
  const fitting = (size) => prefixes.find(([scale]) => scale <= size * (1 + 1e-9)) ?? prefixes.at(-1);
  if (sizes.length === 0 || !["Pa", "1/Pa", "s"].includes(unit)) return {unit, scale: 1};
  if (unit === "1/Pa") {
    const [scale, prefix] = fitting(1 / typical);
    return {unit: `1/${prefix}Pa`, scale: 1 / scale};
  }
  const [scale, prefix] = fitting(unit === "s" ? 10 ** most : typical);
  return {unit: prefix + unit, scale};
}

/// A quantity with the unit that suits it, such as "2.3 1/GPa": in 1/Pa the prefix is that of the pascal.
export function withUnit(value, unit) {
  if (unit !== "1/Pa" || !(value > 0 && Number.isFinite(value))) return display(value, unit);
  const rounded = Number(value.toPrecision(3));
  const [scale, prefix] = prefixes.filter(([size]) => rounded * size >= 1 - 1e-9).at(-1) ?? prefixes[0];
  return `${shortNumber(rounded * scale)} 1/${prefix}Pa`;
}

/// About `count` round numbers between two numbers, [{at, text}], all with the decimals that their step needs.
export function evenTicks(first, last, count) {
  const raw = (last - first) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((size) => size * power).find((size) => size >= raw * (1 - 1e-9));
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const ticks = [];
  for (let i = Math.ceil(first / step - 1e-9); i <= last / step + 1e-9; ++i) {
    ticks.push({at: i * step, text: minus((i * step).toFixed(decimals).replace(/^-(0\.?0*)$/, "$1"))});
  }
  return ticks;
}

/// Ticks of a logarithmic axis from 10^first to 10^last, [{at, text}]. `count` is the number of texts that fit; the
/// other ticks have an empty text.
export function logarithmicTicks(first, last, count, textOf) {
  const decades = last - first;
  if (decades < 0.5) return evenTicks(10 ** first, 10 ** last, count).map(({at}) => ({at, text: textOf(at)}));
  const step = Math.ceil(decades / count);
  const labelled = decades < 1.1 ? [1, 2, 3, 5, 7] : decades < 0.4 * count ? [1, 2, 5] : [1];
  const ticks = [];
  for (let power = Math.floor(first); power <= last; ++power) {
    for (const digit of step > 1 ? [1] : [1, 2, 3, 4, 5, 6, 7, 8, 9]) {
      const at = digit * 10 ** power;
      if (Math.log10(at) < first - 1e-9 || Math.log10(at) > last + 1e-9) continue;
      const hasText = labelled.includes(digit) && power % step === 0;
      ticks.push({at, text: hasText ? textOf(at) : ""});
    }
  }
  return ticks;
}
