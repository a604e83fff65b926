#include "films/solver/symmetric_factors.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <mpi.h>

#include "breccia/error.hpp"

#include "films/solver/elimination_order.hpp"
#include "parallel/communicator.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace breccia::films {
namespace {

// The numbers of the jobs and the parameters of MUMPS ("Users' guide", 5.5.1), the latter from 1.
enum Job { begin = -1, end = -2, analysis = 1, factorisation = 2, solution = 3 };
enum Control {
  errors = 1,
  diagnostics = 2,
  statistics = 3,
  verbosity = 4,
  ordering = 7,
  more_memory = 14,
  use_files = 22
};
enum Information { status = 1, detail = 2, megabytes_of_a_process = 16 };
// Values of the status.
constexpr int too_few_integers = -8, too_few_reals = -9, singular = -10, too_small_to_send = -17,
              too_small_to_receive = -20, no_files = -90;

int& control(DMUMPS_STRUC_C& mumps, Control number) {
  return mumps.icntl[number - 1];
}

int information(const DMUMPS_STRUC_C& mumps, Information number) {
  return mumps.infog[number - 1];
}

/// Runs a job and returns its status, which is negative when it fails.
int attempt(DMUMPS_STRUC_C& mumps, Job job) {
  mumps.job = job;
  dmumps_c(&mumps);
  return information(mumps, status);
}

/// Throws NumericalError for the status of a job that has failed.
void require_success(const DMUMPS_STRUC_C& mumps) {
  const int found = information(mumps, status);
  if (found >= 0) return;
  if (found == singular) {
    throw NumericalError("films: the matrix is singular; a modulus of the binder may not be positive");
  }
  if (found == no_files) {
    throw NumericalError(
        fmt::format("films: the factors of the matrix cannot be kept in files in {}: it may be full; the environment "
                    "variable TMPDIR names another place",
                    std::string_view(mumps.ooc_tmpdir)));
  }
  throw NumericalError(
      fmt::format("films: the matrix cannot be factorised (MUMPS: {}, {}); memory may have run out, fewer grains take "
                  "less",
                  found, information(mumps, detail)));
}

void run(DMUMPS_STRUC_C& mumps, Job job) {
  attempt(mumps, job);
  require_success(mumps);
}

/// Factorises. Pivots that are delayed may take more memory than the analysis estimated; then it is increased until it
/// suffices.
void factorise_with_room(DMUMPS_STRUC_C& mumps) {
  constexpr int most_per_cent = 2000;
  for (;;) {
    const int found = attempt(mumps, factorisation);
    const bool wants_room = found == too_few_integers || found == too_few_reals || found == too_small_to_send ||
                            found == too_small_to_receive;
    if (!wants_room || control(mumps, more_memory) > most_per_cent) break;
    control(mumps, more_memory) *= 2;
  }
  require_success(mumps);
}

}  // namespace

void SymmetricFactors::InstanceDeleter::operator()(DMUMPS_STRUC_C* instance) const {
  instance->job = end;
  dmumps_c(instance);
  delete instance;
}

/// Orders the unknowns of the first matrix; all further matrices have the same pattern.
void SymmetricFactors::analyse() {
  constexpr int symmetric = 2, works_too = 1, given = 1, silent = 0, no_unit = -1, per_cent = 30;
  auto blank = std::make_unique<DMUMPS_STRUC_C>();
  auto& mumps = *blank;
  mumps.comm_fortran = MPI_Comm_c2f(parallel::communicator());
  mumps.par = works_too;
  mumps.sym = symmetric;
  run(mumps, begin);
  std::unique_ptr<DMUMPS_STRUC_C, InstanceDeleter> begun(blank.release());
  for (const auto unit : {errors, diagnostics, statistics}) control(mumps, unit) = no_unit;
  control(mumps, verbosity) = silent;
  control(mumps, ordering) = given;
  control(mumps, more_memory) = per_cent;

  rows_.clear();
  columns_.clear();
  for (int column = 0; column < matrix_.outerSize(); ++column) {
    for (Sparse::InnerIterator at(matrix_, column); at; ++at) {
      rows_.push_back(static_cast<int>(at.row()) + 1);
      columns_.push_back(column + 1);
    }
  }
  mumps.n = static_cast<int>(matrix_.rows());
  mumps.nnz = matrix_.nonZeros();
  mumps.irn = rows_.data();
  mumps.jcn = columns_.data();
  std::vector<int> positions;
  if (has_matrix()) positions = elimination_order(matrix_);
  for (int& position : positions) ++position;
  mumps.perm_in = positions.data();
  run(mumps, analysis);
  mumps.perm_in = nullptr;
  if (1e6 * information(mumps, megabytes_of_a_process) > memory_) {
    control(mumps, use_files) = 1;
    // The texts have a fixed length and end with zero.
    const auto set_text = [](auto& text, const std::string& value) {
      std::ranges::copy_n(value.c_str(), static_cast<std::ptrdiff_t>(std::min(value.size() + 1, sizeof text)), text);
    };
    directory_.emplace();
    set_text(mumps.ooc_tmpdir, directory_->path().string());
    set_text(mumps.ooc_prefix, "factors");
  }
  mumps_ = std::move(begun);
}

bool SymmetricFactors::has_matrix() noexcept {
  return parallel::rank() == 0;
}

void SymmetricFactors::factorise(const std::function<Sparse()>& lower_triangle) {
  parallel::start();
  if (has_matrix()) {
    matrix_ = lower_triangle();
    matrix_.makeCompressed();
  }
  if (!mumps_) analyse();
  mumps_->a = matrix_.valuePtr();
  factorise_with_room(*mumps_);
}

/// Solves by the factors without refinement, with the right side and the solution on the process that has the matrix.
Eigen::VectorXd SymmetricFactors::solve_once(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXd solution = right_side;
  mumps_->rhs = solution.data();
  run(*mumps_, Job::solution);
  return solution;
}

Eigen::VectorXd SymmetricFactors::solve(const Eigen::VectorXd& right_side) {
  constexpr double largest_residual = 1e-6;
  Eigen::VectorXd solution = solve_once(right_side);
  const auto missing = [&]() -> Eigen::VectorXd {
    if (!has_matrix()) return right_side;
    return right_side - matrix_.selfadjointView<Eigen::Lower>() * solution;
  };
  solution += solve_once(missing());
  residual_ = missing().norm() / std::max(right_side.norm(), 1e-300);
  parallel::copy_from_first(std::span(solution.data(), static_cast<std::size_t>(solution.size())));
  parallel::copy_from_first(std::span(&residual_, 1));
  if (!(residual_ <= largest_residual)) {
    throw NumericalError(fmt::format("films: the residual of a solution is {:.1e} of the load", residual_));
  }
  return solution;
}

bool SymmetricFactors::are_in_files() const {
  return control(*mumps_, use_files) != 0;
}

}  // namespace breccia::films
