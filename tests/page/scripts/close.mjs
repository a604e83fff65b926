import assert from "node:assert/strict";

/// Fails unless a number is within a relative tolerance of the expected one.
export function assertClose(actual, expected, tolerance, what) {
  const isClose = Math.abs(actual - expected) <= tolerance * Math.abs(expected);
  assert.ok(isClose, `${what}: got ${actual}, expected ${expected} within ${tolerance}`);
}
