/// The first screen of a study: the results, the warnings, and the moduli at whole decades.

import {complexColumns, complexModuli, complexOf, complexSentences, complexYoungsModuli, measuredColumns, measuredComplex,
  sentenceOnMeasuredComplex, showsError} from "./complex_moduli.js";
import {resultSentences, hasFlowedAway, sentenceOnMeasurement} from "./result_sentences.js";
import {bestGrid} from "./curves.js";
import {data, study} from "./data.js";
import {element} from "./elements.js";
import {mainLoad} from "./loads.js";
import {bulkSymbolOf, hasFilms, symbolOf, textOnStage} from "./names.js";
import {display, percent, shortNumber, unbroken, withMicroSign} from "./numbers.js";
import {own} from "./records.js";
import {onAnisotropy, nextStep, onFilms, onMeasuringGrids, onSpace} from "./reliability_sentences.js";
import {decades, valueAt} from "./sampling.js";
import {binderOf, matrixStageOf, stagesOfInterest} from "./stages.js";
import {table} from "./table.js";
import {lossModulus, relaxationModulus, storageModulus} from "./viscoelasticity.js";
import {groupsOfWarnings, lineOnGroup} from "./warnings.js";
import {sentenceOnWholeFiller} from "./whole_filler.js";

const softestFirst = ["traction", "periodic", "displacement"];

/// The relaxation moduli of a stage to be shown first: those of the best grid or, where the run has not reached it, of
/// the last one that it has; in shear or, where that was not tested, in bulk.
function testedCurves(curves, stage) {
  const ofStage = curves.filter((curve) => curve.role === "stage" && curve.stage === stage);
  const tested = ["shear", "bulk"].map((quantity) => ofStage.filter((curve) => curve.quantity === quantity))
    .find((some) => some.length > 0) ?? [];
  const best = tested.filter((curve) => curve.cells === bestGrid(stage));
  return best.length > 0 ? best : tested.filter((curve) => curve.cells === tested.at(-1).cells);
}

/// The curves of the last stage to be shown first, beginning with the softest boundary: those of the quasi-static method if
/// there are any, under the main load.
function curvesOfResult(curves) {
  const stage = stagesOfInterest(study).at(-1);
  const tested = stage === undefined ? [] : testedCurves(curves, stage.name);
  if (tested.length === 0) return [];
  const method = tested.some((curve) => curve.method === "quasistatic") ? "quasistatic" : "dynamic";
  const load = mainLoad(tested.map((curve) => curve.load));
  const of = (boundary) => tested.find((curve) => curve.load === load && curve.method === method &&
    curve.boundary === boundary);
  return softestFirst.map(of).filter((curve) => curve !== undefined);
}

/// The curves that answer: that of the periodic boundary, which comes nearest to the material, or else all.
function curvesOfAnswer(result) {
  const periodic = result.filter(({boundary}) => boundary === "periodic");
  return periodic.length > 0 ? periodic : result;
}

/// The curves that answer, and then the others.
function answersFirst(result) {
  return [...new Set([...curvesOfAnswer(result), ...result])];
}

/// The measured relaxation modulus of a stage, of a quantity: "shear" or "young".
function measuredBeside(curves, stage, quantity) {
  const found = curves.find((curve) => curve.role === "measured" && curve.stage === stage && curve.quantity === quantity);
  return found && {name: found.label.replace("measured, ", ""), x: found.x, y: found.y};
}

/// The complex Young's moduli under the boundaries of a result.
function youngsModuliOf(curves, result) {
  const boundaries = result.map(({boundary}) => boundary);
  return complexYoungsModuli(othersOf("young-dynamic", curves, result)).filter(({boundary}) => boundaries.includes(boundary));
}

/// The complex moduli {letter, moduli, relaxation, measured} that answer a study whose deck gives frequencies, with the
/// relaxation moduli that belong to them: those of E where E alone was measured, else those of G. No moduli for other
/// studies.
function complexAnswer(curves, result) {
  if (study.frequencies_Hz === undefined) return {moduli: []};
  const [{stage, load}] = result;
  const ofShear = load === "bulk" ? undefined : measuredComplex(curves, stage, "dynamic");
  const ofYoung = measuredComplex(curves, stage, "young-dynamic");
  const isShearMeasured = ofShear !== undefined || measuredBeside(curves, stage, "shear") !== undefined;
  const youngs = ofYoung === undefined || isShearMeasured ? [] : youngsModuliOf(curves, result);
  if (youngs.length === 0) return {letter: "G", moduli: complexModuli(curves, result), relaxation: result, measured: ofShear};
  const relaxation = othersOf("young", curves, result).filter(({boundary}) =>
    youngs.some((young) => young.boundary === boundary));
  return {letter: "E", moduli: youngs, relaxation, measured: ofYoung};
}

/// The sentences on the moduli of a study that was asked in frequency.
function sentencesInFrequency(curves, result, {letter, moduli, relaxation, measured}) {
  const [{stage, load}] = result;
  const error = letter === "G" ? textOnError(result, stage) : textOnErrorOfYoung(relaxation);
  const inTime = load === "bulk" ? undefined : measuredBeside(curves, stage, "shear");
  return [...complexSentences({stage: nameOfResult(stage), letter, moduli, result: relaxation, error,
    binder: letter === "G" ? complexBinder(stage) : undefined}),
  ...(measured !== undefined ? [sentenceOnMeasuredComplex(moduli, measured, letter)]
    : inTime === undefined ? [] : sentenceOnMeasurement(result, inTime))];
}

/// The sentences on Young's modulus beside what was measured of it, where the answer is another modulus.
function sentencesOnYoungsModulus(curves, result) {
  const measured = measuredComplex(curves, result[0].stage, "young-dynamic");
  if (study.frequencies_Hz !== undefined && measured !== undefined) {
    return [sentenceOnMeasuredComplex(youngsModuliOf(curves, result), measured, "E")];
  }
  return sentencesOnOther("young", "Young's modulus", curves, result);
}

/// The sentences on a relaxation modulus that was measured beside that of the result: "young" or "bulk".
function sentencesOnOther(quantity, name, curves, result) {
  const inTime = measuredBeside(curves, result[0].stage, quantity);
  return inTime === undefined ? [] : sentenceOnMeasurement(othersOf(quantity, curves, result), inTime, name);
}

function binderBeside(stage) {
  const binder = binderOf(study, stage);
  return binder && {name: binder.name, at: (time) => relaxationModulus(binder.shear, time)};
}

/// The complex modulus {at} of the binder of a stage over frequency in hertz; undefined where there is none.
function complexBinder(stage) {
  const binder = binderOf(study, stage);
  return binder && {at: (frequency) => complexOf(...[storageModulus, lossModulus].map((modulus) =>
    modulus(binder.shear, 2 * Math.PI * frequency)))};
}

/// A sentence on a run that has no relaxation modulus.
function textWithoutResult() {
  if (study.stages.length === 0) return "No stage is finished.";
  return study.stages.some(({tests}) => tests.length > 0) ? "No relaxation modulus was tested." : "Packed, not tested.";
}

/// A text on the error of curves: the causes of the whole one, or else what is known of that of the grid or of films.
function textOnError(result, stage) {
  if (result.every(hasWholeError)) return `± ${causesOfErrors(result)}`;
  const shares = result.flatMap(({error}) => error?.grid ?? []).filter(Number.isFinite);
  if (shares.length > 0 && gridsOf(stage).length > 1) return `± ${percent(Math.max(...shares))} by the grid`;
  const expected = expectedErrorOf(stage), ofFilms = hasFilms(stageOf(stage));
  if (expected === undefined) return `the ${ofFilms ? "error of the mesh" : "discretisation error"} is not known`;
  return `the ${ofFilms ? "model of films" : "grid"} may err by ${percent(expected)}`;
}

/// A text on the error of Young's moduli, which follows from those of G and K.
function textOnErrorOfYoung(relaxation) {
  if (!relaxation.every(hasWholeError)) return "the error of E is not known";
  return `± ${percent(Math.max(...relaxation.flatMap(({error}) => error.whole)))} by the errors of G and K`;
}

/// Whether the whole error of a curve is known at all of its times.
function hasWholeError({error}) {
  return error !== undefined && error.whole.every(Number.isFinite);
}

/// The largest errors of curves by their causes: "3.4 % by the grid, 7.9 % by the packing".
function causesOfErrors(result) {
  const ofFilms = hasFilms(stageOf(result[0].stage));
  const causes = {grid: ofFilms ? "model of films" : "grid", sample: "packing", matrix: "matrix", solver: "solver"};
  const least = 1e-3;  // the solver's error is smaller by default
  const largest = Object.entries(causes).map(([cause, name]) =>
    [Math.max(...result.flatMap(({error}) => error[cause])), name]);
  const shown = largest.filter(([share], i) => share >= least || i === 0);
  const about = (name) => (name === "packing" ? "about " : "");  // by a rule
  return shown.map(([share, name]) => `${about(name)}${percent(share)} by the ${name}`).join(", ");
}

/// The warnings of all stages, those of one kind together.
function groupsOfStudy() {
  const warnings = study.stages.flatMap((stage) => stage.warnings.map(withMicroSign));
  if (!study.complete) warnings.unshift("The run is not complete: this is what there is so far.");
  return groupsOfWarnings(warnings, study.stages.map(({name}) => name));
}

function loadsOf(stage) {
  return stageOf(stage).tests.map(({load}) => load);
}

function stageOf(wanted) {
  return study.stages.find(({name}) => name === wanted);
}

function gridsOf(stage) {
  return stageOf(stage).cells;
}

function qualityOf(stage) {
  return stageOf(stage).quality;
}

/// The largest error of one grid by a rule; undefined where there is none.
function expectedErrorOf(stage) {
  return qualityOf(stage)?.expected_grid_error ?? undefined;
}

/// The range of the rule for one grid, or what has no rule.
function ruleOf(stage) {
  return qualityOf(stage)?.grid_rule;
}

/// The name of a stage, with a remark if the run has not reached the end of its chain.
function nameOfResult(stage) {
  const last = (study.stage_names ?? []).at(-1);
  return last === undefined || study.complete || last === stage ? stage : `${stage}, a stage on the way to ${last},`;
}

/// Shows the title, the result, and how it was found.
export function showResult(curves) {
  document.getElementById("title").textContent = study.title;
  const result = curvesOfAnswer(curvesOfResult(curves));
  const place = document.getElementById("summary");
  if (result.length === 0) return place.append(element("p", {}, textWithoutResult()));
  const [{stage, load}] = result;
  const isShear = load !== "bulk";
  const inFrequency = complexAnswer(curves, result);
  const sentences = inFrequency.moduli.length > 0 ? sentencesInFrequency(curves, result, inFrequency)
    : resultSentences({stage: nameOfResult(stage), symbol: symbolOf(load, loadsOf(stage)), curves: result,
      error: textOnError(result, stage), binder: isShear ? binderBeside(stage) : undefined,
      measured: isShear ? measuredBeside(curves, stage, "shear") : undefined});
  if (inFrequency.letter !== "E") sentences.push(...sentencesOnYoungsModulus(curves, result));
  if (isShear) sentences.push(...sentencesOnOther("bulk", "the bulk modulus", curves, result));
  sentences.push(onSpace(study, stageOf(stage)));
  const [first, ...others] = sentences.filter((sentence) => sentence !== "");
  place.append(element("p", {id: "answer"}, element("strong", {}, unbroken(first)), ` ${unbroken(others.join(" "))}`));
  const next = nextStep(stageOf(stage));
  if (next !== "") place.append(element("p", {id: "next-step", className: "note"}, next));
}

/// Shows the warnings that the reader should see before using the results, a line for each kind, beside the first
/// figure.
export function showWarnings() {
  const groups = groupsOfStudy();
  const list = document.getElementById("warnings");
  document.querySelector(".first-look").prepend(list);
  list.append(...groups.map((group) => {
    const line = lineOnGroup(group);
    const isWhole = group.texts.length === 1 && line.endsWith(group.texts[0]);
    if (isWhole) return element("li", {}, line);
    return element("li", {}, element("details", {}, element("summary", {}, line),
      ...group.texts.map((text) => element("p", {}, text))));
  }));
  list.hidden = groups.length === 0;
  const whole = document.getElementById("all-warnings");
  whole.append(...groups.flatMap(({texts}) => texts).map((text) => element("li", {}, text)));
  whole.parentElement.hidden = groups.length === 0;
}

/// Shows the microstructure of the last stage beside the figure.
export function showResultPicture() {
  const stage = stagesOfInterest(study).at(-1);
  const svg = stage === undefined ? undefined : own(data.pictures, stage.name);
  const place = document.getElementById("result-picture");
  place.hidden = svg === undefined;
  if (svg === undefined) return;
  const apposition = matrixStageOf(study, stage) === undefined ? "" : ", the composite of the stage before";
  const words = [`${stage.name}: ${textOnStage(stage)}${apposition}.`, sentenceOnWholeFiller(stage)]
    .filter(Boolean).join(" ");
  place.append(element("a", {href: "#microstructures"}, element("img", {alt: words,
    src: `data:image/svg+xml,${encodeURIComponent(svg)}`})), element("figcaption", {}, words));
}

/// The times of the table: whole decades, every second or third one where there are more than `most` of them.
function timesOfTable([first, last], most) {
  const all = decades(first, last);
  const step = Math.ceil(all.length / most);
  return all.filter((_, i) => (all.length - 1 - i) % step === 0);
}

/// Shows the moduli of the last stage at whole decades, with their errors, beside those of the binder and of
/// the measurement.
export function showModuli(curves) {
  const result = curvesOfResult(curves);
  if (result.length === 0) return;
  const [{stage, load}] = result;
  const inFrequency = complexAnswer(curves, result);
  if (inFrequency.moduli.length > 0) {
    const isShown = inFrequency.moduli.some(showsError);
    const note = isShown ? noteOnErrors(result, stage) : onAnisotropy(study, qualityOf(stage));
    const ofYoung = isShown && inFrequency.letter === "E" ? " That of E follows from those of G and K." : "";
    return showTable(stage, complexTable(inFrequency), note + ofYoung);
  }
  const isShear = load !== "bulk";
  const binder = isShear ? binderBeside(stage) : undefined;
  const measured = isShear ? measuredBeside(curves, stage, "shear") : undefined;
  const at = ({x, y}, time) => valueAt(x, y, time);
  const times = timesOfTable([Math.min(...result.map(({x}) => x[0])), Math.max(...result.map(({x}) => x.at(-1)))], 12);
  const columns = [["time", (time) => display(time, "s")]];
  for (const curve of answersFirst(result)) {
    columns.push([curve.boundary, (time) => modulusText(curve, time)]);
  }
  const ratios = (reference, time) =>
    [...new Set(result.map((curve) => shortNumber(at(curve, time) / reference, 2)))].join(" … ");
  if (binder !== undefined) {
    columns.push([`over ${binder.name}`, (time) => (hasFlowedAway(binder, time) ? "–" : ratios(binder.at(time), time))]);
  }
  const bulks = isShear ? othersOf("bulk", curves, result).filter(({cells}) => cells === result[0].cells) : [];
  for (const bulk of bulks) {
    columns.push([`${bulkSymbolOf(stageOf(stage))}, ${bulk.boundary}`, (time) => modulusText(bulk, time)],
      ...columnOfRatios(bulk, measuredBeside(curves, stage, "bulk"), "K"));
  }
  if (measured !== undefined) {
    columns.push(["measured", (time) => display(at(measured, time), "Pa")], ["over measured", (time) =>
      Number.isFinite(at(measured, time)) ? ratios(at(measured, time), time) : "–"]);
  }
  for (const young of othersOf("young", curves, result)) {
    columns.push([`Young's modulus, ${young.boundary}`, (time) => modulusText(young, time)],
      ...columnOfRatios(young, measuredBeside(curves, stage, "young"), "E"));
  }
  showTable(stage, [columns, times], noteOnErrors(result, stage));
}

/// The column of the ratios of a modulus to what was measured of it, where that is known.
function columnOfRatios(curve, measured, letter) {
  if (measured === undefined) return [];
  return [[`over measured ${letter}`, (time) => {
    const ratio = valueAt(curve.x, curve.y, time) / valueAt(measured.x, measured.y, time);
    return Number.isFinite(ratio) ? shortNumber(ratio, 2) : "–";
  }]];
}

/// The columns and the frequencies [Hz] of the table of complex moduli.
function complexTable({letter, moduli, measured}) {
  const whole = timesOfTable(study.frequencies_Hz, 12);
  const frequencies = whole.length > 1 ? whole : study.frequencies_Hz;
  const named = (boundary) => (moduli.length > 1 ? boundary : "");
  return [[["frequency", (frequency) => display(frequency, "Hz")],
    ...moduli.flatMap((modulus) => complexColumns(letter, modulus, named(modulus.boundary))),
    ...(measured === undefined ? [] : measuredColumns(letter, moduli, measured))], frequencies];
}

/// Shows a table of columns [head, text of a row] with a note below.
function showTable(stage, [columns, rows], note) {
  document.getElementById("moduli").append(element("h2", {}, `Moduli of ${stage}`),
    table(columns.map(([head]) => head), rows.map((row) => columns.map(([, text]) => text(row)))),
    element("p", {className: "note"}, note));
}

/// The curves of another quantity of the stage and the method of a result, by boundary.
function othersOf(quantity, curves, [{stage, method}]) {
  return softestFirst.flatMap((boundary) => curves.filter((curve) => curve.quantity === quantity &&
    curve.role === "stage" && curve.stage === stage && curve.boundary === boundary && curve.method === method));
}

/// A modulus with half its band.
function modulusText({x, y, band}, time) {
  const modulus = valueAt(x, y, time);
  if (!Number.isFinite(modulus)) return "–";
  const half = band === undefined ? NaN : valueAt(x, band, time);
  return Number.isFinite(half) ? `${display(modulus, "Pa")} ± ${percent(half / modulus)}` : display(modulus, "Pa");
}

function noteOnErrors(result, stage) {
  const quality = qualityOf(stage);
  const isWhole = result.every(hasWholeError);
  const grid = isWhole
    ? `± is the error, meant to hold in 95 of 100 cases: at most ${causesOfErrors(result)} (see below).`
    : result.some(({band}) => band !== undefined) && gridsOf(stage).length > 1
      ? result.some(hasWholeError) ? "± is the error of the grid, and with the periodic boundary that of the packing, too."
        : "± is the error of the grid, from the grids of the run."
    : hasFilms(stageOf(stage)) ? onFilms(quality)
      : expectedErrorOf(stage) === undefined
        ? `Of one grid: its error is not known${ruleOf(stage) === undefined ? "" : ` (${ruleOf(stage)})`}.`
        : `Of one grid, whose error is up to about ${percent(expectedErrorOf(stage))} ${ruleOf(stage) ?? "by a rule"}.`;
  return [onAnisotropy(study, quality), grid, onMeasuringGrids(quality?.measuring_grids),
    result.some(hasWholeError) ? "" : "The scatter from one packing to another is not in it."].filter((sentence) => sentence !== "").join(" ");
}
