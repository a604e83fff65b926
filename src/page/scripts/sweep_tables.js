/// The summary and the tables of a sweep.

import {readTable, sweep} from "./data.js";
import {element} from "./elements.js";
import {gridName, listed, methodNames, symbolOf} from "./names.js";
import {display, duration, percent, shortNumber, unbroken} from "./numbers.js";
import {groupsOf} from "./records.js";
import {decades, valueAt} from "./sampling.js";
import {curvesOfSentences, seedsSentences, sweepSentences} from "./sweep_sentences.js";
import {labelOfKey, sweptKeys} from "./sweep_curves.js";
import {meansOverSeeds} from "./sweep_means.js";
import {measuredCurves, ratioColumns} from "./sweep_measurements.js";
import {table} from "./table.js";

/// Shows the title, the swept keys, and the failed tasks.
export function showSweepSummary(curves) {
  document.getElementById("title").textContent = sweep.title;
  const isComplex = curves.some(({quantity}) => quantity === "absolute");
  const shown = curves.filter(({quantity}) => (isComplex ? quantity === "absolute" : ["shear", "bulk"].includes(quantity)));
  if (shown.length > 0) showResult(curvesOfSentences(shown));
  const what = sweptKeys.map(({path, values}) => `${path}: ${listed(values.map(String))}`);
  document.getElementById("summary").append(
    element("p", {}, `${sweep.tasks.length} runs of one deck, with all combinations of`),
    element("ul", {}, ...what.map((text) => element("li", {}, text))));
  if (sweep.dimensions === 2) {
    document.getElementById("summary").append(element("p", {className: "note"}, "Computed in two dimensions (plane strain): " +
      "particles are cross-sections of cylinders. The pages of the tasks have their warnings."));
  }
  const ofState = (state) => sweep.tasks.filter((task) => task.state === state).length;
  const warnings = [];
  if (ofState("waiting") > 0) warnings.push(`${ofState("waiting")} tasks are still to be done.`);
  for (const task of sweep.tasks.filter(({state}) => state === "failed")) warnings.push(`${task.name}: ${task.error}`);
  const list = document.getElementById("warnings");
  list.append(...warnings.map((text) => element("li", {}, text)));
  list.hidden = warnings.length === 0;
}

function showResult(curves) {
  const [{load, boundary, stage, quantity}] = curves;
  const moving = sweptKeys.filter(({values}) => values.length > 1);
  const isOfSeeds = curves.length > 1 && moving.every(({isSeed}) => isSeed);
  const compared = isOfSeeds ? curves : meansOverSeeds(curves);
  const measured = ["isotropic", "shear"].includes(load)
    ? measuredCurves().find((one) => one.stage === stage && one.quantity === quantity) : undefined;
  const isComplex = quantity === "absolute";
  const words = {curves: compared, symbol: isComplex ? "|G*|" : symbolOf(load), xUnit: isComplex ? "Hz" : "s", boundary, measured,
    tasks: sweep.tasks.filter(({state}) => state === "done").length, textOnTask: (curve) => textOnTask(curve, moving)};
  const [first, ...others] = isOfSeeds ? seedsSentences(words) : sweepSentences(words);
  document.getElementById("summary").append(
    element("p", {id: "answer"}, element("strong", {}, unbroken(first)), ` ${unbroken(others.join(" "))}`));
}

/// "gap 1 um", "gap 1 um, mean of 5 seeds": the values of the moving keys of a task, or of the mean of several.
function textOnTask({values, packings}, moving) {
  const shown = moving.filter(({isSeed}) => packings === undefined || !isSeed);
  const text = shown.map(({path, label}) => `${label} ${values[path]}`).join(", ") || "the one task";
  return packings === undefined ? text : `${text}, mean of ${packings} seeds`;
}

/// Shows the tasks, with links to their reports, and the ratio of their curves to the measurement.
export function showTasks(curves) {
  const ratios = ratioColumns(curves);
  const rows = sweep.tasks.map((task, i) => {
    const name = task.state === "done" ? element("a", {href: `${encodeURIComponent(task.name)}/report.html`}, task.name)
      : task.name;
    const seconds = task.wall_time_s === null ? "" : duration(task.wall_time_s);
    const values = sweptKeys.map(({path}) => String(task.values[path]));
    return element("tr", {}, ...[name, ...values, ...ratios.map(({of}) => of(i)), task.state, seconds]
      .map((text) => element("td", {}, text)));
  });
  const heads = ["task", ...sweptKeys.map(({label}) => label), ...ratios.map(({head}) => head), "state",
    "wall time"];
  document.getElementById("task-table").append(element("div", {className: "table"}, element("table", {},
    element("thead", {}, element("tr", {}, ...heads.map((text) => element("th", {}, text)))),
    element("tbody", {}, ...rows))));
}

/// Shows the mean and the standard deviation over the seeds, at whole decades: of the modulus or, where the deck gives
/// frequencies, of the absolute value and the phase of the complex modulus.
export function showSpread() {
  const inFrequency = readTable("spread_dynamic.csv");
  const rows = inFrequency.length > 0 ? inFrequency : readTable("spread.csv");
  document.getElementById("spread").hidden = rows.length === 0;
  const keys = sweep.keys.filter((path) => rows.length > 0 && Object.hasOwn(rows[0], path));
  for (const group of groupsOf(rows, [...keys, "stage", "load", "boundary", "method", "cells"])) {
    const {stage, load, boundary, method, cells, tasks} = group[0];
    const title = [...keys.map((path) => `${labelOfKey(path)} = ${group[0][path]}`), stage, load, boundary,
      methodNames[method], gridName(cells), `${tasks} seeds`].join(", ");
    document.getElementById("spread-tables").append(element("h3", {}, title),
      inFrequency.length > 0 ? spreadInFrequency(group) : spreadInTime(group));
  }
}

/// A function that returns the value of a column of rows at a place along `x`.
function columnsOver(x, rows) {
  return (column, at) => valueAt(x, rows.map((row) => row[column]), at);
}

function spreadInTime(rows) {
  const times = rows.map((row) => row.time_s), of = columnsOver(times, rows);
  return table(["time", "mean", "standard deviation"], decades(times[0], times.at(-1)).map((time) => {
    const mean = of("mean_modulus_Pa", time);
    return [display(time, "s"), display(mean, "Pa"), percent(of("standard_deviation_Pa", time) / mean)];
  }));
}

function spreadInFrequency(rows) {
  const frequencies = rows.map((row) => row.angular_frequency_rad_per_s / (2 * Math.PI));
  const of = columnsOver(frequencies, rows);
  const degrees = (radians) => `${shortNumber(radians * 180 / Math.PI, 3)}°`;
  return table(["frequency", "mean |G*|", "standard deviation", "mean phase", "standard deviation"],
    decades(frequencies[0], frequencies.at(-1)).map((at) => {
      const mean = of("mean_absolute_Pa", at);
      return [display(at, "Hz"), display(mean, "Pa"), percent(of("standard_deviation_absolute_Pa", at) / mean),
        degrees(of("mean_phase_rad", at)), degrees(of("standard_deviation_phase_rad", at))];
    }));
}

/// Shows the program that made the results, and its input.
export function showSweepProvenance() {
  document.getElementById("deck-text").append(element("p", {className: "note"},
    `${sweep.program} ${sweep.version}, ${sweep.deck}`));
}
