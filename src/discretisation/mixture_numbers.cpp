#include "mixture_numbers.hpp"

#include "breccia/discretisation/mixed_cells.hpp"

namespace breccia {
namespace {

Mixture mixture_of(const CellContent& content) {
  Mixture mixture;
  for (const auto& [phase, steps] : content) mixture.push_back({phase, static_cast<double>(steps) / mixture_steps});
  return mixture;
}

}  // namespace

void MixtureNumbers::fill(const Index<2>& cell, const CellContent& content) {
  if (content.size() == 1) {
    discretisation_.fill(cell, content.front().first);
    return;
  }
  const auto [entry, is_new] = known_.try_emplace(content);
  if (is_new) entry->second = discretisation_.add_mixture(mixture_of(content), phases_);
  discretisation_.fill(cell, entry->second);
}

}  // namespace breccia
