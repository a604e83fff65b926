#include "network_spectrum.hpp"

#include <array>
#include <cmath>
#include <map>

#include <lapacke.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

/// S with S' S = a positive semidefinite matrix. What is zero, or is less than none by rounding, gets the size of the
/// rounding in the stiffness as a whole, so that what nothing holds flows in a time beyond all others.
Eigen::MatrixXd square_root(const Eigen::MatrixXd& matrix, double rounding) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);
  return modes.eigenvalues().cwiseMax(rounding).cwiseSqrt().asDiagonal() * modes.eigenvectors().transpose();
}

/// The terms of both moduli by relaxation time [s]. Where a bulk term is negative, K + G/3 is not: each is the
/// stiffness of a solid in plane strain.
std::map<double, Moduli> joined(const Material& material) {
  std::map<double, Moduli> terms;
  for (const auto& [time, modulus] : material.shear.terms()) terms[time].shear += modulus;
  for (const auto& [time, modulus] : material.bulk.terms()) terms[time].bulk += modulus;
  return terms;
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
  const auto stiffness = [&](const Moduli& moduli) -> Eigen::MatrixXd {
    return moduli.shear * response.matrix_shear + moduli.bulk * response.matrix_bulk;
  };
  const Eigen::MatrixXd unrelaxed = response.filler + stiffness({matrix.bulk.unrelaxed(), matrix.shear.unrelaxed()});
  const double rounding = 1e-16 * unrelaxed.diagonal().maxCoeff();
  const auto at_rest =
      square_root(response.filler + stiffness({matrix.bulk.equilibrium(), matrix.shear.equilibrium()}), rounding);
  const auto terms_of_both = joined(matrix);
  const auto size = response.filler.rows();
  const auto dashpots = static_cast<Eigen::Index>(terms_of_both.size()) * size;
  Eigen::MatrixXd springs(at_rest.rows() + dashpots, size);
  Eigen::VectorXd rates(dashpots);
  springs.topRows(at_rest.rows()) = at_rest;
  Eigen::Index row = 0;
  for (const auto& [time, moduli] : terms_of_both) {
    springs.middleRows(at_rest.rows() + row, size) = square_root(stiffness(moduli), rounding);
    rates.segment(row, size).setConstant(1.0 / time);
    row += size;
  }

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
