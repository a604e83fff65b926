#include "discretisation/mixture_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "discretisation/mixed_cells.hpp"

namespace breccia {
namespace {

Mixture mixture_of(const CellContent& content) {
  Mixture mixture;
  for (const auto& [phase, steps] : content) mixture.push_back({phase, static_cast<double>(steps) / mixture_steps});
  return mixture;
}

}  // namespace

CellContent rounded_content(std::span<const std::int64_t> shares) {
  const double steps_per_unit =
      static_cast<double>(mixture_steps) / static_cast<double>(std::reduce(shares.begin(), shares.end()));
  const auto largest = std::ranges::max_element(shares) - shares.begin();
  CellContent content;
  int rest = mixture_steps;
  for (std::size_t phase = 0; phase < shares.size(); ++phase) {
    const int steps = static_cast<int>(std::lround(steps_per_unit * static_cast<double>(shares[phase])));
    if (static_cast<std::ptrdiff_t>(phase) == largest) {
      content.emplace_back(static_cast<PhaseIndex>(phase), 0);
    } else if (steps > 0) {
      content.emplace_back(static_cast<PhaseIndex>(phase), steps);
      rest -= steps;
    }
  }
  std::ranges::find(content, static_cast<PhaseIndex>(largest), &CellContent::value_type::first)->second = rest;
  return content;
}

template <int dim>
void MixtureNumbers<dim>::fill(const Index<dim>& cell, const CellContent& content) {
  if (content.size() == 1) {
    discretisation_.fill(cell, content.front().first);
    return;
  }
  const auto [entry, is_new] = known_.try_emplace(content);
  if (is_new) entry->second = discretisation_.add_mixture(mixture_of(content), phases_);
  discretisation_.fill(cell, entry->second);
}

template class MixtureNumbers<2>;
template class MixtureNumbers<3>;

}  // namespace breccia
