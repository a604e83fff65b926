/// Extrapolates a value from grids of different cell sizes to vanishing cells: first order in the side of a cell, by
/// the two finest grids (docs/theory.md, Eq. 21). `grids` is a list of {cells, value}, `cells` being the number along a
/// side of the box. One grid alone gives its own value.
export function limitOfCells(grids) {
  const [fine, coarse] = [...grids].sort((a, b) => b.cells - a.cells);
  if (coarse === undefined) return fine.value;
  return fine.value - ((coarse.value - fine.value) / (1 / coarse.cells - 1 / fine.cells)) / fine.cells;
}
