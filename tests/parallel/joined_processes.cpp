// A test under mpirun: processes that make layers of a microstructure together get a result that is bitwise identical
// to that of a single process, in common memory and, where there is none, each in its own memory.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string_view>

#include <mpi.h>

#include "breccia/error.hpp"

#include "discretisation/joined_discretisation.hpp"
#include "discretisation/labels.hpp"
#include "discretisation/mixed_cells.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/communicator.hpp"
#include "parallel/machine.hpp"
#include "parallel/session.hpp"

namespace {

namespace parallel = breccia::parallel;
using breccia::CellLayers;
using breccia::Discretisation;

/// Prints the mistake unless the condition is true.
bool expect(bool holds, const char* wrong) {
  if (!holds) std::puts(wrong);
  return holds;
}

template <int dim>
bool are_equal(const Discretisation<dim>& one, const Discretisation<dim>& other) {
  return std::ranges::equal(one.cells(), other.cells()) && one.mixtures() == other.mixtures() &&
         one.first_mixture() == other.first_mixture();
}

std::shared_ptr<std::byte> no_memory(std::size_t) {
  return nullptr;
}

/// Whether the joined parts of the processes equal the whole that each process makes, with common memory and without.
template <int dim, class Make>
bool is_joined(int layers, const Make& make) {
  const auto own = breccia::layers_of_part(layers, parallel::rank_on_machine(), parallel::ranks_on_machine());
  const auto part = make(own);
  const auto whole = make(CellLayers{});
  return are_equal<dim>(breccia::joined_on_machine<dim>(part, 2), whole) &&
         are_equal<dim>(breccia::joined_on_machine<dim>(part, 2, no_memory), whole);
}

/// Whether all processes read the values that each has written to the common memory; also if there is none.
bool memory_is_common() {
  const auto rank = static_cast<std::size_t>(parallel::rank_on_machine());
  const auto ranks = static_cast<std::size_t>(parallel::ranks_on_machine());
  const auto memory = parallel::common_memory(ranks);
  if (memory == nullptr) {
    std::puts("this system gives processes no memory in common");
    return true;
  }
  memory.get()[rank] = static_cast<std::byte>(rank + 1);
  MPI_Barrier(parallel::machine_communicator());
  for (std::size_t other = 0; other < ranks; ++other) {
    if (memory.get()[other] != static_cast<std::byte>(other + 1)) return false;
  }
  return true;
}

/// Whether a mistake of the last process is thrown on all processes.
bool mistakes_are_common() {
  try {
    static_cast<void>(parallel::made_by_all([] {
      if (parallel::rank() == parallel::ranks() - 1) throw breccia::InputError("of the last process");
      return 1;
    }));
  } catch (const breccia::InputError& error) {
    return std::string_view(error.what()) == "of the last process";
  }
  return false;
}

/// Whether a failure of the first process alone, which writes for all, is thrown on all processes as an error of the
/// same kind.
template <class Failure>
bool is_thrown_on_all(const Failure& failure) {
  bool has_written = false;
  try {
    parallel::done_by_first([&] {
      has_written = true;
      throw failure;
    });
  } catch (const Failure& error) {
    return std::string_view(error.what()) == failure.what() && has_written == (parallel::rank() == 0);
  }
  return false;
}

bool failures_of_the_first_are_common() {
  parallel::done_by_first([] {});
  return is_thrown_on_all(breccia::FileError("no space left")) && is_thrown_on_all(breccia::InputError("in the way")) &&
         is_thrown_on_all(breccia::DirectoryInUse("another process")) &&
         is_thrown_on_all(breccia::NumericalError("no convergence")) &&
         is_thrown_on_all(breccia::Interrupted("enough")) && is_thrown_on_all(std::bad_alloc()) &&
         is_thrown_on_all(std::runtime_error("something else"));
}

}  // namespace

int main() {
  parallel::start();
  const std::array<breccia::PhaseIndex, 2> phases = {1, 1};
  const breccia::Microstructure<2> discs = {1.0, breccia::Walls::periodic, {{{0.05, 0.9}, 0.5}, {{0.52, 0.41}, 0.37}}};
  const breccia::Microstructure<3> spheres = {
      1.0, breccia::Walls::periodic, {{{0.05, 0.9, 0.98}, 0.5}, {{0.52, 0.41, 0.43}, 0.37}}};
  const auto of_particles = breccia::without_coatings(phases);
  const std::span<const breccia::ParticlePhases> particles(of_particles);
  const auto in_wave = [](const breccia::Vector<2>& place) {
    return breccia::PhaseAt{static_cast<breccia::PhaseIndex>(std::sin(9.0 * place[0] + 7.0 * place[1]) > 0.3)};
  };
  const breccia::Grid<2> grid = {{31, 30}, 1.0 / 30};

  bool holds = expect(memory_is_common(), "common memory does not hold what others have written");
  holds = expect(mistakes_are_common(), "a mistake of one process is not thrown on all") && holds;
  holds = expect(failures_of_the_first_are_common(), "a failure of the first process is not thrown on all") && holds;
  holds = expect(parallel::made_by_all([] { return 7; }) == 7, "what all have made is not returned") && holds;
  holds =
      expect(is_joined<2>(
                 40, [&](const CellLayers& layers) { return discretise_mixed(discs, 40, 0, particles, 2, layers); }),
             "mixed cells of discs are others") &&
      holds;
  holds = expect(is_joined<2>(
                     2, [&](const CellLayers& layers) { return discretise_mixed(discs, 2, 0, particles, 2, layers); }),
                 "mixed cells are others where a process has none") &&
          holds;
  holds =
      expect(is_joined<3>(
                 12, [&](const CellLayers& layers) { return discretise_mixed(spheres, 12, 0, particles, 2, layers); }),
             "mixed cells of spheres are others") &&
      holds;
  holds =
      expect(is_joined<3>(12, [&](const CellLayers& layers) { return discretise(spheres, 12, 0, particles, layers); }),
             "points of spheres are others") &&
      holds;
  holds = expect(is_joined<2>(30, [&](const CellLayers& layers) { return discretise_mixed(grid, in_wave, 2, layers); }),
                 "mixed cells of a labelling are others") &&
          holds;
  parallel::stop();
  return holds ? 0 : 1;
}
