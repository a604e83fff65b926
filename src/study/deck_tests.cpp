#include <algorithm>

#include <fmt/format.h>

#include "deck_sections.hpp"

namespace breccia {

namespace {

/// Reports an element that an array has twice.
template <class T>
void refuse_repeats(const Section& section, const std::string& key, const std::vector<T>& values) {
  for (auto value = values.begin(); value != values.end(); ++value) {
    if (std::find(values.begin(), value, *value) != value) section.report(key, "the same twice");
  }
}

void read_times(const Section& section, Tests& tests) {
  const auto times = section.quantities("times", Dimension::time, Range::positive());
  if (times.empty()) return;
  if (times.size() != 2 || times[0] >= times[1]) {
    section.report("times", R"(expected two rising times, such as ["10 ns", "10 ms"])");
    return;
  }
  tests.first_time = times[0];
  tests.last_time = times[1];
}

std::vector<double> read_density_factors(const Section& section) {
  if (!section.has("density_factors")) return {};
  if (section.kind("density_factors") == Kind::text) {
    static_cast<void>(section.choice<bool>("density_factors", {{"auto", true}}));
    return {};
  }
  auto factors = section.numbers("density_factors", Range::positive());
  if (!std::ranges::is_sorted(factors, std::ranges::less_equal()))
    section.report("density_factors", "expected rising numbers");
  return factors;
}

DynamicOptions read_dynamic(const Section& section) {
  DynamicOptions options;
  if (section.has("formulation")) {
    options.formulation = section
                              .choice<Formulation>("formulation", {{"total-lagrangian", Formulation::total_lagrangian},
                                                                   {"classical", Formulation::classical}})
                              .value_or(options.formulation);
  }
  if (section.has("start")) {
    options.start = section.choice<Start>("start", {{"boundary", Start::boundary}, {"affine", Start::affine}})
                        .value_or(options.start);
  }
  options.courant = section.optional_number("courant", Range::above_and_up_to(0.0, 1.0)).value_or(options.courant);
  if (section.has("ramp")) section.refuse({"ramp_transits"}, "the ramp is given as a time already");
  options.ramp_time = section.optional_quantity("ramp", Dimension::time, Range::not_negative());
  options.ramp_transits =
      section.optional_number("ramp_transits", Range::not_negative()).value_or(options.ramp_transits);
  options.density_factors = read_density_factors(section);
  options.reduction_tolerance =
      section.optional_number("reduction_tolerance", Range::between(0.0, 1.0)).value_or(options.reduction_tolerance);
  return options;
}

}  // namespace

Tests read_tests(const Section& deck) {
  const auto section = deck.section("tests");
  Tests tests;
  if (section.has("loads")) {
    tests.loads = section.list_of_choices<Load>(
        "loads", {{"shear", Load::shear}, {"shear-xx-yy", Load::diagonal_shear}, {"bulk", Load::bulk}});
    refuse_repeats(section, "loads", tests.loads);
  }
  if (section.has("bounds")) {
    tests.bounds = section.list_of_choices<Bound>("bounds", {{"upper", Bound::upper}});
    refuse_repeats(section, "bounds", tests.bounds);
  }
  if (section.has("method")) {
    tests.method = section.choice<Method>("method", {{"dynamic", Method::dynamic}}).value_or(tests.method);
  }
  read_times(section, tests);
  const Range points{.lower = 1.0, .upper = 1000.0};
  tests.points_per_decade = static_cast<int>(section.optional_integer("points_per_decade", points).value_or(20));
  if (const auto dynamic = section.optional_section("dynamic")) tests.dynamic = read_dynamic(*dynamic);
  if (section.has("volumetric")) {
    tests.dynamic.volumetric =
        section
            .choice<Volumetric>("volumetric", {{"averaged", Volumetric::averaged}, {"standard", Volumetric::standard}})
            .value_or(tests.dynamic.volumetric);
  }
  return tests;
}

}  // namespace breccia
