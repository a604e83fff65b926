/// The section that predicts G(t) and G* with another temperature, another spectrum or other moduli of one material.

import {complexCurves, inHertz} from "./complex_curves.js";
import {complexOf} from "./complex_moduli.js";
import {materialsInUse} from "./curves.js";
import {colourOf, isOfBestGrid, lineOf} from "./curve_style.js";
import {data, study} from "./data.js";
import {chooser, element} from "./elements.js";
import {drawFigure, layoutOf, saveFigure, tracesOf} from "./figure.js";
import {csvOf, fileName, save} from "./files.js";
import {fitted, freeNumbers, misfitText} from "./live_fit.js";
import {liveChoices, showSpectrum, spectrumButtons} from "./material_choice.js";
import {axes, instantText, quantities} from "./names.js";
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
  const offered = quantities.filter(({name}) => shownQuantities.includes(name));
  let quantity = offered.find(({name}) => name === (study.frequencies_Hz === undefined ? "shear" : "dynamic"));
  const state = {material: candidates[0], spectrum: undefined, bulk: undefined, pasted: undefined,
    decades: 0};
  let results = [];

  const curvesOfRun = (result, name) => curves.filter((curve) => curve.role === "stage" && curve.quantity === name &&
    ["stage", "load", "boundary"].every((key) => curve[key] === result[key]) &&
    (curve.method ?? "quasistatic") === "quasistatic" && isOfBestGrid(curve));
  const curveOfRun = (result) => curvesOfRun(result, "shear")[0];
  const measuredCurves = () => curves.filter((curve) => curve.role === "measured" && curve.quantity === quantity.name &&
    results.some(({stage}) => stage === curve.stage));

  /// The curves to draw and their quantity, over time or over the frequency in Hz.
  const onAxis = (some) => (quantity.x === "time" ? some : inHertz(some));
  const shownQuantity = () => (quantity.x === "time" ? quantity : {...quantity, ...axes.frequency});
  const liveCurves = () => curvesOfResults(results).filter((curve) => curve.quantity === quantity.name);

  const draw = () => {
    const shown = shownQuantity(), live = onAxis(liveCurves()), measured = onAxis(measuredCurves());
    const ofRun = onAxis(results.flatMap((result) => curvesOfRun(result, quantity.name)));
    const traces = live.flatMap((curve) => tracesOf(curve, shown, {color: colourOf(curve),
      dash: curve.part === "loss" ? "dash" : "solid"}));
    traces.push(...ofRun.flatMap(({band, ...curve}) => tracesOf({...curve, label: `${curve.label}, of the run`}, shown,
      {color: colourOf(curve), dash: "dot", width: 1.3}).map((trace) => ({...trace, showlegend: false}))));
    traces.push(...measured.flatMap((curve) => tracesOf(curve, shown, lineOf(curve), "markers")));
    return drawFigure(plot, traces, layoutOf(shown, [...live, ...ofRun, ...measured]));
  };

  const resultsWith = (changed) => respond(study, data.responses, Object.fromEntries(study.materials.map((material) =>
    [material.name, material.name === changed.material.name ? changedMaterial(changed) : material])));
  /// What was measured of G, over time or over frequency as the study has it, and the predicted curves of that.
  const fittedQuantity = study.frequencies_Hz === undefined ? "shear" : "dynamic";
  const measuredModuli = curves.filter((curve) => curve.role === "measured" && curve.quantity === fittedQuantity);
  const predictedModuli = (some) => curvesOfResults(some).filter((curve) => curve.quantity === fittedQuantity);

  const compute = () => {
    results = resultsWith(state);
    showRefusals(results);
    const misfit = misfitText(predictedModuli(results), measuredModuli);
    document.getElementById("live-misfit").textContent = misfit === "" ? "" : `Deviation from what was measured: ${misfit}.`;
    fitButton.textContent = `Fit ${state.material.name} to what was measured`;
    fitButton.hidden = misfit === "" || freeNumbers(state) === undefined;
    return draw();
  };
  const fit = () => {
    const numbers = freeNumbers(state);
    const found = fitted(numbers, (material) => predictedModuli(resultsWith({...state, ...material})), measuredModuli);
    if (found !== undefined) {
      Object.assign(state, {spectrum: found.spectrum, bulk: found.bulk});
      showSpectrum(found.spectrum);
      compute();
    }
    document.getElementById("live-misfit").append(found === undefined ? " Too few measured points are within the curves to fit."
      : ` Fitted: ${found.text}. breccia calibrate finds such numbers with their intervals.`);
  };

  const fitButton = element("button", {id: "fit-measured", onclick: fit});

  const name = () => `${study.title} live`;
  document.getElementById("live-buttons").append(
    element("button", {onclick: () => save(fileName(name(), "csv"), csvOf(onAxis(liveCurves()), shownQuantity()),
      "text/csv")}, "These curves as CSV"),
    element("button", {onclick: () => saveFigure(plot, name(), draw)}, "This figure as SVG"), fitButton);
  const select = chooser("live-quantity", "quantity", offered.map((one) => [one, one.title]), (chosen) => {
    quantity = chosen;
    draw();
  });
  select.selectedIndex = offered.indexOf(quantity);
  document.getElementById("live-choices").append(...liveChoices(candidates, state, compute), select);
  spectrumButtons(state, compute);
  compute();
  showAgreement(results, curveOfRun, curves.filter((curve) => curve.role === "measured" &&
    shownQuantities.includes(curve.quantity)));
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

/// The quantities that the figure can show.
const shownQuantities = ["shear", "dynamic", "absolute", "phase", "loss-factor"];

/// The predicted curves of all of these quantities.
function curvesOfResults(results) {
  return results.flatMap((result) => {
    const [begin, end] = result.window;
    if (!(begin < end)) return [];
    const common = {role: "stage", stage: result.stage, boundary: result.boundary, load: result.load,
      label: `${result.stage}, ${result.boundary}`};
    const x = logarithmic(begin, end, 20);
    return [{...common, quantity: "shear", x, y: x.map((t) => result.modulus(t))},
      ...complexCurves(common, [1 / end, 1 / begin], (omega) => {
        const {storage, loss} = result.complexModulus(omega);
        return complexOf(storage, loss);
      })];
  });
}

/// A text on the way to results beyond the moduli that the run has sampled.
function remedyForRefusals() {
  const ranges = study.stages.flatMap((stage) => stage.tests.map((test) => test.range));
  return ranges.includes("times") ? 'run the study with tests.quasistatic.range = "matrix", the default'
    : "run a study with that material";
}

/// "from 1 ms to 1 s", or the frequencies that belong to these times.
function windowText([begin, end]) {
  const ends = study.frequencies_Hz === undefined ? [begin, end] : [end, begin];
  return `from ${instantText(study, ends[0], 2)} to ${instantText(study, ends[1], 2)}`;
}

function showRefusals(results) {
  const list = document.getElementById("live-refusals");
  const isCut = ({window: [begin, end]}) => begin > study.times_s[0] || end < study.times_s[1];
  const texts = results.filter((result) => result.refusal !== undefined || isCut(result)).map((result) => {
    const [begin, end] = result.window;
    const left = begin < end ? `shown ${windowText(result.window)} only` : "not shown";
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
function showAgreement(results, curveOfRun, measured) {
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
  const isMeasured = results.some((result) => measured.some(({stage}) => stage === result.stage));
  note.textContent = `${isMeasured ? "Points: measured. " : ""}Dotted: the run itself. With its own materials the page gives the curves of the run within ` +
    `${percent(worst)}.`;
}
