#pragma once

#include <cstddef>
#include <span>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/parallel/ordered_values.hpp"

#include "parallel/common_failure.hpp"
#include "parallel/first_exception.hpp"

namespace breccia {

/// Brings fields, whose values are spread over the processes cell by cell, to the first process in pieces, in the order
/// of the lattice, so that no process holds all of them. Calls begin() there, then take(index of the first value,
/// piece) for one piece after the other, then finish(). Every process must call the function; exceptions of these
/// functions are thrown at the end, on all processes.
template <int dim, class Begin, class Take, class Finish>
void collect_fields(const Grid<dim>& grid, const LatticeFields<dim>& own, const Begin& begin, const Take& take,
                    const Finish& finish) {
  parallel::FirstException failure;
  if (parallel::is_collecting()) failure.run(begin);
  const auto places = places_of_timed_fields(grid, own.cells);
  parallel::for_each_piece(size_of_timed_fields(grid), [&](std::size_t first, std::size_t end) {
    const auto collected = [&](const auto& values) { return parallel::collect(std::span(values), places, first, end); };
    const LatticeFields<dim> piece = {.cells = own.cells,
                                      .phase = collected(own.phase),
                                      .displacement = collected(own.displacement),
                                      .strain = collected(own.strain),
                                      .stress = collected(own.stress)};
    if (parallel::is_collecting()) failure.run([&] { take(first, piece); });
  });
  if (parallel::is_collecting()) failure.run(finish);
  parallel::do_together([&] { failure.rethrow(); });
}

}  // namespace breccia
