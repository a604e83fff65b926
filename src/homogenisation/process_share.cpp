#include "breccia/homogenisation/process_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "breccia/discretisation/phase.hpp"
#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/quasistatic_time.hpp"
#include "breccia/quasistatic/substructure_side.hpp"

namespace breccia {
namespace {

/// How much faster several processes are with sparse factors: 1.45 times with two, and no more than twice with sixteen.
double speed_of_factors(int processes) {
  constexpr double exponent = 0.53, fastest = 2.0;
  return std::min(fastest, std::pow(processes, exponent));
}

/// Entries of the factors of the coarse problem of substructures, of HB-1 with 1000 and 2000 cells a side.
double entries_of_coarse_factors(double unknowns, int side) {
  constexpr double of_block = 4.0, slope = 12.2, offset = 105.0, fewest = 10.0;
  const double coarse = of_block * unknowns / (2.0 * side * side);
  return coarse * std::max(fewest, slope * std::log2(std::max(1.0, coarse)) - offset);
}

/// Work on substructures of a side over that on those of eight cells a side, measured with 600 cells a side.
double work_on_substructures(int side) {
  constexpr double slope = 0.062, curvature = 0.0036;
  const double more = side - 8.0;
  return 1.0 + more * (slope + curvature * more);
}

/// Seconds on substructures: the work on them is shared, that on the coarse problem hardly.
double seconds_on_substructures(double alone, double unknowns, int processes) {
  // Share of the coarse problem in the time of one process with 2000 cells a side.
  constexpr double coarse_share = 0.18, measured_unknowns = 8e6;
  constexpr int measured_side = 8;
  const double entries_each = entries_of_coarse_factors(unknowns, measured_side) / unknowns;
  const double measured_each = entries_of_coarse_factors(measured_unknowns, measured_side) / measured_unknowns;
  const double coarse = alone * std::min(0.5, coarse_share * entries_each / measured_each);
  if (processes == 1) return alone;
  const int side = substructure_side(processes);
  const double smaller = entries_of_coarse_factors(unknowns, side) / entries_of_coarse_factors(unknowns, measured_side);
  return (alone - coarse) * work_on_substructures(side) / processes + coarse * smaller / speed_of_factors(processes);
}

/// Memory of the phases of all points [B], which a machine has once.
double labels_of(int dimensions, int cells) {
  return std::pow(2.0 * cells, dimensions) * sizeof(PhaseIndex);
}

}  // namespace

ProcessShare quasistatic_share(const Study& study, const Stage& stage, Boundary boundary, int cells, int processes) {
  const double unknowns = quasistatic_unknowns(stage, cells);
  const double bytes = quasistatic_memory(study, stage, cells);
  const double alone = quasistatic_time(study, stage, boundary, cells);
  const double labels = std::min(bytes, labels_of(stage.dimensions(), cells));
  const double memory = (bytes - labels) / processes;
  const bool is_direct =
      study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), stage.dimensions());
  if (is_direct) return {memory, alone / speed_of_factors(processes), labels};
  if (stage.dimensions() == 2) return {memory, seconds_on_substructures(alone, unknowns, processes), labels};
  return {memory, alone / processes, labels};
}

ProcessShare film_share(const Study& study, const Stage& stage, const FilmedGrains& grains, int processes) {
  // Of 10 000 grains the factors take so much of the memory and of the time; all else is on the first process, or on
  // each.
  constexpr double share_of_memory = 0.6, share_of_time = 0.65;
  const double bytes = film_memory(study, stage, grains), seconds = film_time(study, stage, grains);
  return {bytes * (1.0 - share_of_memory + share_of_memory / processes),
          seconds * (1.0 - share_of_time + share_of_time / speed_of_factors(processes))};
}

ProcessShare dynamic_share(int dimensions, int cells, double bytes, double seconds, int processes) {
  const double labels = std::min(bytes, labels_of(dimensions, cells));
  // Each process has one layer of nodes more than of cells, with displacement, increment and step over mass.
  const double layer = std::pow(cells + 1.0, dimensions - 1) * (2.0 * dimensions + 1.0) * sizeof(double);
  const double of_each = std::min(bytes - labels, layer);
  return {of_each + (bytes - labels - of_each) / processes, seconds / processes, labels};
}

ProcessShare classical_share(int dimensions, int cells, double bytes, double seconds) {
  const double labels = std::min(bytes, labels_of(dimensions, cells));
  return {bytes - labels, seconds, labels};
}

}  // namespace breccia
