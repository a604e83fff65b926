/// Small systems whose solutions are known.

import assert from "node:assert/strict";
import {test} from "node:test";

import {dot, nonNegativeLeastSquares, solveSymmetric} from "../../../src/page/scripts/linear_algebra.js";
import {assertClose} from "./close.mjs";

test("symmetric positive definite system", () => {
  // The second differences of x = (1, -2, 3, -4).
  const matrix = [[2, -1, 0, 0], [-1, 2, -1, 0], [0, -1, 2, -1], [0, 0, -1, 2]];
  solveSymmetric(matrix, [4, -8, 12, -11]).forEach((value, i) => {
    assertClose(value, [1, -2, 3, -4][i], 1e-14, `x[${i}]`);
  });
});

test("least squares without negative unknowns", () => {
  const columns = [[1, 0, 1], [0, 1, 1]];
  // Without the constraint x = (3, -1) meets all three equations. With x[1] = 0 the best x[0] is (3 + 2) / 2.
  assert.deepEqual(nonNegativeLeastSquares(columns, [3, -1, 2]).map((value) => Number(value.toFixed(12))), [2.5, 0]);
  nonNegativeLeastSquares(columns, [3, 1, 4]).forEach((value, i) => assertClose(value, [3, 1][i], 1e-13, `x[${i}]`));
});

test("least squares without negative unknowns, with many nearly dependent columns", () => {
  // The conditions of optimality (Karush, Kuhn, Tucker): no unknown is negative, and the slope of the squared residual
  // is zero for each positive one and not below zero for the others.
  const at = Array.from({length: 40}, (_, i) => 10 ** (i / 10 - 2));
  const columns = Array.from({length: 60}, (_, j) => at.map((s) => s / (s + 10 ** (j / 12 - 2.5))));
  const right = at.map((s, i) => s / (s + 0.3) + 2 * s / (s + 7) + 0.01 * Math.sin(5 * i));
  const x = nonNegativeLeastSquares(columns, right);
  const residual = right.map((value, i) => value - dot(x, columns.map((column) => column[i])));
  assert.ok(x.every((value) => value >= 0));
  columns.forEach((column, j) => {
    const slope = -dot(column, residual) / Math.sqrt(dot(column, column));
    assert.ok(slope > -1e-10, `x[${j}] should grow: slope ${slope}`);
    if (x[j] > 0) assert.ok(slope < 1e-10, `x[${j}] should shrink: slope ${slope}`);
  });
});
