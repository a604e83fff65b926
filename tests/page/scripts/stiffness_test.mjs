/// The whole stiffness on the page of a run.

import assert from "node:assert/strict";
import {test} from "node:test";

import {matrixOf, sentenceOnStiffness} from "../../../src/page/scripts/stiffness_text.js";

test("a plane stiffness as a matrix in one unit", () => {
  const row = {C11_Pa: 12.3456e9, C12_Pa: 5.5e9, C16_Pa: -2e5, C22_Pa: 11e9, C26_Pa: -0.04e9, C66_Pa: 3e9};
  assert.deepEqual(matrixOf(row), {unit: "GPa", heads: ["GPa", "xx", "yy", "xy"], rows: [
    ["xx", "12.35", "5.50", "0.00"], ["yy", "5.50", "11.00", "−0.04"], ["xy", "0.00", "−0.04", "3.00"]]});
});

test("a stiffness in space is symmetric and in the order of Voigt", () => {
  const row = {};
  for (let i = 1; i <= 6; ++i) for (let j = i; j <= 6; ++j) row[`C${i}${j}_Pa`] = 1e6 * (10 * i + j);
  const {heads, rows} = matrixOf(row);
  assert.deepEqual(heads, ["MPa", "xx", "yy", "zz", "yz", "zx", "xy"]);
  assert.deepEqual(rows[0], ["xx", "11.00", "12.00", "13.00", "14.00", "15.00", "16.00"]);
  assert.deepEqual(rows[3], ["yz", "14.00", "24.00", "34.00", "44.00", "45.00", "46.00"]);
});

test("what is not known is said", () => {
  const row = {time_s: 1e-3, bulk_modulus_Pa: 4e9, shear_modulus_Pa: 1.5e9, anisotropy: "0.0123", error: "0.034"};
  assert.equal(sentenceOnStiffness(row), "At 1 ms the nearest isotropic stiffness has K = 4 GPa and G = 1.5 GPa, with a " +
    "universal index of anisotropy of 0.012 (0: isotropic); ± 3.4 % of √(Cᵢᵢ Cⱼⱼ) is the error of a constant.");
  assert.match(sentenceOnStiffness({...row, anisotropy: "", error: ""}),
    /no index of anisotropy, since the stiffness is not positive definite; the error of the constants is not known/);
});
