#include "quasistatic/operator/recovery.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include "discretisation/gaps/linear_motion.hpp"
#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// The displacement of the nodes of the cells of this process, in units of the cell side.
template <int dim>
class NodalDisplacement {
 public:
  using Shape = CellShape<dim>;

  NodalDisplacement(const ElasticOperator<dim>& elastic_operator, Load load, const Displacement& displacement)
      : elastic_operator_(&elastic_operator),
        nodes_(&elastic_operator.nodes()),
        strain_(unit_strain<dim>(load)),
        macroscopic_(displacement.macroscopic()),
        seen_(nodes_->local_copy(displacement.fluctuation())),
        fluctuation_(seen_.get()),
        of_gaps_(elastic_operator.gap_layout().values(displacement.fluctuation())),
        phase_strains_(displacement.phase_strains()) {}

  [[nodiscard]] typename Shape::Values of_cell(const Index<dim>& cell) const {
    const typename Shape::Values fluctuation = nodes_->cell_values(cell, fluctuation_.data());
    typename Shape::Values u;
    for (int n = 0; n < Shape::nodes; ++n) {
      auto node = Shape::corner(n);
      Vector<dim> x{};
      for (std::size_t axis = 0; axis < node.size(); ++axis) {
        node[axis] += cell[axis];
        x[axis] = node[axis];
      }
      const auto affine = product(strain_, x);
      for (int i = 0; i < dim; ++i) {
        u[dim * n + i] = macroscopic_ * affine[static_cast<std::size_t>(i)] + fluctuation[dim * n + i];
      }
    }
    return u;
  }

  /// The unknowns of a cell with gaps.
  [[nodiscard]] gaps::CellUnknowns<dim> of_cell_with_gaps(const Index<dim>& cell, const GapOperator<dim>& gap) const {
    return gap.unknowns(of_cell(cell), elastic_operator_->gap_layout(), of_gaps_);
  }

  /// The strain of a phase of a mixed cell whose first unknown strain is at an index.
  [[nodiscard]] typename Shape::ModeValues of_part(const Index<dim>& cell, const MixedCell<dim>& mixed,
                                                   std::size_t index, std::size_t part) const {
    const auto strain = elastic_operator_->modes_of(cell, of_cell(cell), of_gaps_);
    return mixed.strain_of(part, strain, phase_strains_.range(index, mixed.unknowns()));
  }

 private:
  const ElasticOperator<dim>* elastic_operator_;
  const NodeLayout<dim>* nodes_;
  Strain<dim> strain_;
  double macroscopic_;
  NodalVector seen_;
  ReadValues fluctuation_;  ///< fluctuation of the nodes that this process sees
  std::vector<double> of_gaps_;
  ReadValues phase_strains_;  ///< strains of its mixed cells, in the order of the cells
};

template <int dim>
struct AppliedToNodes {
  NodalDisplacement<dim> bulk, shear;
};

/// Stress as in LatticeFields, from the pressure and the shear modulus applied to the strain.
template <int dim>
auto stress_of(const typename CellShape<dim>::StrainVector& shear, double pressure) {
  typename decltype(LatticeFields<dim>::stress)::value_type stress{};
  std::array<double, 3> normal{};  // in plane strain the out-of-plane component is zero
  for (std::size_t axis = 0; axis < dim; ++axis) normal[axis] = shear[static_cast<Eigen::Index>(axis)];
  for (std::size_t i = 0; i < 3; ++i) {
    stress[i] = pressure + 4.0 / 3.0 * normal[i] - 2.0 / 3.0 * (normal[(i + 1) % 3] + normal[(i + 2) % 3]);
  }
  for (std::size_t i = 3; i < stress.size(); ++i) stress[i] = shear[static_cast<Eigen::Index>(i + dim - 3)];
  return stress;
}

/// Stress of a crystal as in LatticeFields, from its strain with engineering shears.
template <int dim>
auto stress_of_crystal(const StiffnessTensor<3>& stiffness, const typename CellShape<dim>::StrainVector& strain) {
  typename decltype(LatticeFields<dim>::stress)::value_type stress{};
  Eigen::Map<Eigen::VectorXd>(stress.data(), static_cast<Eigen::Index>(stress.size())) =
      stiffness(stress_components<dim>, strain_components<dim>) * strain;
  return stress;
}

/// Stress of each point of a mixed cell: the mean over its phases.
template <int dim>
auto mixed_stress(const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index,
                  const std::map<PhaseIndex, AppliedToNodes<dim>>& by_material,
                  const typename CellShape<dim>::PointDeviators& point_deviators) {
  using Shape = CellShape<dim>;
  typename Shape::ModeValues shear = Shape::ModeValues::Zero();
  double bulk = 0.0;
  for (std::size_t part = 0; part < mixed.mixture().size(); ++part) {
    const auto& [bulk_of_phase, shear_of_phase] = by_material.at(mixed.mixture()[part].phase);
    const auto weight = mixed.weight_of_stress(part);
    shear += weight.cwiseProduct(shear_of_phase.of_part(cell, mixed, index, part));
    bulk += (weight.cwiseProduct(bulk_of_phase.of_part(cell, mixed, index, part)))[Shape::modes - 1];
  }
  const double dilatational = dilatational_modulus<dim>({.bulk = bulk, .shear = shear[Shape::modes - 1]});
  const Eigen::Matrix<double, Shape::points * Shape::deviators, 1> deviators =
      point_deviators * shear.template head<Shape::modes - 1>() / std::sqrt(Shape::point_volume);
  using Stress = typename decltype(LatticeFields<dim>::stress)::value_type;
  std::array<Stress, Shape::points> stresses{};
  for (int p = 0; p < Shape::points; ++p) {
    typename Shape::StrainVector components =
        Shape::deviator_matrix().transpose() * deviators.template segment<Shape::deviators>(Shape::deviators * p);
    components.template head<dim>().array() += dilatational;
    auto& stress = stresses[static_cast<std::size_t>(p)];
    // In plane strain each phase has no strain out of the plane.
    if constexpr (dim == 2) stress[2] = bulk - 2.0 / 3.0 * shear[Shape::modes - 1];
    for (std::size_t i = 0; i < dim; ++i) stress[i] = components[static_cast<Eigen::Index>(i)];
    for (std::size_t i = 3; i < stress.size(); ++i) stress[i] = components[static_cast<Eigen::Index>(i + dim - 3)];
  }
  return stresses;
}

template <std::size_t components>
void add_to(std::array<double, components>& values, const std::array<double, components>& more) {
  for (std::size_t i = 0; i < components; ++i) values[i] += more[i];
}

/// Adds what gaps contribute to the fields of the points of a cell: the volume change is that of the gaps, and the ties
/// of the slopes have a stress.
template <int dim>
void add_gaps(const ElasticOperator<dim>& elastic_operator, const Index<dim>& cell, const gaps::GapCell<dim>& gap_cell,
              const NodalDisplacement<dim>& moved, const std::map<PhaseIndex, AppliedToNodes<dim>>& by_material,
              LatticeFields<dim>& fields) {
  using Shape = CellShape<dim>;
  const GapOperator<dim> gap(gap_cell, elastic_operator.modes());
  const double of_nodes = (elastic_operator.modes() * moved.of_cell(cell))[Shape::modes - 1];
  const double volume = gap.volume(moved.of_cell_with_gaps(cell, gap)) - of_nodes;
  auto forces = gaps::CellUnknowns<dim>::Zero().eval();
  for (const auto& [phase, factor, form] : gap_cell.terms) {
    form.add_to(forces, factor * form.of(by_material.at(phase).shear.of_cell_with_gaps(cell, gap)));
  }
  typename decltype(LatticeFields<dim>::strain)::value_type strain{};
  typename decltype(LatticeFields<dim>::stress)::value_type stress{};
  // A shear strain has the rotation of ElasticOperator::uniform_strain().
  const double below = elastic_operator.boundary() == Boundary::traction ? 0.0 : 0.5;
  for (int i = 0; i < dim; ++i) {
    strain[static_cast<std::size_t>(i)] = volume / dim;
    for (int j = i; j < dim; ++j) {
      Eigen::Matrix<double, dim, dim> gradient = Eigen::Matrix<double, dim, dim>::Zero();
      gradient(i, j) = i == j ? 1.0 : 1.0 - below;
      if (i != j) gradient(j, i) = below;
      // Plane stresses have the one out of the plane between the normal ones and the shear.
      const int component = component_index<dim>(i, j) + (i == j ? 0 : 3 - dim);
      stress[static_cast<std::size_t>(component)] = forces.dot(gaps::linear_motion<dim>(gradient));
    }
  }
  // Fields in space have one place a cell.
  constexpr int places = dim == 2 ? Shape::points : 1;
  for (int p = 0; p < places; ++p) {
    const auto index = place_in_timed_fields(elastic_operator.nodes().cells(), cell, p);
    add_to(fields.strain[index], strain);
    add_to(fields.stress[index], stress);
  }
}

}  // namespace

template <int dim>
LatticeFields<dim> recover_fields(const ElasticOperator<dim>& elastic_operator,
                                  const Discretisation<dim>& discretisation, Volumetric volumetric, Load load,
                                  const Displacement& displacement, const std::map<PhaseIndex, AppliedModuli>& applied,
                                  const Crystals& crystals) {
  using Shape = CellShape<dim>;
  const auto& grid = discretisation.grid();
  const NodalDisplacement<dim> moved(elastic_operator, load, displacement);
  std::map<PhaseIndex, AppliedToNodes<dim>> by_material;
  for (const auto& [phase, moduli] : applied) {
    by_material.emplace(phase, AppliedToNodes<dim>{NodalDisplacement<dim>(elastic_operator, load, moduli.bulk),
                                                   NodalDisplacement<dim>(elastic_operator, load, moduli.shear)});
  }
  const auto& cells = elastic_operator.nodes().cells();
  auto fields = zero_timed_fields(discretisation, cells, crystals);
  for (int p = 0; p < Shape::points; ++p) {
    const auto weights = Shape::weights(p);
    const auto strain_matrix = Shape::strain_matrix(p, volumetric);
    const auto volume = Shape::volumetric_strain_matrix(p, volumetric);
    for_each_index(cells.begin, cells.end, [&](const Index<dim>& cell) {
      const auto index = place_in_timed_fields(cells, cell, p);
      const auto u = moved.of_cell(cell);
      Vector<dim> of_point{};
      for (std::size_t node = 0; node < weights.size(); ++node) {
        for (std::size_t i = 0; i < dim; ++i) {
          of_point[i] += grid.cell_side * weights[node] * u[static_cast<Eigen::Index>(dim * node + i)];
        }
      }
      put_in_timed_fields<dim>(of_point, fields.displacement[index]);
      const typename Shape::StrainVector strain = strain_matrix * u;
      typename decltype(LatticeFields<dim>::strain)::value_type tensor{};
      for (std::size_t i = 0; i < tensor.size(); ++i) {
        tensor[i] = (i < dim ? 1.0 : 0.5) * strain[static_cast<Eigen::Index>(i)];
      }
      put_in_timed_fields<dim>(tensor, fields.strain[index]);
      if (elastic_operator.kinds().mixed_cell(cell) != nullptr) return;
      const auto phase = discretisation.cell(cell)[static_cast<std::size_t>(p)];
      const auto crystal = crystals.find(phase);
      if (crystal != crystals.end()) {
        put_in_timed_fields<dim>(stress_of_crystal<dim>(crystal->second.stiffness, strain), fields.stress[index]);
        return;
      }
      const auto& [bulk, shear] = by_material.at(phase);
      put_in_timed_fields<dim>(stress_of<dim>(strain_matrix * shear.of_cell(cell), volume.dot(bulk.of_cell(cell))),
                               fields.stress[index]);
    });
  }
  const auto point_deviators = Shape::point_deviators();
  elastic_operator.for_mixed_cells_of_planes(
      0, elastic_operator.planes(), [&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
        const auto stresses = mixed_stress<dim>(cell, mixed, index, by_material, point_deviators);
        for (int p = 0; p < Shape::points; ++p) {
          put_in_timed_fields<dim>(stresses[static_cast<std::size_t>(p)],
                                   fields.stress[place_in_timed_fields(cells, cell, p)]);
        }
        const auto* gap = elastic_operator.gap_cell(cell);
        if (gap != nullptr) add_gaps(elastic_operator, cell, *gap, moved, by_material, fields);
      });
  return fields;
}

template LatticeFields<2> recover_fields(const ElasticOperator<2>&, const Discretisation<2>&, Volumetric, Load,
                                         const Displacement&, const std::map<PhaseIndex, AppliedModuli>&,
                                         const Crystals&);
template LatticeFields<3> recover_fields(const ElasticOperator<3>&, const Discretisation<3>&, Volumetric, Load,
                                         const Displacement&, const std::map<PhaseIndex, AppliedModuli>&,
                                         const Crystals&);

}  // namespace breccia::quasistatic
