/// The whole stiffness of the stages of a run, as a matrix at a time and as its isotropic part over time.

import {readTable} from "./data.js";
import {chooser, element} from "./elements.js";
import {methodNames} from "./names.js";
import {display, percent, shortNumber} from "./numbers.js";
import {groupsOf, numberIfKnown} from "./records.js";
import {decades} from "./sampling.js";
import {matrixOf, sentenceOnStiffness} from "./stiffness_text.js";
import {table} from "./table.js";

/// The rows of a test at whole decades of time, and its first and last one.
function rowsToShow(rows) {
  const [first, last] = [rows[0], rows.at(-1)];
  const wanted = decades(first.time_s, last.time_s);
  const isWanted = (row) => wanted.some((time) => Math.abs(row.time_s / time - 1) < 1e-6);
  return rows.filter((row) => row === first || row === last || isWanted(row));
}

/// Shows the whole stiffness of each stage and boundary that has one.
export function showStiffness() {
  const tests = groupsOf(readTable("stiffness.csv"), ["stage", "boundary", "method", "cells"]);
  const section = document.getElementById("stiffness");
  section.hidden = tests.length === 0;
  tests.forEach((rows, number) => {
    const shown = rowsToShow(rows);
    const place = element("div", {});
    const draw = (row) => {
      const {heads, rows: lines} = matrixOf(row);
      place.replaceChildren(table(heads, lines), element("p", {}, sentenceOnStiffness(row)));
    };
    const [{stage, boundary, method, cells}] = rows;
    const grid = cells === "films" ? "films" : `${cells} cells a side`;
    const choice = chooser(`stiffness-time-${number}`, `time of the stiffness of ${stage}`,
      shown.map((row) => [row, `at ${display(row.time_s, "s")}`]), draw);
    choice.selectedIndex = shown.length - 1;
    section.append(element("h3", {}, `${stage}: ${boundary}, ${methodNames[method]}, ${grid}`),
      element("p", {className: "choices"}, choice), place,
      table(["time", "K", "G", "index of anisotropy", "error"], shown.map((row) => [display(row.time_s, "s"),
        display(row.bulk_modulus_Pa, "Pa"), display(row.shear_modulus_Pa, "Pa"),
        shortNumber(numberIfKnown(row.anisotropy), 2), percent(numberIfKnown(row.error))])));
    draw(shown.at(-1));
  });
}
