#pragma once

#include <petscvec.h>

#include "breccia/parallel/session.hpp"

namespace breccia::quasistatic {

/// The values of a vector of PETSc on this process, to be read during the lifetime of this object.
class ReadValues {
 public:
  explicit ReadValues(Vec vector) : vector_(vector) {
    parallel::check(VecGetArrayRead(vector_, &data_), "reading nodal values");
  }
  ReadValues(const ReadValues&) = delete;
  ReadValues& operator=(const ReadValues&) = delete;
  ReadValues(ReadValues&&) = delete;
  ReadValues& operator=(ReadValues&&) = delete;
  ~ReadValues() { VecRestoreArrayRead(vector_, &data_); }

  [[nodiscard]] const double* data() const noexcept { return data_; }

 private:
  Vec vector_;
  const double* data_ = nullptr;
};

}  // namespace breccia::quasistatic
