#include "cli/assessment_page.hpp"

#include <numbers>

#include <nlohmann/json.hpp>

#include "cli/assessment_tables.hpp"
#include "cli/calibration_tables.hpp"
#include "io/display.hpp"
#include "page/page.hpp"
#include "results/assessment_files.hpp"
#include "results/curve_places.hpp"

namespace breccia::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The measured values of a relaxation modulus, G or K, as points; none of another curve.
Json measured_points(const AssessedCurve& curve, const std::vector<Observation>& measured) {
  Json points = Json::array();
  for (const auto& one : measured) {
    const bool is_of_curve = (curve.name == "G" && one.modulus == ObservedModulus::shear) ||
                             (curve.name == "K" && one.modulus == ObservedModulus::bulk);
    if (is_of_curve && one.curve == ObservedCurve::relaxation) points.push_back({{"x", one.at}, {"y", one.value}});
  }
  return points;
}

/// A curve in the units of the page: times in seconds or frequencies in hertz, moduli in pascals, phases in degrees.
Json json_of(const AssessedCurve& curve, const AssessmentPage& page) {
  const bool is_phase = curve.unit == "rad";
  const double scale = is_phase ? 180.0 / std::numbers::pi : 1.0;
  const double of_abscissa = page.abscissa == Abscissa::frequency ? 0.5 / std::numbers::pi : 1.0;
  Json x = Json::array(), median = Json::array(), lower = Json::array(), upper = Json::array();
  Json whole_lower = Json::array(), whole_upper = Json::array(), alone = Json::array(), has_shares_at = Json::array();
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    x.push_back(of_abscissa * curve.at[i]);
    median.push_back(scale * curve.median[i]);
    lower.push_back(scale * curve.of_inputs[i].lower);
    upper.push_back(scale * curve.of_inputs[i].upper);
    const auto& whole = curve.whole[i];
    whole_lower.push_back(whole ? Json(scale * whole->lower) : Json());
    has_shares_at.push_back(has_shares(curve, i));
    whole_upper.push_back(whole ? Json(scale * whole->upper) : Json());
  }
  for (Eigen::Index input = 0; input < curve.alone.rows(); ++input) {
    const Eigen::VectorXd shares = curve.alone.row(input);
    alone.push_back(std::vector<double>(shares.begin(), shares.end()));
  }
  return {{"name", curve.name},
          {"unit", is_phase ? "\u00b0" : curve.unit},
          {"x", std::move(x)},
          {"median", std::move(median)},
          {"inputs_lower", std::move(lower)},
          {"inputs_upper", std::move(upper)},
          {"whole_lower", std::move(whole_lower)},
          {"whole_upper", std::move(whole_upper)},
          {"alone", std::move(alone)},
          {"interactions", interactions_of(curve)},
          {"has_shares", std::move(has_shares_at)},
          {"measured", measured_points(curve, page.measured)},
          {"unexplained", curve.unexplained}};
}

Json json_of(const Calibration& calibration) {
  Json estimates = Json::array();
  for (const auto& one : calibration.estimates) {
    estimates.push_back({{"name", one.name},
                         {"value", number_in_words(one.value, one.unit)},
                         {"interval", number_in_words(one.interval.lower, one.unit) + " to " +
                                          number_in_words(one.interval.upper, one.unit)},
                         {"learned", one.learned},
                         {"before", in_words(one.prior, one.unit)}});
  }
  auto remarks = calibration.warnings;
  remarks.insert(remarks.end(), calibration.remarks.begin(), calibration.remarks.end());
  return {{"estimates", std::move(estimates)}, {"remarks", remarks}};
}

}  // namespace

std::string assessment_page(const AssessmentPage& page, const Assessment& assessment) {
  Json inputs = Json::array(), curves = Json::array();
  for (std::size_t i = 0; i < assessment.inputs.size(); ++i) {
    const auto& input = assessment.inputs[i];
    inputs.push_back({{"name", input.name},
                      {"short", short_name(input)},
                      {"known", in_words(input)},
                      {"is_of_box", static_cast<bool>(page.change_the_box[i])}});
  }
  for (const auto& curve : assessment.curves) {
    curves.push_back(json_of(curve, page));
    curves.back()["decades"] = decades_of(curve.at, page.abscissa);
  }
  Json content = {{"title", page.title},
                  {"version", BRECCIA_VERSION},
                  {"source", page.source},
                  {"abscissa", page.abscissa == Abscissa::time ? "time" : "frequency"},
                  {"samples", assessment.samples},
                  {"boxes", assessment.boxes},
                  {"inputs", std::move(inputs)},
                  {"curves", std::move(curves)},
                  {"warnings", assessment.warnings}};
  if (page.calibration) content["found"] = json_of(*page.calibration);
  const Json data = {{"assessment", std::move(content)}};
  return assess_page(page.title, data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace breccia::cli
