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

/// Reflects a vector at the plane whose normal is a given unit vector; both start at the entry `begin`.
function reflect(normal, vector, begin) {
  let product = 0;
  for (let i = begin; i < vector.length; ++i) product += normal[i] * vector[i];
  for (let i = begin; i < vector.length; ++i) vector[i] -= 2 * product * normal[i];
}

/// The least-squares solution of A x = right by Householder reflections, for a matrix A that gains and loses columns.
class LeastSquares {
  #right;
  #steps = [];  // for each column the reflection, the reflected column and the reflected right side

  constructor(right) {
    this.#right = Float64Array.from(right);
  }

  /// Appends a column to A.
  add(column) {
    const place = this.#steps.length;
    const reflected = Float64Array.from(column);
    this.#steps.forEach(({normal}, i) => reflect(normal, reflected, i));
    const normal = reflected.slice().fill(0, 0, place);
    const length = Math.sqrt(dot(normal, normal));
    normal[place] += normal[place] < 0 ? -length : length;
    const size = Math.sqrt(dot(normal, normal));
    for (let i = place; i < normal.length; ++i) normal[i] /= size;
    reflect(normal, reflected, place);
    const right = (place === 0 ? this.#right : this.#steps.at(-1).right).slice();
    reflect(normal, right, place);
    this.#steps.push({normal, column: reflected, right});
  }

  /// Keeps the first columns of A alone.
  truncate(count) {
    this.#steps.length = count;
  }

  /// x, by the upper triangle that the reflections make of A.
  solution() {
    const count = this.#steps.length;
    const x = new Array(count).fill(0);
    for (let i = count - 1; i >= 0; --i) {
      let sum = this.#steps.at(-1).right[i];
      for (let k = i + 1; k < count; ++k) sum -= this.#steps[k].column[i] * x[k];
      x[i] = sum / this.#steps[i].column[i];
    }
    return x;
  }
}

/// The least-squares solution with x >= 0 (C. L. Lawson, R. J. Hanson, Solving least squares problems, chapter 23);
/// `columnsOfA` is a list of columns.
export function nonNegativeLeastSquares(columnsOfA, right) {
  const columns = columnsOfA.map((column) => Float64Array.from(column));
  const count = columns.length;
  const tolerance = 1e-13;
  const x = new Array(count).fill(0);
  const free = [];  // the unknowns above zero, in the order of the columns of their system
  const system = new LeastSquares(right);
  const lengths = columns.map((column) => Math.sqrt(dot(column, column)));
  for (let round = 0; round < 3 * count; ++round) {
    const residual = residualOf(columns, right, x);
    const slopes = columns.map((column, j) => (x[j] > 0 ? 0 : dot(column, residual) / lengths[j]));
    // An unknown that rounding keeps from becoming positive is passed over.
    const candidates = slopes.flatMap((slope, j) => (slope > tolerance ? [j] : []))
      .sort((a, b) => slopes[b] - slopes[a]);
    if (!candidates.some((j) => moveToOptimum(columns, system, x, free, j))) break;
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
function moveToOptimum(columns, system, x, free, freed) {
  free.push(freed);
  system.add(columns[freed]);
  for (;;) {
    const optimum = system.solution();
    if (x[freed] === 0 && !(optimum.at(-1) > 0)) {
      free.pop();
      system.truncate(free.length);
      return false;
    }
    let step = 1;
    free.forEach((j, i) => {
      if (optimum[i] <= 0) step = Math.min(step, x[j] / (x[j] - optimum[i]));
    });
    free.forEach((j, i) => {
      x[j] += step * (optimum[i] - x[j]);
      if (x[j] <= 0 || (optimum[i] <= 0 && x[j] < 1e-15 * Math.abs(optimum[i]))) x[j] = 0;
    });
    dropZeros(columns, system, x, free);
    if (step === 1 || x[freed] === 0) return true;
  }
}

/// Takes the unknowns that are zero out of the system.
function dropZeros(columns, system, x, free) {
  const first = free.findIndex((j) => x[j] === 0);
  if (first === -1) return;
  const rest = free.splice(first).filter((j) => x[j] > 0);
  system.truncate(first);
  for (const j of rest) {
    free.push(j);
    system.add(columns[j]);
  }
}
