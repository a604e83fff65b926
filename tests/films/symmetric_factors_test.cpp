#include "films/solver/symmetric_factors.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "films/grid_matrix.hpp"
#include "films/solver/elimination_order.hpp"
#include "messages.hpp"
#include "parallel/session.hpp"
#include "scoped_variable.hpp"
#include "temporary_directory.hpp"

namespace breccia::films {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using test::components;
using test::grid_matrix;
using test::right_side;
using test::side_of_grid;
using test::Sparse;

TEST(EliminationOrder, HasEveryUnknownOnce) {
  auto positions = elimination_order(grid_matrix(1.0));
  EXPECT_EQ(positions, elimination_order(grid_matrix(3.0)));
  // The two components of a node have the same entries and follow each other in the order.
  for (std::size_t node = 0; node < side_of_grid * side_of_grid; ++node) {
    EXPECT_EQ(positions[components * node] + 1, positions[components * node + 1]);
  }
  std::ranges::sort(positions);
  std::vector<int> all(positions.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(positions, all);
}

// Nested dissection leaves some 31 n log2(n) / 4 entries of a grid of n nodes, the order of the rows n^(3/2).
TEST(EliminationOrder, EndsWithASeparator) {
  const auto positions = elimination_order(grid_matrix(1.0));
  const auto count = positions.size();
  // Without the last unknowns in the order, about two grid lines of nodes, the grid separates into parts of at most two
  // thirds.
  constexpr std::size_t separator = 2 * 3 * side_of_grid;
  std::vector<int> part(count);
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int at) {
    while (part[static_cast<std::size_t>(at)] != at) at = part[static_cast<std::size_t>(at)];
    return at;
  };
  const auto is_left = [&](int unknown) {
    return static_cast<std::size_t>(positions[static_cast<std::size_t>(unknown)]) + separator < count;
  };
  const auto matrix = grid_matrix(1.0);
  for (int column = 0; column < matrix.outerSize(); ++column) {
    for (Sparse::InnerIterator at(matrix, column); at; ++at) {
      const auto row = static_cast<int>(at.row());
      if (is_left(row) && is_left(column)) part[static_cast<std::size_t>(root(row))] = root(column);
    }
  }
  std::vector<std::size_t> sizes(count, 0);
  for (int unknown = 0; unknown < static_cast<int>(count); ++unknown) {
    if (is_left(unknown)) ++sizes[static_cast<std::size_t>(root(unknown))];
  }
  EXPECT_LT(*std::ranges::max_element(sizes), count * 2 / 3);
}

TEST(SymmetricFactors, SolveForOneMatrixAfterTheOther) {
  SymmetricFactors factors(std::numeric_limits<double>::infinity());
  for (const double stiffness : {1.0, 1e3, 1e6}) {
    const auto matrix = grid_matrix(stiffness);
    factors.factorise([&] { return matrix; });
    const auto load = right_side(matrix);
    const auto solution = factors.solve(load);
    EXPECT_LT((matrix.selfadjointView<Eigen::Lower>() * solution - load).norm(), 1e-12 * load.norm());
    EXPECT_LT(factors.effort().residual, 1e-12);
  }
  EXPECT_FALSE(factors.are_in_files());
}

TEST(SymmetricFactors, InFilesAreThoseInMemoryButForRounding) {
  const auto matrix = grid_matrix(1e3);
  SymmetricFactors in_memory(std::numeric_limits<double>::infinity()), in_files(0.0);
  for (auto* factors : {&in_memory, &in_files}) factors->factorise([&] { return matrix; });
  EXPECT_TRUE(in_files.are_in_files());
  const auto load = right_side(matrix);
  const auto expected = in_memory.solve(load);
  EXPECT_LT((in_files.solve(load) - expected).norm(), 1e-14 * expected.norm());
}

TEST(SymmetricFactors, LeaveNoFiles) {
  parallel::start();  // before MPI can leave files of its own there
  const test::TemporaryDirectory directory;
  const test::ScopedVariable temporary("TMPDIR", directory.path().string());
  {
    SymmetricFactors factors(0.0);
    const auto matrix = grid_matrix(1.0);
    factors.factorise([&] { return matrix; });
    factors.factorise([&] { return matrix; });
    EXPECT_FALSE(std::filesystem::is_empty(directory.path()));
    static_cast<void>(factors.solve(right_side(matrix)));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
  const auto leave_in_a_hurry = [] {
    SymmetricFactors factors(0.0);
    factors.factorise([] { return grid_matrix(1.0); });
    throw Interrupted("stop");
  };
  EXPECT_THROW(leave_in_a_hurry(), Interrupted);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(SymmetricFactors, SayWhereTheyHaveNoPlaceForFiles) {
  parallel::start();  // before TMPDIR is changed, since MPI has its own limits for the name of that directory
  const auto refusal = [](const std::filesystem::path& place) {
    const test::ScopedVariable temporary("TMPDIR", place.string());
    SymmetricFactors factors(0.0);
    return test::message_of<InputError>([&] { factors.factorise([] { return grid_matrix(1.0); }); });
  };
  const test::TemporaryDirectory directory;
  EXPECT_THAT(refusal(directory.path() / "missing"), HasSubstr("the environment variable TMPDIR names none"));
  EXPECT_THAT(refusal("/proc"), AllOf(HasSubstr("the directory /proc/breccia-factors-"), HasSubstr("cannot be made")));
  // MUMPS takes names of up to 255 characters; 23 of them are the name of the new directory.
  auto place = directory.path();
  while (place.string().size() + 100 < 233) place /= std::string(99, 'a');
  const auto longest = place / std::string(231 - place.string().size(), 'b');
  const auto longer = place / std::string(232 - place.string().size(), 'c');
  std::filesystem::create_directories(longest);
  std::filesystem::create_directories(longer);
  EXPECT_THAT(refusal(longer), HasSubstr("has 256 characters: expected at most 255"));
  const test::ScopedVariable temporary("TMPDIR", longest.string());
  SymmetricFactors factors(0.0);
  const auto matrix = grid_matrix(1.0);
  factors.factorise([&] { return matrix; });
  EXPECT_FALSE(std::filesystem::is_empty(longest));
  const auto load = right_side(matrix);
  EXPECT_LT((matrix.selfadjointView<Eigen::Lower>() * factors.solve(load) - load).norm(), 1e-12 * load.norm());
}

TEST(SymmetricFactors, OfASingularMatrixAreRefused) {
  Sparse matrix(2, 2);
  matrix.insert(0, 0) = 1.0;
  matrix.insert(1, 0) = 1.0;
  matrix.insert(1, 1) = 1.0;
  SymmetricFactors factors(std::numeric_limits<double>::infinity());
  EXPECT_THROW(factors.factorise([&] { return matrix; }), NumericalError);
}

}  // namespace
}  // namespace breccia::films
