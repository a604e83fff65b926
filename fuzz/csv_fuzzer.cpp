// A CSV file, read by every reader of such files: of Prony series, sizes, discs, measurements and data to fit.

#include "breccia/deck/read_study.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "deck/fit_data.hpp"
#include "input_folder.hpp"
#include "refusal.hpp"
#include "study_reading.hpp"
#include "tables/csv.hpp"
#include "tables/table_description.hpp"

namespace {

using namespace breccia;

bool has(std::string_view text, std::string_view column) {
  return text.find(column) != std::string_view::npos;
}

/// A deck that names the file in the place that suits its columns.
const char* deck_for(std::string_view text) {
  if (has(text, "x_m")) return "discs_input.toml";
  if (has(text, "diameter_m")) return "sizes_input.toml";
  return has(text, "relaxation_time_s") ? "prony_input.toml" : "measured_input.toml";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  static const fuzz::InputFolder folder;
  const auto text = fuzz::text_of(data, size);
  const auto file = folder.written("input.csv", text);
  fuzz::allow_refusal([&] {
    const auto table = read_measured_table(file);
    static_cast<void>(description_of(table));
    static_cast<void>(fit_data_in(table));
  });
  if (has(text, "stage")) fuzz::allow_refusal([&] { static_cast<void>(read_csv(file, {"stage", "load", "cells"})); });
  fuzz::allow_refusal([&] { fuzz::look_through(read_study(folder.path() / deck_for(text))); });
  return 0;
}
