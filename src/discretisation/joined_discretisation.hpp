#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"

#include "parallel/machine.hpp"

namespace breccia {

/// The layers of cells in one of several parts of a grid. Parts have numbers from 0 to parts - 1 and follow one
/// another.
[[nodiscard]] CellLayers layers_of_part(int layers, int part, int parts);

/// A whole microstructure from its parts: every process of a machine passes the layers_of_part() of its rank on the
/// machine, and gets all layers, of which the machine holds one copy in memory. Mixtures have the numbers that a single
/// process would have given them; they follow those of the `phases` phases. All processes of the machine must call the
/// function. Where `common_memory` returns null, each process has a copy of its own. Throws InputError, on all
/// processes, when there are more mixtures than a PhaseIndex can number. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> joined_on_machine(
    const Discretisation<dim>& part, std::size_t phases,
    const std::function<std::shared_ptr<std::byte>(std::size_t)>& common_memory = parallel::common_memory);

/// The mixtures of several parts, each once, in the order of the parts and of their lists.
struct JoinedMixtures {
  std::vector<Mixture> mixtures;
  /// For each part the indices of its mixtures in this list.
  std::vector<std::vector<std::size_t>> numbers;
};
[[nodiscard]] JoinedMixtures join_mixtures(std::span<const std::vector<Mixture>> parts);

}  // namespace breccia
