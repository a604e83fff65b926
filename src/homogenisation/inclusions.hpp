#pragma once

#include <vector>

#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// A material in the box of a stage other than the matrix: that of a filler, or of its coating.
struct Inclusion {
  const Material* material;
  double fraction;  ///< fraction by volume [-]
  bool is_coating;
};

/// The inclusions of a stage with these statistics of its fillers: each filler, followed by its coating.
std::vector<Inclusion> inclusions_of(const Stage& stage, const std::vector<FillerStatistics>& fillers);

/// The volume fraction of all inclusions together [-].
double fraction_of(const std::vector<Inclusion>& inclusions);

/// The density of a matrix with inclusions [kg/m^3].
double density_with(const std::vector<Inclusion>& inclusions, double matrix);

/// The mean density of inclusions by volume [kg/m^3]; 0 without any.
double mean_density(const std::vector<Inclusion>& inclusions);

}  // namespace breccia
