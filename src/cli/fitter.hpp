#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/law_fit.hpp"

#include "cli/fit_results.hpp"
#include "deck/fit_data.hpp"

namespace breccia::cli {

/// What a user chooses of a fit; texts are empty where nothing is chosen.
struct FitChoices {
  std::filesystem::path file;  ///< of the data, for messages
  double times_per_decade = FitOptions{}.times_per_decade;
  std::string ramp;
  std::string reference_temperature;
  std::string law;                ///< in the words of decks; empty: a spectrum
  std::vector<std::string> kept;  ///< parameters of the law that are given, KEY=VALUE
};

/// Fits data of each kind by a spectrum or a law.
class Fitter {
 public:
  /// Throws InputError for choices that are invalid, whatever the data.
  explicit Fitter(FitChoices choices);

  // Throw InputError where the data and the choices do not suit each other, and NumericalError.
  FitResult operator()(const RelaxationData& data) const;
  FitResult operator()(const CreepData& data) const;
  FitResult operator()(const DynamicData& data) const;
  FitResult operator()(const PronySeries& series) const;

 private:
  /// The law that was asked for, or the spectrum that was fitted.
  [[nodiscard]] FitResult of_dynamic(RelaxationFit spectrum, const std::vector<double>& frequencies,
                                     const std::vector<double>& storage, const std::vector<double>& loss) const;
  void refuse_ramp() const;
  void refuse_reference() const;

  FitChoices choices_;
  FitOptions options_;
  std::optional<LawForm> law_;  ///< nothing: a spectrum
  GivenParameters given_;
};

}  // namespace breccia::cli
