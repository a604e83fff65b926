/// Names of curves at their ends, instead of a legend.

import {currentInks} from "./colours.js";
import {isNarrow, plotText} from "./figure.js";

const lineHeight = 1.25;  // of the letters

/// Breaks a text into lines of about this many letters.
function inLines(text, most) {
  const lines = [""];
  for (const word of text.split(" ")) {
    const longer = `${lines.at(-1)} ${word}`.trim();
    if (lines.at(-1) !== "" && longer.length > most) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines;
}

/// Places labels, {at, height}, from the top so that none covers another and none leaves [0, room], all in pixels:
/// {at} are their middles, as near to the wanted ones as that allows.
export function parted(labels, room) {
  const placed = labels.map((label, i) => ({...label, i})).sort((one, other) => one.at - other.at);
  let edge = 0;
  for (const label of placed) {
    label.at = Math.max(label.at, edge + label.height / 2);
    edge = label.at + label.height / 2;
  }
  edge = room;
  for (const label of placed.reverse()) {
    label.at = Math.min(label.at, edge - label.height / 2);
    edge = label.at - label.height / 2;
  }
  return placed.sort((one, other) => one.i - other.i).map(({at}) => at);
}

/// Adds to a layout the names of curves, [{text, color, x, y}] with the coordinates of their ends, to the right of
/// them, and removes the legend. `height` is that of the plot [pixels].
export function addEndLabels(layout, labels, height) {
  const narrow = isNarrow();
  const size = narrow ? 10 : 12;
  const lettersOfLine = narrow ? 13 : 22;
  layout.showlegend = false;
  layout.margin.r = narrow ? 80 : 150;
  const onAxis = ({type}, value) => type === "log" ? Math.log10(value) : value;
  const [least, most] = layout.yaxis.range;
  const room = height - layout.margin.t - layout.margin.b;
  const lines = labels.map(({text}) => inLines(text, lettersOfLine));
  const wanted = labels.map(({y}, i) => ({height: lineHeight * size * lines[i].length,
    at: room * (most - onAxis(layout.yaxis, y)) / (most - least)}));
  parted(wanted, room).forEach((at, i) => layout.annotations.push({
    xref: "x", yref: "y", x: onAxis(layout.xaxis, labels[i].x), y: onAxis(layout.yaxis, labels[i].y),
    xanchor: "left", yanchor: "middle", xshift: 6, yshift: wanted[i].at - at, align: "left", showarrow: false,
    text: lines[i].map(plotText).join("<br>"), font: {size, color: labels[i].color ?? currentInks().ink}}));
}
