#include "results/history_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/safe_name.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

constexpr auto times_dataset = "/history/time_s";
constexpr auto modulus_dataset = "/history/modulus_Pa";
constexpr auto compliance_dataset = "/history/compliance_1_per_Pa";

/// Numbers of the intervals of an outline, which have two samples each: before time zero, and after it on a linear and
/// on a logarithmic axis.
constexpr int parts_before = 30;
constexpr int parts_after = 250;
constexpr int parts_per_decade = 60;

}  // namespace

std::string history_file(std::string_view load, std::string_view boundary, int cells, std::size_t number) {
  return fmt::format("{}-{}-dynamic-{}-{}.h5", load, boundary, cells, number);
}

bool is_history(std::string_view name) {
  constexpr std::string_view method = "-dynamic-", ending = ".h5";
  const auto middle = name.find(method);
  if (middle == std::string_view::npos || !name.ends_with(ending)) return false;
  const auto test = name.substr(0, middle);
  auto numbers = name.substr(middle + method.size());
  numbers.remove_suffix(std::min(ending.size(), numbers.size()));
  const auto dash = numbers.find('-');
  if (dash == std::string_view::npos || !is_count(numbers.substr(0, dash)) || !is_count(numbers.substr(dash + 1))) {
    return false;
  }
  const auto before_boundary = test.rfind('-');
  return before_boundary != std::string_view::npos && value_named<Load>(test.substr(0, before_boundary)) &&
         value_named<Boundary>(test.substr(before_boundary + 1));
}

void write_history(const std::filesystem::path& directory, const Study& study, const Stage& stage, const TestId& test,
                   std::size_t number, const TimeDomain& domain) {
  std::vector<double> times, moduli;
  for (const auto& [time, modulus] : domain.history) {
    times.push_back(time);
    moduli.push_back(modulus);
  }
  const int cells = test.grid.cells().value();
  Hdf5Writer file(directory / history_file(name_of(test.load), name_of(test.boundary), cells, number));
  file.write(times_dataset, times);
  if (test.boundary == Boundary::traction) {
    for (auto& value : moduli) value = 1.0 / value;
    file.write(compliance_dataset, moduli);
  } else {
    file.write(modulus_dataset, moduli);
  }
  const std::vector<std::pair<std::string, Hdf5Attribute>> attributes = {
      {"deck_hash", provenance_of(study).hash},
      {"stage", stage.name},
      {"load", name_of(test.load)},
      {"boundary", name_of(test.boundary)},
      {"cells", std::int64_t{cells}},
      {"density_factor", domain.mass_scaling},
      {"time_step_s", domain.time_step},
      {"ramp_s", domain.ramp},
      {"steps", domain.steps},
      {"valid_s", std::vector<double>{domain.window.begin, domain.window.end}},
      {"active_terms", static_cast<std::int64_t>(domain.terms)},
      {"reduction_error", domain.reduction_error}};
  for (const auto& [attribute, value] : attributes) file.write_attribute("/history", attribute, value);
  file.commit();
}

void write_histories(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                     const std::vector<TestResult>& tests) {
  for (const auto& test : tests) {
    const auto* dynamic = std::get_if<DynamicRecord>(&test.record);
    if (dynamic == nullptr) continue;
    std::size_t number = 0;
    for (const auto& domain : dynamic->domains) {
      write_history(directory, study, stage, test.id, ++number, domain);
    }
  }
}

StoredHistory read_history(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  StoredHistory history = {file.attribute<std::string>("/history", "deck_hash"), file.read_numbers(times_dataset),
                           file.read_numbers(file.has(compliance_dataset) ? compliance_dataset : modulus_dataset)};
  if (history.times.size() == history.values.size()) return history;
  throw FileError(fmt::format("{}: {} times and {} values: not as `breccia run` writes it", path.string(),
                              history.times.size(), history.values.size()));
}

StoredHistory outline_of(const StoredHistory& history) {
  StoredHistory outline{.deck_hash = history.deck_hash, .times = {}, .values = {}};
  if (history.times.empty()) return outline;
  const double first = std::abs(history.times.front()), last = history.times.back();
  const auto part_of = [&](double time) {
    if (time <= 0.0) return std::pair{std::floor(parts_before * time / first), 0.0};
    return std::pair{std::floor(parts_after * time / last), std::floor(parts_per_decade * std::log10(time))};
  };
  const auto keep = [&](std::size_t i) {
    outline.times.push_back(history.times[i]);
    outline.values.push_back(history.values[i]);
  };
  for (std::size_t begin = 0; begin < history.times.size();) {
    std::size_t end = begin + 1;
    while (end < history.times.size() && part_of(history.times[end]) == part_of(history.times[begin])) ++end;
    const auto from = history.values.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto [least, most] = std::minmax_element(from, history.values.begin() + static_cast<std::ptrdiff_t>(end));
    const auto lower = static_cast<std::size_t>(least - history.values.begin());
    const auto upper = static_cast<std::size_t>(most - history.values.begin());
    keep(std::min(lower, upper));
    if (lower != upper) keep(std::max(lower, upper));
    begin = end;
  }
  return outline;
}

}  // namespace breccia
