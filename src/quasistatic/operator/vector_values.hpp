#pragma once

#include <cstddef>

#include <Eigen/Core>
#include <petscvec.h>

#include "parallel/session.hpp"

namespace breccia::quasistatic {

/// Read access to the values of a vector of PETSc on this process, during the lifetime of this object.
class ReadValues {
 public:
  explicit ReadValues(Vec vector) : vector_(vector) {
    parallel::check(VecGetArrayRead(vector_, &data_), "reading nodal values");
  }
  ReadValues(const ReadValues&) = delete;
  ReadValues& operator=(const ReadValues&) = delete;
  ReadValues(ReadValues&& other) noexcept : vector_(std::exchange(other.vector_, nullptr)), data_(other.data_) {}
  ReadValues& operator=(ReadValues&&) = delete;
  ~ReadValues() {
    if (vector_ != nullptr) VecRestoreArrayRead(vector_, &data_);
  }

  [[nodiscard]] const double* data() const noexcept { return data_; }
  /// `count` values, beginning at an index.
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> range(std::size_t index, Eigen::Index count) const noexcept {
    return {data_ + index, count};
  }

 private:
  Vec vector_;
  const double* data_ = nullptr;
};

/// Write access to the values of a vector of PETSc on this process, during the lifetime of this object.
class WriteValues {
 public:
  explicit WriteValues(Vec vector) : vector_(vector) {
    parallel::check(VecGetArray(vector_, &data_), "writing nodal values");
  }
  WriteValues(const WriteValues&) = delete;
  WriteValues& operator=(const WriteValues&) = delete;
  WriteValues(WriteValues&&) = delete;
  WriteValues& operator=(WriteValues&&) = delete;
  ~WriteValues() { VecRestoreArray(vector_, &data_); }

  [[nodiscard]] double* data() const noexcept { return data_; }
  /// `count` values, beginning at an index.
  [[nodiscard]] Eigen::Map<Eigen::VectorXd> range(std::size_t index, Eigen::Index count) const noexcept {
    return {data_ + index, count};
  }

 private:
  Vec vector_;
  double* data_ = nullptr;
};

}  // namespace breccia::quasistatic
