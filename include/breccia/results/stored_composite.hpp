#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// Which of the results of a study are meant. What is not chosen is taken where there is no choice: the last stage that
/// was tested, the only boundary condition, the shear under the load `shear` or else the only one.
struct CompositeChoice {
  std::string stage = {};  ///< empty: the last one
  std::optional<Boundary> boundary = {};
  std::optional<Load> shear_load = {};
};

/// The moduli of a composite from the results of a study on the disk.
struct StoredComposite {
  std::string title;  ///< of the study
  std::string stage;
  Boundary boundary = Boundary::displacement;
  Load shear_load = Load::shear;
  int dimensions = 2;
  double density = 0.0;                     ///< of the stage with all that is in its matrix [kg/m^3]
  PronySeries shear;                        ///< G(t) [Pa]
  std::optional<PronySeries> dilatational;  ///< of the bulk test: K(t), in plane strain K(t) + G(t)/3 [Pa]
  std::optional<TemperatureShift> shift;    ///< of the binder, where nothing else of the composite relaxes
  TimeWindow times;                         ///< of the study [s]

  /// K(t) [Pa], where there was a bulk test; in plane strain a difference, whose terms may be negative.
  [[nodiscard]] std::optional<PronySeries> bulk() const;
};

/// Reads them from `prony.csv` and `study.json` of a directory of results. Throws InputError with every mistake in the
/// choice, with what there is to choose from, and where the directory has no such results; FileError when a file is not
/// as `breccia run` writes it.
StoredComposite read_stored_composite(const std::filesystem::path& directory, const CompositeChoice& choice = {});

}  // namespace breccia
