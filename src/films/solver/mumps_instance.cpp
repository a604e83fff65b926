#include "films/solver/mumps_instance.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <mpi.h>

#include "breccia/error.hpp"

#include "films/solver/elimination_order.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/communicator.hpp"

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
  use_files = 22,
  low_rank = 35
};
enum RealControl { low_rank_error = 7 };
enum Information { status = 1, detail = 2, megabytes_of_a_process = 16 };
// Values of the status.
constexpr int too_few_integers = -8, too_few_reals = -9, singular = -10, too_small_to_send = -17,
              too_small_to_receive = -20, no_files = -90;

template <class Structure>
int& control(Structure& mumps, Control number) {
  return mumps.icntl[number - 1];
}

template <class Structure>
int information(const Structure& mumps, Information number) {
  return mumps.infog[number - 1];
}

/// Runs a job and returns its status, which is negative when it fails.
template <class Number>
int attempt(typename MumpsOf<Number>::Structure& mumps, Job job) {
  mumps.job = job;
  MumpsOf<Number>::call(mumps);
  return information(mumps, status);
}

/// Throws NumericalError for the status of a job that has failed.
template <class Structure>
void require_success(const Structure& mumps) {
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

template <class Number>
void run(typename MumpsOf<Number>::Structure& mumps, Job job) {
  attempt<Number>(mumps, job);
  require_success(mumps);
}

}  // namespace

template <class Number>
void MumpsInstance<Number>::Deleter::operator()(Structure* instance) const {
  attempt<Number>(*instance, end);
  delete instance;
}

template <class Number>
MumpsInstance<Number>::MumpsInstance(const Sparse& lower_triangle, FactorBlocks blocks) {
  constexpr int symmetric = 2, works_too = 1, given = 1, silent = 0, no_unit = -1, per_cent = 30;
  constexpr int full_blocks = 0, of_low_rank_in_solutions_too = 2;
  std::vector<int> positions;
  parallel::done_by_first([&] {
    positions = elimination_order(lower_triangle);
    for (int& position : positions) ++position;
    for (int column = 0; column < lower_triangle.outerSize(); ++column) {
      for (Sparse::InnerIterator at(lower_triangle, column); at; ++at) {
        rows_.push_back(static_cast<int>(at.row()) + 1);
        columns_.push_back(column + 1);
      }
    }
  });
  auto blank = std::make_unique<Structure>();
  auto& mumps = *blank;
  mumps.comm_fortran = MPI_Comm_c2f(parallel::communicator());
  mumps.par = works_too;
  mumps.sym = symmetric;
  run<Number>(mumps, begin);
  mumps_.reset(blank.release());
  for (const auto unit : {errors, diagnostics, statistics}) control(mumps, unit) = no_unit;
  control(mumps, verbosity) = silent;
  control(mumps, ordering) = given;
  control(mumps, more_memory) = per_cent;
  control(mumps, low_rank) = blocks == FactorBlocks::full ? full_blocks : of_low_rank_in_solutions_too;

  mumps.n = static_cast<int>(lower_triangle.rows());
  mumps.nnz = lower_triangle.nonZeros();
  mumps.irn = rows_.data();
  mumps.jcn = columns_.data();
  mumps.perm_in = positions.data();
  run<Number>(mumps, analysis);
  mumps.perm_in = nullptr;
}

template <class Number>
double MumpsInstance<Number>::memory() const {
  return 1e6 * information(*mumps_, megabytes_of_a_process);
}

template <class Number>
void MumpsInstance<Number>::keep_in_files(const std::filesystem::path& directory) {
  control(*mumps_, use_files) = 1;
  // The texts have a fixed length and end with zero.
  const auto set_text = [](auto& text, const std::string& value) {
    std::ranges::copy_n(value.c_str(), static_cast<std::ptrdiff_t>(std::min(value.size() + 1, sizeof text)), text);
  };
  set_text(mumps_->ooc_tmpdir, directory.string());
  set_text(mumps_->ooc_prefix, "factors");
}

template <class Number>
bool MumpsInstance<Number>::keeps_in_files() const {
  return control(*mumps_, use_files) != 0;
}

template <class Number>
void MumpsInstance<Number>::set_error(double error) {
  mumps_->cntl[low_rank_error - 1] = static_cast<Number>(error);
}

// Pivots that are delayed may take more memory than the analysis estimated; then it is increased until it suffices.
template <class Number>
void MumpsInstance<Number>::factorise(Number* entries) {
  constexpr int most_per_cent = 2000;
  mumps_->a = entries;
  for (;;) {
    const int found = attempt<Number>(*mumps_, factorisation);
    const bool wants_room = found == too_few_integers || found == too_few_reals || found == too_small_to_send ||
                            found == too_small_to_receive;
    if (!wants_room || control(*mumps_, more_memory) > most_per_cent) break;
    control(*mumps_, more_memory) *= 2;
  }
  mumps_->a = nullptr;
  require_success(*mumps_);
}

template <class Number>
void MumpsInstance<Number>::solve(Number* right_side) const {
  mumps_->rhs = right_side;
  attempt<Number>(*mumps_, solution);
  mumps_->rhs = nullptr;
  require_success(*mumps_);
}

template class MumpsInstance<double>;
template class MumpsInstance<float>;

}  // namespace breccia::films
