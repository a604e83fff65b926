#include "operator/natural_order.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>

#include <petscdmda.h>

namespace breccia::quasistatic {
namespace {

constexpr const char* what = "ordering the values of all processes";

/// The values of a process that has them all.
parallel::OrderedPlaces all_places(Vec vector) {
  PetscInt length = 0;
  check(VecGetLocalSize(vector, &length), what);
  return parallel::consecutive_places(0, static_cast<std::size_t>(length));
}

/// The nodes of one process among those of the grid.
struct NodeBox {
  std::array<std::size_t, 3> begin{}, size{}, all{};
  std::size_t components = 0;

  [[nodiscard]] std::size_t place_of(std::size_t value) const noexcept {
    auto node = value / components, place = std::size_t{0}, before = std::size_t{1};
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
      place += before * (begin[axis] + node % size[axis]);
      before *= all[axis];
      node /= size[axis];
    }
    return components * place + value % components;
  }
};

NodeBox box_of(DM grid) {
  std::array<PetscInt, 3> begin{}, size{}, all{};
  PetscInt components = 0;
  check(DMDAGetCorners(grid, &begin[0], &begin[1], &begin[2], &size[0], &size[1], &size[2]), what);
  check(DMDAGetInfo(grid, nullptr, &all[0], &all[1], &all[2], nullptr, nullptr, nullptr, &components, nullptr, nullptr,
                    nullptr, nullptr, nullptr),
        what);
  NodeBox box = {.components = static_cast<std::size_t>(components)};
  for (std::size_t axis = 0; axis < begin.size(); ++axis) {
    box.begin[axis] = static_cast<std::size_t>(begin[axis]);
    box.size[axis] = static_cast<std::size_t>(size[axis]);
    box.all[axis] = static_cast<std::size_t>(all[axis]);
  }
  return box;
}

/// The places of the values of this process in the natural order, as PETSc keeps them.
class Places {
 public:
  explicit Places(ISLocalToGlobalMapping mapping) : mapping_(mapping) {
    check(ISLocalToGlobalMappingGetIndices(mapping_, &places_), what);
  }
  Places(const Places&) = delete;
  Places& operator=(const Places&) = delete;
  Places(Places&&) = delete;
  Places& operator=(Places&&) = delete;
  ~Places() { ISLocalToGlobalMappingRestoreIndices(mapping_, &places_); }

  [[nodiscard]] std::size_t operator[](std::size_t value) const noexcept {
    return static_cast<std::size_t>(places_[value]);
  }

 private:
  ISLocalToGlobalMapping mapping_;
  const PetscInt* places_ = nullptr;
};

}  // namespace

parallel::OrderedPlaces natural_places_of_nodes(Vec nodal) {
  if (parallel::ranks() == 1) return all_places(nodal);
  DM grid = nullptr;
  check(VecGetDM(nodal, &grid), what);
  if (grid == nullptr) throw std::logic_error("a nodal vector without its grid");
  auto places = all_places(nodal);
  places.place_of = [box = box_of(grid)](std::size_t value) { return box.place_of(value); };
  return places;
}

void set_natural_places(const std::vector<PetscInt>& places, Vec vector) {
  ISLocalToGlobalMapping mapping = nullptr;
  check(ISLocalToGlobalMappingCreate(PETSC_COMM_WORLD, 1, static_cast<PetscInt>(places.size()), places.data(),
                                     PETSC_COPY_VALUES, &mapping),
        what);
  check(VecSetLocalToGlobalMapping(vector, mapping), what);
  check(ISLocalToGlobalMappingDestroy(&mapping), what);
}

parallel::OrderedPlaces natural_places(Vec vector) {
  ISLocalToGlobalMapping mapping = nullptr;
  check(VecGetLocalToGlobalMapping(vector, &mapping), what);
  auto places = all_places(vector);
  if (mapping == nullptr) return places;
  places.place_of = [known = std::make_shared<const Places>(mapping)](std::size_t value) { return (*known)[value]; };
  return places;
}

}  // namespace breccia::quasistatic
