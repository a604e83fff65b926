#include "study/tests_soundness.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "study/chain.hpp"
#include "study/limits.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

constexpr auto tests_part = "tests";

bool is_rising_window(const TimeWindow& window) {
  return accepts(Range::positive(), window.begin) && accepts(Range::positive(), window.end) &&
         window.begin < window.end;
}

/// Checks a list in the tests: it must not be empty, and must not have an element twice.
template <class T>
void check_list(const std::vector<T>& values, const char* noun, StudyMistakes& mistakes) {
  if (values.empty()) mistakes.add(tests_part, fmt::format("expected a {}", noun));
  if (has_repeats(values)) mistakes.add(tests_part, fmt::format("the same {} twice", noun));
}

void check_quasistatic(const QuasistaticOptions& options, StudyMistakes& mistakes) {
  constexpr auto part = "tests, quasi-static method";
  mistakes.check_number(part, "tolerance of the sampling", options.sampling.tolerance, allowed::accuracy);
  mistakes.check_integer(part, "largest number of snapshots", options.sampling.most_snapshots, allowed::snapshots);
  mistakes.check_integer(part, "steps per decade", options.steps_per_decade, allowed::steps_per_decade);
  const auto& linear = options.linear;
  mistakes.check_number(part, "tolerance of the linear systems", linear.tolerance, allowed::accuracy);
  mistakes.check_number(part, "tolerance of the energy in three dimensions", linear.energy_tolerance,
                        allowed::accuracy);
  mistakes.check_integer(part, "threads", linear.threads, Range::not_negative());
  for (const auto unknowns : {linear.most_unknowns_direct, linear.most_unknowns_direct_in_3d}) {
    mistakes.check_number(part, "largest number of unknowns of a direct solver", static_cast<double>(unknowns),
                          Range::not_negative());
  }
}

void check_dynamic(const DynamicOptions& options, StudyMistakes& mistakes) {
  constexpr auto part = "tests, dynamic method";
  mistakes.check_number(part, "Courant number", options.courant, allowed::courant);
  mistakes.check_number(part, "transits of the strain ramp", options.ramp_transits, allowed::ramp);
  mistakes.check_number(part, "transits of the traction ramp", options.creep_ramp_transits, allowed::ramp);
  if (options.ramp_time) {
    mistakes.check_quantity(part, "time of the ramp", *options.ramp_time, allowed::ramp, Dimension::time);
  }
  for (const double factor : options.mass_scaling_factors) {
    mistakes.check_number(part, "mass scaling factor", factor, Range::positive());
  }
  if (!is_rising(options.mass_scaling_factors)) mistakes.add(part, "mass scaling factors: expected rising numbers");
  mistakes.check_number(part, "overlap", options.overlap, allowed::overlap);
  mistakes.check_number(part, "tolerance of the reduction", options.reduction_tolerance, allowed::reduction_tolerance);
}

void check_curve(const Curve& curve, const std::string& part, StudyMistakes& mistakes) {
  constexpr std::size_t fewest = 2;
  const auto has_positive = [&curve](auto member) {
    return std::ranges::all_of(curve,
                               [member](const Sample& sample) { return accepts(Range::positive(), sample.*member); });
  };
  if (curve.size() < fewest) mistakes.add(part, fmt::format("expected at least {} points of the curve", fewest));
  if (!has_positive(&Sample::time) || !std::ranges::is_sorted(curve, std::ranges::less_equal(), &Sample::time)) {
    mistakes.add(part, "expected rising positive times of the curve");
  }
  if (!has_positive(&Sample::modulus)) mistakes.add(part, "expected positive moduli of the curve");
}

void check_measurement(const Measurement& measurement, const Study& study, StudyMistakes& mistakes) {
  const auto part = "measurement " + measurement.label;
  const auto& [label, stage, modulus, times, dynamic, kind] = measurement;
  mistakes.check_name(part, label);
  if (std::ranges::find(study.stages, stage, &Stage::name) == study.stages.end()) {
    mistakes.add(part, fmt::format("there is no stage \"{}\"", stage));
  }
  if (const auto* curve = std::get_if<Curve>(&modulus)) {
    check_curve(*curve, part, mistakes);
  } else {
    mistakes.check_quantity(part, "unrelaxed modulus", std::get<PronySeries>(modulus).unrelaxed(), Range::positive(),
                            Dimension::pressure);
  }
  if (times && !is_rising_window(*times)) mistakes.add(part, "expected two rising positive times");
  if (name_of(kind).empty()) mistakes.add(part, "expected a shear, Young's or bulk modulus");
  const auto& loads = study.tests.loads;
  if (kind == ModulusKind::shear && std::ranges::find(loads, shear_of_material(study.tests)) == loads.end()) {
    mistakes.add(part, "there is no test in shear that could be compared");
  }
}

}  // namespace

void check_varied_materials(const Study& study, StudyMistakes& mistakes) {
  const auto& varied = study.tests.varied;
  for (auto one = varied.begin(); one != varied.end(); ++one) {
    const auto part = "tests, varied material " + one->name;
    mistakes.add_all(part, mistakes_of_varied(*one, study.stages));
    if (std::ranges::find(varied.begin(), one, one->name, &VariedMaterial::name) != one) {
      mistakes.add(part, "it is given twice");
    }
  }
}

void check_tests(const Tests& tests, StudyMistakes& mistakes) {
  const TimeWindow times{tests.first_time, tests.last_time};
  if (!is_rising_window(times)) {
    mistakes.add(tests_part, "expected first_time < last_time, both above zero and finite");
  } else {
    mistakes.add_all("tests, times of fields", mistakes_of_field_times(tests.field_times, times));
  }
  check_list(tests.loads, "load", mistakes);
  check_list(tests.boundaries, "boundary condition", mistakes);
  check_list(tests.methods, "method", mistakes);
  mistakes.check_integer(tests_part, "points per decade", tests.points_per_decade, allowed::points_per_decade);
  if (tests.accuracy) mistakes.check_number(tests_part, "accuracy", *tests.accuracy, allowed::fraction);
  mistakes.check_number(tests_part, "tolerance of the fit", tests.fit_tolerance, allowed::fit_tolerance);
  mistakes.check_number("tests, films", "length of the elements", tests.films.face_share, allowed::face_share);
  mistakes.check_integer("tests, films", "number of elements along an edge", tests.films.divisions, allowed::divisions);
  if (tests.films.layers) {
    mistakes.check_integer("tests, films", "number of layers", *tests.films.layers, allowed::layers);
  }
  check_quasistatic(tests.quasistatic, mistakes);
  check_dynamic(tests.dynamic, mistakes);
}

void check_measurements(const Study& study, StudyMistakes& mistakes) {
  const auto& measurements = study.measurements;
  for (auto measurement = measurements.begin(); measurement != measurements.end(); ++measurement) {
    check_measurement(*measurement, study, mistakes);
    const auto first = std::ranges::find(measurements, measurement->label, &Measurement::label);
    if (first != measurement) mistakes.add("measurement " + measurement->label, "another measurement has this name");
  }
}

}  // namespace breccia
