#include "quasistatic/operator/natural_order.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>

#include <petscdmda.h>

namespace breccia::quasistatic {
namespace {

constexpr const char* ordering = "ordering the values of all processes";

/// The indices of the values of a process that has all of them.
parallel::OrderedPlaces all_indices(Vec vector) {
  PetscInt length = 0;
  check(VecGetLocalSize(vector, &length), ordering);
  return parallel::consecutive_places(0, static_cast<std::size_t>(length));
}

/// The nodes of one process among those of the grid.
struct NodeBox {
  std::array<std::size_t, 3> begin{}, size{}, all{};
  std::size_t components = 0;

  [[nodiscard]] std::size_t index_of(std::size_t value) const noexcept {
    auto node = value / components, index = std::size_t{0}, before = std::size_t{1};
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
      index += before * (begin[axis] + node % size[axis]);
      before *= all[axis];
      node /= size[axis];
    }
    return components * index + value % components;
  }
};

NodeBox box_of(DM grid) {
  std::array<PetscInt, 3> begin{}, size{}, all{};
  PetscInt components = 0;
  check(DMDAGetCorners(grid, &begin[0], &begin[1], &begin[2], &size[0], &size[1], &size[2]), ordering);
  check(DMDAGetInfo(grid, nullptr, &all[0], &all[1], &all[2], nullptr, nullptr, nullptr, &components, nullptr, nullptr,
                    nullptr, nullptr, nullptr),
        ordering);
  NodeBox box = {.components = static_cast<std::size_t>(components)};
  for (std::size_t axis = 0; axis < begin.size(); ++axis) {
    box.begin[axis] = static_cast<std::size_t>(begin[axis]);
    box.size[axis] = static_cast<std::size_t>(size[axis]);
    box.all[axis] = static_cast<std::size_t>(all[axis]);
  }
  return box;
}

/// The indices of the values of this process in the natural order, in the list that PETSc keeps.
class NaturalIndices {
 public:
  explicit NaturalIndices(ISLocalToGlobalMapping mapping) : mapping_(mapping) {
    check(ISLocalToGlobalMappingGetIndices(mapping_, &indices_), ordering);
  }
  NaturalIndices(const NaturalIndices&) = delete;
  NaturalIndices& operator=(const NaturalIndices&) = delete;
  NaturalIndices(NaturalIndices&&) = delete;
  NaturalIndices& operator=(NaturalIndices&&) = delete;
  ~NaturalIndices() { ISLocalToGlobalMappingRestoreIndices(mapping_, &indices_); }

  [[nodiscard]] std::size_t operator[](std::size_t value) const noexcept {
    return static_cast<std::size_t>(indices_[value]);
  }

 private:
  ISLocalToGlobalMapping mapping_;
  const PetscInt* indices_ = nullptr;
};

}  // namespace

parallel::OrderedPlaces natural_indices_of_nodes(Vec nodal) {
  if (parallel::ranks() == 1) return all_indices(nodal);
  DM grid = nullptr;
  check(VecGetDM(nodal, &grid), ordering);
  if (grid == nullptr) return natural_indices(nodal);
  auto indices = all_indices(nodal);
  indices.place_of = [box = box_of(grid)](std::size_t value) { return box.index_of(value); };
  return indices;
}

void set_natural_indices(const std::vector<PetscInt>& indices, Vec vector) {
  ISLocalToGlobalMapping mapping = nullptr;
  check(ISLocalToGlobalMappingCreate(PETSC_COMM_WORLD, 1, static_cast<PetscInt>(indices.size()), indices.data(),
                                     PETSC_COPY_VALUES, &mapping),
        ordering);
  check(VecSetLocalToGlobalMapping(vector, mapping), ordering);
  check(ISLocalToGlobalMappingDestroy(&mapping), ordering);
}

parallel::OrderedPlaces natural_indices(Vec vector) {
  ISLocalToGlobalMapping mapping = nullptr;
  check(VecGetLocalToGlobalMapping(vector, &mapping), ordering);
  auto indices = all_indices(vector);
  if (mapping == nullptr && parallel::ranks() > 1) throw std::logic_error("a distributed vector without its order");
  if (mapping == nullptr) return indices;
  indices.place_of = [known = std::make_shared<const NaturalIndices>(mapping)](std::size_t value) {
    return (*known)[value];
  };
  return indices;
}

}  // namespace breccia::quasistatic
