#include "assessment/unknown_vector.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "assessment/changed_material.hpp"
#include "io/collected_mistakes.hpp"
#include "io/display.hpp"
#include "io/nearest_name.hpp"

namespace breccia {
namespace {

/// The components of an unknown.
struct ComponentsOf {
  std::size_t index;

  std::vector<UnknownComponent> operator()(const UnknownNumber& unknown) const {
    return {{.name = name_of(Unknown(unknown)),
             .unknown = index,
             .unit = std::string(unit_of(unknown.number)),
             .prior = unknown.prior}};
  }
  std::vector<UnknownComponent> operator()(const UnknownSpectrum& unknown) const {
    std::vector<UnknownComponent> components;
    for (std::size_t k = 0; k < unknown.times.size(); ++k) {
      components.push_back({.name = fmt::format("{} at {}", name_of(Unknown(unknown)), display_time(unknown.times[k])),
                            .unknown = index,
                            .term = k,
                            .unit = "Pa",
                            .prior = unknown.term});
    }
    return components;
  }
};

std::vector<std::string> mistakes_in(const std::vector<Unknown>& unknowns,
                                     const std::vector<ShiftedMaterial>& materials) {
  std::vector<std::string> mistakes, names;
  for (const auto& one : materials) names.push_back(one.material.name);
  std::set<std::string> named;
  for (const auto& unknown : unknowns) {
    const auto name = name_of(unknown);
    if (!named.insert(name).second) mistakes.push_back(fmt::format("{} is named twice", name));
    const auto& material = material_of(unknown);
    if (std::ranges::find(names, material) == names.end()) {
      mistakes.push_back(fmt::format("{}: no material \"{}\"{}", name, material, suggestion(material, names)));
    }
    if (const auto* const spectrum = std::get_if<UnknownSpectrum>(&unknown); spectrum && spectrum->times.empty()) {
      mistakes.push_back(fmt::format("{}: expected relaxation times", name));
    }
    if (auto mistake = mistake_in(prior_of(unknown)); !mistake.empty())
      mistakes.push_back(fmt::format("{}: {}", name, mistake));
  }
  return mistakes;
}

}  // namespace

UnknownVector::UnknownVector(std::vector<Unknown> unknowns, std::vector<ShiftedMaterial> materials)
    : unknowns_(std::move(unknowns)), materials_(std::move(materials)) {
  refuse_unless_empty(mistakes_in(unknowns_, materials_));
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const auto found = std::ranges::find(materials_, material_of(unknowns_[i]),
                                         [](const ShiftedMaterial& one) { return one.material.name; });
    material_of_unknown_.push_back(static_cast<std::size_t>(found - materials_.begin()));
    std::ranges::move(std::visit(ComponentsOf{i}, unknowns_[i]), std::back_inserter(components_));
  }
  // What has no meaning for a material is refused at once.
  std::vector<std::string> mistakes;
  for (std::size_t m = 0; m < materials_.size(); ++m) {
    try {
      static_cast<void>(material_at(m, Eigen::VectorXd::Zero(size())));
    } catch (const InputError& error) {
      mistakes.emplace_back(error.what());
    }
  }
  refuse_unless_empty(mistakes);
}

ShiftedMaterial UnknownVector::material_at(std::size_t material, const Eigen::VectorXd& scores) const {
  MaterialChange change;
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const auto& component = components_[c];
    if (material_of_unknown_[component.unknown] != material) continue;
    const double value = value_at_score(component.prior, scores[static_cast<Eigen::Index>(c)]);
    const auto& unknown = unknowns_[component.unknown];
    if (const auto* const number = std::get_if<UnknownNumber>(&unknown)) {
      change.numbers[number->number] = value;
    } else {
      if (!change.shear_terms) change.shear_terms.emplace();
      change.shear_terms->push_back({std::get<UnknownSpectrum>(unknown).times[component.term], value});
    }
  }
  const bool is_unchanged = change.numbers.empty() && !change.shear_terms;
  return is_unchanged ? materials_[material] : changed(materials_[material], change);
}

std::vector<ShiftedMaterial> UnknownVector::materials_at(const Eigen::VectorXd& scores) const {
  std::vector<ShiftedMaterial> materials;
  for (std::size_t m = 0; m < materials_.size(); ++m) materials.push_back(material_at(m, scores));
  return materials;
}

Eigen::VectorXd UnknownVector::prior_deviations() const {
  Eigen::VectorXd deviations(size());
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const auto* const spectrum = std::get_if<UnknownSpectrum>(&unknowns_[components_[c].unknown]);
    deviations[static_cast<Eigen::Index>(c)] =
        spectrum == nullptr ? 1.0 : std::sqrt(static_cast<double>(spectrum->times.size()));
  }
  return deviations;
}

Eigen::MatrixXd UnknownVector::curvature() const {
  std::vector<Eigen::RowVectorXd> rows;
  for (std::size_t c = 2; c < components_.size(); ++c) {
    const auto* const spectrum = std::get_if<UnknownSpectrum>(&unknowns_[components_[c].unknown]);
    if (spectrum == nullptr || components_[c].term < 2) continue;
    const auto k = components_[c].term;
    const double spacing = std::log(spectrum->times[k] / spectrum->times[k - 1]);
    const double logarithm = std::log(spectrum->term.factor) * std::pow(std::abs(spacing), -1.5);
    auto& row = rows.emplace_back(Eigen::RowVectorXd::Zero(size()));
    const auto last = static_cast<Eigen::Index>(c);
    row[last - 2] = logarithm;
    row[last - 1] = -2.0 * logarithm;
    row[last] = logarithm;
  }
  Eigen::MatrixXd curvature(static_cast<Eigen::Index>(rows.size()), size());
  for (std::size_t r = 0; r < rows.size(); ++r) curvature.row(static_cast<Eigen::Index>(r)) = rows[r];
  return curvature;
}

}  // namespace breccia
