#pragma once

#include <utility>

#include <petscdm.h>
#include <petscksp.h>

#include "parallel/session.hpp"

namespace breccia::quasistatic {

/// Owner of one PETSc object, which it destroys at its end of life.
template <class Object, auto destroy>
class PetscHandle {
 public:
  PetscHandle() = default;
  explicit PetscHandle(Object object) noexcept : object_(object) {}
  PetscHandle(const PetscHandle&) = delete;
  PetscHandle& operator=(const PetscHandle&) = delete;
  PetscHandle(PetscHandle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  PetscHandle& operator=(PetscHandle&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~PetscHandle() {
    if (object_ != nullptr) destroy(&object_);
  }

  [[nodiscard]] Object get() const noexcept { return object_; }
  /// Another owner of the same object, which lives as long as one of them.
  [[nodiscard]] PetscHandle shared() const {
    parallel::check(PetscObjectReference(reinterpret_cast<PetscObject>(object_)), "sharing an object of PETSc");
    return PetscHandle(object_);
  }
  /// Address at which a creating function of PETSc stores the new object.
  [[nodiscard]] Object* put() noexcept { return &object_; }

 private:
  Object object_ = nullptr;
};

using NodalVector = PetscHandle<Vec, VecDestroy>;
using Matrix = PetscHandle<Mat, MatDestroy>;
using NodeGrid = PetscHandle<DM, DMDestroy>;
using Scatter = PetscHandle<VecScatter, VecScatterDestroy>;
using LinearSolver = PetscHandle<KSP, KSPDestroy>;

using parallel::check;

}  // namespace breccia::quasistatic
