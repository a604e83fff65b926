#pragma once

#include <complex>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "breccia/homogenisation/new_materials.hpp"
#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/viscoelasticity/carson_moduli.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// A modulus of a stage at one Laplace variable [Pa], and its derivatives [-] with respect to the Carson moduli of the
/// materials that vary, by the names of these materials. They are real where the variable and the moduli are.
struct ModulusAndGradient {
  std::complex<double> modulus = 0.0;
  std::map<std::string, ComplexModuli> gradient = {};
};

/// Computes the stages of a solved study with other materials, at another temperature or at other times, in
/// milliseconds, from their reduced responses. A responder is immutable: at(), with(), within(), chain_of() and alone()
/// return a new one.
class Responder {
 public:
  /// Takes stages with the materials of their study. `materials` lists all materials of the study, as far as they are
  /// known, with the laws of their temperature shifts. Throws InputError where the stages belong to several studies,
  /// one is given twice, or stages build on each other in a circle.
  explicit Responder(std::vector<StageResponses> stages, std::vector<ShiftedMaterial> materials = {});

  /// A responder whose varying materials are at another temperature [K], at which nothing was measured. An elastic
  /// matrix does not change; the results then have a warning. Throws InputError where a material that relaxes has no
  /// shift law, or that law does not reach the temperature.
  [[nodiscard]] Responder at(double temperature) const;
  /// A responder with new materials in place of those that they name. Throws InputError, with one line for each
  /// mistake: a name that no varying material or phase has, a phase made up of several materials, a material that is
  /// replaced twice, a stage without the stage that it builds on; NotVaried where a material is elastic and was not
  /// sampled.
  [[nodiscard]] Responder with(const std::vector<NewMaterial>& materials) const;
  /// A responder with other first and last times of the curves [s].
  [[nodiscard]] Responder within(const TimeWindow& times) const;
  /// A responder whose results are over time or over frequency, as those of the study are by default.
  [[nodiscard]] Responder over(Abscissa abscissa) const;
  /// A responder with one stage and the stages that it builds on. Throws InputError if there is no such stage.
  [[nodiscard]] Responder chain_of(const std::string& stage) const;
  /// A responder with one stage, without the stages that it builds on; its matrix has to be given by with(). Throws
  /// InputError if there is no such stage.
  [[nodiscard]] Responder alone(const std::string& stage) const;

  /// Computes the results of the stages, in the order in which they build on each other: the matrix of a later stage is
  /// the new result of the stage before it. Each result has the warnings of the run, those about its bounds among
  /// them, except the warnings about the varying materials; and new warnings about its present materials and bounds.
  /// Throws NotCovered, with the times that are covered, if a material leaves the sampled range; InputError if a stage
  /// lacks its matrix.
  [[nodiscard]] std::vector<StageResult> respond() const;

  /// The Carson modulus of a stage at a Laplace variable s [1/s] away from the negative real axis, by the
  /// correspondence principle, on the finest grid; at s = i omega it is the complex modulus. Under the load `isotropic`
  /// it is the mean of all shears, under `bulk` K, in plane strain K + G/3. Throws InputError if there is no such test.
  [[nodiscard]] ModulusAndGradient modulus_and_gradient(const std::string& stage, TestLoad load, Boundary boundary,
                                                        std::complex<double> laplace_variable) const;
  /// The modulus of a stage whose varying materials have these moduli [Pa], which are given by the names of the
  /// materials.
  [[nodiscard]] ModulusAndGradient modulus_and_gradient(const std::string& stage, TestLoad load, Boundary boundary,
                                                        const std::map<std::string, ComplexModuli>& moduli) const;

  /// The stages with their present materials and times. Materials have the names that they have in the study.
  [[nodiscard]] const std::vector<StageResponses>& stages() const noexcept { return stages_; }
  /// The materials of the study, with new materials under the names of those that they replace.
  [[nodiscard]] const std::vector<ShiftedMaterial>& materials() const noexcept { return materials_; }
  /// The names under which results show the varying materials, such as "binder at 40 degC", each once, in the
  /// alphabetical order of the names in the study.
  [[nodiscard]] std::vector<std::string> shown_names() const;

 private:
  /// The name under which results show a material: its own, and the temperature to which it was moved.
  struct ShownName {
    std::string material, temperature = {};

    [[nodiscard]] std::string text() const { return material + temperature; }
  };

  void replace(const std::string& name, ShiftedMaterial material, ShownName shown);
  [[nodiscard]] const StageResponses& stage_named(const std::string& stage) const;
  [[nodiscard]] std::vector<StageResponses> stages_with_shown_names() const;
  void add_warnings(std::vector<StageResult>& results) const;

  std::vector<StageResponses> stages_;
  std::vector<ShiftedMaterial> materials_;
  std::map<std::string, ShownName> shown_ = {};  ///< shown names of replaced materials, by their names in the study
  std::set<std::string> unshifted_ = {};         ///< elastic materials that were requested at another temperature
};

/// The responder of a study from its result. Throws InputError where the result is that of another study.
Responder responder_of(const Study& study, const StudyResult& result);

}  // namespace breccia
