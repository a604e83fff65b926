/// Texts that the page takes from its reader and gives to it.

import assert from "node:assert/strict";
import {test} from "node:test";

import {csvOf, csvOfTable, fileName} from "../../../src/page/scripts/files.js";
import {distinct, groupsOf, numberOf, own} from "../../../src/page/scripts/records.js";
import {readSpectrum} from "../../../src/page/scripts/spectrum_text.js";

test("a relaxation spectrum as it is typed", () => {
  assert.deepEqual(readSpectrum("relaxation_time_s,modulus_Pa\n# a comment\n1e-2, 2e6\r\n\n3;4\n5 6\ninf 7\n"), {
    equilibrium_Pa: 7,
    terms: [{relaxation_time_s: 0.01, modulus_Pa: 2e6}, {relaxation_time_s: 3, modulus_Pa: 4},
      {relaxation_time_s: 5, modulus_Pa: 6}],
  });
  assert.deepEqual(readSpectrum("inf,1\ninf,2"), {equilibrium_Pa: 3, terms: []});
});

test("mistakes in a spectrum are told with their line", () => {
  const expected = "expected a relaxation time above 0 and a modulus not below 0";
  for (const line of ["0.01,stiff", "0.01", "1,2,3", "0,1", "-1,1", "1,-1", "1,inf", "soft,1"]) {
    assert.throws(() => readSpectrum(`0.1,1\n${line}`), {message: `line 2: ${expected}, got "${line}"`});
  }
  for (const text of ["", "time,modulus\n", "1,0\n"]) {
    assert.throws(() => readSpectrum(text), {message: "expected at least one term with a modulus above 0"});
  }
});

test("files that the reader keeps", () => {
  assert.equal(fileName("A, upper", "csv"), "A-upper.csv");
  assert.equal(fileName("Ω/..", "csv"), "breccia.csv");
  const curve = {label: 'Bennett, "1998"', x: [1, 2], y: [3e6, 4e-7]};
  assert.equal(csvOf([curve], {xUnit: "s", unit: "Pa"}),
    'curve,time_s,value_Pa\n"Bennett, ""1998""",1,3000000\n"Bennett, ""1998""",2,4e-7\n');
  // The text has the form that `breccia fit` reads.
  assert.equal(csvOf([{label: "A", x: [1], y: [2]}], {xUnit: "rad/s", unit: "Pa"}),
    "curve,angular_frequency_rad_per_s,value_Pa\nA,1,2\n");
  assert.equal(csvOf([{label: "A", x: [1], y: [2]}], {xUnit: "Hz", unit: ""}), "curve,frequency_Hz,value\nA,1,2\n");
  assert.equal(csvOfTable({stage: ["A", "#1"], "modulus, Pa": [1, "inf"]}), 'stage,"modulus, Pa"\nA,1\n"#1",inf\n');
});

test("rows of tables", () => {
  const rows = [{a: 1, b: "x"}, {a: 2, b: "y"}, {a: 1, b: "z"}];
  assert.deepEqual(groupsOf(rows, ["a"]), [[rows[0], rows[2]], [rows[1]]]);
  assert.deepEqual(distinct(rows, "a"), [1, 2]);
  assert.deepEqual([numberOf("inf"), numberOf(3), own({}, "constructor"), own({constructor: 1}, "constructor")],
    [Infinity, 3, undefined, 1]);
});
