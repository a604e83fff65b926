#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/interval.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// How an assessment samples the uncertain inputs of a study.
struct AssessmentOptions {
  int samples = 1000;      ///< number of samples of all inputs
  int boxes = 0;           ///< number of boxes, where some inputs change the box; 0: as many as these inputs need
  std::uint64_t seed = 1;  ///< seed of the samples
};

/// The samples of the uncertain inputs of a study. Inputs that change the box, or whose values the responses of a box
/// do not answer, take the values of a few boxes; the others have values of their own in every sample.
struct AssessmentDesign {
  std::vector<bool> change_the_box;  ///< by input
  Eigen::MatrixXd boxes;             ///< coordinates (inputs x boxes); those of inputs that change no box are 0
  Eigen::MatrixXd coordinates;       ///< of the samples (inputs x samples)
  std::vector<std::size_t> box_of;   ///< index of the box of each sample
  bool has_all_boxes = false;        ///< whether the boxes are all combinations of choices, so that no others exist
};

/// Latin hypercubes of the boxes and of the samples; all combinations of the boxes where these inputs have few choices.
/// Throws InputError for fewer than 100 samples, and for a single box.
AssessmentDesign design_samples(const std::vector<UncertainInput>& inputs, const std::vector<bool>& change_the_box,
                                const AssessmentOptions& options);

/// A curve of a composite in every sample.
struct SampledCurve {
  std::string name = {};                             ///< "G", "K + G/3", "|G*|", "phase of G*"
  std::string unit = {};                             ///< "Pa", or "rad" of a phase
  ObservedModulus modulus = ObservedModulus::shear;  ///< G or K
  ObservedCurve curve = ObservedCurve::relaxation;  ///< relaxation modulus, or absolute value or phase of a complex one
  double share_of_shear = 0.0;                      ///< share of G in it beside K: 1/3 of K + G/3
  Boundary boundary = Boundary::periodic;
  std::vector<double> at = {};         ///< rising times [s], or angular frequencies [rad/s]
  Eigen::MatrixXd values = {};         ///< of the curve (at x samples)
  std::vector<double> reference = {};  ///< the curve with the median of each input
  /// The error of the modulus of the reference by grid, sample and solver, over it [-]; nothing where it is not known,
  /// and of a phase.
  std::vector<std::optional<double>> errors = {};
};

/// A curve of a composite with its uncertainty.
struct AssessedCurve {
  std::string name = {};
  std::string unit = {};
  ObservedCurve curve = ObservedCurve::relaxation;
  std::vector<double> at = {};
  std::vector<double> reference = {};              ///< the curve with the median of each input
  std::vector<double> median = {};                 ///< the median of the curves
  std::vector<Interval> of_inputs = {};            ///< 95 % of the curves, by the inputs alone
  std::vector<std::optional<double>> errors = {};  ///< of the model (SampledCurve)
  /// 95 % of the curves by the inputs and the errors of the model together; nothing where the latter are not known.
  std::vector<std::optional<Interval>> whole = {};
  /// Shares of the variance of the logarithm of a modulus, or of a phase (inputs x at): those that an input causes
  /// alone (first-order Sobol' indices), and those to which it contributes, alone or with others (total indices).
  Eigen::MatrixXd alone = {}, total = {};
  /// The share of the variance of the samples that the polynomials in the inputs do not predict.
  std::vector<double> unexplained = {};
};

/// Whether the shares of the inputs at a place of a curve mean something: the curves differ by more than 1 % there, and
/// polynomials predict half of their variance at least.
bool has_shares(const AssessedCurve& curve, std::size_t index);

/// The share of the variance that inputs cause together, beyond what each causes alone, at each place of a curve; 0
/// where nothing varies.
std::vector<double> interactions_of(const AssessedCurve& curve);

/// What the uncertainty of the inputs of a study makes of its results.
struct Assessment {
  std::vector<UncertainInput> inputs = {};
  std::vector<AssessedCurve> curves = {};
  std::size_t samples = 0, boxes = 0;
  std::vector<std::string> warnings = {};
};

/// Carries the uncertainty of inputs through: polynomials in the inputs that follow the samples (theory, section 20),
/// the bands of the curves and the shares of the inputs in their variance.
Assessment assess(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                  const std::vector<SampledCurve>& curves);

}  // namespace breccia
