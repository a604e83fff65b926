// A reduced response as a part of the state of a calculation.
#include "quasistatic/reduced/reduced_response_state.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "checkpoint/enumeration.hpp"

namespace breccia {
namespace {

void save_matrix(StateWriter& state, const std::string& name, const Eigen::MatrixXd& matrix) {
  state.write(name, std::span(matrix.data(), static_cast<std::size_t>(matrix.size())));
}

Eigen::MatrixXd read_square(const StateReader& state, const std::string& name, std::size_t side) {
  const auto values = state.numbers(name, side * side);
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(side),
                                           static_cast<Eigen::Index>(side));
}

}  // namespace

Load read_load(const StateReader& state, const std::string& name) {
  const auto number = state.integer(name);
  for (const auto& pair : pairs_of_loads) {
    if (static_cast<std::int64_t>(pair.both) == number) return pair.both;
  }
  return read_enumeration<Load>(state, name);
}

void save(StateWriter& state, const std::string& group, const ReducedResponse& response) {
  state.write(group + "/load", static_cast<std::int64_t>(response.load));
  state.write(group + "/boundary", static_cast<std::int64_t>(response.boundary));
  save_matrix(state, group + "/constant_Pa", response.constant);
  state.write(group + "/parts", static_cast<std::int64_t>(response.parts.size()));
  for (std::size_t i = 0; i < response.parts.size(); ++i) {
    const auto& [parameter, stiffness] = response.parts[i];
    const auto part = fmt::format("{}/part/{}", group, i);
    state.write(part + "/phase", parameter.phase);
    state.write(part + "/modulus", static_cast<std::int64_t>(parameter.modulus));
    save_matrix(state, part + "/stiffness", stiffness);
  }
  save_matrix(state, group + "/load_forces", response.load_forces);
  save_matrix(state, group + "/residual_products", response.residual_products);
  state.write(group + "/residual_scale", response.residual_scale);
  std::vector<double> shear, bulk, errors;
  for (const auto& [moduli, error] : response.snapshots) {
    for (const auto& of_phase : moduli) {
      shear.push_back(of_phase.shear);
      bulk.push_back(of_phase.bulk);
    }
    errors.push_back(error);
  }
  state.write(group + "/snapshots/shear_Pa", shear);
  state.write(group + "/snapshots/bulk_Pa", bulk);
  state.write(group + "/snapshots/error_before", errors);
}

ReducedResponse read_response(const StateReader& state, const std::string& group) {
  ReducedResponse response;
  response.load = read_load(state, group + "/load");
  response.boundary = read_enumeration<Boundary>(state, group + "/boundary");
  const auto forces = state.numbers(group + "/load_forces");
  const auto size = forces.size();
  response.load_forces = Eigen::Map<const Eigen::VectorXd>(forces.data(), static_cast<Eigen::Index>(size));
  response.constant = read_square(state, group + "/constant_Pa", size);
  const auto parts = state.integer(group + "/parts");
  for (std::int64_t i = 0; i < parts; ++i) {
    const auto part = fmt::format("{}/part/{}", group, i);
    response.parts.push_back({{state.text(part + "/phase"), read_enumeration<ElasticModulus>(state, part + "/modulus")},
                              read_square(state, part + "/stiffness", size)});
  }
  response.residual_products = read_square(state, group + "/residual_products", (response.parts.size() + 1) * size + 1);
  response.residual_scale = state.number(group + "/residual_scale");
  const auto shear = state.numbers(group + "/snapshots/shear_Pa");
  const auto bulk = state.numbers(group + "/snapshots/bulk_Pa", shear.size());
  const auto phases = response.phases().size();
  const auto errors = state.numbers(group + "/snapshots/error_before", shear.size() / std::max(phases, std::size_t{1}));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    auto& snapshot = response.snapshots.emplace_back(Snapshot{{}, errors[i]});
    for (std::size_t k = i * phases; k < (i + 1) * phases; ++k) {
      snapshot.moduli.push_back({.bulk = bulk[k], .shear = shear[k]});
    }
  }
  return response;
}

}  // namespace breccia
