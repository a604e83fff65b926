#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "quasistatic/operator/displacement_state.hpp"
#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/reduced/affine_stiffness.hpp"
#include "quasistatic/reduced/stored_vectors.hpp"

namespace breccia::quasistatic {

/// The vectors of a reduced basis of a cube without the strains of the phases of its mixed cells, which take as much
/// memory as the displacements of the nodes. The strains follow from the displacements of the nodes: in a solution for
/// some moduli, the phases share the strain of their cell by the rule of its mixture, and a vector is
/// the sum of such a solution and of earlier vectors (theory, Eq. 76).
class CondensedVectors {
 public:
  /// An empty list of vectors for a basis of this load. The operator and the stiffness must outlive it.
  CondensedVectors(const ElasticOperator<3>& elastic_operator, const AffineStiffness& stiffness, Load load)
      : elastic_operator_(&elastic_operator), stiffness_(&stiffness), load_(load) {}

  [[nodiscard]] std::size_t size() const noexcept { return vectors_.size(); }
  /// The vector at an index. It shares its fluctuation with the basis, so that it must not be changed.
  [[nodiscard]] Displacement at(std::size_t index) const;
  void add(Displacement vector, VectorOrigin origin);

  /// The work of forces on each of the vectors.
  [[nodiscard]] Eigen::VectorXd works(const Forces& forces) const;
  /// sum += the vectors times these weights
  void add_to(Displacement& sum, const Eigen::VectorXd& weights) const;

  void save(StateWriter& state, const std::string& group) const;
  void restore(const StateReader& state, const std::string& group, const std::function<Displacement()>& zero);

 private:
  using Shape = CellShape<3>;
  using ValuesOfCell = Eigen::Matrix<double, Shape::Values::RowsAtCompileTime, Eigen::Dynamic>;
  /// A number for the volumetric strain and one for the deviators, by row, for each vector.
  using OfVectors = Eigen::Matrix<double, 2, Eigen::Dynamic>;
  using SharesOfPhases = std::vector<OfVectors>;  ///< values for all phases except the first

  struct Condensed {
    Displacement displacement;  ///< displacement without strains of phases, and without nodal values if it is affine
    VectorOrigin origin;
    std::vector<std::vector<StrainShare>> shares;  ///< shares by kind of cell, for all phases except the first
  };

  /// The strains of the phases of a mixed cell among those of all cells.
  struct MixedStrains {
    std::uint32_t kind;  ///< kind of the cell
    std::size_t first;   ///< index of the first of these strains
  };

  class ValuesAtNodes;

  /// Adds the strains of phases in the vectors times these weights.
  void add_phase_strains(const Eigen::VectorXd& weights, Vec phase_strains) const;

  /// Calls work(plane, displacements of the nodes of a mixed cell in the first `count` vectors, what gaps add to its
  /// volumetric strains, its strains) for all mixed cells. The cells of a plane come one after the other; several
  /// threads take different planes.
  template <class Work>
  void for_mixed_cells(std::size_t count, const Work& work) const;
  /// The rows of the modes of a cell that are deviators, and the one that is the volumetric strain.
  [[nodiscard]] auto deviators() const { return elastic_operator_->modes().topRows<Shape::modes - 1>(); }
  [[nodiscard]] auto volume() const { return elastic_operator_->modes().row(Shape::modes - 1); }
  [[nodiscard]] std::vector<SharesOfPhases> shares_of_kinds(std::size_t count) const;
  [[nodiscard]] std::vector<SharesOfPhases> shares_in_sum(const Eigen::VectorXd& weights) const;
  [[nodiscard]] Eigen::MatrixXd amounts_of_earlier(std::size_t count) const;
  [[nodiscard]] Displacement condensed(Displacement vector, const VectorOrigin& origin) const;
  [[nodiscard]] Displacement without_strains(const Displacement& condensed) const;
  [[nodiscard]] std::vector<std::vector<StrainShare>> shares_of(const VectorOrigin& origin) const;

  const ElasticOperator<3>* elastic_operator_;
  const AffineStiffness* stiffness_;
  Load load_;
  std::vector<Condensed> vectors_;
};

}  // namespace breccia::quasistatic
