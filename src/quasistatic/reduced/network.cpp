#include "quasistatic/reduced/network.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "breccia/error.hpp"

#include "quasistatic/lapack.hpp"
#include "quasistatic/reduced/part_series.hpp"

namespace breccia::quasistatic {
namespace {

/// Square root S of a positive semidefinite matrix, S' S = matrix. Eigenvalues that are zero, or negative by rounding,
/// are replaced by the rounding level of the whole stiffness, so that modes without stiffness get retardation times
/// beyond all others.
Eigen::MatrixXd square_root(const Eigen::MatrixXd& matrix, double rounding) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);
  return modes.eigenvalues().cwiseMax(rounding).cwiseSqrt().asDiagonal() * modes.eigenvectors().transpose();
}

/// Stiffness of the parts of a response with these moduli [Pa], without the constant part.
Eigen::MatrixXd stiffness_of_parts(const ReducedResponse& response, std::span<const double> moduli) {
  const auto size = response.constant.rows();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < moduli.size(); ++i) sum += moduli[i] * response.parts[i].stiffness;
  return sum;
}

/// The terms of all moduli [Pa] by relaxation time [s], each a list by part. A bulk term may be negative, but K + G/3
/// of a term, its stiffness in plane strain, is not.
std::map<double, std::vector<double>> terms_of(const std::vector<const PronySeries*>& series) {
  std::map<double, std::vector<double>> terms;
  for (std::size_t i = 0; i < series.size(); ++i) {
    for (const auto& [time, modulus] : series[i]->terms()) {
      const auto term = terms.try_emplace(time, series.size(), 0.0).first;
      term->second[i] += modulus;
    }
  }
  return terms;
}

/// The springs and dashpots of the network. The rows of S are springs: first the equilibrium springs, then the springs
/// of every term, each in series with a dashpot.
struct Network {
  std::vector<double> equilibrium;              ///< moduli [Pa] by part
  std::map<double, std::vector<double>> terms;  ///< moduli [Pa] by part, by relaxation time [s]
  Eigen::MatrixXd springs;                      ///< S
  Eigen::VectorXd rates;  ///< relaxation rates of the springs with dashpots, the last rows of S [1/s]

  [[nodiscard]] Eigen::Index dashpots() const { return rates.size(); }
};

Network network_of(const ReducedResponse& response, std::span<const Material> of_phases) {
  const auto series = series_of_parts(response, of_phases);
  std::vector<double> at_first, at_rest;
  for (const auto* modulus : series) {
    at_first.push_back(modulus->unrelaxed());
    at_rest.push_back(modulus->equilibrium());
  }
  const Eigen::MatrixXd unrelaxed = response.constant + stiffness_of_parts(response, at_first);
  const double rounding = 1e-16 * unrelaxed.diagonal().maxCoeff();
  const auto size = response.constant.rows();
  Network network = {.equilibrium = at_rest, .terms = terms_of(series), .springs = {}, .rates = {}};
  network.rates.resize(static_cast<Eigen::Index>(network.terms.size()) * size);
  network.springs.resize(size + network.dashpots(), size);
  network.springs.topRows(size) =
      square_root(response.constant + stiffness_of_parts(response, network.equilibrium), rounding);
  Eigen::Index row = 0;
  for (const auto& [time, moduli] : network.terms) {
    network.springs.middleRows(size + row, size) = square_root(stiffness_of_parts(response, moduli), rounding);
    network.rates.segment(row, size).setConstant(1.0 / time);
    row += size;
  }
  return network;
}

/// The factors of S = Q R, and an orthonormal basis M of the orthogonal complement of Q.
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

/// Singular values and left singular vectors of a well conditioned matrix times a diagonal one. One-sided Jacobi
/// rotations find each singular value to full relative precision, whatever the range of the diagonal (Drmac and Veselic
/// 2008).
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

/// The action of the load on the weights c of the network. A traction boundary prescribes forces, and all of c is free.
/// The other boundaries prescribe e' c = 1: c is the unrelaxed solution plus a part that is orthogonal to e and free.
struct Loading {
  Eigen::VectorXd prescribed;
  Eigen::MatrixXd free;  ///< orthonormal columns
  Eigen::VectorXd forces;
};

Loading loading_of(const ReducedResponse& response, const Network& network) {
  const auto& e = response.load_forces;
  const auto size = e.size();
  if (response.boundary == Boundary::traction) {
    return {Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Identity(size, size), e};
  }
  const Eigen::VectorXd unrelaxed = (network.springs.transpose() * network.springs).ldlt().solve(e);
  const Eigen::MatrixXd around = Eigen::HouseholderQR<Eigen::MatrixXd>(e).householderQ();
  return {unrelaxed / e.dot(unrelaxed), around.rightCols(size - 1), Eigen::VectorXd::Zero(size)};
}

/// The network at one time after loading.
struct Creep {
  Eigen::VectorXd pulled;         ///< p = R^-T F' f, the part of the forces in the springs that balances the load
  Eigen::VectorXd flow;           ///< z, elongations of the dashpots
  Eigen::VectorXd spring_forces;  ///< S c - z, by row of S
};

/// Solves the eigenproblem of the dashpots: each mode of the forces in them decays at its own rate, a squared singular
/// value.
Creep creep_of(const Network& network, const Loading& loading, const Factors& factors, double time) {
  const auto dashpots = network.dashpots();
  const Eigen::VectorXd pre_strain = network.springs * loading.prescribed;
  const Eigen::VectorXd at_first = factors.m().transpose() * pre_strain;
  Creep creep;
  if (factors.size > 0) {
    creep.pulled =
        factors.r.transpose().triangularView<Eigen::Lower>().solve(loading.free.transpose() * loading.forces);
  }
  Eigen::VectorXd crept = Eigen::VectorXd::Zero(at_first.size());  // N' z
  creep.flow = Eigen::VectorXd::Zero(dashpots);
  if (dashpots > 0) {
    const Eigen::MatrixXd held = factors.m().bottomRows(dashpots);
    const auto [values, left] = graded_singular_values(held.transpose() * network.rates.cwiseSqrt().asDiagonal());
    const Eigen::VectorXd pull =
        left.transpose() *
        (at_first + held.colPivHouseholderQr().solve(factors.q().bottomRows(dashpots) * creep.pulled));
    const Eigen::ArrayXd done = -(-time * values.array().square()).unaryExpr([](double x) { return std::expm1(x); });
    crept = left * (done * pull.array()).matrix();
    creep.flow = held.transpose().colPivHouseholderQr().solve(crept);
  }
  creep.spring_forces = factors.q() * creep.pulled + factors.m() * (at_first - crept);
  return creep;
}

/// The weights c: the prescribed part, and the free part that makes S c - z the forces in the springs.
Eigen::VectorXd displacement_of(const Network& network, const Loading& loading, const Factors& factors,
                                const Creep& creep) {
  if (factors.size == 0) return loading.prescribed;
  const Eigen::VectorXd pre_strain = network.springs * loading.prescribed;
  const Eigen::VectorXd strains = creep.pulled + factors.q().bottomRows(network.dashpots()).transpose() * creep.flow -
                                  factors.q().transpose() * pre_strain;
  return loading.prescribed + loading.free * factors.r.triangularView<Eigen::Upper>().solve(strains);
}

}  // namespace

CreepCompliance network_compliance(const ReducedResponse& response, std::span<const Material> of_phases) {
  // The retardation rates of the network are the squared singular values of N' D, where N is the part of M that belongs
  // to the springs with dashpots and D holds the square roots of their relaxation rates.
  const auto network = network_of(response, of_phases);
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

ReducedState network_state(const ReducedResponse& response, std::span<const Material> of_phases, double time) {
  const auto network = network_of(response, of_phases);
  const auto loading = loading_of(response, network);
  const Factors factors(network.springs * loading.free);
  const auto crept = creep_of(network, loading, factors, time);
  ReducedState state;
  state.displacement = displacement_of(network, loading, factors, crept);
  // The moduli applied to the history of c: the equilibrium modulus times c, plus for every term its modulus times the
  // elongation of its springs.
  for (const double modulus : network.equilibrium) state.applied.emplace_back(modulus * state.displacement);
  const auto size = loading.prescribed.size();
  Eigen::Index row = size;
  for (const auto& [relaxation_time, moduli] : network.terms) {
    const Eigen::VectorXd elongation =
        network.springs.middleRows(row, size).colPivHouseholderQr().solve(crept.spring_forces.segment(row, size));
    for (std::size_t i = 0; i < moduli.size(); ++i) state.applied[i] += moduli[i] * elongation;
    row += size;
  }
  return state;
}

}  // namespace breccia::quasistatic
