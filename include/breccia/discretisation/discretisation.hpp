#pragma once

#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "breccia/discretisation/grid.hpp"
#include "breccia/discretisation/mixture.hpp"
#include "breccia/discretisation/phase.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/particle_box.hpp"

namespace breccia {

/// The phases of a particle: its own and that of its coating.
struct ParticlePhases {
  PhaseIndex phase{};
  PhaseIndex coating = no_phase;
  double coating_thickness = 0.0;  ///< thickness, outside the diameter of the particle [m]; 0 without a coating
};

/// The particles of a box with their phases and coatings: particles of any shape in the plane, balls in space.
template <int dim>
struct ParticlesInBox {
  std::conditional_t<dim == 2, ParticleBox, Microstructure<3>> box;  ///< its own coatings do not count
  PhaseIndex matrix{};
  std::vector<ParticlePhases> phases;  ///< by particle
};

/// The phases of the points of one cell, in the order of CellShape.
template <int dim>
using CellPhases = std::array<PhaseIndex, std::size_t{1} << dim>;

/// The phases of the points of many cells.
template <int dim>
using CellArray = CellPhases<dim>[];  // NOLINT(modernize-avoid-c-arrays): of any number
/// The phases of the points of many cells, in memory that may be shared.
template <int dim>
using SharedCells = std::shared_ptr<const CellArray<dim>>;

/// A microstructure on a grid: the phase of every material point. The points of a mixed cell all have the number of its
/// mixture in place of a phase. Copies share the phases of their points until one of them is changed. An object may
/// hold only some layers of the cells; other processes then hold the other layers (joined_discretisation.hpp).
template <int dim>
class Discretisation {
 public:
  static constexpr int points_per_cell = 1 << dim;

  /// Gives all points one phase. Throws InputError when the grid has no cells or no size.
  explicit Discretisation(const Grid<dim>& grid, PhaseIndex phase = 0, const CellLayers& layers = {});

  /// Takes the phases of the cells of the whole grid, in the order of the grid, in memory that may be shared. The first
  /// mixture has the number `first_mixture`. Throws InputError when the grid has no cells or no size.
  Discretisation(const Grid<dim>& grid, SharedCells<dim> cells, std::vector<Mixture> mixtures,
                 PhaseIndex first_mixture);

  [[nodiscard]] const Grid<dim>& grid() const noexcept { return grid_; }
  /// The cells that this object holds: all cells of the grid or some layers of them.
  [[nodiscard]] const IndexRange<dim>& range() const noexcept { return range_; }
  [[nodiscard]] std::size_t points() const noexcept { return cells().size() * points_per_cell; }

  /// Phases of the points of one of the cells held.
  [[nodiscard]] const CellPhases<dim>& cell(const Index<dim>& cell) const noexcept {
    return cells_.get()[index_of(cell)];
  }
  /// Phases of the points of all cells held, in the order of the grid.
  [[nodiscard]] std::span<const CellPhases<dim>> cells() const noexcept { return {cells_.get(), count_}; }

  /// Position of a point of a cell [m].
  [[nodiscard]] Vector<dim> position(const Index<dim>& cell, int point) const noexcept;

  /// Gives a phase to all points for which inside(position [m]) holds.
  template <std::predicate<const Vector<dim>&> Inside>
  void paint(Inside&& inside, PhaseIndex phase) {
    paint_range(range_, inside, phase);
  }

  /// Gives every point the phase that phase_at(its position [m]) returns.
  template <class PhaseAt>
  void label(PhaseAt&& phase_at) {
    auto* cells = own_cells();
    for_each_index(range_.begin, range_.end, [&](const Index<dim>& cell) {
      auto& phases = cells[index_of(cell)];
      for (int p = 0; p < points_per_cell; ++p) phases[static_cast<std::size_t>(p)] = phase_at(position(cell, p));
    });
  }

  /// Gives a phase to all points in a ball.
  void paint(const Ball<dim>& ball, PhaseIndex phase);

  /// Gives a phase, or a mixture, to all points of one of the cells held.
  void fill(const Index<dim>& cell, PhaseIndex phase) { own_cells()[index_of(cell)].fill(phase); }

  /// Adds a mixture and returns its number, which the points of a mixed cell have in place of the number of a phase.
  /// The numbers of the mixtures follow those of the phases, of which there are `phases`. Throws InputError when no
  /// number is left.
  PhaseIndex add_mixture(Mixture mixture, std::size_t phases);
  [[nodiscard]] const std::vector<Mixture>& mixtures() const noexcept { return mixtures_; }
  /// The number of the first mixture; no_phase if there is no mixture.
  [[nodiscard]] PhaseIndex first_mixture() const noexcept { return first_mixture_; }
  /// The mixture with this number; nullptr for the number of a phase and for no_phase.
  [[nodiscard]] const Mixture* mixture(PhaseIndex number) const noexcept {
    if (number < first_mixture_ || number >= first_mixture_ + mixtures_.size()) return nullptr;
    return &mixtures_[static_cast<std::size_t>(number - first_mixture_)];
  }

  /// The particles whose gaps calculations resolve though they may be narrower than a cell (theory, section 2); null
  /// where there are none, and after a change of any cell.
  [[nodiscard]] const std::shared_ptr<const ParticlesInBox<dim>>& particles_with_gaps() const noexcept {
    return particles_with_gaps_;
  }
  void set_particles_with_gaps(std::shared_ptr<const ParticlesInBox<dim>> particles) {
    particles_with_gaps_ = std::move(particles);
  }

  /// Number of points of each of the phases 0 .. count - 1. The points of a mixed cell count for its phases by the
  /// fractions of the mixture; the sums are exact where these fractions are multiples of 1 / mixture_steps. A mixture
  /// whose number is below `count` is counted as a phase of its own. Throws std::out_of_range for another phase; see
  /// require_phases().
  [[nodiscard]] std::vector<double> points_by_phase(std::size_t count) const;
  /// Fractions of the phases: points_by_phase() over the number of all points held [-].
  [[nodiscard]] std::vector<double> fractions(std::size_t count) const;

 private:
  template <class Inside>
  void paint_range(const IndexRange<dim>& range, Inside&& inside, PhaseIndex phase) {
    auto* cells = own_cells();
    for_each_index(range.begin, range.end, [&](const Index<dim>& cell) {
      auto& phases = cells[index_of(cell)];
      for (int p = 0; p < points_per_cell; ++p) {
        if (inside(position(cell, p))) phases[static_cast<std::size_t>(p)] = phase;
      }
    });
  }

  /// Index of a cell in the list of the cells held. Layers follow one another in the list of the grid, so that one
  /// offset is enough.
  [[nodiscard]] std::size_t index_of(const Index<dim>& cell) const noexcept {
    assert(range_.contains(cell));
    return grid_.cell_index(cell) - first_;
  }

  /// The phases of the points, to be changed: in memory that belongs to this object alone.
  [[nodiscard]] CellPhases<dim>* own_cells() {
    particles_with_gaps_.reset();
    if (own_ == nullptr || cells_.use_count() > 1) take_own_cells();
    return own_;
  }
  void take_own_cells();

  Grid<dim> grid_;
  IndexRange<dim> range_;
  std::size_t first_ = 0;  ///< index of the first cell held among all cells of the grid
  std::size_t count_ = 0;
  SharedCells<dim> cells_;
  CellPhases<dim>* own_ = nullptr;  ///< the phases in `cells_`, if their memory may be changed
  std::vector<Mixture> mixtures_;
  PhaseIndex first_mixture_ = no_phase;  ///< the number of the first mixture
  std::shared_ptr<const ParticlesInBox<dim>> particles_with_gaps_;
};

/// Throws InputError, with the name of the calculation, when a point has none of the phases 0 .. count - 1, so that it
/// has no material. Points with no_phase need no material. Instantiated for 2 and 3 dimensions.
template <int dim>
void require_phases(std::string_view calculation, const Discretisation<dim>& discretisation, std::size_t count);
/// Throws InputError, with the name of the calculation, when a point has neither one of the phases 0 .. count - 1 nor a
/// mixture of them. It serves calculations that derive the moduli of mixed cells from those of their phases.
template <int dim>
void require_phases_in_cells(std::string_view calculation, const Discretisation<dim>& discretisation,
                             std::size_t count);

extern template class Discretisation<2>;
extern template class Discretisation<3>;

/// The phases of particles that have no coatings.
[[nodiscard]] std::vector<ParticlePhases> without_coatings(std::span<const PhaseIndex> particles);

/// Discretises a microstructure on `cells` cells along each axis. Points in a particle, or in its image in a periodic
/// box, have the phase of the particle; points in its coating have the phase of the coating, and all other points that
/// of the matrix. Coatings must not overlap. Throws InputError unless `particles` holds the phases of every particle.
/// Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                                             std::span<const ParticlePhases> particles, const CellLayers& layers = {});

/// Discretises a microstructure of particles without coatings; `particles` holds the phase of each particle.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                                             std::span<const PhaseIndex> particles);

/// Discretises a microstructure of particles that all have one phase.
template <int dim>
[[nodiscard]] Discretisation<dim> discretise(const Microstructure<dim>& microstructure, int cells, PhaseIndex matrix,
                                             PhaseIndex particles);

}  // namespace breccia
