#include "cli/fit_page.hpp"

#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "cli/fit_law.hpp"
#include "page/page.hpp"

namespace breccia::cli {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PronySeries& series) {
  Json terms = Json::array();
  for (const auto& term : series.terms()) {
    terms.push_back({{"relaxation_time_s", term.relaxation_time}, {"modulus_Pa", term.modulus}});
  }
  return {{"equilibrium_Pa", series.equilibrium()}, {"terms", std::move(terms)}};
}

Json json_of(const WilliamsLandelFerryFit& fit) {
  return {{"c1", fit.law.c1},
          {"c1_error", fit.c1_error},
          {"c2_K", fit.law.c2},
          {"c2_error_K", fit.c2_error},
          {"reference_K", fit.law.reference_temperature},
          {"worst_deviation", fit.worst_deviation},
          {"worst_at_K", fit.worst_at}};
}

Json json_of(const LawFit& fit) {
  Json parameters = Json::array();
  for (const auto& [key, value, note] : parameters_in_words(fit)) parameters.push_back({key, value, note});
  return {{"name", name_of(fit.form)}, {"deck", law_for_deck(fit)}, {"parameters", std::move(parameters)}};
}

/// A number, or null for a temperature that is not known.
Json finite(double number) {
  return std::isfinite(number) && number > 0.0 ? Json(number) : Json();
}

/// The data in the form that the page reads: `samples` over time with the fit, or `sweeps` over the frequency.
struct PageOfData {
  const FitResult& result;

  [[nodiscard]] Json samples(const std::vector<double>& times, const std::vector<double>& values) const {
    return {{"samples", {{"time_s", times}, {"value", values}, {"fitted", result.quality->fitted}}}};
  }
  Json operator()(const RelaxationData& data) const { return samples(data.times, data.moduli); }
  Json operator()(const CreepData& data) const { return samples(data.times, data.compliances); }
  Json operator()(const DynamicData& data) const {
    Json sweeps = Json::array();
    for (std::size_t i = 0; i < data.sweeps.size(); ++i) {
      const auto& [temperature, frequencies, storage, loss] = data.sweeps[i];
      Json sweep = {{"temperature_K", finite(temperature)},
                    {"angular_frequency_rad_per_s", frequencies},
                    {"storage_Pa", storage},
                    {"loss_Pa", loss},
                    {"log10_shift_factor", 0.0},
                    {"standard_error", 0.0}};
      if (result.master_curve) {
        const auto& factor = result.master_curve->shift_factors[i];
        sweep["log10_shift_factor"] = factor.log10_factor;
        sweep["standard_error"] = factor.standard_error;
      }
      sweeps.push_back(std::move(sweep));
    }
    return {{"sweeps", std::move(sweeps)}};
  }
  Json operator()(const PronySeries&) const { return Json::object(); }
};

}  // namespace

std::string fit_report(const std::string& source, const FitData& data, const FitResult& result) {
  Json fit = {{"source", source},
              {"version", BRECCIA_VERSION},
              {"kind", name(result.kind)},
              {"symbol", symbol(result.kind)},
              {"compliance_symbol", compliance_symbol(result.kind)},
              {"measured", word_for(result.measured)},
              {"times_s", {result.reach.begin, result.reach.end}},
              {"series", json_of(result.modulus)}};
  if (result.quality) {
    fit["quality"] = {{"median", result.quality->median_error},
                      {"worst", result.quality->worst_error},
                      {"worst_at", result.quality->worst_at}};
  }
  if (result.master_curve) fit["reference_K"] = result.master_curve->reference_temperature;
  if (result.shift_law) fit["law"] = json_of(*result.shift_law);
  if (result.law) fit["modulus_law"] = json_of(*result.law);
  Json page = std::visit(PageOfData{result}, data);
  page["fit"] = std::move(fit);
  return fit_page(source, page.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace breccia::cli
