#include "quasistatic/solvers/saddle_point/gap_forms.hpp"

#include <array>

#include "discretisation/gaps/space/cube_unknowns.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

/// The entries of the unknowns of a cell in a field.
class Entries {
 public:
  Entries(const ElasticOperator<3>& elastic_operator, const NodeLattice& lattice)
      : layout_(elastic_operator.gap_layout()), lattice_(lattice) {}

  [[nodiscard]] std::array<std::size_t, gaps::unknowns_of_cell<3>> of(const Index<3>& cell,
                                                                      const gaps::GapCell<3>& gap) const {
    std::array<std::size_t, gaps::unknowns_of_cell<3>> entries{};
    for (int node = 0; node < Shape::nodes; ++node) {
      const auto corner = Shape::corner(node);
      const auto index = lattice_.arrays.row_at(cell[1] + corner[1], cell[2] + corner[2]) +
                         static_cast<std::size_t>(cell[0] + corner[0]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        entries[static_cast<std::size_t>(gaps::displacement_of<3>(node, axis))] = axis * lattice_.size() + index;
      }
    }
    for (std::size_t k = 0; k < gap.gap_unknowns.size(); ++k) {
      const auto number = gap.gap_unknowns[k];
      if (number != gaps::GapCell<3>::none) entries[Shape::dofs + k] = 3 * lattice_.size() + layout_.index_of(number);
    }
    return entries;
  }

 private:
  const GapLayout& layout_;
  const NodeLattice& lattice_;
};

/// Whether a form has flows, and therefore no displacements.
bool is_of_flows(const gaps::LinearForm<3>& form) {
  bool is_of_flows = false;
  form.for_parts([&](int unknown, double) {
    const int first = gaps::flow_through_cube(0);
    is_of_flows |= unknown >= first && unknown < first + gaps::faces_of_cell<3>;
  });
  return is_of_flows;
}

}  // namespace

GapForms::GapForms(const ElasticOperator<3>& elastic_operator, const NodeLattice& lattice) {
  const auto& box = elastic_operator.nodes().cells();
  const Entries all_entries(elastic_operator, lattice);
  int plane = 0;
  const auto begin_plane = [&] {
    slopes.of_plane.push_back(slopes.count());
    flows.of_plane.push_back(flows.count());
    of_plane.push_back(cells.size());
  };
  begin_plane();
  elastic_operator.nodes().for_cells([&](const Index<3>& cell) {
    for (; plane < cell[2]; ++plane) begin_plane();
    const auto* gap = elastic_operator.gap_cell(cell);
    if (gap == nullptr) return;
    const auto entries = all_entries.of(cell, *gap);
    for (const auto& [phase, factor, form] : gap->terms) {
      auto& terms = is_of_flows(form) ? flows : slopes;
      form.for_parts(
          [&](int unknown, double weight) { terms.forms.add(entries[static_cast<std::size_t>(unknown)], weight); });
      terms.forms.end();
      terms.phases.push_back(phase);
      terms.factors.push_back(factor);
    }
    for (std::size_t unknown = 0; unknown < entries.size(); ++unknown) {
      const double weight = gap->volume[static_cast<Eigen::Index>(unknown)];
      if (weight != 0.0) volumes.add(entries[unknown], weight);
    }
    volumes.end();
    cells.push_back(static_cast<std::uint32_t>(box.place_of(cell)));
  });
  for (; plane < box.end[2]; ++plane) begin_plane();
}

}  // namespace breccia::quasistatic
