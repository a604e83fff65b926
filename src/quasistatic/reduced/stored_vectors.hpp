#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "checkpoint/state.hpp"
#include "quasistatic/reduced/affine_composite.hpp"

namespace breccia::quasistatic {

/// The origin of a vector of a reduced basis: an amount of a displacement, and these amounts of the earlier vectors.
struct VectorOrigin {
  /// Moduli [Pa] for which the displacement is a solution; nothing for other displacements.
  std::optional<std::vector<double>> parameters;
  Eigen::VectorXd of_earlier;
};

/// The vectors of a reduced basis, stored completely.
template <DisplacementVector Vector>
class StoredVectors {
 public:
  [[nodiscard]] std::size_t size() const noexcept { return vectors_.size(); }
  [[nodiscard]] const Vector& at(std::size_t index) const { return vectors_.at(index); }
  void add(Vector vector, const VectorOrigin& /*origin*/) { vectors_.push_back(std::move(vector)); }

  /// The work of forces on each of the vectors.
  [[nodiscard]] Eigen::VectorXd works(const Vector& forces) const {
    Eigen::VectorXd works(static_cast<Eigen::Index>(size()));
    for (std::size_t i = 0; i < size(); ++i) works[static_cast<Eigen::Index>(i)] = work(forces, vectors_[i]);
    return works;
  }
  /// sum += the vectors times these weights
  void add_to(Vector& sum, const Eigen::VectorXd& weights) const {
    for (std::size_t i = 0; i < size(); ++i) sum.add(weights[static_cast<Eigen::Index>(i)], vectors_[i]);
  }

  void save(StateWriter& state, const std::string& group) const {
    state.write(group + "/vectors", static_cast<std::int64_t>(size()));
    for (std::size_t i = 0; i < size(); ++i) save_vector(state, fmt::format("{}/vector/{}", group, i), vectors_[i]);
  }
  void restore(const StateReader& state, const std::string& group, const std::function<Vector()>& zero) {
    const auto count = state.integer(group + "/vectors");
    vectors_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      restore_vector(state, fmt::format("{}/vector/{}", group, i), vectors_.emplace_back(zero()));
    }
  }

 private:
  std::vector<Vector> vectors_;
};

}  // namespace breccia::quasistatic
