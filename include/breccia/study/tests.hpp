#pragma once

#include <array>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/virtual_test/quasistatic_test.hpp"
#include "breccia/virtual_test/virtual_test.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// How a test is computed.
enum class Method {
  quasistatic,  ///< implicit, without inertia
  dynamic       ///< explicit material point method
};

template <>
inline constexpr auto words<Method> = std::to_array<Word<Method>>({{"quasistatic", Method::quasistatic},
                                                                   {"dynamic", Method::dynamic}});

/// The virtual tests of every stage.
struct Tests {
  std::vector<Load> loads{Load::shear};
  std::vector<Boundary> boundaries{Boundary::displacement, Boundary::traction};
  std::vector<Method> methods{Method::quasistatic};
  double first_time = 0.0;  ///< [s]
  double last_time = 0.0;   ///< [s]
  int points_per_decade = 20;
  std::vector<double> field_times = {};  ///< at which the fields of the first load are left, rising [s]
  /// Largest relative deviation that the fit of a stage's result may have where a later stage builds on it [-].
  double fit_tolerance = 0.03;
  QuasistaticOptions quasistatic = {};
  DynamicOptions dynamic = {};
};

}  // namespace breccia
