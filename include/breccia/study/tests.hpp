#pragma once

#include <array>
#include <optional>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/mixture.hpp"
#include "breccia/discretisation/volumetric.hpp"
#include "breccia/study/test_load.hpp"
#include "breccia/study/varied_material.hpp"
#include "breccia/virtual_test/dynamic_options.hpp"
#include "breccia/virtual_test/quasistatic_options.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The numerical method of a test.
enum class Method {
  quasistatic,  ///< implicit, without inertia
  dynamic       ///< explicit material point method
};

template <>
inline constexpr auto words<Method> = std::to_array<Word<Method>>({{"quasistatic", Method::quasistatic},
                                                                   {"dynamic", Method::dynamic}});

/// The numerical model of a test.
enum class Model {
  cells,  ///< cells of a grid, whose points have the phases at their positions
  films   ///< where a stage has grains that fill the box: conforming grains and thin films (theory, section 17)
};

template <>
inline constexpr auto words<Model> = std::to_array<Word<Model>>({{"cells", Model::cells}, {"films", Model::films}});

/// The variable over which a deck asks for its results, and of which messages speak. To an angular frequency omega
/// belongs the time 1/omega.
enum class Abscissa { time, frequency };

/// Settings of the model of grains and films.
struct FilmOptions {
  /// In the plane, length of the longest element along a face, over the square root of the area of the smaller of the
  /// two grains beside it [-].
  double face_share = 0.3;
  /// Number of layers of elements that resolve the binder across every film. If absent, films are thin and have one row
  /// of elements each.
  std::optional<int> layers = {};
  int divisions = 2;  ///< in space, number of elements along each edge of a grain
};

/// The virtual tests of every stage.
struct Tests {
  std::vector<TestLoad> loads{Load::shear};
  /// Whether the whole stiffness is wanted, beside `loads`; these are then the isotropic mean and bulk.
  bool whole_stiffness = false;
  std::vector<Boundary> boundaries{Boundary::displacement, Boundary::traction};
  std::vector<Method> methods{Method::quasistatic};
  Model model = Model::cells;
  FilmOptions films = {};
  Mixing mixing = Mixing::series;  ///< treatment of the cells that an interface crosses
  Volumetric volumetric = Volumetric::averaged;
  double first_time = 0.0;               ///< first time of the curves [s]
  double last_time = 0.0;                ///< last time of the curves [s]
  bool by_frequency = false;             ///< whether a deck gives frequencies, at which the dynamic moduli then are
  int points_per_decade = 20;            ///< samples per decade of the curves
  std::optional<double> accuracy = {};   ///< largest whole error that is wanted of the moduli [-]
  std::vector<double> field_times = {};  ///< rising times at which the fields of the first load are saved [s]
  bool lists_field_times = false;        ///< whether a deck lists these times; its results are the same without it
  /// Largest relative deviation that the fit of a stage's result may have if a later stage builds on it [-].
  double fit_tolerance = 0.03;
  QuasistaticOptions quasistatic = {};
  std::vector<VariedMaterial> varied = {};  ///< elastic materials over whose moduli the reduced solver samples, too
  DynamicOptions dynamic = {};

  [[nodiscard]] Abscissa abscissa() const { return by_frequency ? Abscissa::frequency : Abscissa::time; }
};

}  // namespace breccia
