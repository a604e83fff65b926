#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <Eigen/SparseCore>
#include <dmumps_c.h>
#include <smumps_c.h>

namespace breccia::films {

template <class Number>
struct MumpsOf;
template <>
struct MumpsOf<double> {
  using Structure = DMUMPS_STRUC_C;
  static void call(Structure& instance) { dmumps_c(&instance); }
};
template <>
struct MumpsOf<float> {
  using Structure = SMUMPS_STRUC_C;
  static void call(Structure& instance) { smumps_c(&instance); }
};

/// The blocks of factors: with all their digits, or approximated by products of low rank (Amestoy et al. 2017).
enum class FactorBlocks { full, low_rank };

/// An instance of MUMPS (Amestoy, Duff, L'Excellent and Koster 2001) for the factors L D L^T of one symmetric matrix
/// after the other, all with the same pattern, in the order of elimination_order(). All processes of the group call the
/// functions together; the matrix is on the first one.
template <class Number>
class MumpsInstance {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  /// Orders the unknowns of a matrix whose lower triangle is given. Throws NumericalError.
  MumpsInstance(const Sparse& lower_triangle, FactorBlocks blocks);

  /// Memory for factors and workspace that a process will take at most, if no block has a low rank [B].
  [[nodiscard]] double memory() const;
  /// Keeps the factors in files in a directory.
  void keep_in_files(const std::filesystem::path& directory);
  [[nodiscard]] bool keeps_in_files() const;
  /// Sets the absolute error of blocks of low rank in further factors.
  void set_error(double error);

  /// Factorises the matrix with these entries of its lower triangle, column by column. Throws NumericalError.
  void factorise(Number* entries);
  /// Solves for a right side, which the solution replaces, on the first process. Throws NumericalError.
  void solve(Number* right_side) const;

 private:
  using Structure = typename MumpsOf<Number>::Structure;
  /// Ends an instance.
  struct Deleter {
    void operator()(Structure* instance) const;
  };

  std::vector<int> rows_, columns_;  ///< rows and columns of the entries, from 1
  std::unique_ptr<Structure, Deleter> mumps_;
};

}  // namespace breccia::films
