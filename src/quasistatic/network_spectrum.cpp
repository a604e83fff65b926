#include "network_spectrum.hpp"

#include <array>
#include <cmath>

#include <lapacke.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

/// S with S' S = a positive semidefinite matrix; what is zero gets the size of its rounding.
Eigen::MatrixXd square_root(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);
  const double rounding = 1e-15 * modes.eigenvalues().maxCoeff();
  return modes.eigenvalues().cwiseMax(rounding).cwiseSqrt().asDiagonal() * modes.eigenvectors().transpose();
}

struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
};

/// One-sided Jacobi rotations find the singular values of (well conditioned) x (diagonal) each to full relative
/// precision, however far the diagonal reaches (Drmac and Veselic 2008).
SingularValues graded_singular_values(Eigen::MatrixXd matrix) {
  const auto size = static_cast<lapack_int>(matrix.rows());
  Eigen::VectorXd values(size);
  Eigen::MatrixXd left(size, size), unused(1, 1);
  std::array<double, 7> statistics{};
  std::array<lapack_int, 3> counts{};
  const auto failure =
      LAPACKE_dgejsv(LAPACK_COL_MAJOR, 'C', 'U', 'N', 'N', 'N', 'N', size, size, matrix.data(), size, values.data(),
                     left.data(), size, unused.data(), 1, statistics.data(), counts.data());
  if (failure != 0) throw NumericalError("reduced response: the spectrum of its network does not converge");
  return {statistics[0] / statistics[1] * values, std::move(left)};
}

}  // namespace

CreepCompliance network_compliance(const ReducedResponse& response, const Material& matrix) {
  // The springs of the network: first those without dashpot, then for every term those that its dashpots hold.
  const auto at_rest = square_root(response.filler + matrix.shear.equilibrium() * response.matrix_shear +
                                   matrix.bulk.equilibrium() * response.matrix_bulk);
  const auto in_shear = square_root(response.matrix_shear), in_volume = square_root(response.matrix_bulk);
  const auto& shear = matrix.shear.terms();
  const auto& bulk = matrix.bulk.terms();
  const auto dashpots = static_cast<Eigen::Index>(shear.size()) * in_shear.rows() +
                        static_cast<Eigen::Index>(bulk.size()) * in_volume.rows();
  const auto size = response.filler.rows();
  Eigen::MatrixXd springs(at_rest.rows() + dashpots, size);
  Eigen::VectorXd rates(dashpots);
  springs.topRows(at_rest.rows()) = at_rest;
  Eigen::Index row = 0;
  const auto add = [&](const std::vector<MaxwellTerm>& terms, const Eigen::MatrixXd& root) {
    for (const auto& [time, modulus] : terms) {
      springs.middleRows(at_rest.rows() + row, root.rows()) = std::sqrt(modulus) * root;
      rates.segment(row, root.rows()).setConstant(1.0 / time);
      row += root.rows();
    }
  };
  add(shear, in_shear);
  add(bulk, in_volume);

  // S = Q R; the rates of the network are the squared singular values of N' D, with N the dashpots' part of an
  // orthonormal basis of all that is orthogonal to Q, and D the square roots of the terms' own rates.
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(springs);
  const Eigen::MatrixXd q = factors.householderQ();
  const Eigen::MatrixXd r = factors.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  const Eigen::VectorXd pulled = r.transpose().triangularView<Eigen::Lower>().solve(response.load_forces);
  const Eigen::MatrixXd held = q.bottomRightCorner(dashpots, springs.rows() - size);
  const Eigen::VectorXd at_first = q.bottomLeftCorner(dashpots, size) * pulled;

  const auto [values, left] = graded_singular_values(held.transpose() * rates.cwiseSqrt().asDiagonal());
  const Eigen::VectorXd strengths = left.transpose() * held.colPivHouseholderQr().solve(at_first);
  std::vector<RetardationTerm> terms;
  for (Eigen::Index k = 0; k < dashpots; ++k) {
    if (strengths[k] == 0.0) continue;
    terms.push_back({1.0 / (values[k] * values[k]), strengths[k] * strengths[k]});
  }
  return {pulled.squaredNorm(), std::move(terms), 0.0};
}

}  // namespace breccia::quasistatic
