/// Small dense systems: a matrix is a list of its rows, or of its columns where that is said.

/// Solves a system with a symmetric positive definite matrix, given by rows, by Cholesky factorisation.
export function solveSymmetric(matrix, right) {
  const n = right.length;
  const factor = matrix.map((row) => row.slice());
  for (let j = 0; j < n; ++j) {
    for (let k = 0; k < j; ++k) {
      for (let i = j; i < n; ++i) factor[i][j] -= factor[i][k] * factor[j][k];
    }
    const root = Math.sqrt(factor[j][j]);
    for (let i = j; i < n; ++i) factor[i][j] /= root;
  }
  const x = right.slice();
  for (let i = 0; i < n; ++i) {
    for (let k = 0; k < i; ++k) x[i] -= factor[i][k] * x[k];
    x[i] /= factor[i][i];
  }
  for (let i = n - 1; i >= 0; --i) {
    for (let k = i + 1; k < n; ++k) x[i] -= factor[k][i] * x[k];
    x[i] /= factor[i][i];
  }
  return x;
}

export function dot(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += a[i] * b[i];
  return sum;
}

/// Reflects a vector at the plane whose normal is a given unit vector; both count from the entry `begin` on.
function reflect(normal, vector, begin) {
  let product = 0;
  for (let i = begin; i < vector.length; ++i) product += normal[i] * vector[i];
  for (let i = begin; i < vector.length; ++i) vector[i] -= 2 * product * normal[i];
}

/// The least-squares solution x of A x = right, by Householder reflections; `columns` are those of A.
function leastSquares(columns, right) {
  const a = columns.map((column) => Float64Array.from(column));
  const b = Float64Array.from(right);
  for (let j = 0; j < a.length; ++j) {
    const normal = Float64Array.from(a[j]).fill(0, 0, j);
    const length = Math.sqrt(dot(normal, normal));
    normal[j] += normal[j] < 0 ? -length : length;
    const size = Math.sqrt(dot(normal, normal));
    for (let i = j; i < normal.length; ++i) normal[i] /= size;
    for (let k = j; k < a.length; ++k) reflect(normal, a[k], j);
    reflect(normal, b, j);
  }
  const x = new Array(a.length).fill(0);
  for (let j = a.length - 1; j >= 0; --j) {
    let sum = b[j];
    for (let k = j + 1; k < a.length; ++k) sum -= a[k][j] * x[k];
    x[j] = sum / a[j][j];
  }
  return x;
}

/// The same with x >= 0 (C. L. Lawson, R. J. Hanson, Solving least squares problems, chapter 23).
export function nonNegativeLeastSquares(columns, right) {
  const count = columns.length;
  const tolerance = 1e-13;
  const x = new Array(count).fill(0);
  const isFree = new Array(count).fill(false);
  const lengths = columns.map((column) => Math.sqrt(dot(column, column)));
  for (let round = 0; round < 3 * count; ++round) {
    const residual = residualOf(columns, right, x);
    const slopes = columns.map((column, j) => (isFree[j] ? 0 : dot(column, residual) / lengths[j]));
    // An unknown that rounding keeps from becoming positive is passed over.
    const candidates = slopes.flatMap((slope, j) => (slope > tolerance ? [j] : []))
      .sort((a, b) => slopes[b] - slopes[a]);
    if (!candidates.some((j) => moveToOptimum(columns, right, x, isFree, j))) break;
  }
  return x;
}

/// right - A x
function residualOf(columns, right, x) {
  const residual = Float64Array.from(right);
  columns.forEach((column, j) => {
    if (x[j] !== 0) for (let i = 0; i < residual.length; ++i) residual[i] -= x[j] * column[i];
  });
  return residual;
}

/// Frees the unknown `freed` and moves to the optimum of all free unknowns; those that would become negative are fixed
/// at zero. Returns false, with nothing moved, if rounding keeps the new unknown from becoming positive.
function moveToOptimum(columns, right, x, isFree, freed) {
  isFree[freed] = true;
  for (;;) {
    const free = isFree.flatMap((isOne, j) => (isOne ? [j] : []));
    const optimum = leastSquares(free.map((j) => columns[j]), right);
    if (x[freed] === 0 && !(optimum[free.indexOf(freed)] > 0)) {
      isFree[freed] = false;
      return false;
    }
    let step = 1;
    free.forEach((j, i) => {
      if (optimum[i] <= 0) step = Math.min(step, x[j] / (x[j] - optimum[i]));
    });
    free.forEach((j, i) => {
      x[j] += step * (optimum[i] - x[j]);
      if (optimum[i] <= 0 && x[j] < 1e-15 * Math.abs(optimum[i])) x[j] = 0;
      if (x[j] <= 0) [x[j], isFree[j]] = [0, false];
    });
    if (step === 1) return true;
  }
}
