/// The figure with the modulus at one time or frequency against a swept key that holds numbers.

import {currentInks} from "./colours.js";
import {sweep} from "./data.js";
import {chooser, element} from "./elements.js";
import {axisTitle, drawFigure, layoutOf, plotText, saveFigure, valueText} from "./figure.js";
import {display, shortNumber} from "./numbers.js";
import {extent, valueAt} from "./sampling.js";
import {sweptKeys} from "./sweep_curves.js";
import {labelOfSweepCurve, lineOfSweepCurve, shownMeasurements, sweepContents} from "./sweep_figure.js";

/// Fills the section and returns the function that draws the figure.
export function keyFigure(curves, choice) {
  // The number of a seed means nothing.
  const keys = sweptKeys.filter((key) => key.numbers !== undefined && key.values.length > 1 && !key.isSeed);
  document.getElementById("key").hidden = keys.length === 0;
  if (keys.length === 0) return () => {};
  const plot = document.getElementById("key-plot");
  // The place of the slider, from the first to the last time or frequency of the shown quantity.
  const shown = {key: keys.at(-1), share: 1};
  const placeOf = ({name}) => {
    const [begin, end] = extent(curves.filter((curve) => curve.quantity === name)
      .flatMap(({x}) => [x[0], x.at(-1)]));
    return begin * Math.pow(end / begin, shown.share);
  };

  const draw = () => {
    const [seen, quantity] = sweepContents(curves, choice);
    const place = placeOf(quantity);
    const lines = [...linesAgainst(shown.key, place, seen, choice),
      ...measuredLevels(shown.key, place, shownMeasurements(seen, choice))];
    const layout = layoutOf({...quantity, xUnit: shown.key.unit, x: shown.key.label}, lines);
    const text = (curve, i) => {
      const value = valueText(curve.y[i], quantity);
      return curve.isLevel ? value : `${shown.key.label} ${shown.key.values[curve.indices[i]]}: ${value}`;
    };
    const spread = Math.max(...shown.key.numbers) / Math.min(...shown.key.numbers);
    const {textOf, ...xaxis} = layout.xaxis;
    layout.xaxis = {...xaxis, ...keyAxis(shown.key, spread)};
    layout.hovermode = "closest";
    document.getElementById("key-time").textContent = `at ${display(place, quantity.xUnit, 3)}`;
    return drawFigure(plot, lines.map((curve) => ({x: curve.x, y: curve.y, type: "scatter",
      mode: curve.isLevel ? "lines" : "lines+markers",
      name: plotText(curve.label), text: curve.x.map((_, i) => text(curve, i)), hovertemplate: "%{text}",
      line: {width: 2, ...curve.line}, marker: {size: 7}})), layout);
  };

  const slider = element("input", {type: "range", id: "key-slider", ariaLabel: "time or frequency", min: 0, max: 200,
    value: 200, oninput: () => {
      shown.share = slider.value / 200;
      draw();
    }});
  if (keys.length > 1) {
    const select = chooser("key-choice", "key", keys.map((key) => [key, `against ${key.label}`]), (key) => {
      shown.key = key;
      draw();
    });
    select.selectedIndex = keys.length - 1;
    document.getElementById("key-choices").append(select);
  }
  document.getElementById("key-choices").append(slider, element("span", {id: "key-time"}));
  document.getElementById("key-buttons").append(element("button", {onclick: () =>
    saveFigure(plot, `${sweep.title} against ${shown.key.label}`, draw)}, "This figure as SVG"));
  return draw;
}

/// The axis of a key: logarithmic if its values are positive and span a factor of eight or more.
function keyAxis(key, spread) {
  const hasOrigin = !/^(deg|°)/.test(key.unit ?? "");
  const isLogarithmic = hasOrigin && Math.min(...key.numbers) > 0 && spread >= 8;
  const ends = [Math.min(...key.numbers), Math.max(...key.numbers)];
  const title = axisTitle(key.label, key.unit);
  if (isLogarithmic) {
    const room = 0.05 * Math.log10(spread);
    return {type: "log", title, range: [Math.log10(ends[0]) - room, Math.log10(ends[1]) + room], tickvals: key.numbers,
      ticktext: key.numbers.map((number) => shortNumber(number))};
  }
  const room = 0.05 * (ends[1] - ends[0]);
  return {type: "linear", title, range: [ends[0] - room, ends[1] + room], scale: 1};
}

/// The measured values at a time, as level lines over the values of the key.
function measuredLevels(key, time, measured) {
  const x = extent(key.numbers);
  return measured.map((curve) => ({curve, value: valueAt(curve.x, curve.y, time)}))
    .filter(({value}) => Number.isFinite(value))
    .map(({curve: {label, part}, value}) => ({label, isLevel: true, x, y: [value, value],
      line: {color: currentInks().ink, dash: part === "loss" ? "dashdot" : "dot"}}));
}

/// A line through all shown curves that differ in the key alone; `indices` are those of the values of the key.
export function linesAgainst(key, time, seen, choice) {
  const others = choice.dimensions.filter(({name}) => name !== key.path);
  const groups = new Map();
  for (const curve of seen) {
    const value = valueAt(curve.x, curve.y, time);
    const direct = curve.y[curve.x.findIndex((x) => Math.abs(x / time - 1) < 1e-6)];
    const y = direct ?? value;
    if (!Number.isFinite(y)) continue;
    const name = [curve.part, ...others.map((one) => one.of(curve))].join("|");
    if (!groups.has(name)) groups.set(name, {curve, points: []});
    const index = key.values.indexOf(curve.values[key.path]);
    groups.get(name).points.push([key.numbers[index], y, index]);
  }
  return [...groups.values()].map(({curve, points}) => {
    points.sort(([a], [b]) => a - b);
    const label = labelOfSweepCurve(curve, others, choice.values);
    const coloured = choice.coloured?.name === key.path ? {color: undefined} : {};
    return {label, x: points.map(([x]) => x), y: points.map(([, y]) => y), indices: points.map(([, , index]) => index),
      line: {...lineOfSweepCurve(curve, choice), ...coloured}};
  });
}
