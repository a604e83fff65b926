#include "discretisation/joined_discretisation.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include <mpi.h>

#include "parallel/communicator.hpp"
#include "parallel/machine.hpp"

namespace breccia {
namespace {

/// The lists of values of all processes of the machine, by rank.
std::vector<std::vector<double>> gathered_on_machine(const std::vector<double>& own) {
  const auto machine = parallel::machine_communicator();
  std::vector<int> counts(static_cast<std::size_t>(parallel::ranks_on_machine())), begins;
  const int count = static_cast<int>(own.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, machine);
  int all = 0;
  for (const int each : counts) begins.push_back(std::exchange(all, all + each));
  std::vector<double> values(static_cast<std::size_t>(all));
  MPI_Allgatherv(own.data(), count, MPI_DOUBLE, values.data(), counts.data(), begins.data(), MPI_DOUBLE, machine);
  std::vector<std::vector<double>> lists;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    const auto begin = values.begin() + begins[rank];
    lists.emplace_back(begin, begin + counts[rank]);
  }
  return lists;
}

/// Mixtures as numbers: for each mixture the number of its parts, then their phases and fractions.
std::vector<double> numbers_of(const std::vector<Mixture>& mixtures) {
  std::vector<double> numbers;
  for (const auto& mixture : mixtures) {
    numbers.push_back(static_cast<double>(mixture.size()));
    for (const auto& [phase, fraction] : mixture) numbers.insert(numbers.end(), {static_cast<double>(phase), fraction});
  }
  return numbers;
}

std::vector<Mixture> mixtures_of(const std::vector<double>& numbers) {
  std::vector<Mixture> mixtures;
  for (auto at = numbers.begin(); at != numbers.end();) {
    auto& mixture = mixtures.emplace_back(static_cast<std::size_t>(*at++));
    for (auto& [phase, fraction] : mixture) {
      phase = static_cast<PhaseIndex>(*at++);
      fraction = *at++;
    }
  }
  return mixtures;
}

/// The cells of all processes of the machine in order, where the processes have no common memory: each has a copy of
/// its own.
template <int dim>
SharedCells<dim> gathered_cells(const Grid<dim>& grid, const std::vector<CellPhases<dim>>& own) {
  const int parts = parallel::ranks_on_machine();
  // MPI counts in 32 bits, so cells are passed in whole layers.
  const auto of_layer = grid.cell_count() / static_cast<std::size_t>(grid.cells.back());
  MPI_Datatype layer = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(of_layer * sizeof(CellPhases<dim>)), MPI_BYTE, &layer);
  MPI_Type_commit(&layer);
  std::vector<int> counts, begins;
  for (int part = 0; part < parts; ++part) {
    const auto [begin, end] = layers_of_part(grid.cells.back(), part, parts);
    begins.push_back(begin);
    counts.push_back(end - begin);
  }
  auto cells = std::make_shared<CellArray<dim>>(grid.cell_count());
  MPI_Allgatherv(own.data(), counts[static_cast<std::size_t>(parallel::rank_on_machine())], layer, cells.get(),
                 counts.data(), begins.data(), layer, parallel::machine_communicator());
  MPI_Type_free(&layer);
  return cells;
}

/// The cells of all processes of the machine, in common memory; the cells of this process come after `first` others.
template <int dim>
SharedCells<dim> common_cells(const std::shared_ptr<std::byte>& memory, std::size_t first,
                              const std::vector<CellPhases<dim>>& own) {
  const std::shared_ptr<CellArray<dim>> cells(memory, reinterpret_cast<CellPhases<dim>*>(memory.get()));
  std::ranges::copy(own, cells.get() + first);
  MPI_Barrier(parallel::machine_communicator());
  return cells;
}

}  // namespace

CellLayers layers_of_part(int layers, int part, int parts) {
  const auto first_of = [&](int which) { return static_cast<int>(static_cast<std::int64_t>(layers) * which / parts); };
  return {first_of(part), first_of(part + 1)};
}

JoinedMixtures join_mixtures(std::span<const std::vector<Mixture>> parts) {
  const auto comes_before = [](const Mixture& one, const Mixture& other) {
    return std::ranges::lexicographical_compare(
        one, other, {}, [](const MixedPart& part) { return std::pair(part.phase, part.fraction); },
        [](const MixedPart& part) { return std::pair(part.phase, part.fraction); });
  };
  std::map<Mixture, std::size_t, decltype(comes_before)> known(comes_before);
  JoinedMixtures joined;
  for (const auto& part : parts) {
    auto& numbers = joined.numbers.emplace_back();
    for (const auto& mixture : part) {
      const auto [entry, is_new] = known.try_emplace(mixture, joined.mixtures.size());
      if (is_new) joined.mixtures.push_back(mixture);
      numbers.push_back(entry->second);
    }
  }
  return joined;
}

template <int dim>
Discretisation<dim> joined_on_machine(const Discretisation<dim>& part, std::size_t phases,
                                      const std::function<std::shared_ptr<std::byte>(std::size_t)>& common_memory) {
  if (parallel::ranks_on_machine() == 1) return part;
  std::vector<std::vector<Mixture>> of_parts;
  for (const auto& numbers : gathered_on_machine(numbers_of(part.mixtures()))) of_parts.push_back(mixtures_of(numbers));
  auto joined = join_mixtures(of_parts);
  const auto& grid = part.grid();
  Discretisation<dim> numbered(grid, 0, {0, 0});
  std::vector<PhaseIndex> numbers;
  for (auto& mixture : joined.mixtures) numbers.push_back(numbered.add_mixture(std::move(mixture), phases));

  const auto& joined_numbers = joined.numbers[static_cast<std::size_t>(parallel::rank_on_machine())];
  std::vector<CellPhases<dim>> cells(part.cells().begin(), part.cells().end());
  for (auto& cell : cells) {
    for (auto& phase : cell) {
      if (part.mixture(phase) == nullptr) continue;
      phase = numbers[joined_numbers[static_cast<std::size_t>(phase - part.first_mixture())]];
    }
  }
  const auto memory = common_memory(grid.cell_count() * sizeof(CellPhases<dim>));
  auto all = memory == nullptr ? gathered_cells<dim>(grid, cells)
                               : common_cells<dim>(memory, grid.cell_index(part.range().begin), cells);
  Discretisation<dim> whole(grid, std::move(all), numbered.mixtures(), numbered.first_mixture());
  whole.set_particles_with_gaps(part.particles_with_gaps());
  return whole;
}

using GiveMemory = std::function<std::shared_ptr<std::byte>(std::size_t)>;
template Discretisation<2> joined_on_machine(const Discretisation<2>&, std::size_t, const GiveMemory&);
template Discretisation<3> joined_on_machine(const Discretisation<3>&, std::size_t, const GiveMemory&);

}  // namespace breccia
