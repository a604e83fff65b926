"use strict";

/// Ticks that can be read alone: "1 ms", "10 ms" along an axis of time, 0.40, 0.42 along one of fractions, and numbers in
/// one unit, which the title tells, along one of moduli. The library would write 1m, 400m and 10M.

/// The unit for values of a quantity: {unit, scale}; a value over the scale is a number of units.
function unitFor(unit, values) {
  const sizes = values.map(Math.abs).filter((value) => value > 0 && Number.isFinite(value));
  const [least, most] = extent(sizes.map(Math.log10));
  // Of many decades the upper ones are read.
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

/// Round numbers from one number to another, some `count` of them, all with as many decimals as their step has.
function evenTicks(first, last, count) {
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

/// Ticks of a logarithmic axis between two powers of ten, those between the decades without a text where there is no room.
function logarithmicTicks(first, last, count, textOf) {
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

/// What Plotly takes for an axis between two ends, in the coordinates of the axis: tick marks, small ones without text.
function tickSettings(axis, [first, last]) {
  const count = axis.tickCount ?? 6;
  const scale = axis.scale ?? 1;
  const ticks = axis.type === "log" ? logarithmicTicks(first, last, count, axis.textOf)
    : evenTicks(first / scale, last / scale, count).map(({at, text}) => ({at: at * scale, text}));
  const labelled = ticks.filter(({text}) => text !== "");
  return {
    tickmode: "array", tickvals: labelled.map(({at}) => at), ticktext: labelled.map(({text}) => text),
    minor: {tickmode: "array", tickvals: ticks.filter(({text}) => text === "").map(({at}) => at), ticks: "outside",
      ticklen: 3, tickcolor: currentInks().line, showgrid: false},
  };
}

/// The same layout with ticks for the axes that say how theirs are written (`textOf` or `scale`).
function withTicks(layout) {
  const axes = Object.entries(layout).filter(([name, axis]) => /^[xy]axis\d*$/.test(name) && isOurs(axis));
  const told = axes.map(([name, {textOf, scale, tickCount, ...axis}]) =>
    [name, {...axis, ...tickSettings({...axis, textOf, scale, tickCount}, axis.range)}]);
  return {...layout, ...Object.fromEntries(told)};
}

function isOurs(axis) {
  return axis.textOf !== undefined || axis.scale !== undefined;
}

/// Gives the axes of a plot new ticks where its reader has zoomed or moved.
function followZoom(plot, layout) {
  const changes = {};
  for (const [name, axis] of Object.entries(layout)) {
    const range = plot.layout[name]?.range;
    if (!/^[xy]axis\d*$/.test(name) || !isOurs(axis) || range === undefined) continue;
    const {tickvals, ticktext, minor} = tickSettings(axis, [...range].sort((a, b) => a - b));
    if (JSON.stringify(tickvals) === JSON.stringify(plot.layout[name].tickvals)) continue;
    Object.assign(changes, {[`${name}.tickvals`]: tickvals, [`${name}.ticktext`]: ticktext,
      [`${name}.minor.tickvals`]: minor.tickvals});
  }
  return Object.keys(changes).length === 0 ? Promise.resolve() : Plotly.relayout(plot, changes);
}
