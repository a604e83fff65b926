#include "quasistatic/solvers/saddle_point/slope_elimination.hpp"

#include <algorithm>

namespace breccia::quasistatic {

SlopeElimination::SlopeElimination(const SaddlePointOperator& saddle)
    : saddle_(&saddle),
      slope_of_term_(saddle.forms().slopes.count()),
      weight_of_slope_(saddle.forms().slopes.count()),
      compliance_(saddle.diagonal_of_slopes()) {
  const auto& terms = saddle.forms().slopes;
  const auto first_gap = saddle.first_gap();
  for (std::size_t term = 0; term < terms.count(); ++term) {
    terms.forms.for_parts(term, [&](std::size_t entry, double weight) {
      if (entry < first_gap) return;
      slope_of_term_[term] = entry;
      weight_of_slope_[term] = weight;
    });
  }
  for (double& value : compliance_) value = value > 0.0 ? 1.0 / value : 0.0;
}

template <class Action>
void SlopeElimination::for_terms(const Action& action) const {
  const auto& stiffness = saddle_->stiffness_of_slopes();
  for (std::size_t term = 0; term < stiffness.size(); ++term) {
    action(term, stiffness[term], slope_of_term_[term], weight_of_slope_[term]);
  }
}

void SlopeElimination::condense(const NodalField& right, NodalField& forces) const {
  std::ranges::copy(right.all(), forces.all().begin());
  const auto first_gap = saddle_->first_gap();
  const double* rights = right.all().data();
  double* on_nodes = forces.all().data();
  for_terms([&](std::size_t term, double stiffness, std::size_t slope, double weight) {
    const double moved = compliance_[slope - first_gap] * rights[slope];
    saddle_->forms().slopes.forms.for_parts(term, [&](std::size_t entry, double of_node) {
      if (entry < first_gap) on_nodes[entry] -= stiffness * of_node * weight * moved;
    });
  });
}

void SlopeElimination::recover(const NodalField& right, NodalField& displacement) const {
  const auto first_gap = saddle_->first_gap();
  const double* rights = right.all().data();
  double* values = displacement.all().data();
  for (std::size_t gap = 0; gap < compliance_.size(); ++gap) {
    if (compliance_[gap] > 0.0) values[first_gap + gap] = compliance_[gap] * rights[first_gap + gap];
  }
  for_terms([&](std::size_t term, double stiffness, std::size_t slope, double weight) {
    double of_nodes = 0.0;
    saddle_->forms().slopes.forms.for_parts(term, [&](std::size_t entry, double of_node) {
      if (entry < first_gap) of_nodes += of_node * values[entry];
    });
    values[slope] -= compliance_[slope - first_gap] * stiffness * weight * of_nodes;
  });
}

}  // namespace breccia::quasistatic
