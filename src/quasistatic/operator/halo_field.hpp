#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/discretisation/tensor.hpp"

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/operator/node_layout.hpp"

namespace breccia::quasistatic {

/// Displacements or forces of the nodes of a cube that a process sees (its own and their neighbours), one component
/// after the other, in the form for CellSweep. Several threads fill it plane by plane, with bitwise identical results
/// for any number of threads.
class HaloField {
 public:
  /// A field of zeros.
  HaloField(const NodeLayout<3>& nodes, int threads);

  [[nodiscard]] const NodeArrays& arrays() const noexcept { return arrays_; }
  [[nodiscard]] std::size_t index_of(const Index<3>& node) const noexcept {
    return arrays_.row_at(node[1] - begin_[1], node[2] - begin_[2]) + static_cast<std::size_t>(node[0] - begin_[0]);
  }
  /// The components, from an index on.
  [[nodiscard]] CellSweep::Output from(std::size_t index) noexcept {
    return {values_[0].data() + index, values_[1].data() + index, values_[2].data() + index};
  }
  [[nodiscard]] CellSweep::Input from(std::size_t index) const noexcept {
    return {values_[0].data() + index, values_[1].data() + index, values_[2].data() + index};
  }

  /// Takes the values of a nodal vector plus the affine motion of an amount of a strain.
  void read(const NodeLayout<3>& nodes, Vec nodal, double amount, const Strain<3>& strain);
  /// Adds the values that all processes have to a nodal vector, whose held components become zero. A single process
  /// needs no copy of the field for this, and none of the vector for read().
  void sum_up(const NodeLayout<3>& nodes, Vec nodal) const;
  /// The work of the values, as forces, on the affine motion of a strain.
  [[nodiscard]] double work_on(const Strain<3>& strain) const;

 private:
  template <class IndexOf>
  void read_values(const double* values, const IndexOf& index_of_node, double amount, const Strain<3>& strain);
  void write(Vec local) const;
  void add_plane(const NodeLayout<3>& nodes, int third, std::size_t first_index, double* nodal) const;
  /// Calls work(third index, first index) for all planes of nodes.
  template <class Work>
  void for_planes(const Work& work) const;
  /// Calls work(node, index) for the nodes of a plane.
  template <class Work>
  void for_nodes_of_plane(int third, std::size_t index, const Work& work) const;

  Index<3> begin_;  ///< the lowest node
  NodeArrays arrays_;
  int threads_;
  std::array<std::vector<double>, 3> values_;  ///< values by component
};

}  // namespace breccia::quasistatic
