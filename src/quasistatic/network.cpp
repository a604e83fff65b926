#include "network.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

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

/// The springs of the network: first those without dashpot, then for every term those that its dashpots hold.
struct Network {
  std::map<double, Moduli> terms;
  Eigen::MatrixXd springs;  ///< S
  Eigen::VectorXd rates;    ///< of the dashpots, the last rows of S [1/s]

  [[nodiscard]] Eigen::Index dashpots() const { return rates.size(); }
};

Network network_of(const ReducedResponse& response, const Material& matrix) {
  const auto stiffness = [&](const Moduli& moduli) -> Eigen::MatrixXd {
    return moduli.shear * response.matrix_shear + moduli.bulk * response.matrix_bulk;
  };
  const Eigen::MatrixXd unrelaxed = response.filler + stiffness({matrix.bulk.unrelaxed(), matrix.shear.unrelaxed()});
  const double rounding = 1e-16 * unrelaxed.diagonal().maxCoeff();
  const auto size = response.filler.rows();
  Network network = {.terms = joined(matrix), .springs = {}, .rates = {}};
  network.rates.resize(static_cast<Eigen::Index>(network.terms.size()) * size);
  network.springs.resize(size + network.dashpots(), size);
  network.springs.topRows(size) =
      square_root(response.filler + stiffness({matrix.bulk.equilibrium(), matrix.shear.equilibrium()}), rounding);
  Eigen::Index row = 0;
  for (const auto& [time, moduli] : network.terms) {
    network.springs.middleRows(size + row, size) = square_root(stiffness(moduli), rounding);
    network.rates.segment(row, size).setConstant(1.0 / time);
    row += size;
  }
  return network;
}

/// S = Q R, and an orthonormal basis M of all that is orthogonal to Q.
struct Factors {
  explicit Factors(const Eigen::MatrixXd& springs) : size(springs.cols()) {
    if (size == 0) {
      all = Eigen::MatrixXd::Identity(springs.rows(), springs.rows());
      return;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(springs);
    all = factors.householderQ();
    r = factors.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  }
  [[nodiscard]] auto q() const { return all.leftCols(size); }
  [[nodiscard]] auto m() const { return all.rightCols(all.cols() - size); }

  Eigen::Index size;
  Eigen::MatrixXd all;  ///< Q and M
  Eigen::MatrixXd r;
};

struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
};

/// One-sided Jacobi rotations find the singular values of (well conditioned) x (diagonal) each to full relative
/// precision, however far the diagonal reaches (Drmac and Veselic 2008).
SingularValues graded_singular_values(Eigen::MatrixXd matrix) {
  const auto rows = static_cast<lapack_int>(matrix.rows()), columns = static_cast<lapack_int>(matrix.cols());
  Eigen::VectorXd values(columns);
  Eigen::MatrixXd left(rows, columns), unused(1, 1);
  std::array<double, 7> statistics{};
  std::array<lapack_int, 3> counts{};
  const auto failure =
      LAPACKE_dgejsv(LAPACK_COL_MAJOR, 'C', 'U', 'N', 'N', 'N', 'N', rows, columns, matrix.data(), rows, values.data(),
                     left.data(), rows, unused.data(), 1, statistics.data(), counts.data());
  if (failure != 0) throw NumericalError("reduced response: the spectrum of its network does not converge");
  return {statistics[0] / statistics[1] * values, std::move(left)};
}

/// What the load gives: under a traction boundary forces and all strains free; under the others the strain of the
/// unrelaxed network, and what leaves e' c = 1 as it is free.
struct Motion {
  Eigen::VectorXd given;
  Eigen::MatrixXd free;  ///< orthonormal columns
  Eigen::VectorXd forces;
};

Motion motion_of(const ReducedResponse& response, const Network& network) {
  const auto& e = response.load_forces;
  const auto size = e.size();
  if (response.boundary == Boundary::traction) {
    return {Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Identity(size, size), e};
  }
  const Eigen::VectorXd unrelaxed = (network.springs.transpose() * network.springs).ldlt().solve(e);
  const Eigen::MatrixXd around = Eigen::HouseholderQR<Eigen::MatrixXd>(e).householderQ();
  return {unrelaxed / e.dot(unrelaxed), around.rightCols(size - 1), Eigen::VectorXd::Zero(size)};
}

}  // namespace

CreepCompliance network_compliance(const ReducedResponse& response, const Material& matrix) {
  // The rates of the network are the squared singular values of N' D, with N the dashpots' part of M and D the square
  // roots of the terms' own rates.
  const auto network = network_of(response, matrix);
  const auto dashpots = network.dashpots();
  const Factors factors(network.springs);
  const Eigen::VectorXd pulled = factors.r.transpose().triangularView<Eigen::Lower>().solve(response.load_forces);
  const Eigen::MatrixXd held = factors.m().bottomRows(dashpots);
  const Eigen::VectorXd at_first = factors.q().bottomRows(dashpots) * pulled;

  const auto [values, left] = graded_singular_values(held.transpose() * network.rates.cwiseSqrt().asDiagonal());
  const Eigen::VectorXd strengths = left.transpose() * held.colPivHouseholderQr().solve(at_first);
  std::vector<RetardationTerm> terms;
  for (Eigen::Index k = 0; k < dashpots; ++k) {
    if (strengths[k] == 0.0) continue;
    terms.push_back({1.0 / (values[k] * values[k]), strengths[k] * strengths[k]});
  }
  return {pulled.squaredNorm(), std::move(terms), 0.0};
}

ReducedState network_state(const ReducedResponse& response, const Material& matrix, double time) {
  const auto network = network_of(response, matrix);
  const auto dashpots = network.dashpots();
  const auto [given, free, forces] = motion_of(response, network);
  const Factors factors(network.springs * free);
  const Eigen::VectorXd pre_strain = network.springs * given;
  const Eigen::VectorXd at_first = factors.m().transpose() * pre_strain;
  Eigen::VectorXd pulled;  // p
  if (factors.size > 0) pulled = factors.r.transpose().triangularView<Eigen::Lower>().solve(free.transpose() * forces);

  Eigen::VectorXd crept = Eigen::VectorXd::Zero(at_first.size());  // N' z
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(dashpots);          // z
  if (dashpots > 0) {
    const Eigen::MatrixXd held = factors.m().bottomRows(dashpots);
    const auto [values, left] = graded_singular_values(held.transpose() * network.rates.cwiseSqrt().asDiagonal());
    const Eigen::VectorXd pull =
        left.transpose() * (at_first + held.colPivHouseholderQr().solve(factors.q().bottomRows(dashpots) * pulled));
    const Eigen::ArrayXd done = -(-time * values.array().square()).unaryExpr([](double x) { return std::expm1(x); });
    crept = left * (done * pull.array()).matrix();
    flow = held.transpose().colPivHouseholderQr().solve(crept);
  }

  // Of every term c less the strain of its dashpots from the forces in its springs, S_k h_k.
  const Eigen::VectorXd spring_forces = factors.q() * pulled + factors.m() * (at_first - crept);
  ReducedState state;
  state.displacement = given;
  if (factors.size > 0) {
    const Eigen::VectorXd strains =
        pulled + factors.q().bottomRows(dashpots).transpose() * flow - factors.q().transpose() * pre_strain;
    state.displacement += free * factors.r.triangularView<Eigen::Upper>().solve(strains);
  }
  state.shear = matrix.shear.equilibrium() * state.displacement;
  state.bulk = matrix.bulk.equilibrium() * state.displacement;
  const auto size = given.size();
  Eigen::Index row = size;
  for (const auto& [relaxation_time, moduli] : network.terms) {
    const Eigen::VectorXd elongation =
        network.springs.middleRows(row, size).colPivHouseholderQr().solve(spring_forces.segment(row, size));
    state.shear += moduli.shear * elongation;
    state.bulk += moduli.bulk * elongation;
    row += size;
  }
  return state;
}

}  // namespace breccia::quasistatic
