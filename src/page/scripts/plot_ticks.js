/// The ticks of figures drawn by Plotly. An axis of a layout that has `textOf` (the text of a value) or `scale` (the
/// size of its unit) gets the ticks of ticks.js, any other those of Plotly.

import {currentInks} from "./colours.js";
import {evenTicks, logarithmicTicks} from "./ticks.js";

/// The settings of Plotly for the ticks of an axis. The ends of the axis are in its own coordinates, on a logarithmic
/// axis powers of ten. Ticks without a text become small ones.
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

/// A layout with the ticks of its axes filled in.
export function withTicks(layout) {
  const axes = Object.entries(layout).filter(([name, axis]) => /^[xy]axis\d*$/.test(name) && hasOwnTicks(axis));
  const complete = axes.map(([name, {textOf, scale, tickCount, ...axis}]) =>
    [name, {...axis, ...tickSettings({...axis, textOf, scale, tickCount}, axis.range)}]);
  return {...layout, ...Object.fromEntries(complete)};
}

function hasOwnTicks(axis) {
  return axis.textOf !== undefined || axis.scale !== undefined;
}

/// Gives the axes of a plot new ticks after the reader has zoomed or moved it.
export function followZoom(plot, layout) {
  const changes = {};
  for (const [name, axis] of Object.entries(layout)) {
    const range = plot.layout[name]?.range;
    if (!/^[xy]axis\d*$/.test(name) || !hasOwnTicks(axis) || range === undefined) continue;
    const {tickvals, ticktext, minor} = tickSettings(axis, [...range].sort((a, b) => a - b));
    if (JSON.stringify(tickvals) === JSON.stringify(plot.layout[name].tickvals)) continue;
    Object.assign(changes, {[`${name}.tickvals`]: tickvals, [`${name}.ticktext`]: ticktext,
      [`${name}.minor.tickvals`]: minor.tickvals});
  }
  return Object.keys(changes).length === 0 ? Promise.resolve() : Plotly.relayout(plot, changes);
}
