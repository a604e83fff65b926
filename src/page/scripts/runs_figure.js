/// The figure with the whole history of every run of a dynamic test: the ringing at its beginning, and the times at
/// which it is valid.

import {currentInks, isDark} from "./colours.js";
import {data, study} from "./data.js";
import {element} from "./elements.js";
import {drawFigure, layoutOf, linearAxis, saveFigure, tracesOf} from "./figure.js";
import {gridName, nameOfTest, quantities} from "./names.js";
import {shortNumber} from "./numbers.js";
import {own} from "./records.js";
import {extent} from "./sampling.js";
import {shareOfLoad} from "./strain_ramp.js";

/// Fills the section and returns the function that draws the figure.
export function runsFigure(curves) {
  const tests = study.stages.flatMap((stage) => stage.tests.map((test) => ({stage, test, runs: runsOf(stage, test)})))
    .filter(({runs}) => runs.length > 0);
  document.getElementById("runs").hidden = tests.length === 0;
  if (tests.length === 0) return () => {};
  const plot = document.getElementById("runs-plot");
  const shown = {of: tests[0], isLogarithmic: tests[0].runs.length > 1};

  const quantityOf = ({test}) => quantities.find(({name}) => name ===
    (test.boundary === "traction" ? "compliance" : test.load === "bulk" ? "bulk" : "shear"));

  const draw = () => {
    const quantity = quantityOf(shown.of);
    const lines = shown.of.runs.flatMap((run, i) => linesOf(run, colourOfRun(i, shown.of.runs.length)));
    const {stage, test} = shown.of;
    const beside = curves.find((curve) => curve.quantity === quantity.name && curve.stage === stage.name &&
      curve.load === test.load && curve.boundary === test.boundary && curve.method === "quasistatic" &&
      curve.cells === String(test.cells));
    if (beside !== undefined) {
      lines.push({x: beside.x, y: beside.y, label: "quasi-static", line: {color: currentInks().ink, dash: "dot"}});
    }
    const isSeen = ({x}) => !shown.isLogarithmic || x > 0;
    const seen = lines.map((curve) => {
      const kept = curve.x.map((x, i) => ({x, y: curve.y[i]})).filter(isSeen);
      return {...curve, x: kept.map(({x}) => x), y: kept.map(({y}) => y)};
    });
    const layout = shown.isLogarithmic ? layoutOf(quantity, seen) : linearLayout(quantity, seen);
    const traces = seen.flatMap((curve) => tracesOf(curve, quantity, curve.line).map((trace) =>
      ({...trace, showlegend: curve.isNamed ?? true})));
    if (!shown.isLogarithmic) traces.push(loadTrace(shown.of));
    return drawFigure(plot, traces, layout);
  };

  const nameOf = ({stage, test}) => nameOfTest(stage, test).concat(gridName(test.cells)).join(", ");
  const select = element("select", {id: "runs-test", ariaLabel: "test", onchange: () => {
    shown.of = tests.find((one) => nameOf(one) === select.value);
    draw();
  }}, ...tests.map((one) => element("option", {value: nameOf(one)}, nameOf(one))));
  const axis = element("select", {id: "runs-axis", ariaLabel: "time axis", onchange: () => {
    shown.isLogarithmic = axis.value === "logarithmic";
    draw();
  }}, element("option", {value: "logarithmic"}, "logarithmic time"),
    element("option", {value: "linear"}, "linear time, with the load"));
  axis.value = shown.isLogarithmic ? "logarithmic" : "linear";
  document.getElementById("runs-choices").append(...(tests.length > 1 ? [select] : []), axis);
  document.getElementById("runs-buttons").append(element("button", {onclick: () =>
    saveFigure(plot, `${study.title} runs of ${nameOf(shown.of)}`, draw)}, "This figure as SVG"));
  return draw;
}

/// The runs of a test: their histories, and the entry of study.json for each.
function runsOf(stage, test) {
  if (test.time_domains === undefined) return [];
  return (own(data.histories, stage.name) ?? [])
    .filter((run) => run.load === test.load && run.boundary === test.boundary && run.cells === test.cells)
    .map((run) => ({...run, ...test.time_domains[run.domain]}));
}

function colourOfRun(i, count) {
  return `hsl(${count === 1 ? 205 : 250 - 225 * i / (count - 1)}, 75%, ${isDark() ? 62 : 42}%)`;
}

/// The curves of a run: a thin one of its whole history, a thick one of the times at which it is valid.
function linesOf(run, color) {
  const label = `ρ × ${shortNumber(run.density_factor)}`;
  const [begin, end] = run.valid_s;
  const within = run.time_s.map((t, i) => [t, run.value[i]]).filter(([t]) => t >= begin && t <= end);
  return [
    {x: run.time_s, y: run.value, label: `${label}, all of it`, isNamed: false, line: {color, width: 0.8}},
    {x: within.map(([t]) => t), y: within.map(([, y]) => y), label, line: {color, width: 2.4}},
  ];
}

/// The layout with a linear time axis: the load above, the response below.
function linearLayout(quantity, curves) {
  const layout = layoutOf(quantity, curves);
  const {tickCount, unifiedhovertitle} = layout.xaxis;
  const times = curves.flatMap((curve) => curve.x);
  return {...layout, uirevision: `${quantity.name} linear`,
    xaxis: {...linearAxis(quantity.x, quantity.xUnit, times), range: extent(times), tickCount, unifiedhovertitle},
    yaxis: {...linearAxis(quantity.title, quantity.unit, curves.flatMap((curve) => curve.y)), domain: [0, 0.7]},
    yaxis2: {...linearAxis("load applied", "", [1]), domain: [0.78, 1], tickCount: 2},
  };
}

/// The trace of the load over the ramp of the last run.
function loadTrace({runs}) {
  const {ramp_s: ramp, time_s: times} = runs.at(-1);
  const half = ramp / 2;
  const x = [Math.min(-half, times[0]), ...Array.from({length: 41}, (_, i) => half * (i / 20 - 1)), times.at(-1)];
  return {x, y: x.map((time) => shareOfLoad(time, ramp)), yaxis: "y2", mode: "lines", name: "load",
    showlegend: false, hoverinfo: "skip", line: {color: currentInks().ink, width: 1.6}};
}
