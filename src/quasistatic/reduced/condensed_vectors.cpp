#include "reduced/condensed_vectors.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// On all processes.
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

/// The strains of the phases of one mixed cell after the other, in each of the vectors.
class CondensedVectors::CellStrains {
 public:
  CellStrains(const CondensedVectors& vectors, std::size_t count)
      : vectors_(&vectors), of_cell_(count), of_phases_(count) {}

  /// Finds those of a cell of a kind, from the values of each vector at its nodes.
  template <class ValuesOf>
  void find(std::uint32_t kind, const ValuesOf& values_of) {
    for (std::size_t i = 0; i < of_cell_.size(); ++i) {
      of_cell_[i].noalias() = vectors_->elastic_operator_->modes() * values_of(i);
      const auto& [displacement, origin, shares] = vectors_->vectors_[i];
      Modes own = of_cell_[i];
      for (std::size_t k = 0; k < i; ++k)
        own.noalias() -= origin.of_earlier[static_cast<Eigen::Index>(k)] * of_cell_[k];
      const auto& of_kind = shares[kind];
      auto& strains = of_phases_[i];
      strains.resize(Shape::modes * static_cast<Eigen::Index>(of_kind.size()));
      for (std::size_t phase = 0; phase < of_kind.size(); ++phase) {
        const auto place = Shape::modes * static_cast<Eigen::Index>(phase);
        strains.segment<Shape::modes>(place) = of_kind[phase].deviatoric * own;
        strains[place + Shape::modes - 1] = of_kind[phase].volumetric * own[Shape::modes - 1];
      }
      for (std::size_t k = 0; k < i; ++k) strains += origin.of_earlier[static_cast<Eigen::Index>(k)] * of_phases_[k];
    }
  }

  /// Those of all phases but the first in a vector.
  [[nodiscard]] const Eigen::VectorXd& in(std::size_t vector) const noexcept { return of_phases_[vector]; }

 private:
  using Shape = CellShape<3>;

  const CondensedVectors* vectors_;
  std::vector<Modes> of_cell_;
  std::vector<Eigen::VectorXd> of_phases_;
};

template <class Work>
void CondensedVectors::for_mixed_cells(std::size_t count, const Work& work) const {
  const auto& nodes = elastic_operator_->nodes();
  // One process reads the values where they are, several need those of their neighbours.
  const bool is_alone = parallel::ranks() == 1;
  std::vector<NodalVector> local;
  std::deque<ReadValues> values;
  std::vector<bool> fluctuates;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec nodal = vectors_[i].displacement.fluctuation();
    fluctuates.push_back(length_of(nodal) > 0);
    if (!fluctuates.back()) {
      values.emplace_back(nodal);
      continue;
    }
    if (!is_alone) local.push_back(nodes.local_copy(nodal));
    values.emplace_back(is_alone ? nodal : local.back().get());
  }
  const CellShape<3>::Values affine = CellShape<3>::affine_motion(unit_strain<3>(load_));
#pragma omp parallel num_threads(elastic_operator_->threads())
  {
    CellStrains strains(*this, count);
#pragma omp for schedule(dynamic, 1)
    for (int plane = 0; plane < elastic_operator_->planes(); ++plane) {
      elastic_operator_->for_mixed_cells_of_planes(
          plane, plane + 1, [&](const Index<3>& cell, const MixedCell<3>& mixed, std::size_t first) {
            const auto places = is_alone ? nodes.nodal_places_of(cell) : nodes.places_of(cell);
            strains.find(elastic_operator_->kind_of_cell(cell), [&](std::size_t i) {
              CellShape<3>::Values u = vectors_[i].displacement.macroscopic() * affine;
              if (!fluctuates[i]) return u;
              for (std::size_t n = 0; n < places.size(); ++n) {
                u.segment<3>(static_cast<Eigen::Index>(3 * n)) += values[i].range(places[n], 3);
              }
              return u;
            });
            work(plane, strains, first, mixed.unknowns());
          });
    }
  }
}

std::vector<std::vector<StrainShare>> CondensedVectors::shares_of(const VectorOrigin& origin) const {
  std::optional<std::vector<Moduli>> moduli;
  if (origin.parameters) moduli = stiffness_->moduli_at(*origin.parameters);
  std::vector<std::vector<StrainShare>> shares;
  for (const auto& mixed : elastic_operator_->mixed_kinds()) {
    auto& of_kind = shares.emplace_back();
    if (!mixed) continue;
    // The uniform strain is the same in all phases.
    constexpr StrainShare whole = {.volumetric = 1.0, .deviatoric = 1.0};
    of_kind = moduli ? mixed->shares(*moduli) : std::vector(mixed->mixture().size() - 1, whole);
  }
  return shares;
}

Displacement CondensedVectors::without_strains(double macroscopic, NodalVector fluctuation) {
  // An affine motion, such as the uniform strain of a box whose walls move with it, takes no memory.
  double largest = 0.0;
  check(VecNorm(fluctuation.get(), NORM_INFINITY, &largest), "reading the displacements");
  return {macroscopic, largest > 0.0 ? std::move(fluctuation) : no_values(), no_values()};
}

void CondensedVectors::add(Displacement vector, VectorOrigin origin) {
  auto shares = shares_of(origin);
  vectors_.push_back(
      {without_strains(vector.macroscopic(), vector.take_fluctuation()), std::move(origin), std::move(shares)});
}

Displacement CondensedVectors::at(std::size_t place) const {
  auto vector = elastic_operator_->zero();
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(place) + 1);
  weights[static_cast<Eigen::Index>(place)] = 1.0;
  add_to(vector, weights);
  return vector;
}

Eigen::VectorXd CondensedVectors::works(const Forces& forces) const {
  const auto count = static_cast<Eigen::Index>(size());
  // By plane of cells, so that the sums have the same bits for any number of threads.
  Eigen::MatrixXd on_phases = Eigen::MatrixXd::Zero(count, elastic_operator_->planes());
  {
    const ReadValues on_strains(forces.phase_strains());
    for_mixed_cells(size(), [&](int plane, const CellStrains& strains, std::size_t first, Eigen::Index unknowns) {
      const auto of_cell = on_strains.range(first, unknowns);
      for (Eigen::Index i = 0; i < count; ++i) {
        on_phases(i, plane) += of_cell.dot(strains.in(static_cast<std::size_t>(i)));
      }
    });
  }
  Eigen::VectorXd works = on_phases.rowwise().sum();
  check(MPI_Allreduce(MPI_IN_PLACE, works.data(), static_cast<int>(count), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD),
        "adding up works");
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& displacement = vectors_[static_cast<std::size_t>(i)].displacement;
    double on_nodes = 0.0;
    if (length_of(displacement.fluctuation()) > 0) {
      check(VecDot(forces.fluctuation(), displacement.fluctuation(), &on_nodes), "a scalar product");
    }
    works[i] += on_nodes + forces.macroscopic() * displacement.macroscopic();
  }
  return works;
}

void CondensedVectors::add_to(Displacement& sum, const Eigen::VectorXd& weights) const {
  {
    const WriteValues phase_strains(sum.phase_strains());
    for_mixed_cells(static_cast<std::size_t>(weights.size()),
                    [&](int, const CellStrains& strains, std::size_t first, Eigen::Index unknowns) {
                      auto of_cell = phase_strains.range(first, unknowns);
                      for (Eigen::Index i = 0; i < weights.size(); ++i) {
                        if (weights[i] != 0.0) of_cell += weights[i] * strains.in(static_cast<std::size_t>(i));
                      }
                    });
  }
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const auto& displacement = vectors_[static_cast<std::size_t>(i)].displacement;
    if (weights[i] == 0.0) continue;
    sum.set_macroscopic(sum.macroscopic() + weights[i] * displacement.macroscopic());
    if (length_of(displacement.fluctuation()) == 0) continue;
    check(VecAXPY(sum.fluctuation(), weights[i], displacement.fluctuation()), "adding nodal vectors");
  }
}

void CondensedVectors::save(StateWriter& state, const std::string& group) const {
  state.write(group + "/vectors", static_cast<std::int64_t>(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    const auto& [displacement, origin, shares] = vectors_[i];
    const auto name = fmt::format("{}/vector/{}", group, i);
    if (length_of(displacement.fluctuation()) > 0) {
      quasistatic::save(state, name, displacement);
    } else {
      Displacement at_rest{displacement.macroscopic(), elastic_operator_->nodes().zeros(), no_values()};
      quasistatic::save(state, name, at_rest);
    }
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
    displacement = without_strains(displacement.macroscopic(), displacement.take_fluctuation());
    const auto of_earlier = state.numbers(name + "/of_earlier");
    const auto parameters = state.numbers(name + "/parameters");
    VectorOrigin origin{std::nullopt, Eigen::Map<const Eigen::VectorXd>(of_earlier.data(),
                                                                        static_cast<Eigen::Index>(of_earlier.size()))};
    if (!parameters.empty()) origin.parameters = parameters;
    auto shares = shares_of(origin);
    vectors_.push_back({std::move(displacement), std::move(origin), std::move(shares)});
  }
}

}  // namespace breccia::quasistatic
