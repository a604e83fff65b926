/// What the page predicts for other matrices beside what `breccia respond` does. respond-test makes the results, in the
/// folder that the environment variable RESULTS names.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";

import {respond} from "../../../src/page/scripts/response.js";
import {readSpectrum} from "../../../src/page/scripts/spectrum_text.js";
import {decadesOfShift, shiftedSeries} from "../../../src/page/scripts/viscoelasticity.js";
import {assertClose} from "../../page/scripts/close.mjs";

const read = (name) => readFileSync(`${process.env.RESULTS}/${name}`, "utf8");

/// The data in the page of the study.
const {study, responses} = JSON.parse(/<script [^>]*id="data">(.*?)<\/script>/s.exec(read("study/report.html"))[1]);
const [binder] = study.materials.filter(({name}) => name === "binder");

/// The best curve of G(t) of each stage and boundary in curves.csv: the limit of vanishing cells, or the finest grid.
function limitsIn(directory) {
  const [header, ...lines] = read(`${directory}/curves.csv`).trim().split("\n").map((line) => line.split(","));
  const rows = lines.map((cells) => Object.fromEntries(cells.map((cell, i) => [header[i], cell])));
  const grids = [...new Set(rows.map(({cells}) => cells))];
  const best = grids.includes("extrapolated") ? "extrapolated" : String(Math.max(...grids.map(Number)));
  return rows.filter(({load, cells}) => load === "shear" && cells === best);
}

/// The command has exact spectra, the page fits them: 2.3e-4 of the modulus of a term, which is here up to three times
/// G(t) when it relaxes (tests/page/scripts/viscoelasticity_test.mjs). Before stage A serves as the matrix of stage B,
/// the page fits its limit once more, and the command fits it within a thirtieth of fit_tolerance = 0.003.
const tolerances = {A: 7e-4, B: 2 * 7e-4 + 1e-4};

function comparePrediction(directory, shear, bulk) {
  const results = respond(study, responses, {binder: {shear, bulk}});
  assert.deepEqual(results.map(({stage, boundary}) => `${stage} ${boundary}`),
    ["A displacement", "A traction", "B displacement", "B traction"]);
  for (const {stage, boundary, window, refusal, modulus} of results) {
    assert.equal(refusal, undefined, `${stage}, ${boundary}`);
    const rows = limitsIn(directory).filter((row) => row.stage === stage && row.boundary === boundary);
    assert.ok(rows.length > 10, `${stage}, ${boundary}: ${rows.length} rows of curves.csv`);
    assert.deepEqual(window, study.times_s);
    for (const {time_s, modulus_Pa} of rows) {
      assertClose(modulus(Number(time_s)), Number(modulus_Pa), tolerances[stage], `${stage}, ${boundary}, ${time_s} s`);
    }
  }
}

test("the matrix of the run", () => comparePrediction("study", binder.shear, binder.bulk));

test("another temperature", () => {
  const law = binder.temperature_shift;
  const factor = 10 ** (decadesOfShift(law, 35 + 273.15) - decadesOfShift(law, law.temperature_K));
  comparePrediction("warm", shiftedSeries(binder.shear, factor), shiftedSeries(binder.bulk, factor));
});

test("another binder", () => {
  comparePrediction("other", readSpectrum("relaxation_time_s,modulus_Pa\n3e-3,2e5\n0.2,3e5\n"), binder.bulk);
});
