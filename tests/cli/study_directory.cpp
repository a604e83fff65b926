#include "study_directory.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "tables/csv.hpp"

namespace breccia::test {

namespace fs = std::filesystem;

std::vector<std::string> StudyDirectory::arguments(const std::string& command, const std::vector<std::string>& more) {
  std::vector<std::string> all{command, "deck.toml"};
  if (command != "check") all.insert(all.end(), {"--out", "out", "--threads", "1"});
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Outcome StudyDirectory::breccia(const std::string& command, const std::vector<std::string>& more) const {
  return run_breccia(path(), arguments(command, more));
}

std::vector<std::string> StudyDirectory::results() const {
  std::vector<std::string> names;
  if (!fs::exists(path() / "out")) return names;
  for (const auto& entry : fs::recursive_directory_iterator(path() / "out")) {
    if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), path() / "out").string());
  }
  std::ranges::sort(names);
  return names;
}

namespace {

/// The samples of a table in whose rows the columns have these texts.
Curve read_rows(const fs::path& curves, const std::map<std::string, std::string>& texts) {
  const auto table = read_csv(curves, {"stage", "load", "boundary", "method", "cells"});
  Curve curve;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto has = [&](const auto& text) { return table.text(text.first)[row] == text.second; };
    if (!std::ranges::all_of(texts, has)) continue;
    curve.push_back({table.numbers("time_s")[row], table.numbers("modulus_Pa")[row]});
  }
  return curve;
}

}  // namespace

Curve read_curve(const fs::path& curves, const std::string& stage, const std::string& load) {
  return read_rows(curves, {{"stage", stage}, {"load", load}});
}

Curve read_curve(const fs::path& curves, const std::string& stage, const std::string& load, const std::string& method) {
  return read_rows(curves, {{"stage", stage}, {"load", load}, {"method", method}});
}

double modulus_at(const Curve& curve, double time) {
  const auto right = std::ranges::lower_bound(curve, time * (1.0 - 1e-9), {}, &Sample::time);
  const bool is_sample = std::abs(right->time / time - 1.0) < 1e-9;
  if (is_sample) return right->modulus;
  const auto left = right - 1;
  const double share = (time - left->time) / (right->time - left->time);
  return left->modulus * std::pow(right->modulus / left->modulus, share);
}

}  // namespace breccia::test
