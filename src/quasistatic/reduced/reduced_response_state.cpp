// A reduced response as a part of the state of a calculation.
#include "breccia/quasistatic/reduced_response_state.hpp"

#include <cstddef>
#include <cstdint>

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

void save(StateWriter& state, const std::string& group, const ReducedResponse& response) {
  state.write(group + "/load", static_cast<std::int64_t>(response.load));
  state.write(group + "/boundary", static_cast<std::int64_t>(response.boundary));
  save_matrix(state, group + "/filler_Pa", response.filler);
  save_matrix(state, group + "/matrix_shear", response.matrix_shear);
  save_matrix(state, group + "/matrix_bulk", response.matrix_bulk);
  save_matrix(state, group + "/load_forces", response.load_forces);
  save_matrix(state, group + "/residual_products", response.residual_products);
  state.write(group + "/residual_scale", response.residual_scale);
  std::vector<double> shear, bulk, errors;
  for (const auto& [matrix, error] : response.snapshots) {
    shear.push_back(matrix.shear);
    bulk.push_back(matrix.bulk);
    errors.push_back(error);
  }
  state.write(group + "/snapshots/shear_Pa", shear);
  state.write(group + "/snapshots/bulk_Pa", bulk);
  state.write(group + "/snapshots/error_before", errors);
}

ReducedResponse read_response(const StateReader& state, const std::string& group) {
  ReducedResponse response;
  response.load = static_cast<Load>(state.integer(group + "/load"));
  response.boundary = static_cast<Boundary>(state.integer(group + "/boundary"));
  const auto forces = state.numbers(group + "/load_forces");
  const auto size = forces.size();
  response.load_forces = Eigen::Map<const Eigen::VectorXd>(forces.data(), static_cast<Eigen::Index>(size));
  response.filler = read_square(state, group + "/filler_Pa", size);
  response.matrix_shear = read_square(state, group + "/matrix_shear", size);
  response.matrix_bulk = read_square(state, group + "/matrix_bulk", size);
  // Of three parts of each vector, and the load.
  response.residual_products = read_square(state, group + "/residual_products", 3 * size + 1);
  response.residual_scale = state.number(group + "/residual_scale");
  const auto shear = state.numbers(group + "/snapshots/shear_Pa");
  const auto bulk = state.numbers(group + "/snapshots/bulk_Pa", shear.size());
  const auto errors = state.numbers(group + "/snapshots/error_before", shear.size());
  for (std::size_t i = 0; i < shear.size(); ++i) {
    response.snapshots.push_back({{.bulk = bulk[i], .shear = shear[i]}, errors[i]});
  }
  return response;
}

}  // namespace breccia
