#include "operator/natural_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <petscdmda.h>

#include "operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

constexpr const char* what = "ordering the values of all processes";

PetscInt local_length(Vec vector) {
  PetscInt length = 0;
  check(VecGetLocalSize(vector, &length), what);
  return length;
}

/// The grid of a nodal vector; null on one process, where a cube has none.
DM grid_of(Vec nodal) {
  DM grid = nullptr;
  check(VecGetDM(nodal, &grid), what);
  if (grid == nullptr && parallel::ranks() > 1) throw std::logic_error("a nodal vector without its grid");
  return grid;
}

/// Sets the values of this process from those of all, one after the other.
void take_own(std::span<const double> all, Vec vector) {
  PetscInt begin = 0, end = 0;
  check(VecGetOwnershipRange(vector, &begin, &end), what);
  const auto own = all.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
  std::ranges::copy(own, WriteValues(vector).data());
}

/// The places of the values of this process in the natural order, during the lifetime of this object.
class Places {
 public:
  explicit Places(Vec vector) {
    check(VecGetLocalToGlobalMapping(vector, &mapping_), what);
    if (mapping_ != nullptr) check(ISLocalToGlobalMappingGetIndices(mapping_, &places_), what);
  }
  Places(const Places&) = delete;
  Places& operator=(const Places&) = delete;
  Places(Places&&) = delete;
  Places& operator=(Places&&) = delete;
  ~Places() {
    if (mapping_ != nullptr) ISLocalToGlobalMappingRestoreIndices(mapping_, &places_);
  }

  /// False where the values of all processes, one after the other, are in the natural order.
  [[nodiscard]] bool are_known() const noexcept { return mapping_ != nullptr; }
  [[nodiscard]] const PetscInt* get() const noexcept { return places_; }

 private:
  ISLocalToGlobalMapping mapping_ = nullptr;
  const PetscInt* places_ = nullptr;
};

}  // namespace

std::vector<double> on_first_process(Vec distributed) {
  NodalVector on_first;
  Scatter scatter;
  check(VecScatterCreateToZero(distributed, scatter.put(), on_first.put()), what);
  check(VecScatterBegin(scatter.get(), distributed, on_first.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  check(VecScatterEnd(scatter.get(), distributed, on_first.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  const ReadValues values(on_first.get());
  return {values.data(), values.data() + local_length(on_first.get())};
}

std::vector<double> nodes_in_natural_order(Vec nodal) {
  DM grid = grid_of(nodal);
  if (grid == nullptr) return on_first_process(nodal);
  NodalVector in_rows;
  check(DMDACreateNaturalVector(grid, in_rows.put()), what);
  check(DMDAGlobalToNaturalBegin(grid, nodal, INSERT_VALUES, in_rows.get()), what);
  check(DMDAGlobalToNaturalEnd(grid, nodal, INSERT_VALUES, in_rows.get()), what);
  return on_first_process(in_rows.get());
}

void set_nodes(std::span<const double> in_natural_order, Vec nodal) {
  DM grid = grid_of(nodal);
  if (grid == nullptr) return take_own(in_natural_order, nodal);
  NodalVector in_rows;
  check(DMDACreateNaturalVector(grid, in_rows.put()), what);
  take_own(in_natural_order, in_rows.get());
  check(DMDANaturalToGlobalBegin(grid, in_rows.get(), INSERT_VALUES, nodal), what);
  check(DMDANaturalToGlobalEnd(grid, in_rows.get(), INSERT_VALUES, nodal), what);
}

void set_natural_places(const std::vector<PetscInt>& places, Vec vector) {
  ISLocalToGlobalMapping mapping = nullptr;
  check(ISLocalToGlobalMappingCreate(PETSC_COMM_WORLD, 1, static_cast<PetscInt>(places.size()), places.data(),
                                     PETSC_COPY_VALUES, &mapping),
        what);
  check(VecSetLocalToGlobalMapping(vector, mapping), what);
  check(ISLocalToGlobalMappingDestroy(&mapping), what);
}

std::vector<double> places_in_natural_order(Vec vector) {
  const auto in_parts = on_first_process(vector);
  const Places places(vector);
  if (!places.are_known()) return in_parts;
  NodalVector of_values;
  check(VecDuplicate(vector, of_values.put()), what);
  std::copy_n(places.get(), local_length(vector), WriteValues(of_values.get()).data());
  const auto at = on_first_process(of_values.get());
  std::vector<double> all(in_parts.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[static_cast<std::size_t>(std::lround(at[i]))] = in_parts[i];
  return all;
}

void set_places(std::span<const double> in_natural_order, Vec vector) {
  const Places places(vector);
  if (!places.are_known()) return take_own(in_natural_order, vector);
  const WriteValues values(vector);
  for (PetscInt i = 0; i < local_length(vector); ++i) {
    values.data()[i] = in_natural_order[static_cast<std::size_t>(places.get()[i])];
  }
}

}  // namespace breccia::quasistatic
