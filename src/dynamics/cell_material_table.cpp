#include "dynamics/cell_material_table.hpp"

#include <algorithm>
#include <cstddef>

#include "dynamics/maxwell_step.hpp"

namespace breccia::dynamics {

template <int dim>
CellMaterialTable<dim>::CellMaterialTable(const std::vector<Material>& materials, double time_step) {
  std::size_t most = 0;
  const auto add_terms = [&](const PronySeries& series) {
    const auto& terms = terms_.emplace_back(maxwell_steps(series, time_step));
    most = std::max(most, terms.size());
    return static_cast<int>(terms.size());
  };
  const auto add = [&](const PronySeries& shear, const PronySeries& dilatational) {
    CellMaterialStep step = {dilatational.equilibrium(), shear.equilibrium(), nullptr, nullptr, 0, 0};
    step.shear_term_count = add_terms(shear);
    step.dilatational_term_count = add_terms(dilatational);
    steps_.push_back(step);
  };
  for (const auto& material : materials) add(material.shear, dilatational_series<dim>(material));
  add({}, {});
  // The kernel reads whole registers of terms.
  const auto length = (most + lanes / 2 - 1) / (lanes / 2) * (lanes / 2);
  for (auto& list : terms_) list.resize(length, TermStep{0.0, 0.0});
  for (std::size_t m = 0; m < steps_.size(); ++m) {
    steps_[m].shear_terms = terms_[2 * m].data();
    steps_[m].dilatational_terms = terms_[2 * m + 1].data();
  }
}

template class CellMaterialTable<2>;
template class CellMaterialTable<3>;

}  // namespace breccia::dynamics
