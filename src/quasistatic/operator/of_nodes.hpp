#pragma once

#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// The values of the nodes in a nodal vector, as a vector of the grid of nodes.
class OfNodes {
 public:
  OfNodes(DM nodes, Vec nodal, bool has_further_values) : nodes_(nodes), nodal_(nodal) {
    if (!has_further_values) return;
    check(VecGetArray(nodal_, &values_), what);
    check(DMGetGlobalVector(nodes_, &view_), what);
    check(VecPlaceArray(view_, values_), what);
  }
  OfNodes(const OfNodes&) = delete;
  OfNodes& operator=(const OfNodes&) = delete;
  OfNodes(OfNodes&&) = delete;
  OfNodes& operator=(OfNodes&&) = delete;
  ~OfNodes() {
    if (view_ == nullptr) return;
    VecResetArray(view_);
    DMRestoreGlobalVector(nodes_, &view_);
    VecRestoreArray(nodal_, &values_);
  }

  [[nodiscard]] Vec get() const noexcept { return view_ != nullptr ? view_ : nodal_; }

 private:
  static constexpr const char* what = "reading the values of nodes";
  DM nodes_;
  Vec nodal_, view_ = nullptr;
  double* values_ = nullptr;
};

}  // namespace breccia::quasistatic
