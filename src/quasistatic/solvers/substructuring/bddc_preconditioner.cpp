#include "quasistatic/solvers/substructuring/bddc_preconditioner.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "parallel/first_exception.hpp"
#include "quasistatic/solvers/substructuring/shared_edge_averages.hpp"

namespace breccia::quasistatic {
namespace {

/// Averaging a jump at an edge may multiply its energy by this factor; modes beyond it become constraints (the 8 of
/// theory, Eq. 39).
constexpr double jump_tolerance = 8.0;

constexpr Eigen::Index vertex_unknowns = 8;

/// Values of some unknowns, zero where the number of the unknown is negative.
Eigen::VectorXf gather_single(const int* unknowns, Eigen::Index count, const std::vector<double>& values) {
  Eigen::VectorXf local(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    local[i] = unknowns[i] < 0 ? 0.0F : static_cast<float>(values[static_cast<std::size_t>(unknowns[i])]);
  }
  return local;
}

/// Local and coarse solvers of a block before they are weighted.
struct ExactSolvers {
  Eigen::MatrixXd local;   ///< W
  Eigen::MatrixXd coarse;  ///< Phi, on the edges and then on the vertices
};

/// With V the inverse of the stiffness of the edges, W = V - V q (q' V q)^-1 q' V. Unit values of the vertices give the
/// displacements -W S_ev of the edges, unit values of the constraints V q (q' V q)^-1.
ExactSolvers solvers_with_constraints(const Eigen::MatrixXd& condensed, const Eigen::MatrixXd& q) {
  const Eigen::Index on_edges = q.rows(), constraints = q.cols();
  const Eigen::MatrixXd inverse =
      condensed.topLeftCorner(on_edges, on_edges).llt().solve(Eigen::MatrixXd::Identity(on_edges, on_edges));
  const Eigen::MatrixXd flexibility = inverse * q;
  const Eigen::MatrixXd of_constraints = q.transpose() * flexibility;
  const Eigen::MatrixXd by_constraints = of_constraints.llt().solve(flexibility.transpose()).transpose();
  const Eigen::MatrixXd local = inverse - by_constraints * flexibility.transpose();
  Eigen::MatrixXd coarse(on_edges + vertex_unknowns, vertex_unknowns + constraints);
  coarse << -local * condensed.topRightCorner(on_edges, vertex_unknowns), by_constraints,
      Eigen::MatrixXd::Identity(vertex_unknowns, vertex_unknowns), Eigen::MatrixXd::Zero(vertex_unknowns, constraints);
  return {local, coarse};
}

}  // namespace

BddcPreconditioner::BddcPreconditioner(const Substructures& blocks,
                                       const std::vector<PackedSymmetric<double>>& condensed, double stiffness_of_held,
                                       int threads)
    : blocks_(&blocks), threads_(threads) {
  average_edges(condensed);
  std::vector<Eigen::MatrixXd> coarse_stiffness;
  make_block_solvers(condensed, coarse_stiffness);
  const auto numbers = number_coarse_unknowns();
  share_coarse_unknowns(numbers);
  averages_.clear();
  factorise_coarse_problem(coarse_stiffness, stiffness_of_held, numbers.owned);
}

void BddcPreconditioner::average_edges(const std::vector<PackedSymmetric<double>>& condensed) {
  const auto& kinds = blocks_->edge_kinds();
  averages_.resize(kinds.size());
  const auto average = [&](std::size_t k) {
    const auto& [lower, upper, is_horizontal] = kinds[k];
    constexpr int elsewhere = Substructures::EdgeKind::elsewhere;
    if (lower == elsewhere || upper == elsewhere) return;
    const auto below = condensed[static_cast<std::size_t>(lower)].full();
    const auto above = condensed[static_cast<std::size_t>(upper)].full();
    averages_[k] = average_at_edge(stiffness_at_edge({&below, blocks_->shape_of(lower), is_horizontal ? top : right}),
                                   stiffness_at_edge({&above, blocks_->shape_of(upper), is_horizontal ? bottom : left}),
                                   jump_tolerance);
  };
  parallel::FirstException failure;
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
  for (std::size_t k = 0; k < kinds.size(); ++k) failure.run([&] { average(k); });
  failure.rethrow();
  average_shared_edges(*blocks_, condensed, jump_tolerance, averages_);
}

/// Also returns the coarse stiffness of each kind of block with neighbours.
void BddcPreconditioner::make_block_solvers(const std::vector<PackedSymmetric<double>>& condensed,
                                            std::vector<Eigen::MatrixXd>& coarse_stiffness) {
  const auto& kinds = blocks_->blocks_with_neighbours();
  block_solvers_.resize(kinds.size());
  coarse_stiffness.resize(kinds.size());
  parallel::FirstException failure;
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    failure.run([&] {
      const auto stiffness = condensed[static_cast<std::size_t>(kinds[k].kind)].full();
      block_solvers_[k] = block_solvers_of(kinds[k], stiffness, coarse_stiffness[k]);
    });
  }
  failure.rethrow();
}

BddcPreconditioner::EdgesOfBlock BddcPreconditioner::edges_of(const Substructures::BlockWithNeighbours& block,
                                                              Eigen::Index on_edges) const {
  const auto& shape = blocks_->shape_of(block.kind);
  Eigen::Index constraints = 0;
  for (const int edge : block.edges) {
    if (edge != BlockEdge::none) constraints += averages_[static_cast<std::size_t>(edge)].constraints.cols();
  }
  EdgesOfBlock edges = {Eigen::MatrixXd::Zero(on_edges, constraints), Eigen::MatrixXd::Identity(on_edges, on_edges)};
  Eigen::Index column = 0;
  for (const auto side : {bottom, top, left, right}) {
    const int edge = block.edges.at(side);
    if (edge == BlockEdge::none) continue;
    const auto& average = averages_[static_cast<std::size_t>(edge)];
    const auto [begin, size] = side_range(shape, side);
    auto of_edge = edges.weight.block(begin, begin, size, size);
    // At its top and right edges this block is the lower one of the two.
    if (side == top || side == right) {
      of_edge = average.lower_weight;
    } else {
      of_edge -= average.lower_weight;
    }
    edges.constraints.block(begin, column, size, average.constraints.cols()) = average.constraints;
    column += average.constraints.cols();
  }
  return edges;
}

BddcPreconditioner::BlockSolvers BddcPreconditioner::block_solvers_of(const Substructures::BlockWithNeighbours& block,
                                                                      const Eigen::MatrixXd& condensed,
                                                                      Eigen::MatrixXd& coarse_stiffness) const {
  const Eigen::Index on_edges = condensed.rows() - vertex_unknowns;
  const auto edges = edges_of(block, on_edges);
  const auto [local, coarse] = solvers_with_constraints(condensed, edges.constraints);
  coarse_stiffness = coarse.transpose() * condensed * coarse;
  Eigen::MatrixXd weighted = local, weighted_coarse = coarse.topRows(on_edges);
  for (const auto side : {bottom, top, left, right}) {
    const auto [begin, size] = side_range(blocks_->shape_of(block.kind), side);
    const Eigen::MatrixXd of_edge = edges.weight.block(begin, begin, size, size);
    weighted.middleRows(begin, size) = (of_edge * weighted.middleRows(begin, size)).eval();
    weighted.middleCols(begin, size) = (weighted.middleCols(begin, size) * of_edge.transpose()).eval();
    weighted_coarse.middleRows(begin, size) = (of_edge * weighted_coarse.middleRows(begin, size)).eval();
  }
  return {PackedSymmetric<float>(weighted), weighted_coarse.cast<float>()};
}

int BddcPreconditioner::constraints_of(int edge) const {
  const int kind = blocks_->edge_kind_of(edge);
  return kind == BlockEdge::none ? 0 : static_cast<int>(averages_[static_cast<std::size_t>(kind)].constraints.cols());
}

/// Numbers the unknowns of the vertices first, then the constraints of the edges; the unknowns of other processes come
/// after those of this one.
BddcPreconditioner::CoarseNumbers BddcPreconditioner::number_coarse_unknowns() {
  const auto& grid = blocks_->grid();
  const int edges = static_cast<int>(grid.edges().size());
  std::vector<int> first(grid.edges().size());
  int next = 2 * grid.owned_vertices();
  const auto number_edges = [&](bool owned) {
    for (int e = 0; e < edges; ++e) {
      if (grid.is_owned(e) != owned) continue;
      first[static_cast<std::size_t>(e)] = next;
      next += constraints_of(e);
    }
  };
  number_edges(true);
  const int owned = next;
  next += 2 * (grid.vertices() - grid.owned_vertices());
  number_edges(false);
  coarse_right_.resize(static_cast<std::size_t>(next));
  coarse_solution_.resize(coarse_right_.size());
  for (int b = 0; b < grid.blocks(); ++b) {
    auto& unknowns = coarse_of_.emplace_back();
    for (const int vertex : grid.vertices_of(b)) {
      const bool is_owned = vertex < grid.owned_vertices();
      const int unknown = is_owned ? 2 * vertex : owned + 2 * (vertex - grid.owned_vertices());
      unknowns.push_back(unknown);
      unknowns.push_back(unknown + 1);
    }
    for (const int edge : grid.edges_of(b)) {
      for (int i = 0; i < constraints_of(edge); ++i) unknowns.push_back(first[static_cast<std::size_t>(edge)] + i);
    }
  }
  return {std::move(first), owned};
}

/// Finds the positions of the coarse unknowns of other processes in the lists of those processes.
void BddcPreconditioner::share_coarse_unknowns(const CoarseNumbers& numbers) {
  const auto& grid = blocks_->grid();
  const auto& between = blocks_->edges_between_processes();
  std::vector<int> first_at_owner;
  first_at_owner.reserve(between.size());
  for (const int edge : between) first_at_owner.push_back(numbers.first_of_edge[static_cast<std::size_t>(edge)]);
  blocks_->shared_edges().copy_from_owners(std::span(first_at_owner));
  std::vector<SharedValues::Copy> copies;
  for (const auto& vertex : blocks_->shared_boundaries().vertices) {
    for (int i = 0; i < 2; ++i) {
      const int index = numbers.owned + 2 * (vertex.number - grid.owned_vertices()) + i;
      copies.push_back({index, vertex.owner, 2 * vertex.number_at_owner + i});
    }
  }
  for (const auto& edge : blocks_->shared_boundaries().edges) {
    const auto index = std::ranges::find(between, edge.number) - between.begin();
    for (int i = 0; i < constraints_of(edge.number); ++i) {
      copies.push_back({numbers.first_of_edge[static_cast<std::size_t>(edge.number)] + i, edge.owner,
                        first_at_owner[static_cast<std::size_t>(index)] + i});
    }
  }
  shared_coarse_ = {static_cast<int>(coarse_right_.size()), copies};
}

void BddcPreconditioner::factorise_coarse_problem(const std::vector<Eigen::MatrixXd>& coarse_stiffness,
                                                  double stiffness_of_held, int owned) {
  std::vector<CoarseSolver::Part> parts;
  for (int b = 0; b < blocks_->grid().blocks(); ++b) {
    auto unknowns = coarse_of_[static_cast<std::size_t>(b)];
    const int* of_vertices = blocks_->unknowns_of(b) + blocks_->unknowns_on_boundary(b) - vertex_unknowns;
    for (std::size_t i = 0; i < vertex_unknowns; ++i) {
      if (of_vertices[i] < 0) unknowns[i] = -1;
    }
    parts.push_back({std::move(unknowns), &coarse_stiffness[static_cast<std::size_t>(blocks_->neighbourhood_of(b))]});
  }
  coarse_solver_.emplace(owned, static_cast<int>(coarse_right_.size()), shared_coarse_, parts, stiffness_of_held);
}

/// Calls work(unknowns of the boundary, solvers, coarse unknowns) for every block, one colour after the other.
template <class Work>
void BddcPreconditioner::for_each_block(const Work& work) const {
  parallel::FirstException failure;
  for (const auto& colour : blocks_->grid().colours()) {
#pragma omp parallel for num_threads(threads_)
    for (const int b : colour) {
      failure.run([&] {
        work(blocks_->unknowns_of(b), block_solvers_[static_cast<std::size_t>(blocks_->neighbourhood_of(b))],
             coarse_of_[static_cast<std::size_t>(b)]);
      });
    }
  }
  failure.rethrow();
}

void BddcPreconditioner::apply(const std::vector<double>& residual, std::vector<double>& result) {
  // The vertices are the first unknowns of both problems.
  const auto vertices = 2 * static_cast<std::size_t>(blocks_->grid().owned_vertices());
  std::fill(coarse_right_.begin(), coarse_right_.end(), 0.0);
  std::copy_n(residual.begin(), vertices, coarse_right_.begin());
  for_each_block([&](const int* unknowns, const BlockSolvers& solvers, const std::vector<int>& coarse) {
    const Eigen::VectorXf forces = solvers.coarse.transpose() * gather_single(unknowns, solvers.local.size(), residual);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      coarse_right_[static_cast<std::size_t>(coarse[i])] += static_cast<double>(forces[static_cast<Eigen::Index>(i)]);
    }
  });
  shared_coarse_.add_to_owners(coarse_right_);
  coarse_solver_->solve(coarse_right_, coarse_solution_);
  shared_coarse_.copy_from_owners(coarse_solution_);
  std::fill(result.begin(), result.end(), 0.0);
  std::copy_n(coarse_solution_.begin(), vertices, result.begin());
  for_each_block([&](const int* unknowns, const BlockSolvers& solvers, const std::vector<int>& coarse) {
    Eigen::VectorXf displacements;
    solvers.local.multiply(gather_single(unknowns, solvers.local.size(), residual), displacements);
    displacements += solvers.coarse * gather_single(coarse.data(), solvers.coarse.cols(), coarse_solution_);
    for (Eigen::Index i = 0; i < displacements.size(); ++i) {
      if (unknowns[i] >= 0) result[static_cast<std::size_t>(unknowns[i])] += static_cast<double>(displacements[i]);
    }
  });
  blocks_->shared_unknowns().sum(result);
}

}  // namespace breccia::quasistatic
