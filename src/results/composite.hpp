#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "homogenisation/whole_filler.hpp"

namespace breccia {

/// Which of the results of a study are meant. What is not chosen is taken where there is no choice: the last stage that
/// was tested, the only boundary condition, the shear under the load `shear` or else the only one.
struct CompositeChoice {
  std::string stage = {};  ///< empty: the last one
  std::optional<Boundary> boundary = {};
  std::optional<Load> shear_load = {};
};

/// The moduli of a composite.
struct Composite {
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

/// "displacement boundary (upper bound)", "periodic boundary".
std::string boundary_in_words(Boundary boundary);

/// What a stage is made of.
struct StageContent {
  std::string name;
  std::string matrix;  ///< an earlier stage or a material
  int dimensions = 2;
  std::vector<FillerShare> shares = {};  ///< of the fillers and coatings, with those of the stages in its matrix
};

/// What is known of a study beside its moduli.
struct StudyContent {
  std::string title;
  TimeWindow times = {};  ///< [s]
  std::vector<StageContent> stages = {};
  std::vector<ShiftedMaterial> materials = {};
};

/// The content of a study, from its result with the microstructures.
StudyContent study_content(const Study& study, const StudyResult& result);

/// The relaxation modulus of a stage under one load and boundary condition.
struct StageSeries {
  std::string stage;
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  PronySeries series = {};
};

/// Of each load and boundary condition of a stage the series of the preferred test (is_preferred).
std::vector<StageSeries> series_of(const StageFindings& stage);

/// The composite that a choice among the series of a study means. Throws InputError with every mistake in the choice,
/// with what there is to choose from; each line begins with `place`, the name of the results. Throws FileError where
/// the content lacks a stage or a material.
Composite composite_of(const StudyContent& content, const std::vector<StageSeries>& series,
                       const CompositeChoice& choice, const std::string& place);

}  // namespace breccia
