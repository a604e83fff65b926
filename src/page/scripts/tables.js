/// The tables of a run.

import {complexOf} from "./complex_moduli.js";
import {readTable, study} from "./data.js";
import {element} from "./elements.js";
import {hasFilms, listed, methodNames, nameOfTest, textOnStage} from "./names.js";
import {display, duration, minus, percent, percentOfWhole, shortNumber, withMicroSign} from "./numbers.js";
import {distinct, groupsOf, numberIfKnown} from "./records.js";
import {decades, valueAt} from "./sampling.js";
import {matrixStageOf, stagesOfInterest} from "./stages.js";
import {table} from "./table.js";
import {sentenceOnWholeFiller} from "./whole_filler.js";

/// Shows the stages and the tests computed of each.
export function showStages() {
  const sentences = study.stages.map((stage) => {
    const earlier = matrixStageOf(study, stage) !== undefined;
    const cells = hasFilms(stage) ? "computed as grains and films" : `${listed(stage.cells.map(String))} cells a side`;
    return `${stage.name}: ${textOnStage(stage)}${earlier ? ", the composite of the stage before" : ""}; ${cells}.`;
  });
  const [begin, end] = study.frequencies_Hz?.map((frequency) => display(frequency, "Hz")) ??
    study.times_s.map((time) => display(time, "s"));
  const tests = study.stages.flatMap((stage) => stage.tests);
  const boundaries = listed(distinct(tests, "boundary"));
  const methods = listed(distinct(tests, "method").map((method) => methodNames[method]));
  const modulus = study.frequencies_Hz === undefined ? "relaxation" : "complex";
  const what = `The ${modulus} modulus from ${begin} to ${end}, computed from the constituents: ${boundaries} boundary, by the ` +
    `${methods} method.`;
  document.getElementById("stages").append(element("p", {}, tests.length > 0 ? what : "Packed, not tested."), sentences.length > 1
    ? element("ol", {}, ...sentences.map((text) => element("li", {}, text))) : element("p", {}, sentences.join("")));
  const fillers = stagesOfInterest(study).map(sentenceOnWholeFiller).filter(Boolean);
  if (fillers.length > 0) document.getElementById("stages").append(element("p", {}, fillers.join(" ")));
}

/// Shows measured and computed moduli, at whole decades of time or at the measured frequencies, and where they agree
/// best and worst. What was not measured in frequency is compared in time.
export function showComparison() {
  const inTime = readTable("comparison.csv"), inFrequency = readTable("comparison_dynamic.csv");
  document.getElementById("comparison").hidden = inTime.length + inFrequency.length === 0;
  const isShownInFrequency = study.frequencies_Hz !== undefined;
  const isInFrequency = ({measurement, stage}) => inFrequency.some((row) =>
    row.measurement === measurement && row.stage === stage);
  showComparisonInTime(inTime.filter((row) => !(isShownInFrequency && isInFrequency(row))));
  showComparisonInFrequency(inFrequency);
  const extremes = study.stages.flatMap((stage) => (stage.comparisons ?? []).map((one) => {
    const [best, worst] = one.best === undefined || (isShownInFrequency && one.best_in_frequency !== undefined)
      ? [one.best_in_frequency, one.worst_in_frequency] : [one.best, one.worst];
    return [nameOfModulus(stage.name, one.modulus), one.measurement, one.boundary, methodNames[one.method],
      ratioText(best), ratioText(worst)];
  }));
  if (extremes.length > 0) {
    document.getElementById("comparison-tables").append(
      element("h3", {}, "Where the ratio is nearest to one and where furthest"),
      table(["stage", "measurement", "boundary", "method", "best", "worst"], extremes));
  }
}

/// The letter of a modulus that was measured; results of earlier versions do not name it and are of G.
function letterOf(modulus = "shear") {
  return {shear: "G", young: "E", bulk: "K"}[modulus];
}

/// The stage and the modulus that are compared: "mixture" for G, "mixture, E".
function nameOfModulus(stage, modulus = "shear") {
  return modulus === "shear" ? stage : `${stage}, ${letterOf(modulus)}`;
}

/// "mixture: rheometer", "mixture, E: tension".
function titleOfComparison({stage, measurement, modulus}) {
  return `${nameOfModulus(stage, modulus)}: ${measurement}`;
}

/// "1.020 at 10 ms", "1.020 at 16 Hz".
function ratioText({ratio, time_s: time, frequency_Hz: frequency}) {
  return `${ratio.toFixed(3)} at ${time === undefined ? display(frequency, "Hz", 2) : display(time, "s", 2)}`;
}

/// A ratio to what was measured, with the error of the computed modulus where that is known.
function ratioWithError(ratio, error) {
  return ratio.toFixed(3) + (Number.isFinite(error) ? ` ± ${percent(error)}` : "");
}

function showComparisonInTime(rows) {
  const place = document.getElementById("comparison-tables");
  for (const group of groupsOf(rows, ["measurement", "stage"])) {
    const tests = groupsOf(group, ["boundary", "method"]);
    const names = tests.map(([row]) => `${row.boundary}, ${methodNames[row.method]}`);
    const at = (test, column, time) =>
      valueAt(test.map((row) => row.time_s), test.map((row) => numberIfKnown(row[column])), time);
    const every = tests.flat().map((row) => row.time_s);
    const body = decades(Math.min(...every), Math.max(...every)).map((time) => {
      const measured = tests.map((test) => at(test, "measured_Pa", time)).find(Number.isFinite);
      return [display(time, "s"), display(measured, "Pa"), ...tests.flatMap((test) => {
        const modulus = at(test, "modulus_Pa", time);
        return Number.isFinite(modulus)
          ? [display(modulus, "Pa"), ratioWithError(modulus / measured, at(test, "error", time))] : ["–", "–"];
      })];
    });
    place.append(element("h3", {}, titleOfComparison(group[0])),
      table(["time", "measured", ...names.flatMap((name) => [name, "ratio"])], body));
  }
}

/// At most some twenty frequencies of each measurement, all of its boundaries side by side.
function showComparisonInFrequency(rows) {
  const most = 20;
  const place = document.getElementById("comparison-tables");
  for (const group of groupsOf(rows, ["measurement", "stage"])) {
    const letter = letterOf(group[0].modulus);
    const tests = groupsOf(group, ["boundary", "method"]);
    const step = Math.ceil(tests[0].length / most);
    const named = (text, {boundary}) => (tests.length > 1 ? `${text}, ${boundary}` : text);
    const body = tests[0].filter((_, i) => i % step === 0).map((row) => {
      const measured = complexOf(row.measured_storage_modulus_Pa, row.measured_loss_modulus_Pa);
      return [display(row.frequency_Hz, "Hz"), display(measured.size, "Pa"), `${shortNumber(measured.phase, 3)}°`,
        ...tests.flatMap((test) => {
          const here = test.find(({frequency_Hz: frequency}) => frequency === row.frequency_Hz);
          if (here === undefined) return ["–", "–", "–", "–", "–"];
          return [ratioWithError(here.ratio, numberIfKnown(here.error)), `${minus(here.phase_difference_deg.toFixed(2))}°`,
            ...[here.storage_ratio, here.loss_ratio, here.loss_ratio / here.storage_ratio].map((ratio) => ratio.toFixed(3))];
        })];
    });
    place.append(element("h3", {}, `${titleOfComparison(group[0])}, over frequency`),
      table(["frequency", `measured |${letter}*|`, "measured phase", ...tests.flatMap(([test]) =>
        [`|${letter}*| ratio`, "phase difference", `${letter}′ ratio`, `${letter}″ ratio`, "tan δ ratio"]
          .map((text) => named(text, test)))],
      body));
  }
}

/// Shows the sentence on the quality of each stage, as `breccia run` prints it.
function showSummaries() {
  const known = study.stages.filter((stage) => stage.quality?.summary);
  document.getElementById("quality-summary").append(
    ...known.map((stage) => element("li", {}, `${stage.name}, this box: ${withMicroSign(stage.quality.summary)}.`)));
}

/// Shows the errors of tests, fits and extrapolations.
export function showQuality() {
  showSummaries();
  const tests = study.stages.flatMap((stage) => stage.tests.map((test) => ({stage, test})));
  const place = document.getElementById("quality-tables");
  const add = (title, explanation, heads, rows) => {
    if (rows.length > 0) {
      place.append(element("h3", {}, title), element("p", {className: "note"}, explanation), table(heads, rows));
    }
  };
  const what = ["stage", "load", "boundary", "method"];
  add("Errors in time, and of fits",
    "Relative. Error: of the reduced basis or of the time steps; the grid is not in it.",
    [...what, "cells", "error", "fit", "snapshots"],
    tests.filter(({test}) => test.error_estimate !== undefined || test.fit_error !== undefined)
      .map(({stage, test}) => [...nameOfTest(stage, test), String(test.cells), percent(test.error_estimate),
        percent(test.fit_error), String(test.snapshots?.length ?? "")]));
  add("Overlaps of time domains", "Largest relative difference of two neighbouring runs where both are valid.",
    [...what, "from", "to", "mismatch"],
    tests.flatMap(({stage, test}) => (test.overlaps ?? []).map(({window_s: [begin, end], mismatch}) =>
      [...nameOfTest(stage, test), display(begin, "s", 3), display(end, "s", 3), percent(mismatch)])));
  add("Limit of vanishing cells", "Half the width of the band in which it is expected, over its value.",
    ["stage", "load", "boundary", "method", "smallest", "largest", "at"], extrapolationRows());
  add("Stages as matrices", "Largest relative deviation of the fitted series that the next stage takes.",
    ["stage", "boundary", "method", "shear", "bulk"],
    study.stages.flatMap((stage) => (stage.materials ?? []).map((one) => [stage.name, one.boundary,
      methodNames[one.method], percent(one.shear_fit_error), percent(one.bulk_fit_error)])));
}

/// Half the width of the band of each extrapolated curve over its value: the smallest, the largest, and its time.
function extrapolationRows() {
  const rows = readTable("extrapolation.csv");
  return groupsOf(rows, ["stage", "load", "boundary", "method"]).map((group) => {
    const shares = group.map((row) => row.half_band_Pa / row.modulus_Pa);
    const largest = Math.max(...shares);
    const {stage, load, boundary, method, time_s} = group[shares.indexOf(largest)];
    return [stage, load, boundary, methodNames[method], percent(Math.min(...shares)), percent(largest),
      display(time_s, "s", 2)];
  });
}

/// Shows the program that made the results, its input, and the time that it took.
export function showProvenance() {
  const place = document.getElementById("provenance-tables");
  const seconds = study.wall_time_s;
  place.append(table(["", ""], [
    ["program", `${study.program} ${study.version}`],
    ["deck", study.deck],
    ["hash of deck, overrides and data", study.hash],
    ["completed", study.date === undefined || study.date === null ? "not complete"
      : study.date.replace("T", " ").replace("Z", " UTC")],
    ["wall time", seconds === null || seconds === undefined ? "not complete" : duration(seconds)],
  ].map((row) => row.map(String))));
  place.append(table(["stage", "particles", "fraction", "smallest gap", "gap in cells", "seed", "packed in"],
    study.stages.map(({name, microstructure: made}) => [name, String(made.particles ?? ""), percentOfWhole(made.fraction),
      made.smallest_gap_m === null ? "" : display(made.smallest_gap_m, "m", 3),
      made.smallest_gap_cells === null ? "" : String(Number(made.smallest_gap_cells.toPrecision(3))),
      String(made.seed ?? ""), display(made.wall_time_s, "s", 2)])));
  const tests = study.stages.flatMap((stage) => stage.tests.map((test) => ({stage, test})));
  const secondsOf = (test) => test.wall_time_s ?? test.time_domains?.reduce((sum, one) => sum + one.wall_time_s, 0);
  place.append(table(["stage", "load", "boundary", "method", "cells", "volume strain", "solver", "wall time"],
    tests.filter(({test}) => secondsOf(test) !== undefined).map(({stage, test}) => [...nameOfTest(stage, test),
      String(test.cells), test.volumetric ?? "", test.solver ?? test.formulation, duration(secondsOf(test))])));
}
