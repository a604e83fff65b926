#include "quasistatic/reduced/condensed_vectors.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "parallel/first_exception.hpp"
#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// The length of a vector on all processes together.
PetscInt length_of(Vec vector) {
  PetscInt length = 0;
  check(VecGetSize(vector, &length), "reading the size of a vector");
  return length;
}

NodalVector no_values() {
  NodalVector none;
  check(VecCreateMPI(PETSC_COMM_WORLD, 0, PETSC_DETERMINE, none.put()), "making a vector of a basis");
  return none;
}

}  // namespace

/// The values of some vectors at the nodes of the cells of this process.
class CondensedVectors::ValuesAtNodes {
 public:
  ValuesAtNodes(const CondensedVectors& vectors, std::size_t count)
      : elastic_operator_(vectors.elastic_operator_),
        nodes_(&elastic_operator_->nodes()),
        is_alone_(parallel::ranks() == 1),
        affine_(CellShape<3>::affine_motion(unit_strain<3>(vectors.load_))) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto& displacement = vectors.vectors_[i].displacement;
      auto* const nodal = displacement.fluctuation();
      const bool fluctuates = length_of(nodal) > 0;
      // A single process reads the values where they are; several processes need those of their neighbours.
      if (fluctuates && !is_alone_) local_.push_back(nodes_->local_copy(nodal));
      const auto& values = values_.emplace_back(fluctuates && !is_alone_ ? local_.back().get() : nodal);
      vectors_.push_back({displacement.macroscopic(), fluctuates ? values.data() : nullptr});
      const auto& layout = vectors.elastic_operator_->gap_layout();
      if (vectors.elastic_operator_->has_gaps()) {
        of_gaps_.push_back(fluctuates ? layout.values(nodal) : std::vector<double>(layout.seen(), 0.0));
      }
    }
  }

  /// The displacements of the nodes of a cell, a column for each vector.
  void find(const Index<3>& cell, ValuesOfCell& of_cell) const {
    const auto indices = is_alone_ ? nodes_->nodal_indices_of(cell) : nodes_->indices_of(cell);
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      const auto& [macroscopic, values] = vectors_[i];
      auto column = of_cell.col(static_cast<Eigen::Index>(i));
      column = macroscopic * affine_;
      if (values == nullptr) continue;
      for (std::size_t n = 0; n < indices.size(); ++n) {
        column.segment<3>(static_cast<Eigen::Index>(3 * n)) += Eigen::Map<const Eigen::Vector3d>(values + indices[n]);
      }
    }
  }

  /// What the gaps of a cell add to the volumetric strains of its nodes, by vector; nothing without gaps.
  [[nodiscard]] Eigen::VectorXd strains_of_gaps(const Index<3>& cell, const ValuesOfCell& of_cell) const {
    const auto* gap_cell = elastic_operator_->gap_cell(cell);
    if (gap_cell == nullptr) return {};
    const GapOperator<3> gap(*gap_cell, elastic_operator_->modes());
    Eigen::VectorXd added(of_cell.cols());
    for (Eigen::Index i = 0; i < added.size(); ++i) {
      const CellShape<3>::Values values = of_cell.col(i);
      const auto unknowns =
          gap.unknowns(values, elastic_operator_->gap_layout(), of_gaps_[static_cast<std::size_t>(i)]);
      added[i] = gap.volume(unknowns) - elastic_operator_->modes().row(CellShape<3>::modes - 1).dot(values);
    }
    return added;
  }

 private:
  struct OfVector {
    double macroscopic;
    const double* fluctuation;  ///< fluctuation; null where there is none
  };

  const ElasticOperator<3>* elastic_operator_;
  const NodeLayout<3>* nodes_;
  bool is_alone_;
  CellShape<3>::Values affine_;
  std::vector<NodalVector> local_;
  std::vector<std::vector<double>> of_gaps_;  ///< values of gaps (GapLayout) by vector, if there are any
  std::deque<ReadValues> values_;
  std::vector<OfVector> vectors_;
};

template <class Work>
void CondensedVectors::for_mixed_cells(std::size_t count, const Work& work) const {
  const ValuesAtNodes values(*this, count);
  parallel::FirstException failure;
#pragma omp parallel for num_threads(elastic_operator_->threads()) schedule(dynamic, 1)
  for (int plane = 0; plane < elastic_operator_->planes(); ++plane) {
    failure.run([&] {
      ValuesOfCell of_cell(ValuesOfCell::RowsAtCompileTime, count);
      elastic_operator_->for_mixed_cells_of_planes(
          plane, plane + 1, [&](const Index<3>& cell, const MixedCell<3>& /*mixed*/, std::size_t first) {
            values.find(cell, of_cell);
            work(plane, of_cell, values.strains_of_gaps(cell, of_cell),
                 MixedStrains{elastic_operator_->kinds().of(cell), first});
          });
    });
  }
  failure.rethrow();
}

/// The shares of the phases in the first `count` vectors, by kind of cell.
std::vector<CondensedVectors::SharesOfPhases> CondensedVectors::shares_of_kinds(std::size_t count) const {
  std::vector<SharesOfPhases> by_kind;
  for (const auto& mixed : elastic_operator_->kinds().mixed()) {
    auto& of_kind = by_kind.emplace_back(mixed ? mixed->mixture().size() - 1 : 0, OfVectors(2, count));
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t phase = 0; phase < of_kind.size(); ++phase) {
        const auto& [volumetric, deviatoric] = vectors_[i].shares[by_kind.size() - 1][phase];
        of_kind[phase].col(static_cast<Eigen::Index>(i)) << volumetric, deviatoric;
      }
    }
  }
  return by_kind;
}

/// The amounts b_ji of the earlier vectors, by row j.
Eigen::MatrixXd CondensedVectors::amounts_of_earlier(std::size_t count) const {
  Eigen::MatrixXd amounts = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  for (Eigen::Index j = 0; j < amounts.rows(); ++j) {
    amounts.row(j).head(j) = vectors_[static_cast<std::size_t>(j)].origin.of_earlier.transpose();
  }
  return amounts;
}

/// The shares D_i of Eq. 77 of the theory, by kind of cell.
std::vector<CondensedVectors::SharesOfPhases> CondensedVectors::shares_in_sum(const Eigen::VectorXd& weights) const {
  const auto count = weights.size();
  const auto earlier = amounts_of_earlier(static_cast<std::size_t>(count));
  Eigen::VectorXd amounts = weights;
  for (Eigen::Index j = count - 1; j >= 0; --j) amounts.head(j) += amounts[j] * earlier.row(j).head(j).transpose();
  auto by_kind = shares_of_kinds(static_cast<std::size_t>(count));
  for (auto& of_kind : by_kind) {
    for (auto& shares : of_kind) {
      const OfVectors own = shares;
      for (Eigen::Index i = 0; i < count; ++i) {
        shares.col(i) = weights[i] * own.col(i);
        for (Eigen::Index j = i + 1; j < count; ++j) {
          shares.col(i) += amounts[j] * earlier(j, i) * (own.col(i) - own.col(j));
        }
      }
    }
  }
  return by_kind;
}

std::vector<std::vector<StrainShare>> CondensedVectors::shares_of(const VectorOrigin& origin) const {
  std::optional<std::vector<Moduli>> moduli;
  if (origin.parameters) moduli = stiffness_->moduli_at(*origin.parameters);
  std::vector<std::vector<StrainShare>> shares;
  const auto& kinds = elastic_operator_->kinds();
  for (std::size_t kind = 0; kind < kinds.count(); ++kind) {
    const auto& mixed = kinds.mixed()[kind];
    auto& of_kind = shares.emplace_back();
    if (!mixed) continue;
    // The uniform strain is the same in all phases.
    const auto uniform =
        kinds.has_gaps(kind) ? mixed->uniform_share() : StrainShare{.volumetric = 1.0, .deviatoric = 1.0};
    of_kind = moduli ? mixed->shares(*moduli) : std::vector(mixed->mixture().size() - 1, uniform);
  }
  return shares;
}

/// A vector in the form that is stored. An affine motion takes no memory: neither that of walls that move with it, nor
/// the uniform strain of a box under tractions, which is stored as a macroscopic part, because such a box has no other
/// one.
Displacement CondensedVectors::condensed(Displacement vector, const VectorOrigin& origin) const {
  if (elastic_operator_->boundary() == Boundary::traction && !origin.parameters) {
    const auto uniform = elastic_operator_->uniform_strain(load_).take_fluctuation();
    double both = 0.0, squared = 0.0;
    check(VecDot(vector.fluctuation(), uniform.get(), &both), "reading a uniform strain");
    check(VecDot(uniform.get(), uniform.get(), &squared), "reading a uniform strain");
    return {both / squared, no_values(), no_values()};
  }
  double largest = 0.0;
  check(VecNorm(vector.fluctuation(), NORM_INFINITY, &largest), "reading the displacements");
  return {vector.macroscopic(), largest > 0.0 ? vector.take_fluctuation() : no_values(), no_values()};
}

/// The vector to be stored: without the strains of phases, and without nodal values if they are zero.
Displacement CondensedVectors::without_strains(const Displacement& condensed) const {
  if (length_of(condensed.fluctuation()) > 0) {
    return {condensed.macroscopic(), condensed.shared_fluctuation(), no_values()};
  }
  if (elastic_operator_->boundary() == Boundary::traction) {
    auto uniform = elastic_operator_->uniform_strain(load_);
    uniform.scale(condensed.macroscopic());
    return {0.0, uniform.take_fluctuation(), no_values()};
  }
  return {condensed.macroscopic(), no_values(), no_values()};
}

void CondensedVectors::add(Displacement vector, VectorOrigin origin) {
  auto shares = shares_of(origin);
  auto displacement = condensed(std::move(vector), origin);
  vectors_.push_back({std::move(displacement), std::move(origin), std::move(shares)});
}

Displacement CondensedVectors::at(std::size_t index) const {
  auto without = without_strains(vectors_[index].displacement);
  const bool fluctuates = length_of(without.fluctuation()) > 0;
  Displacement vector(without.macroscopic(),
                      fluctuates ? without.take_fluctuation() : elastic_operator_->nodes().zeros(),
                      elastic_operator_->zero_strains_of_phases());
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(index) + 1);
  weights[static_cast<Eigen::Index>(index)] = 1.0;
  add_phase_strains(weights, vector.phase_strains());
  return vector;
}

Eigen::VectorXd CondensedVectors::works(const Forces& forces) const {
  const auto count = static_cast<Eigen::Index>(size());
  const auto shares = shares_of_kinds(size());
  const auto earlier = amounts_of_earlier(size());
  // The first sum of Eq. 76 is taken by plane of cells, so that the sums are bitwise identical for any number of
  // threads.
  Eigen::MatrixXd of_own = Eigen::MatrixXd::Zero(count, elastic_operator_->planes());
  {
    const ReadValues on_strains(forces.phase_strains());
    for_mixed_cells(size(), [&](int plane, const ValuesOfCell& values, const Eigen::VectorXd& of_gaps,
                                const MixedStrains& strains) {
      Eigen::VectorXd volumetric(count), deviatoric(count);
      auto first = strains.first;
      for (const auto& of_phase : shares[strains.kind]) {
        const auto on_phase = on_strains.range(first, Shape::modes);
        const Shape::Values on_deviator = deviators().transpose() * on_phase.head<Shape::modes - 1>();
        const Shape::Values on_volume = volume().transpose() * on_phase[Shape::modes - 1];
        volumetric.noalias() = values.transpose() * on_volume;
        deviatoric.noalias() = values.transpose() * on_deviator;
        if (of_gaps.size() > 0) volumetric += on_phase[Shape::modes - 1] * of_gaps;
        first += Shape::modes;
        for (Eigen::Index j = 0; j < count; ++j) {
          const auto amounts = earlier.row(j).head(j);
          of_own(j, plane) += of_phase(0, j) * (volumetric[j] - amounts.dot(volumetric.head(j))) +
                              of_phase(1, j) * (deviatoric[j] - amounts.dot(deviatoric.head(j)));
        }
      }
    });
  }
  Eigen::VectorXd works = of_own.rowwise().sum();
  check(MPI_Allreduce(MPI_IN_PLACE, works.data(), static_cast<int>(count), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD),
        "adding up works");
  for (Eigen::Index j = 0; j < count; ++j) works[j] += earlier.row(j).head(j).dot(works.head(j));
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto displacement = without_strains(vectors_[static_cast<std::size_t>(i)].displacement);
    double on_nodes = 0.0;
    if (length_of(displacement.fluctuation()) > 0) {
      check(VecDot(forces.fluctuation(), displacement.fluctuation(), &on_nodes), "a scalar product");
    }
    works[i] += on_nodes + forces.macroscopic() * displacement.macroscopic();
  }
  return works;
}

void CondensedVectors::add_phase_strains(const Eigen::VectorXd& weights, Vec phase_strains) const {
  const auto shares = shares_in_sum(weights);
  const WriteValues all_strains(phase_strains);
  for_mixed_cells(static_cast<std::size_t>(weights.size()),
                  [&](int, const ValuesOfCell& values, const Eigen::VectorXd& of_gaps, const MixedStrains& strains) {
                    auto first = strains.first;
                    for (const auto& of_phase : shares[strains.kind]) {
                      const Shape::Values volumetric = values * of_phase.row(0).transpose();
                      const Shape::Values deviatoric = values * of_phase.row(1).transpose();
                      auto added = all_strains.range(first, Shape::modes);
                      added.head<Shape::modes - 1>() += deviators() * deviatoric;
                      added[Shape::modes - 1] += volume().dot(volumetric);
                      if (of_gaps.size() > 0) added[Shape::modes - 1] += of_phase.row(0).dot(of_gaps);
                      first += Shape::modes;
                    }
                  });
}

void CondensedVectors::add_to(Displacement& sum, const Eigen::VectorXd& weights) const {
  add_phase_strains(weights, sum.phase_strains());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0.0) continue;
    const auto displacement = without_strains(vectors_[static_cast<std::size_t>(i)].displacement);
    sum.set_macroscopic(sum.macroscopic() + weights[i] * displacement.macroscopic());
    if (length_of(displacement.fluctuation()) == 0) continue;
    check(VecAXPY(sum.fluctuation(), weights[i], displacement.fluctuation()), "adding nodal vectors");
  }
}

void CondensedVectors::save(StateWriter& state, const std::string& group) const {
  state.write(group + "/vectors", static_cast<std::int64_t>(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    const auto& [condensed, origin, shares] = vectors_[i];
    const auto name = fmt::format("{}/vector/{}", group, i);
    auto displacement = without_strains(condensed);
    if (length_of(displacement.fluctuation()) == 0) displacement.set_fluctuation(elastic_operator_->nodes().zeros());
    quasistatic::save(state, name, displacement);
    state.write(name + "/of_earlier",
                std::vector<double>(origin.of_earlier.data(), origin.of_earlier.data() + origin.of_earlier.size()));
    state.write(name + "/parameters", origin.parameters.value_or(std::vector<double>{}));
  }
}

void CondensedVectors::restore(const StateReader& state, const std::string& group,
                               const std::function<Displacement()>& zero) {
  const auto count = state.integer(group + "/vectors");
  vectors_.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    const auto name = fmt::format("{}/vector/{}", group, i);
    Displacement displacement{0.0, zero().take_fluctuation(), no_values()};
    quasistatic::restore(state, name, displacement);
    const auto of_earlier = state.numbers(name + "/of_earlier", static_cast<std::size_t>(i));
    VectorOrigin origin{std::nullopt, Eigen::Map<const Eigen::VectorXd>(of_earlier.data(), i)};
    const auto parameters = state.numbers(name + "/parameters");
    if (!parameters.empty()) origin.parameters = state.numbers(name + "/parameters", stiffness_->parts.size());
    add(std::move(displacement), std::move(origin));
  }
}

}  // namespace breccia::quasistatic
