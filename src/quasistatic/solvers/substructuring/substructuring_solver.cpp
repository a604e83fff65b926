#include "quasistatic/solvers/substructuring/substructuring_solver.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "parallel/first_exception.hpp"
#include "parallel/reduction.hpp"
#include "parallel/threads.hpp"
#include "quasistatic/operator/square_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// Number of threads that are useful: each needs some hundred blocks.
int useful_threads(int threads, int blocks) {
  constexpr int blocks_per_thread = 200;
  return std::clamp(blocks / blocks_per_thread, 1, threads);
}

/// Values of the unknowns of the boundary of a block, zero where they are held.
Eigen::VectorXd gather(const int* unknowns, Eigen::Index count, const std::vector<double>& values) {
  Eigen::VectorXd local(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    local[i] = unknowns[i] < 0 ? 0.0 : values[static_cast<std::size_t>(unknowns[i])];
  }
  return local;
}

Eigen::VectorXd values_at(const std::vector<std::size_t>& indices, const double* values) {
  Eigen::VectorXd chosen(static_cast<Eigen::Index>(indices.size()));
  for (std::size_t i = 0; i < indices.size(); ++i) chosen[static_cast<Eigen::Index>(i)] = values[indices[i]];
  return chosen;
}

/// Throws NumericalError when a displacement of the interface has no positive energy.
void require_definite(double energy) {
  if (energy > 0.0) return;
  throw NumericalError(fmt::format(
      "quasi-static solver: a displacement has the energy {:.1e}, so the stiffness is not positive definite; "
      "a modulus of a material may vanish or be negative, or the contrast be beyond what numbers hold",
      energy));
}

/// a = factor * a + other * b
void combine(double factor, std::vector<double>& a, double other, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = factor * a[i] + other * b[i];
}

}  // namespace

SubstructuringSolver::SubstructuringSolver(const ElasticOperator<2>& elastic_operator, const LinearOptions& options)
    : ElasticSolver(elastic_operator, options, false),
      blocks_(elastic_operator),
      threads_(useful_threads(parallel::threads_for(options.threads), blocks_.grid().blocks())),
      index_of_unknown_(static_cast<std::size_t>(blocks_.grid().owned_unknowns())) {
  const auto& grid = blocks_.grid();
  for (int b = 0; b < grid.blocks(); ++b) {
    const auto block = grid.block(b);
    const auto on_boundary = boundary_unknowns(block, grid.faces());
    const auto unknowns = grid.unknowns_of(b);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      if (unknowns[i] >= grid.owned_unknowns()) continue;
      index_of_unknown_[static_cast<std::size_t>(unknowns[i])] = index_of(block, on_boundary[i]);
    }
  }
}

/// Index of an unknown of a block among the values of this process in a nodal vector.
std::size_t SubstructuringSolver::index_of(const Block& block, const BlockUnknown& unknown) const noexcept {
  const auto& [begin, end] = elastic_operator().nodes().own_nodes();
  const int width = end[0] - begin[0], height = end[1] - begin[1];
  if (unknown.of_face != BlockUnknown::none) {
    const auto of_nodes = 2 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return of_nodes + elastic_operator().gap_layout().index_of(unknown.of_face);
  }
  // The last nodes of a process that wraps around are its first ones.
  const int column = block.first_column + unknown.x - begin[0], row = block.first_row + unknown.y - begin[1];
  return 2 * (static_cast<std::size_t>(row % height) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(column % width)) +
         static_cast<std::size_t>(unknown.component);
}

double SubstructuringSolver::product(const std::vector<double>& a, const std::vector<double>& b) const {
  const Eigen::Index own = blocks_.grid().owned_unknowns();
  return parallel::sum(
      Eigen::Map<const Eigen::VectorXd>(a.data(), own).dot(Eigen::Map<const Eigen::VectorXd>(b.data(), own)));
}

void SubstructuringSolver::update_stiffness(std::span<const Moduli> moduli) {
  stiffest_ = 0.0;
  for (const auto& [bulk, shear] : moduli) stiffest_ = std::max(stiffest_, bulk + shear);
  cells_ = elastic_operator().kinds().stiffnesses(moduli);
  // The memory of the earlier preconditioner is freed before the new one is made.
  preconditioner_.reset();
  condensed_.assign(blocks_.blocks_by_kind().size(), {});
  parallel::FirstException failure;
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
  for (std::size_t kind = 0; kind < condensed_.size(); ++kind) {
    failure.run([&] {
      const BlockStiffness stiffness(blocks_.block_kind(static_cast<int>(kind), cells_, this->moduli()), stiffest_);
      condensed_[kind] = PackedSymmetric<double>(stiffness.condensed());
    });
  }
  failure.rethrow();
  preconditioner_.emplace(blocks_, condensed_, stiffest_, threads_);
  count_factorisation();
}

template <class Work>
void SubstructuringSolver::for_each_block(const Work& work) const {
  const auto& kinds = blocks_.blocks_by_kind();
  parallel::FirstException failure;
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    failure.run([&] {
      const BlockStiffness stiffness(blocks_.block_kind(static_cast<int>(kind), cells_, this->moduli()), stiffest_);
      for (const int block : kinds[kind]) work(block, stiffness);
    });
  }
  failure.rethrow();
}

std::vector<std::size_t> SubstructuringSolver::indices_inside(int number) const {
  const auto block = blocks_.grid().block(number);
  std::vector<std::size_t> indices;
  for (const auto& unknown : inside_unknowns(block, blocks_.grid().faces())) {
    indices.push_back(index_of(block, unknown));
  }
  return indices;
}

std::vector<double> SubstructuringSolver::condense(const double* forces) const {
  const auto& grid = blocks_.grid();
  std::vector<double> carried(blocks_.unknowns_of_all_blocks());
  for_each_block([&](int block, const BlockStiffness& stiffness) {
    const Eigen::VectorXd of_block = stiffness.carried_by_boundary(values_at(indices_inside(block), forces));
    std::copy_n(of_block.data(), of_block.size(), carried.data() + blocks_.first_unknown(block));
  });
  std::vector<double> interface(static_cast<std::size_t>(grid.unknowns()), 0.0);
  for (std::size_t u = 0; u < index_of_unknown_.size(); ++u) interface[u] = forces[index_of_unknown_[u]];
  for (int b = 0; b < grid.blocks(); ++b) {
    const int* unknowns = blocks_.unknowns_of(b);
    const double* of_block = carried.data() + blocks_.first_unknown(b);
    for (int i = 0; i < blocks_.unknowns_on_boundary(b); ++i) {
      if (unknowns[i] >= 0) interface[static_cast<std::size_t>(unknowns[i])] -= of_block[i];
    }
  }
  blocks_.shared_unknowns().sum(interface);
  return interface;
}

void SubstructuringSolver::expand(const double* forces, const std::vector<double>& interface,
                                  double* displacement) const {
  for_each_block([&](int b, const BlockStiffness& stiffness) {
    const auto indices = indices_inside(b);
    const auto boundary = gather(blocks_.unknowns_of(b), blocks_.unknowns_on_boundary(b), interface);
    const Eigen::VectorXd inside = stiffness.displacement_inside(values_at(indices, forces), boundary);
    for (std::size_t i = 0; i < indices.size(); ++i) displacement[indices[i]] += inside[static_cast<Eigen::Index>(i)];
  });
  for (std::size_t u = 0; u < index_of_unknown_.size(); ++u) displacement[index_of_unknown_[u]] += interface[u];
}

void SubstructuringSolver::multiply(const std::vector<double>& x, std::vector<double>& y) const {
  std::fill(y.begin(), y.end(), 0.0);
  const auto add_forces_of = [&](int block) {
    const int* unknowns = blocks_.unknowns_of(block);
    const auto& stiffness = condensed_[static_cast<std::size_t>(blocks_.kind_of(block))];
    Eigen::VectorXd forces;
    stiffness.multiply(gather(unknowns, stiffness.size(), x), forces);
    for (Eigen::Index k = 0; k < forces.size(); ++k) {
      if (unknowns[k] >= 0) y[static_cast<std::size_t>(unknowns[k])] += forces[k];
    }
  };
  parallel::FirstException failure;
  for (const auto& colour : blocks_.grid().colours()) {
#pragma omp parallel for num_threads(threads_)
    for (const int b : colour) failure.run([&] { add_forces_of(b); });
  }
  failure.rethrow();
  blocks_.shared_unknowns().sum(y);
}

double SubstructuringSolver::correct(const Displacement& residual, double largest, Displacement& displacement) {
  constexpr const char* what = "solving for the displacements";
  constexpr int many = 2000;
  const ReadValues forces(residual.fluctuation());
  auto r = condense(forces.data());
  std::vector<double> x(r.size(), 0.0), z(r.size()), p(r.size(), 0.0), s(r.size());
  double before = 1.0, norm = std::sqrt(product(r, r));
  int iterations = 0;
  for (; !is_small(norm, largest) && iterations < many; ++iterations) {
    look_in_iteration();
    preconditioner_->apply(r, z);
    const double now = product(r, z);
    combine(now / before, p, 1.0, z);
    multiply(p, s);
    const double energy = product(p, s);
    require_definite(energy);
    const double step = now / energy;
    combine(1.0, x, step, p);
    combine(1.0, r, -step, s);
    before = now;
    norm = std::sqrt(product(r, r));
  }
  count_iterations(iterations);
  double* values = nullptr;
  check(VecGetArray(displacement.fluctuation(), &values), what);
  expand(forces.data(), x, values);
  check(VecRestoreArray(displacement.fluctuation(), &values), what);
  return norm;
}

ElasticSolver<2>::Convergence SubstructuringSolver::iterate(NodalVector on_nodes, Displacement& displacement) {
  // Iterative refinement: after the first pass only rounding errors of the conjugate gradients remain.
  constexpr int most_corrections = 4;
  displacement.set_macroscopic(0.0);
  // No forces act on the strains of phases, which follow from the displacement.
  auto forces = elastic_operator().zero();
  forces.set_fluctuation(std::move(on_nodes));
  double norm = 0.0;
  for (int correction = 0; correction <= most_corrections; ++correction) {
    elastic_operator().recover_phase_strains(moduli(), forces, displacement);
    auto residual = forces_under(elastic_operator(), moduli(), displacement);
    residual.scale(-1.0);
    residual.add(1.0, forces);
    double largest = 0.0;
    check(VecNorm(displacement.fluctuation(), NORM_INFINITY, &largest), "reading the displacements");
    check(VecNorm(residual.fluctuation(), NORM_2, &norm), "reading the residual");
    if (!std::isfinite(norm)) break;
    if (is_small(norm, largest)) return {true, norm};
    if (correction < most_corrections) correct(residual, largest, displacement);
  }
  return {false, norm};
}

}  // namespace breccia::quasistatic
