/// The section that predicts G(t) with another temperature, another spectrum or other moduli of one material.

import {bestGrid, materialsInUse} from "./curves.js";
import {colourOf} from "./curve_style.js";
import {data, study} from "./data.js";
import {element} from "./elements.js";
import {drawFigure, layoutOf, saveFigure, tracesOf} from "./figure.js";
import {csvOf, fileName, save} from "./files.js";
import {liveChoices, spectrumButtons} from "./material_choice.js";
import {quantities} from "./names.js";
import {display, percent} from "./numbers.js";
import {own} from "./records.js";
import {respond, sampledRange} from "./response.js";
import {logarithmic} from "./sampling.js";
import {shiftedSeries} from "./viscoelasticity.js";

/// Fills the section and returns the function that draws the figure.
export function liveFigure(curves) {
  const stages = Object.keys(data.responses);
  const candidates = varyingMaterials();
  if (stages.length === 0 || candidates.length === 0) return () => {};
  document.getElementById("live").hidden = false;
  const plot = document.getElementById("live-plot");
  const quantity = quantities[0];
  const state = {material: candidates[0], spectrum: undefined, bulk: undefined, decades: 0};
  let results = [];

  const curveOfRun = (result) => curves.find((curve) => curve.quantity === "shear" && curve.load === result.load &&
    curve.stage === result.stage && curve.boundary === result.boundary && curve.method === "quasistatic" &&
    curve.cells === bestGrid(curve.stage));

  const draw = () => {
    const liveCurves = curvesOfResults(results);
    const curvesOfRun = results.map(curveOfRun).filter((curve) => curve !== undefined);
    const traces = liveCurves.flatMap((curve) => tracesOf(curve, quantity, {color: colourOf(curve)}));
    traces.push(...curvesOfRun.flatMap(({band, ...curve}) => tracesOf({...curve, label: `${curve.label}, of the run`},
      quantity,
      {color: colourOf(curve), dash: "dot", width: 1.3}).map((trace) => ({...trace, showlegend: false}))));
    return drawFigure(plot, traces, layoutOf(quantity, [...liveCurves, ...curvesOfRun]));
  };

  const compute = () => {
    results = respond(study, data.responses, Object.fromEntries(study.materials.map((material) =>
      [material.name, material.name === state.material.name ? changedMaterial(state) : material])));
    showRefusals(results);
    return draw();
  };

  const name = () => `${study.title} live`;
  document.getElementById("live-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(curvesOfResults(results), quantity),
      "text/csv")}, "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"));
  document.getElementById("live-choices").append(...liveChoices(candidates, state, compute));
  spectrumButtons(state, compute);
  compute();
  showAgreement(results, curveOfRun);
  return draw;
}

/// The materials that the reader can change, those of the phases that vary: [{name, ..., ranges}]. `ranges` are the
/// moduli for which all boxes with a phase of the material can be used, as sampledRange() gives them.
function varyingMaterials() {
  const rangesOf = new Map();
  for (const stage of study.stages) {
    for (const response of own(data.responses, stage.name) ?? []) {
      const names = [stage.matrix, ...(response.phases ?? []).map(({material}) => material)];
      names.forEach((name, place) => {
        rangesOf.set(name, common(rangesOf.get(name), sampledRange(response, place)));
      });
    }
  }
  const ofMatrices = materialsInUse();
  const others = study.materials.filter((material) => rangesOf.has(material.name) && !ofMatrices.includes(material));
  return [...ofMatrices, ...others].map((material) => ({...material, ranges: rangesOf.get(material.name)}));
}

/// The moduli within two ranges {shear, bulk}; the first may be undefined.
function common(one, other) {
  if (one === undefined) return other;
  const both = (name) => [Math.max(one[name][0], other[name][0]), Math.min(one[name][1], other[name][1])];
  return {shear: both("shear"), bulk: both("bulk")};
}

/// The chosen material with its new spectrum and bulk modulus, all relaxation times multiplied by 10^decades.
function changedMaterial({material, spectrum, bulk, decades}) {
  const factor = Math.pow(10, decades);
  return {shear: shiftedSeries(spectrum ?? material.shear, factor), bulk: shiftedSeries(bulk ?? material.bulk, factor)};
}

function curvesOfResults(results) {
  return results.flatMap((result) => {
    const [begin, end] = result.window;
    if (!(begin < end)) return [];
    const x = logarithmic(begin, end, 20);
    return [{quantity: "shear", role: "stage", stage: result.stage, boundary: result.boundary, load: result.load,
      label: `${result.stage}, ${result.boundary}`, x, y: x.map((t) => result.modulus(t))}];
  });
}

/// A text on the way to results beyond the moduli that the run has sampled.
function remedyForRefusals() {
  const ranges = study.stages.flatMap((stage) => stage.tests.map((test) => test.range));
  return ranges.includes("times") ? 'run the study with tests.quasistatic.range = "matrix", the default'
    : "run a study with that material";
}

function showRefusals(results) {
  const list = document.getElementById("live-refusals");
  const isCut = ({window: [begin, end]}) => begin > study.times_s[0] || end < study.times_s[1];
  const texts = results.filter((result) => result.refusal !== undefined || isCut(result)).map((result) => {
    const [begin, end] = result.window;
    const left = begin < end ? `shown from ${display(begin, "s", 2)} to ${display(end, "s", 2)} only` : "not shown";
    if (result.refusal === undefined) {
      return `${result.stage}, ${result.boundary}: ${left}, as far as ${result.matrix} is known.`;
    }
    const {material, name, value, range, error} = result.refusal;
    if (error !== undefined) {
      return `${result.stage}, ${result.boundary}: ${left}. With these materials together the error of the ` +
        `reduced basis is about ${percent(error)}; ${remedyForRefusals()}.`;
    }
    return `${result.stage}, ${result.boundary}: ${left}. There ${material} would have a ${name} ` +
      `modulus of ${display(value, "Pa", 3)}, outside the range from ${display(range[0], "Pa", 3)} to ` +
      `${display(range[1], "Pa", 3)} in which the run has sampled the boxes; ${remedyForRefusals()}.`;
  });
  list.replaceChildren(...texts.map((text) => element("li", {}, text)));
  list.hidden = texts.length === 0;
}

/// Shows the largest relative difference between the prediction of the page for the matrices of the run and the run.
function showAgreement(results, curveOfRun) {
  let worst = 0;
  for (const result of results) {
    const curve = curveOfRun(result);
    curve?.x.forEach((t, i) => {
      if (t > result.window[1] || t < result.window[0]) return;
      worst = Math.max(worst, Math.abs(result.modulus(t) / curve.y[i] - 1));
    });
  }
  const note = document.getElementById("live-note");
  note.dataset.agreement = worst;
  note.textContent = `Dotted: the run itself. With its own materials the page gives the curves of the run within ` +
    `${percent(worst)}.`;
}
