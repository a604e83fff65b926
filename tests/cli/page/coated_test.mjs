/// What the page predicts for another interphase beside what `breccia respond` does. respond-test makes the results, in
/// the folder that the environment variable RESULTS names.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";

import {fitted, freeNumbers} from "../../../src/page/scripts/live_fit.js";
import {respond, sampledRange} from "../../../src/page/scripts/response.js";
import {assertClose} from "../../page/scripts/close.mjs";

const read = (name) => readFileSync(`${process.env.RESULTS}/${name}`, "utf8");
const {study, responses} = JSON.parse(/<script [^>]*id="data">(.*?)<\/script>/s.exec(read("study/report.html"))[1]);
const materials = Object.fromEntries(study.materials.map((material) => [material.name, material]));

/// G(t) of both bounds in curves.csv.
function rowsIn(directory) {
  const [header, ...lines] = read(`${directory}/curves.csv`).trim().split("\n").map((line) => line.split(","));
  return lines.map((cells) => Object.fromEntries(cells.map((cell, i) => [header[i], cell])))
    .filter(({load}) => load === "shear");
}

function comparePrediction(directory, changed) {
  const results = respond(study, responses, {...materials, ...changed});
  assert.deepEqual(results.map(({boundary}) => boundary), ["displacement", "traction"]);
  for (const {boundary, refusal, modulus} of results) {
    assert.equal(refusal, undefined, boundary);
    const rows = rowsIn(directory).filter((row) => row.boundary === boundary);
    assert.ok(rows.length > 10);
    // The page fits the spectrum that the command has exactly (respond_test.mjs).
    for (const {time_s, modulus_Pa} of rows) {
      assertClose(modulus(Number(time_s)), Number(modulus_Pa), 7e-4, `${boundary}, ${time_s} s`);
    }
  }
}

test("the interphase of the run", () => comparePrediction("study", {}));

test("a softer interphase", () => {
  const {bulk} = materials.interphase;
  comparePrediction("soft", {interphase: {shear: {equilibrium_Pa: 20e6, terms: []}, bulk}});
});

test("an interphase beyond what the run has sampled", () => {
  const rigid = {shear: {equilibrium_Pa: 9e9, terms: []}, bulk: materials.interphase.bulk};
  for (const {refusal, window} of respond(study, responses, {...materials, interphase: rigid})) {
    assert.equal(refusal.material, "interphase");
    assert.ok(!(window[0] < window[1]));
  }
});

test("the fit of the interphase finds the one with which `breccia respond` was asked", () => {
  const {interphase} = materials, rows = rowsIn("soft").filter(({boundary}) => boundary === "displacement");
  const times = rows.map(({time_s}) => Number(time_s));
  const measured = [{stage: "discs", quantity: "shear", x: times, y: rows.map(({modulus_Pa}) => Number(modulus_Pa))}];
  const curvesWith = ({spectrum}) => respond(study, responses, {...materials, interphase: {...interphase, shear: spectrum}})
    .map(({stage, boundary, modulus}) => ({stage, boundary, quantity: "shear", x: times, y: times.map(modulus)}));
  const ranges = sampledRange(responses.discs[0], 1);
  const {spectrum} = fitted(freeNumbers({material: {...interphase, ranges}}), curvesWith, measured);
  assertClose(spectrum.equilibrium_Pa, 20e6, 2e-3, "modulus of the interphase");
});
