#include "balancing.hpp"

namespace breccia::quasistatic {
namespace {

/// Averaging at an edge may cost this many times the energy of what is averaged; what would cost more is constrained.
constexpr double tolerance = 8.0;

constexpr Eigen::Index vertex_unknowns = 8;

/// Forces or displacements on the edges of a block.
Eigen::VectorXf gather(const int* unknowns, Eigen::Index count, const std::vector<double>& values) {
  Eigen::VectorXf local(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    local[i] = unknowns[i] < 0 ? 0.0F : static_cast<float>(values[static_cast<std::size_t>(unknowns[i])]);
  }
  return local;
}

}  // namespace

Balancing::Balancing(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
                     double stiffness_of_held, int threads)
    : blocks_(&blocks), threads_(threads) {
  average_edges(condensed);
  const auto& surrounded = blocks.surrounded();
  answers_.resize(surrounded.size());
  std::vector<Eigen::MatrixXd> coarse_stiffness(surrounded.size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
  for (std::size_t s = 0; s < surrounded.size(); ++s) {
    answers_[s] =
        answers_of(surrounded[s], condensed[static_cast<std::size_t>(surrounded[s].kind)].full(), coarse_stiffness[s]);
  }
  number_constraints();
  averages_.clear();
  std::vector<CoarseSolver::Part> parts;
  for (int b = 0; b < blocks.grid().blocks(); ++b) {
    auto unknowns = coarse_of_[static_cast<std::size_t>(b)];
    for (std::size_t i = 0; i < vertex_unknowns; ++i) {
      if (blocks.is_held(unknowns[i])) unknowns[i] = -1;
    }
    parts.push_back({std::move(unknowns), &coarse_stiffness[static_cast<std::size_t>(blocks.surrounded_of(b))]});
  }
  coarse_solver_.emplace(coarse_unknowns(), parts, stiffness_of_held);
}

void Balancing::average_edges(const std::vector<PackedSymmetric<double>>& condensed) {
  const auto& kinds = blocks_->edge_kinds();
  averages_.resize(kinds.size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto& [lower, upper, is_horizontal] = kinds[k];
    const auto below = condensed[static_cast<std::size_t>(lower)].full();
    const auto above = condensed[static_cast<std::size_t>(upper)].full();
    averages_[k] = average_at_edge({&below, blocks_->shape_of(lower), is_horizontal ? top : right},
                                   {&above, blocks_->shape_of(upper), is_horizontal ? bottom : left}, tolerance);
  }
}

Balancing::Answers Balancing::answers_of(const Substructures::Surrounded& surrounded, const Eigen::MatrixXd& condensed,
                                         Eigen::MatrixXd& coarse_stiffness) const {
  const Eigen::Index on_edges = condensed.rows() - vertex_unknowns;
  const auto& shape = blocks_->shape_of(surrounded.kind);
  Eigen::Index constraints = 0;
  for (const int edge : surrounded.edges) {
    if (edge != BlockEdge::none) constraints += averages_[static_cast<std::size_t>(edge)].constraints.cols();
  }
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(on_edges, constraints);
  Eigen::MatrixXd weight = Eigen::MatrixXd::Identity(on_edges, on_edges);
  Eigen::Index column = 0;
  for (const auto side : {bottom, top, left, right}) {
    const int edge = surrounded.edges.at(side);
    if (edge == BlockEdge::none) continue;
    const auto& average = averages_[static_cast<std::size_t>(edge)];
    const auto [begin, size] = side_range(shape, side);
    auto of_edge = weight.block(begin, begin, size, size);
    // At its top and right this block is the lower one of the two.
    if (side == top || side == right) {
      of_edge = average.lower_weight;
    } else {
      of_edge -= average.lower_weight;
    }
    q.block(begin, column, size, average.constraints.cols()) = average.constraints;
    column += average.constraints.cols();
  }

  // Local answers W - W q (q' W q)^-1 q' W with W the inverse on the edges; coarse ones from unit values of the
  // vertices, -local S_ev, and of the constraints, W q (q' W q)^-1.
  const Eigen::MatrixXd inverse =
      condensed.topLeftCorner(on_edges, on_edges).llt().solve(Eigen::MatrixXd::Identity(on_edges, on_edges));
  const Eigen::MatrixXd answer = inverse * q;
  const Eigen::MatrixXd of_constraints = q.transpose() * answer;
  const Eigen::MatrixXd by_constraints = of_constraints.llt().solve(answer.transpose()).transpose();
  const Eigen::MatrixXd local = inverse - by_constraints * answer.transpose();
  Eigen::MatrixXd coarse(on_edges + vertex_unknowns, vertex_unknowns + constraints);
  coarse << -local * condensed.topRightCorner(on_edges, vertex_unknowns), by_constraints,
      Eigen::MatrixXd::Identity(vertex_unknowns, vertex_unknowns), Eigen::MatrixXd::Zero(vertex_unknowns, constraints);
  coarse_stiffness = coarse.transpose() * condensed * coarse;
  Eigen::MatrixXd weighted = local, weighted_coarse = coarse.topRows(on_edges);
  for (const auto side : {bottom, top, left, right}) {
    const auto [begin, size] = side_range(shape, side);
    const Eigen::MatrixXd of_edge = weight.block(begin, begin, size, size);
    weighted.middleRows(begin, size) = (of_edge * weighted.middleRows(begin, size)).eval();
    weighted.middleCols(begin, size) = (weighted.middleCols(begin, size) * of_edge.transpose()).eval();
    weighted_coarse.middleRows(begin, size) = (of_edge * weighted_coarse.middleRows(begin, size)).eval();
  }
  return {PackedSymmetric<float>(weighted), weighted_coarse.cast<float>()};
}

void Balancing::number_constraints() {
  const auto& grid = blocks_->grid();
  std::vector<int> first = {2 * grid.vertices()};
  for (std::size_t e = 0; e < grid.edges().size(); ++e) {
    const int kind = blocks_->edge_kind_of(static_cast<int>(e));
    const auto count = kind == BlockEdge::none ? 0 : averages_[static_cast<std::size_t>(kind)].constraints.cols();
    first.push_back(first.back() + static_cast<int>(count));
  }
  coarse_right_.resize(static_cast<std::size_t>(first.back()));
  coarse_solution_.resize(coarse_right_.size());
  for (int b = 0; b < grid.blocks(); ++b) {
    auto& unknowns = coarse_of_.emplace_back();
    for (const int vertex : grid.vertices_of(b)) {
      unknowns.push_back(2 * vertex);
      unknowns.push_back(2 * vertex + 1);
    }
    for (const int edge : grid.edges_of(b)) {
      const auto e = static_cast<std::size_t>(edge);
      for (int u = first[e]; u < first[e + 1]; ++u) unknowns.push_back(u);
    }
  }
}

void Balancing::apply(const std::vector<double>& residual, std::vector<double>& result) {
  const auto vertices = 2 * static_cast<std::size_t>(blocks_->grid().vertices());
  std::fill(coarse_right_.begin(), coarse_right_.end(), 0.0);
  std::copy_n(residual.begin(), vertices, coarse_right_.begin());
  const auto for_each_block = [&](const auto& work) {
    for (const auto& colour : blocks_->grid().colours()) {
#pragma omp parallel for num_threads(threads_)
      for (const int b : colour) {
        work(blocks_->unknowns_of(b), answers_[static_cast<std::size_t>(blocks_->surrounded_of(b))],
             coarse_of_[static_cast<std::size_t>(b)]);
      }
    }
  };
  for_each_block([&](const int* unknowns, const Answers& answers, const std::vector<int>& coarse) {
    const Eigen::VectorXf forces = answers.coarse.transpose() * gather(unknowns, answers.local.size(), residual);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      coarse_right_[static_cast<std::size_t>(coarse[i])] += static_cast<double>(forces[static_cast<Eigen::Index>(i)]);
    }
  });
  coarse_solver_->solve(coarse_right_, coarse_solution_);
  std::fill(result.begin(), result.end(), 0.0);
  std::copy_n(coarse_solution_.begin(), vertices, result.begin());
  for_each_block([&](const int* unknowns, const Answers& answers, const std::vector<int>& coarse) {
    Eigen::VectorXf answer;
    answers.local.multiply(gather(unknowns, answers.local.size(), residual), answer);
    answer += answers.coarse * gather(coarse.data(), answers.coarse.cols(), coarse_solution_);
    for (Eigen::Index i = 0; i < answer.size(); ++i) {
      if (unknowns[i] >= 0) result[static_cast<std::size_t>(unknowns[i])] += static_cast<double>(answer[i]);
    }
  });
}

}  // namespace breccia::quasistatic
