#include "assessment/observed_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/carson_moduli.hpp"

#include "io/collected_mistakes.hpp"
#include "parallel/first_exception.hpp"
#include "parallel/threads.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

using Complex = std::complex<double>;

/// Whether two materials have the same shift law, at the same temperature.
bool have_same_shift(const ShiftedMaterial& one, const ShiftedMaterial& other) {
  if (!one.shift || !other.shift) return one.shift.has_value() == other.shift.has_value();
  if (one.shift->temperature != other.shift->temperature || one.shift->law.index() != other.shift->law.index()) {
    return false;
  }
  if (const auto* const law = std::get_if<WilliamsLandelFerry>(&one.shift->law)) {
    const auto& same = std::get<WilliamsLandelFerry>(other.shift->law);
    return law->c1 == same.c1 && law->c2 == same.c2 && law->reference_temperature == same.reference_temperature;
  }
  const auto &table = std::get<ShiftTable>(one.shift->law), &same = std::get<ShiftTable>(other.shift->law);
  return table.temperatures() == same.temperatures() && table.log10_factors() == same.log10_factors();
}

/// The materials of the composites that the unknowns change, each once.
std::vector<ShiftedMaterial> changed_materials(const std::vector<ObservedComposite>& composites,
                                               const std::vector<Unknown>& unknowns) {
  std::vector<ShiftedMaterial> materials;
  std::vector<std::string> mistakes;
  std::set<std::string> wanted;
  for (const auto& unknown : unknowns) wanted.insert(material_of(unknown));
  for (const auto& composite : composites) {
    for (const auto& material : composite.responder.materials()) {
      const auto& name = material.material.name;
      if (!wanted.contains(name)) continue;
      const auto* const known = find_material(materials, name);
      if (known == nullptr) {
        materials.push_back(material);
      } else if (known->material != material.material || !have_same_shift(*known, material)) {
        mistakes.push_back(
            fmt::format("{} of {} is another material than that of an earlier composite", name, composite.name));
      }
    }
  }
  refuse_unless_empty(mistakes);
  return materials;
}

std::vector<std::string> mistakes_in(const std::vector<Observation>& observations,
                                     const std::vector<ObservedComposite>& composites) {
  std::vector<std::string> mistakes;
  for (std::size_t i = 0; i < composites.size(); ++i) {
    if (std::ranges::find(observations, i, &Observation::composite) != observations.end()) continue;
    mistakes.push_back(fmt::format("nothing was measured of {}", composites[i].name));
  }
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const auto& [composite, modulus, curve, at, temperature, value, deviation] = observations[i];
    const auto expect = [&](bool is_met, std::string_view what) {
      if (!is_met) mistakes.push_back(fmt::format("measurement {}: expected {}", i + 1, what));
    };
    expect(composite < composites.size(), "a composite that is known");
    expect(at > 0.0 && std::isfinite(at), "a positive time or frequency");
    expect(value > 0.0 && std::isfinite(value), "a positive value");
    expect(deviation > 0.0 && std::isfinite(deviation), "a positive standard deviation");
  }
  return mistakes;
}

/// Throws InputError, with advice, where a material is elastic in a composite and was not sampled.
void require_variation(const ObservedComposite& composite, const std::vector<ShiftedMaterial>& changed) {
  std::vector<NewMaterial> materials;
  for (const auto& material : changed) {
    if (find_material(composite.responder.materials(), material.material.name) == nullptr) continue;
    materials.push_back(new_material(material.material.name, material));
  }
  static_cast<void>(composite.responder.with(materials));
}

const StageResponses& stage_of(const ObservedComposite& composite) {
  const auto& stages = composite.responder.stages();
  const auto found = std::ranges::find(stages, composite.stage, &StageResponses::stage);
  if (found == stages.end()) throw InputError(fmt::format("{} has no stage {}", composite.name, composite.stage));
  return *found;
}

}  // namespace

ObservedModel::ObservedModel(std::vector<ObservedComposite> composites, const std::vector<Unknown>& unknowns,
                             std::vector<Observation> observations)
    : composites_(std::move(composites)),
      observations_(std::move(observations)),
      unknowns_(unknowns, changed_materials(composites_, unknowns)),
      components_(unknowns_.components()) {
  refuse_unless_empty(mistakes_in(observations_, composites_));
  for (const auto& composite : composites_) {
    auto& factor = factors_.emplace_back();
    if (!(composite.model_deviation > 0.0)) continue;
    factor = components_.size();
    components_.push_back({.name = fmt::format("model of {}", composite.name),
                           .unknown = unknowns.size(),
                           .prior = LogNormal{1.0, 1.0 + composite.model_deviation}});
  }
  for (const auto& observation : observations_) {
    auto& [observed, points] = plans_.emplace_back(Plan{ObservedValue(observation), {}});
    for (const auto s : observed.variables()) points.push_back(point_of(observation, s));
  }
  for (const auto& composite : composites_) {
    require_variation(composite, unknowns_.materials_at(Eigen::VectorXd::Zero(size())));
  }
  // A composite without the tests that a measurement needs is refused at once.
  static_cast<void>(predictions(Eigen::VectorXd::Zero(size())));
}

std::size_t ObservedModel::state_of(const Observation& observation) {
  const auto found = std::ranges::find_if(states_, [&](const State& one) {
    return one.composite == observation.composite && one.temperature == observation.temperature;
  });
  const auto index = static_cast<std::size_t>(found - states_.begin());
  if (found == states_.end()) states_.push_back({observation.composite, observation.temperature});
  return index;
}

/// The index of the point of an observation at a Laplace variable, which several observations may share.
std::size_t ObservedModel::point_of(const Observation& observation, Complex variable) {
  const auto state = state_of(observation);
  const bool has_bulk = observation.modulus != ObservedModulus::shear;
  const auto found =
      std::ranges::find_if(points_, [&](const Point& one) { return one.state == state && one.variable == variable; });
  const auto index = static_cast<std::size_t>(found - points_.begin());
  if (found == points_.end()) {
    points_.push_back({state, variable, has_bulk});
  } else {
    found->has_bulk = found->has_bulk || has_bulk;
  }
  return index;
}

ObservedModel::MaterialsOfStates ObservedModel::materials_of_states(const Eigen::VectorXd& scores) const {
  const auto changed = unknowns_.materials_at(scores);
  MaterialsOfStates of_states;
  for (const auto& [composite, temperature] : states_) {
    auto& materials = of_states.emplace_back(composites_[composite].responder.materials());
    for (auto& material : materials) {
      if (const auto* const found = find_material(changed, material.material.name)) material = *found;
      if (temperature) material = at_temperature(std::move(material), *temperature);
    }
  }
  return of_states;
}

ObservedModel::PointModuli ObservedModel::moduli_at(const Point& point,
                                                    const std::vector<ShiftedMaterial>& materials) const {
  const auto& composite = composites_[states_[point.state].composite];
  const auto& stage = stage_of(composite);
  std::map<std::string, ComplexModuli> moduli;
  for (const auto& one : materials) moduli[one.material.name] = carson_moduli(one.material, point.variable);
  const auto under = [&](TestLoad load) {
    return composite.responder.modulus_and_gradient(composite.stage, load, composite.boundary, moduli);
  };
  PointModuli found = {.shear = under(stage.shear)};
  if (!point.has_bulk) return found;
  found.bulk = under(Load::bulk);
  const double share = shear_in_bulk_test(stage.dimensions);
  found.bulk.modulus -= share * found.shear.modulus;
  for (const auto& [material, by] : found.shear.gradient) {
    found.bulk.gradient[material].bulk -= share * by.bulk;
    found.bulk.gradient[material].shear -= share * by.shear;
  }
  return found;
}

int ObservedModel::threads() const {
  constexpr std::int64_t points_of_a_thread = 50;
  return parallel::threads_for(0, std::ssize(points_), points_of_a_thread);
}

std::vector<ObservedModel::PointModuli> ObservedModel::moduli_at_points(const Eigen::VectorXd& scores) const {
  const auto materials = materials_of_states(scores);
  std::vector<PointModuli> moduli(points_.size());
  parallel::FirstException failure;
#pragma omp parallel for num_threads(threads()) schedule(static)
  for (std::size_t i = 0; i < points_.size(); ++i) {
    failure.run([&] { moduli[i] = moduli_at(points_[i], materials[points_[i].state]); });
  }
  failure.rethrow();
  return moduli;
}

/// The factor by which the model of a composite changes an observation.
double ObservedModel::factor(std::size_t observation, const Eigen::VectorXd& scores) const {
  const auto& component = factors_[observations_[observation].composite];
  if (!component) return 1.0;
  const double of_modulus =
      value_at_score(components_[*component].prior, scores[static_cast<Eigen::Index>(*component)]);
  return std::pow(of_modulus, plans_[observation].observed.power_of_factor());
}

Eigen::VectorXd ObservedModel::predictions_from(const std::vector<PointModuli>& moduli,
                                                const Eigen::VectorXd& scores) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(observations_.size()));
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    const auto& [observed, points] = plans_[i];
    std::vector<Complex> at_points;
    for (const auto point : points) {
      const auto& [shear, bulk] = moduli[point];
      at_points.push_back(observed_modulus(observations_[i].modulus, shear.modulus, bulk.modulus).value);
    }
    values[static_cast<Eigen::Index>(i)] = observed.value(at_points) * factor(i, scores);
  }
  return values;
}

Eigen::VectorXd ObservedModel::predictions(const Eigen::VectorXd& scores) const {
  return predictions_from(moduli_at_points(scores), scores);
}

/// The differences of the moduli of two forms of a material at all points; zero at those of composites without it. Most
/// unknowns change a few terms, so that the difference of the series has few.
std::vector<ComplexModuli> ObservedModel::differences(const ShiftedMaterial& more, const ShiftedMaterial& less) const {
  std::vector<std::optional<Material>> in_states;
  for (const auto& [composite, temperature] : states_) {
    auto& difference = in_states.emplace_back();
    if (find_material(composites_[composite].responder.materials(), more.material.name) == nullptr) continue;
    const auto in_state = [&temperature = temperature](const ShiftedMaterial& material) {
      return temperature ? at_temperature(material, *temperature).material : material.material;
    };
    const auto whole = in_state(more), part = in_state(less);
    difference = Material{.name = more.material.name,
                          .bulk = PronySeries::difference(whole.bulk, part.bulk),
                          .shear = PronySeries::difference(whole.shear, part.shear)};
  }
  std::vector<ComplexModuli> moduli;
  for (const auto& point : points_) {
    const auto& difference = in_states[point.state];
    moduli.push_back(difference ? carson_moduli(*difference, point.variable) : ComplexModuli{});
  }
  return moduli;
}

/// The changes of all observed values, before the factors of the models, where the moduli of a material change by
/// these differences at the points; to first order.
Eigen::VectorXd ObservedModel::changes(const std::vector<PointModuli>& moduli, const std::string& material,
                                       const std::vector<ComplexModuli>& differences) const {
  const auto along = [&](const ModulusAndGradient& modulus, std::size_t point) -> Complex {
    const auto by = modulus.gradient.find(material);
    if (by == modulus.gradient.end()) return 0.0;
    return by->second.bulk * differences[point].bulk + by->second.shear * differences[point].shear;
  };
  Eigen::VectorXd changes(static_cast<Eigen::Index>(observations_.size()));
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    const auto& [observed, points] = plans_[i];
    std::vector<Complex> values, changes_at_points;
    for (const auto point : points) {
      const auto& [shear, bulk] = moduli[point];
      const auto [value, by_shear, by_bulk] = observed_modulus(observations_[i].modulus, shear.modulus, bulk.modulus);
      values.push_back(value);
      changes_at_points.push_back(by_shear * along(shear, point) + by_bulk * along(bulk, point));
    }
    changes[static_cast<Eigen::Index>(i)] = observed.change(values, changes_at_points);
  }
  return changes;
}

Eigen::MatrixXd ObservedModel::jacobian(const Eigen::VectorXd& scores) const {
  const auto moduli = moduli_at_points(scores);
  const auto values = predictions_from(moduli, scores);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(values.size(), size());

  // The moduli of a material take no time: central differences of them err by 1e-7. The derivatives of the composite by
  // its materials are exact.
  constexpr double step = 1e-4;
  for (Eigen::Index column = 0; column < unknowns_.size(); ++column) {
    const auto material = unknowns_.index_of_material(static_cast<std::size_t>(column));
    const Eigen::VectorXd move = step * Eigen::VectorXd::Unit(scores.size(), column);
    const auto more = unknowns_.material_at(material, scores + move);
    const auto less = unknowns_.material_at(material, scores - move);
    jacobian.col(column) = changes(moduli, more.material.name, differences(more, less)) / (2.0 * step);
  }
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto& observation = observations_[i];
    jacobian.row(row) *= factor(i, scores);
    // The deviation of all but a phase is that of the logarithm.
    if (observation.curve != ObservedCurve::phase) jacobian.row(row) /= values[row];
    if (const auto& component = factors_[observation.composite]) {
      jacobian(row, static_cast<Eigen::Index>(*component)) =
          plans_[i].observed.power_of_factor() * std::log(std::get<LogNormal>(components_[*component].prior).factor);
    }
    jacobian.row(row) /= observation.deviation;
  }
  return jacobian;
}

}  // namespace breccia
