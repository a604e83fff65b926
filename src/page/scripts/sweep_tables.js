/// The summary and the tables of a sweep.

import {readTable, sweep} from "./data.js";
import {element} from "./elements.js";
import {gridName, listed, methodNames, symbolOf} from "./names.js";
import {display, duration, percent} from "./numbers.js";
import {groupsOf} from "./records.js";
import {decades, valueAt} from "./sampling.js";
import {curvesOfSentences, sweepSentences} from "./sweep_sentences.js";
import {labelOfKey, sweptKeys} from "./sweep_curves.js";
import {measuredCurves, ratioColumns} from "./sweep_measurements.js";
import {table} from "./table.js";

/// Shows the title, the swept keys, and the failed tasks.
export function showSweepSummary(curves) {
  document.getElementById("title").textContent = sweep.title;
  if (curves.length > 0) showResult(curvesOfSentences(curves));
  const what = sweptKeys.map(({path, values}) => `${path}: ${listed(values.map(String))}`);
  document.getElementById("summary").append(
    element("p", {}, `One deck, ${sweep.tasks.length} times, with all combinations of`),
    element("ul", {}, ...what.map((text) => element("li", {}, text))));
  const ofState = (state) => sweep.tasks.filter((task) => task.state === state).length;
  const warnings = [];
  if (ofState("waiting") > 0) warnings.push(`${ofState("waiting")} tasks are still to be done.`);
  for (const task of sweep.tasks.filter(({state}) => state === "failed")) warnings.push(`${task.name}: ${task.error}`);
  const list = document.getElementById("warnings");
  list.append(...warnings.map((text) => element("li", {}, text)));
  list.hidden = warnings.length === 0;
}

function showResult(curves) {
  const [{load, boundary, stage}] = curves;
  const moving = sweptKeys.filter(({values}) => values.length > 1);
  const measured = ["isotropic", "shear"].includes(load) ? measuredCurves().find((one) => one.stage === stage) : undefined;
  const [first, ...others] = sweepSentences({curves, symbol: symbolOf(load), boundary, measured,
    tasks: sweep.tasks.filter(({state}) => state === "done").length,
    textOnTask: ({values}) => moving.map(({path, label}) => `${label} ${values[path]}`).join(", ") || "the one task"});
  document.getElementById("summary").append(
    element("p", {id: "answer"}, element("strong", {}, first), ` ${others.join(" ")}`));
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

/// Shows the mean and the standard deviation over the seeds, at whole decades.
export function showSpread() {
  const rows = readTable("spread.csv");
  document.getElementById("spread").hidden = rows.length === 0;
  const keys = sweep.keys.filter((path) => rows.length > 0 && Object.hasOwn(rows[0], path));
  for (const group of groupsOf(rows, [...keys, "stage", "load", "boundary", "method", "cells"])) {
    const {stage, load, boundary, method, cells, tasks} = group[0];
    const times = group.map((row) => row.time_s);
    const at = (column, time) => valueAt(times, group.map((row) => row[column]), time);
    const title = [...keys.map((path) => `${labelOfKey(path)} = ${group[0][path]}`), stage, load, boundary,
      methodNames[method], gridName(cells), `${tasks} seeds`].join(", ");
    document.getElementById("spread-tables").append(element("h3", {}, title),
      table(["time", "mean", "standard deviation"], decades(times[0], times.at(-1)).map((time) => {
        const mean = at("mean_modulus_Pa", time);
        return [display(time, "s"), display(mean, "Pa"), percent(at("standard_deviation_Pa", time) / mean)];
      })));
  }
}

/// Shows the program that made the results, and its input.
export function showSweepProvenance() {
  document.getElementById("deck-text").append(element("p", {className: "note"},
    `${sweep.program} ${sweep.version}, ${sweep.deck}`));
}
