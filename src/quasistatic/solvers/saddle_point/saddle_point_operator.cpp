#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

#include <algorithm>
#include <utility>

#include "breccia/error.hpp"

#include "parallel/session.hpp"
#include "quasistatic/operator/cube_forces.hpp"

namespace breccia::quasistatic {
namespace {

/// The operator, if its box is one that a saddle point serves.
const ElasticOperator<3>& whole_periodic_box(const ElasticOperator<3>& elastic_operator) {
  if (parallel::ranks() > 1 || elastic_operator.boundary() != Boundary::periodic) {
    throw InputError("quasi-static solver: expected one process and a periodic boundary for a saddle point");
  }
  return elastic_operator;
}

/// The rows of nodes along the edges of a row of cells, in the arrays of a field.
template <class Value, class Field>
EdgeRows<Value> edge_rows(const NodeArrays& nodes, Field& field, int second, int third) {
  EdgeRows<Value> rows{};
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const auto index = nodes.row_at(second + static_cast<int>(edge & 1U), third + static_cast<int>(edge >> 1U));
    for (std::size_t component = 0; component < 3; ++component) {
      rows[component][edge] = field.component(component) + index;
    }
  }
  return rows;
}

void add_terms(const SquareTerms& terms, const std::vector<double>& stiffness, int first_plane, int end_plane,
               const double* field, double* product) {
  const auto first = terms.of_plane[static_cast<std::size_t>(first_plane)];
  const auto end = terms.of_plane[static_cast<std::size_t>(end_plane)];
  for (auto term = first; term < end; ++term) {
    terms.forms.add_to(term, stiffness[term] * terms.forms.of(term, field), product);
  }
}

std::vector<double> stiffness_of(const SquareTerms& terms, std::span<const Moduli> moduli) {
  std::vector<double> stiffness(terms.count());
  for (std::size_t term = 0; term < terms.count(); ++term) {
    stiffness[term] = terms.factors[term] * moduli[terms.phases[term]].shear;
  }
  return stiffness;
}

}  // namespace

SaddlePointOperator::SaddlePointOperator(const ElasticOperator<3>& elastic_operator)
    : elastic_operator_(&whole_periodic_box(elastic_operator)),
      lattice_(elastic_operator.nodes()),
      boundary_(lattice_),
      sweep_(lattice_.cells, lattice_.arrays),
      forms_(elastic_operator, lattice_) {
  cells_ = 1;
  for (const int along_axis : lattice_.cells) cells_ *= static_cast<std::size_t>(along_axis);
  const auto& kinds = elastic_operator.kinds();
  for (std::size_t kind = 0; kind < kinds.count(); ++kind) has_no_gap_.push_back(kinds.has_gaps(kind) ? 0.0 : 1.0);
}

void SaddlePointOperator::set_moduli(std::span<const Moduli> moduli) {
  // A needs some bulk modulus, so that it resists all motions; with 2/3 of the shear modulus it is like G times the
  // Laplacian.
  constexpr double of_shear = 2.0 / 3.0, of_bulk = 0.5;
  moduli_ = condensed_cells(*elastic_operator_, moduli);
  if (!moduli_.stiffnesses.empty()) {
    throw InputError("quasi-static solver: expected mixed cells, which boxes with gaps have");
  }
  similar_ = moduli_;
  bulk_of_pressures_ = moduli_.bulk;
  for (std::size_t kind = 0; kind < bulk_of_pressures_.size(); ++kind) {
    similar_.bulk[kind] = std::min(of_shear * moduli_.shear[kind], of_bulk * moduli_.bulk[kind]);
    // The volume change of a cell with gaps is not that of its nodes.
    moduli_.bulk[kind] = has_no_gap_[kind] * similar_.bulk[kind];
    bulk_of_pressures_[kind] -= moduli_.bulk[kind];
  }
  stiffness_of_slopes_ = stiffness_of(forms_.slopes, moduli);
  stiffness_of_flows_ = stiffness_of(forms_.flows, moduli);
  diagonal_of_slopes_ = diagonal_of(forms_.slopes, stiffness_of_slopes_);
  diagonal_of_flows_ = diagonal_of(forms_.flows, stiffness_of_flows_);
}

std::vector<double> SaddlePointOperator::diagonal_of(const SquareTerms& terms,
                                                     const std::vector<double>& stiffness) const {
  std::vector<double> diagonal(layout().seen(), 0.0);
  for (std::size_t term = 0; term < terms.count(); ++term) {
    terms.forms.for_parts(term, [&](std::size_t entry, double weight) {
      if (entry >= first_gap()) diagonal[entry - first_gap()] += stiffness[term] * weight * weight;
    });
  }
  return diagonal;
}

void SaddlePointOperator::multiply(NodalField& field, NodalField& product) {
  boundary_.repeat_first_nodes(field);
  std::ranges::fill(product.all(), 0.0);
  sweep_.add_forces(moduli_, std::as_const(field).components(), product.components(), threads());
  std::vector<CellVolumes> rows(static_cast<std::size_t>(threads()), CellVolumes(lattice_.cells[0]));
  sweep_.for_slabs(threads(), [&](int thread, int first_plane, int end_plane) {
    add_slab(first_plane, end_plane, field, product, rows[static_cast<std::size_t>(thread)]);
  });
  boundary_.collect(product);
}

void SaddlePointOperator::add_slab(int first_plane, int end_plane, const NodalField& field, NodalField& product,
                                   CellVolumes& row) const {
  const double* values = field.all().data();
  double* products = product.all().data();
  add_terms(forms_.slopes, stiffness_of_slopes_, first_plane, end_plane, values, products);
  add_terms(forms_.flows, stiffness_of_flows_, first_plane, end_plane, values, products);
  const double* pressure = values + first_pressure();
  double* volume = products + first_pressure();
  std::vector<double> of_nodes(static_cast<std::size_t>(lattice_.cells[0]));  // the pressures of cells without gaps
  for (int third = first_plane; third < end_plane; ++third) {
    for (int second = 0; second < lattice_.cells[1]; ++second) {
      const auto* kinds = moduli_.kind_of.row_at(second, third);
      const auto first = static_cast<std::size_t>(kinds - moduli_.kind_of.first);
      const auto& strains = row.strains(edge_rows<const double>(lattice_.arrays, field, second, third));
      for (std::size_t cell = 0; cell < of_nodes.size(); ++cell) {
        const auto kind = kinds[cell];
        volume[first + cell] = has_no_gap_[kind] * strains[cell] - pressure[first + cell] / bulk_of_pressures_[kind];
        of_nodes[cell] = has_no_gap_[kind] * pressure[first + cell];
      }
      row.add_forces(of_nodes.data(), edge_rows<double>(lattice_.arrays, product, second, third));
    }
  }
  const auto end = forms_.of_plane[static_cast<std::size_t>(end_plane)];
  for (auto gap = forms_.of_plane[static_cast<std::size_t>(first_plane)]; gap < end; ++gap) {
    const auto cell = forms_.cells[gap];
    volume[cell] += forms_.volumes.of(gap, values);
    forms_.volumes.add_to(gap, pressure[cell], products);
  }
}

void SaddlePointOperator::multiply_similar(NodalField& field, NodalField& product) {
  boundary_.repeat_first_nodes(field);
  std::ranges::fill(product.all(), 0.0);
  sweep_.add_forces(similar_, std::as_const(field).components(), product.components(), threads());
  boundary_.collect(product);
}

}  // namespace breccia::quasistatic
