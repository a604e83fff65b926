#include "page/report_tables.hpp"

#include <algorithm>
#include <cmath>

#include "page/report_data.hpp"
#include "tables/csv.hpp"

namespace breccia {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json table_for_page(const std::filesystem::path& file, const std::vector<std::string>& text_columns) {
  Json columns = Json::object();
  if (!is_there(file)) return columns;
  const auto table = read_csv(file, text_columns);
  for (const auto& name : table.names()) {
    Json& column = columns[name] = Json::array();
    if (std::ranges::find(text_columns, name) != text_columns.end()) {
      for (const auto& text : table.text(name)) column.push_back(text);
    } else {
      for (const double number : table.numbers(name)) {
        column.push_back(std::isfinite(number) ? Json(number) : Json(number > 0.0 ? "inf" : "-inf"));
      }
    }
  }
  return columns;
}

std::vector<std::string> text_columns_of_tests() {
  // Numbers that may not be known, as those of quality.csv and errors, are read as text.
  return {"measurement",
          "modulus",
          "stage",
          "load",
          "boundary",
          "method",
          "cells",
          "upper_Pa",
          "lower_Pa",
          "relative_distance",
          "grid_half_band_Pa",
          "error",
          "grid_error",
          "sample_error",
          "solver_error",
          "matrix_error",
          "error_1_per_K",
          "anisotropy",
          "bulk_modulus_error",
          "youngs_modulus_error",
          "poisson_ratio_error"};
}

}  // namespace breccia
