#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"

namespace breccia {

/// The phases of a cell with their shares in steps of 1 / mixture_steps.
using CellContent = std::vector<std::pair<PhaseIndex, int>>;

/// The content of a cell in which each phase has a share of this size, by PhaseIndex: the shares of all phases except
/// the largest are rounded to steps, and the largest phase has the rest.
CellContent rounded_content(std::span<const std::int64_t> shares);

/// Fills cells with their contents, and adds a mixture to the discretisation for every new content of several phases.
template <int dim>
class MixtureNumbers {
 public:
  /// `phases` is the number of phases, which the numbers of the mixtures follow.
  MixtureNumbers(Discretisation<dim>& discretisation, std::size_t phases)
      : discretisation_(discretisation), phases_(phases) {}

  /// Throws InputError when there are more mixtures than a PhaseIndex can number.
  void fill(const Index<dim>& cell, const CellContent& content);

 private:
  Discretisation<dim>& discretisation_;
  std::size_t phases_;
  std::map<CellContent, PhaseIndex> known_;
};

}  // namespace breccia
