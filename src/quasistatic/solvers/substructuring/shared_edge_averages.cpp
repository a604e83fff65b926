#include "quasistatic/solvers/substructuring/shared_edge_averages.hpp"

#include <algorithm>

#include "parallel/reduction.hpp"

namespace breccia::quasistatic {
namespace {

/// Storage for the matrices of one edge in a list of numbers that is exchanged between processes.
class Room {
 public:
  explicit Room(double* begin) : next_(begin) {}

  void put(const Eigen::MatrixXd& matrix) { next_ = std::copy_n(matrix.data(), matrix.size(), next_); }
  [[nodiscard]] Eigen::MatrixXd take(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(next_, rows, columns);
    next_ += matrix.size();
    return matrix;
  }

 private:
  double* next_;
};

/// The stiffness of the block of this process at an edge between processes.
EdgeStiffness own_stiffness(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
                            int edge) {
  const auto& [lower, upper, is_horizontal] = blocks.grid().edges()[static_cast<std::size_t>(edge)];
  const bool is_lower = lower != BlockEdge::none;
  const int kind = blocks.kind_of(is_lower ? lower : upper);
  const auto stiffness = condensed[static_cast<std::size_t>(kind)].full();
  const Side side = is_horizontal ? (is_lower ? top : bottom) : (is_lower ? right : left);
  return stiffness_at_edge({&stiffness, blocks.shape_of(kind), side});
}

}  // namespace

void average_shared_edges(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
                          double tolerance, std::vector<EdgeAverage>& averages) {
  const auto& edges = blocks.edges_between_processes();
  int longest = 0;
  for (const int edge : edges) longest = std::max(longest, blocks.grid().unknowns_of_edge(edge));
  longest = static_cast<int>(parallel::largest(longest));
  const int with_ends = longest + 4;
  const int room = longest * longest + with_ends * with_ends;
  std::vector<double> numbers(edges.size() * static_cast<std::size_t>(room), 0.0);
  const auto room_of = [&](std::size_t i) { return Room(numbers.data() + i * static_cast<std::size_t>(room)); };
  const auto average_of = [&](int edge) -> EdgeAverage& {
    return averages[static_cast<std::size_t>(blocks.edge_kind_of(edge))];
  };

  // The block below or to the left is that of the process to which the edge does not belong.
  std::vector<EdgeStiffness> own;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    own.push_back(own_stiffness(blocks, condensed, edges[i]));
    if (blocks.grid().is_owned(edges[i])) continue;
    auto to = room_of(i);
    to.put(own[i].held);
    to.put(own[i].free);
  }
  blocks.shared_edges().copy_to_owners(numbers, room);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!blocks.grid().is_owned(edges[i])) continue;
    auto from = room_of(i);
    EdgeStiffness lower;
    lower.held = from.take(own[i].held.rows(), own[i].held.cols());
    lower.free = from.take(own[i].free.rows(), own[i].free.cols());
    auto& average = average_of(edges[i]) = average_at_edge(lower, own[i], tolerance);
    auto to = room_of(i);
    to.put(Eigen::MatrixXd::Constant(1, 1, static_cast<double>(average.constraints.cols())));
    to.put(average.lower_weight);
    to.put(average.constraints);
  }
  blocks.shared_edges().copy_from_owners(numbers, room);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (blocks.grid().is_owned(edges[i])) continue;
    auto from = room_of(i);
    const auto size = own[i].held.rows();
    const auto constraints = static_cast<Eigen::Index>(from.take(1, 1)(0, 0));
    auto& average = average_of(edges[i]);
    average.lower_weight = from.take(size, size);
    average.constraints = from.take(size, constraints);
  }
}

}  // namespace breccia::quasistatic
