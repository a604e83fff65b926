// Writes results of the library as JSON to the standard output, with which the tests of the page's scripts compare: for
// some Prony series, temperature shifts, ramps, grids, reduced responses and quantities for display.

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <nlohmann/json.hpp>

#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "dynamics/dynamic_problem.hpp"
#include "io/display.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampled_moduli.hpp"
#include "virtual_test/extrapolation.hpp"
#include "viscoelasticity/binder.hpp"

namespace breccia {
namespace {

using Json = nlohmann::ordered_json;

/// The series as in study.json.
Json json_of(const PronySeries& series) {
  Json terms = Json::array();
  for (const auto& [time, modulus] : series.terms()) {
    terms.push_back({{"relaxation_time_s", time}, {"modulus_Pa", modulus}});
  }
  return {{"equilibrium_Pa", series.equilibrium()}, {"terms", std::move(terms)}};
}

const PronySeries elastic(3.6e9);
const PronySeries one_term(0.1e6, {{1e-2, 0.5e6}});
const PronySeries relaxing_bulk(1e8, {{3e-7, 2e9}, {2e-5, 1e9}});

/// Moduli of some series in time, in frequency and at Laplace variables.
Json moduli_of_series() {
  Json cases = Json::array();
  for (const auto& series : {elastic, one_term, relaxing_bulk, binder}) {
    Json relaxation = Json::array(), complex = Json::array(), carson = Json::array();
    for (const double time : {0.0, 1e-16, 3e-9, 1e-6, 4e-4, 1e-2, 0.3, 20.0, 1e4, 1e8}) {
      relaxation.push_back({time, series.at(time)});
    }
    for (const double variable : {1e-9, 2e-5, 0.7, 100.0, 3e6, 5e10, 1e15}) {
      const auto modulus = series.complex_modulus(variable);
      complex.push_back({variable, modulus.real(), modulus.imag()});
      carson.push_back({variable, carson_moduli({"", 0.0, elastic, series}, variable).shear});
    }
    cases.push_back({{"series", json_of(series)},
                     {"relaxation", std::move(relaxation)},
                     {"complex", std::move(complex)},
                     {"carson", std::move(carson)}});
  }
  return cases;
}

/// Series, the Carson moduli that belong to a window of time, and the relaxation moduli within it.
Json interconversions() {
  Json cases = Json::array();
  for (const auto& series : {elastic, one_term, relaxing_bulk, binder}) {
    const TimeWindow window = {1e-6, 1e-1};
    constexpr double margin = 30.0;
    Json carson = Json::array(), relaxation = Json::array();
    for (const double s : logarithmic_times({1.0 / (margin * window.end), margin / window.begin}, 10)) {
      carson.push_back({s, carson_moduli({"", 0.0, elastic, series}, s).shear});
    }
    for (const double time : logarithmic_times(window, 20)) relaxation.push_back({time, series.at(time)});
    cases.push_back({{"carson", std::move(carson)}, {"relaxation", std::move(relaxation)}});
  }
  return cases;
}

Json temperature_shifts() {
  Json cases = Json::array();
  for (const auto& law : {WilliamsLandelFerry{6.5, 120.0, 292.15}, WilliamsLandelFerry{17.4, 51.6, 250.0}}) {
    Json factors = Json::array();
    for (const double excess : {-40.0, -1.0, 0.0, 6.0, 60.0}) {
      const double temperature = law.reference_temperature + excess;
      const double factor = law.shift_factor(temperature);
      factors.push_back(
          {{"temperature_K", temperature}, {"factor", factor}, {"binder", binder.shifted(factor).at(1e-3)}});
    }
    cases.push_back(
        {{"law", {{"c1", law.c1}, {"c2_K", law.c2}, {"reference_K", law.reference_temperature}}}, {"at", factors}});
  }
  const ShiftTable table({240.0, 280.0, 300.0, 350.0}, {6.0, 1.5, 0.0, -2.0}, 290.0);
  Json factors = Json::array();
  for (const double temperature : {240.0, 251.0, 280.0, 290.0, 349.0, 350.0}) {
    const double factor = table.shift_factor(temperature);
    factors.push_back(
        {{"temperature_K", temperature}, {"factor", factor}, {"binder", binder.shifted(factor).at(1e-3)}});
  }
  cases.push_back({{"law", {{"temperatures_K", table.temperatures()}, {"log10_shift_factors", table.log10_factors()}}},
                   {"at", factors}});
  return {{"binder", json_of(binder)}, {"laws", std::move(cases)}};
}

Json ramps() {
  Json cases = Json::array();
  for (const double duration : {0.0, 1e-9, 3.7e-5}) {
    const StrainRamp ramp(duration);
    for (const double share : {-0.6, -0.5, -0.4999, -0.37, -0.21, -0.01, 0.0, 0.08, 0.25, 0.49, 0.5, 0.7}) {
      cases.push_back({{"ramp", duration}, {"time", share * duration}, {"share", ramp.at(share * duration)}});
    }
  }
  return cases;
}

/// Values on grids of a box with side 1, and their limit.
Json limits_of_grids() {
  Json cases = Json::array();
  const std::vector<std::vector<int>> all_cells = {{24, 48}, {24, 48, 96}, {50, 51}, {100, 250, 300}};
  for (const auto& cells : all_cells) {
    std::vector<double> sides, values;
    Json grids = Json::array();
    for (const int count : cells) {
      sides.push_back(1.0 / count);
      values.push_back(2.3e5 * (1.0 + 1.7 / count - 3.0 / (count * count)));
      grids.push_back({{"cells", count}, {"value", values.back()}});
    }
    cases.push_back({{"grids", std::move(grids)}, {"limit", extrapolate(sides, values).value}});
  }
  return cases;
}

/// The bulk modulus of a composite from its plane-strain bulk modulus K + G/3 and its shear modulus.
Json bulk_moduli() {
  Json cases = Json::array();
  const auto bulk = PronySeries::difference(relaxing_bulk, one_term.scaled(1.0 / 3.0));
  for (const double time : {0.0, 1e-6, 1e-3, 1.0}) {
    cases.push_back(
        {{"plane_strain_bulk", relaxing_bulk.at(time)}, {"shear", one_term.at(time)}, {"bulk", bulk.at(time)}});
  }
  return cases;
}

Json json_of(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (const auto& row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

/// A positive definite matrix without special structure.
Eigen::MatrixXd stiffness_part(Eigen::Index size, double seed) {
  const Eigen::MatrixXd factor = Eigen::MatrixXd::NullaryExpr(size, size, [seed](Eigen::Index i, Eigen::Index j) {
    return std::sin(seed + 3.1 * static_cast<double>(i) + 1.7 * static_cast<double>(j * j));
  });
  return factor * factor.transpose() + 0.01 * Eigen::MatrixXd::Identity(size, size);
}

/// A reduced response with a stiff filler, whose snapshots reach down to a shear modulus [Pa].
ReducedResponse response_down_to(double softest) {
  constexpr Eigen::Index size = 6;
  ReducedResponse response;
  response.constant = 1e10 * stiffness_part(size, 1.0);
  Eigen::MatrixXd bulk = stiffness_part(size, 3.0);
  // The shear modulus of the matrix alone resists the first mode: the composite relaxes with it.
  for (auto* part : {&response.constant, &bulk}) {
    part->row(0).setZero();
    part->col(0).setZero();
  }
  response.parts = matrix_parts(stiffness_part(size, 2.0), std::move(bulk));
  response.load_forces = Eigen::VectorXd::LinSpaced(size, 1.0, 2.0);
  response.snapshots = {{{{3.6e9, 2e9}}, 0.0}, {{{3.0e9, softest}}, 0.0}, {{{3.6e9, 1e6}}, 0.0}};
  return response;
}

Json snapshots_of(const ReducedResponse& response, std::size_t phase) {
  Json snapshots = Json::array();
  for (const auto& snapshot : response.snapshots) {
    const auto& [bulk, shear] = snapshot.moduli[phase];
    snapshots.push_back({{"shear_Pa", shear}, {"bulk_Pa", bulk}});
  }
  return snapshots;
}

Json json_of(const ReducedResponse& response) {
  return {{"load", "shear"},
          {"boundary", "displacement"},
          {"cells", 12},
          {"filler_Pa", json_of(response.constant)},
          {"matrix_shear", json_of(response.part(ElasticModulus::shear))},
          {"matrix_bulk", json_of(response.part(ElasticModulus::bulk))},
          {"load_forces", std::vector<double>(response.load_forces.begin(), response.load_forces.end())},
          {"snapshots", snapshots_of(response, 0)}};
}

/// The composite with elastic matrices, the sampled moduli, and G(t) with viscoelastic matrices. All softer matrices
/// are alike below 1.4e-7 of the bulk modulus, 420 Pa.
Json responses() {
  Json cases = Json::array();
  const TimeWindow window = {1e-6, 1e-1};
  for (const double softest : {1e5, 425.0, 415.0, 1.0}) {
    const auto response = response_down_to(softest);
    Json elastic_matrices = Json::array(), composites = Json::array();
    for (const Moduli& matrix : {Moduli{3.6e9, 2e9}, Moduli{3.6e9, 1e5}, Moduli{1e8, 300.0}}) {
      elastic_matrices.push_back(
          {{"shear", matrix.shear}, {"bulk", matrix.bulk}, {"modulus", response.modulus(matrix)}});
    }
    const Material with_elastic_bulk = {"", 1000.0, elastic, binder};
    for (const auto& matrix : {with_elastic_bulk, Material{"", 1000.0, relaxing_bulk, binder}}) {
      const auto modulus = relaxation_modulus(creep_compliance(response, matrix));
      Json relaxation = Json::array();
      for (const double time : logarithmic_times(window, 7)) relaxation.push_back({time, modulus.at(time)});
      composites.push_back(
          {{"shear", json_of(matrix.shear)}, {"bulk", json_of(matrix.bulk)}, {"relaxation", std::move(relaxation)}});
    }
    const auto [least, most] = coverage(response, std::array{with_elastic_bulk}, window).phases.front().sampled;
    cases.push_back({{"response", json_of(response)},
                     {"elastic", std::move(elastic_matrices)},
                     {"sampled", {{"shear", {least.shear, most.shear}}, {"bulk", {least.bulk, most.bulk}}}},
                     {"times_s", {window.begin, window.end}},
                     {"composites", std::move(composites)}});
  }
  return cases;
}

void add_part(ReducedResponse& response, PhaseModulus parameter, Eigen::MatrixXd stiffness) {
  auto& part = response.parts.emplace_back();
  part.parameter = std::move(parameter);
  part.stiffness = std::move(stiffness);
}

/// The response of the composite with an interphase whose moduli vary, too.
ReducedResponse coated_response() {
  auto response = response_down_to(1e5);
  const auto size = response.constant.rows();
  add_part(response, {"interphase", ElasticModulus::shear}, stiffness_part(size, 4.0));
  add_part(response, {"interphase", ElasticModulus::bulk}, stiffness_part(size, 5.0));
  response.residual_products = 1e-4 * stiffness_part(5 * size + 1, 6.0);
  response.residual_scale = 0.3;
  double shear = 1e7;
  for (auto& snapshot : response.snapshots) snapshot.moduli.push_back({.bulk = 2e9, .shear = shear *= 10.0});
  return response;
}

/// The composite with an interphase: moduli, error estimates, the sampled moduli of the interphase, and G(t).
Json coated_responses() {
  const auto response = coated_response();
  auto json = json_of(response);
  json["phases"] = Json::array({{{"material", "interphase"},
                                 {"shear", json_of(response.part({"interphase", ElasticModulus::shear}))},
                                 {"bulk", json_of(response.part({"interphase", ElasticModulus::bulk}))},
                                 {"snapshots", snapshots_of(response, 1)}}});
  Json upper = Json::array();
  for (Eigen::Index i = 0; i < response.residual_products.rows(); ++i) {
    const auto row = response.residual_products.row(i).tail(response.residual_products.cols() - i);
    upper.push_back(std::vector<double>(row.begin(), row.end()));
  }
  json["residual_products"] = std::move(upper);
  json["residual_scale"] = response.residual_scale;
  Json at_moduli = Json::array();
  for (const auto& [matrix, interphase] :
       {std::pair{Moduli{3.6e9, 2e9}, Moduli{2e9, 1e8}}, std::pair{Moduli{3.6e9, 1e5}, Moduli{1e9, 3e9}},
        std::pair{Moduli{3.0e9, 1e7}, Moduli{2e9, 1e6}}}) {
    const std::vector both = {matrix, interphase};
    at_moduli.push_back(
        {{"moduli",
          {{{"shear", matrix.shear}, {"bulk", matrix.bulk}}, {{"shear", interphase.shear}, {"bulk", interphase.bulk}}}},
         {"modulus", response.modulus(both)},
         {"error", response.error_estimate(both)}});
  }
  const TimeWindow window = {1e-6, 1e-1};
  const std::vector<Material> materials = {{"binder", 1000.0, elastic, binder},
                                           {"interphase", 1000.0, PronySeries(2e9), PronySeries(2e8, {{1e-3, 5e9}})}};
  const auto modulus = relaxation_modulus(creep_compliance(response, materials));
  Json relaxation = Json::array();
  for (const double time : logarithmic_times(window, 7)) relaxation.push_back({time, modulus.at(time)});
  Json series = Json::object();
  for (const auto& material : materials) {
    series[material.name] = {{"shear", json_of(material.shear)}, {"bulk", json_of(material.bulk)}};
  }
  const auto [least, most] = coverage(response, materials, window).phases.back().sampled;
  return {{"response", std::move(json)},
          {"at", std::move(at_moduli)},
          {"sampled", {{"shear", {least.shear, most.shear}}, {"bulk", {least.bulk, most.bulk}}}},
          {"times_s", {window.begin, window.end}},
          {"materials", std::move(series)},
          {"relaxation", std::move(relaxation)}};
}

/// Quantities as the command line shows them. None lies in the middle of two rounded numbers, where C++ takes the even
/// one and JavaScript the larger.
Json quantities_for_display() {
  Json lengths = Json::array(), times = Json::array(), durations = Json::array();
  for (const double value :
       {0.0, 1.5e-14, 48e-6, 999.4e-6, 999.5e-6, 999.96e-6, 6e-3, 1.0, 12345.0, -2510.0, 943.87e6, 3.6e9, 7e14}) {
    for (const int digits : {1, 2, 3, 5}) {
      lengths.push_back({{"value", value}, {"digits", digits}, {"text", display(value, "Pa", digits)}});
    }
  }
  for (const double value : {10e-9, 2.5e-3, 0.05, 1.0, 999.4, 999.6, 1e3, 12345.0}) {
    times.push_back({{"value", value}, {"text", display_time(value)}});
  }
  for (const double value : {0.81, 90.0, 119.9, 120.0, 3000.0, 7199.0, 7200.0, 100000.0, 172800.0, 1e6}) {
    durations.push_back({{"value", value}, {"text", display_duration(value, 3)}});
  }
  return {{"quantities", std::move(lengths)}, {"times", std::move(times)}, {"durations", std::move(durations)}};
}

}  // namespace
}  // namespace breccia

int main() {
  using namespace breccia;
  try {
    const Json cases = {{"series", moduli_of_series()},       {"interconversions", interconversions()},
                        {"shifts", temperature_shifts()},     {"ramps", ramps()},
                        {"limits", limits_of_grids()},        {"bulk_moduli", bulk_moduli()},
                        {"responses", responses()},           {"coated", coated_responses()},
                        {"display", quantities_for_display()}};
    std::cout << cases.dump(1) << '\n';
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
