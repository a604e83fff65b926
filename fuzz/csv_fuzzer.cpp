// A CSV file, and everything that is read from one: Prony series, sizes, discs, measurements, data to fit.

#include "breccia/io/csv.hpp"
#include "breccia/study/deck.hpp"
#include "breccia/study/prony_file.hpp"

#include "cli/fit_data.hpp"
#include "input_folder.hpp"
#include "refusal.hpp"
#include "study_reading.hpp"

namespace {

/// A deck that names the file as what its columns say it is.
const char* deck_for(std::string_view text) {
  const auto has = [text](std::string_view column) { return text.find(column) != std::string_view::npos; };
  if (has("x_m")) return "discs_input.toml";
  if (has("diameter_m")) return "sizes_input.toml";
  return has("relaxation_time_s") ? "prony_input.toml" : "measured_input.toml";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace breccia::fuzz;
  static const InputFolder folder;
  const auto file = folder.written("input.csv", text_of(data, size));
  allow_refusal([&] { static_cast<void>(breccia::read_csv(file, {"stage", "load", "cells"})); });
  allow_refusal([&] { static_cast<void>(breccia::read_prony_file(file)); });
  allow_refusal([&] { static_cast<void>(breccia::cli::read_fit_data(file)); });
  allow_refusal([&] { look_through(breccia::read_study(folder.path() / deck_for(text_of(data, size)))); });
  return 0;
}
