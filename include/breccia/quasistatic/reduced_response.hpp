#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The moduli at which the elastic composite was solved for a vector of the reduced basis.
struct Snapshot {
  std::vector<Moduli> moduli = {};  ///< moduli [Pa] of the phases that vary, in the order of ReducedResponse::phases()
  /// Relative error of the reduced modulus at these moduli just before the snapshot was added [-]. It is measured for
  /// the snapshots of the greedy selection, and 0 for the initial ones.
  double error_before = 0.0;
};

/// A modulus of an isotropic solid.
enum class ElasticModulus { shear, bulk };

template <>
inline constexpr auto words<ElasticModulus> = std::to_array<Word<ElasticModulus>>({{"shear", ElasticModulus::shear},
                                                                                   {"bulk", ElasticModulus::bulk}});

/// Name of the matrix phase of a composite.
inline constexpr std::string_view name_of_matrix_phase = "matrix";

/// A modulus of a phase.
struct PhaseModulus {
  std::string phase;
  ElasticModulus modulus = ElasticModulus::shear;

  friend bool operator==(const PhaseModulus&, const PhaseModulus&) = default;
};

/// One part K_i of the affine stiffness K(p) = K_0 + sum_i p_i K_i of a reduced basis with r vectors.
struct AffinePart {
  PhaseModulus parameter;     ///< phase and kind of the modulus p_i
  Eigen::MatrixXd stiffness;  ///< K_i, the stiffness of a unit modulus: r x r [-]
};

/// The two parts of a composite in which the shear and the bulk modulus of the matrix vary.
std::vector<AffinePart> matrix_parts(Eigen::MatrixXd shear, Eigen::MatrixXd bulk);

/// The stiffness of one microstructure under one load and boundary condition as an affine function of the moduli p_i
/// that vary, those of the matrix and of any other phase: the Galerkin projection of K(p) = K_0 + sum_i p_i K_i on a
/// reduced basis of r vectors (theory, Eq. 18a). The modulus of the projection is never below that of the unreduced
/// composite, under any boundary condition. Parameters p_i are in Pa and in the order of the parts; moduli and
/// materials of the phases that vary are in the order of phases(). Where only the moduli of the matrix vary, overloads
/// take the matrix alone.
struct ReducedResponse {
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Eigen::MatrixXd constant;       ///< K_0, the stiffness of the phases that do not vary: r x r [Pa]
  std::vector<AffinePart> parts;  ///< affine parts K_i
  Eigen::VectorXd load_forces;    ///< vector e of r components; the compliance is e' K^-1 e
  /// Scalar products of the parts of the residual, with n parts and the r vectors v: K_0 v, then K_i v part by part,
  /// then the load. The matrix has (n + 1) r + 1 rows and columns.
  Eigen::MatrixXd residual_products;
  double residual_scale = 0.0;  ///< largest ratio of a measured error to its estimate from the residual [-]
  std::vector<Snapshot> snapshots;

  /// Names of the phases whose moduli vary, in the order of their first parts.
  [[nodiscard]] std::vector<std::string> phases() const;
  /// The stiffness K_i of a modulus of a phase. Throws InputError when the response has no such part.
  [[nodiscard]] const Eigen::MatrixXd& part(const PhaseModulus& parameter) const;
  /// The stiffness K_i of a modulus of the matrix.
  [[nodiscard]] const Eigen::MatrixXd& part(ElasticModulus modulus) const;

  /// Parameters p_i for these moduli [Pa] of the phases that vary. Throws InputError when their number is not that of
  /// these phases.
  [[nodiscard]] std::vector<double> parameters(std::span<const Moduli> of_phases) const;
  /// Parameters p_i for a matrix of these moduli [Pa]. Throws InputError when moduli of another phase vary too.
  [[nodiscard]] std::vector<double> parameters(const Moduli& matrix) const;
  /// Materials given by the names of the phases that vary, in the order of phases(). Throws InputError when a phase has
  /// no material, and when a name is not that of a phase that varies.
  [[nodiscard]] std::vector<Material> materials(const std::map<std::string, Material>& by_phase) const;

  /// The stiffness K(p), r x r [Pa].
  [[nodiscard]] Eigen::MatrixXd stiffness(std::span<const double> parameters) const;
  /// Modulus of the elastic composite [Pa].
  [[nodiscard]] double modulus(std::span<const double> parameters) const;
  [[nodiscard]] double modulus(std::span<const Moduli> of_phases) const;
  [[nodiscard]] double modulus(const Moduli& matrix) const;
  /// Estimate of the relative error of modulus(), from the residual of the reduced solution [-].
  [[nodiscard]] double error_estimate(std::span<const double> parameters) const;
  [[nodiscard]] double error_estimate(std::span<const Moduli> of_phases) const;
  [[nodiscard]] double error_estimate(const Moduli& matrix) const;
};

/// Creep compliance [1/Pa] of the composite with these materials as its varying phases. It is exact for the reduced
/// stiffness (theory, Eqs. 19 and 20). The relaxation modulus follows from it by interconversion. Throws InputError
/// when the number of materials is not that of the varying phases.
CreepCompliance creep_compliance(const ReducedResponse& response, std::span<const Material> of_phases);
/// Creep compliance [1/Pa] of a composite in which only the moduli of the matrix vary.
CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix);

}  // namespace breccia
