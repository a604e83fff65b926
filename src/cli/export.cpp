#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/results/stored_responder.hpp"

#include "cli/asked_temperature.hpp"
#include "cli/command.hpp"
#include "cli/output_file.hpp"
#include "io/collected_mistakes.hpp"
#include "io/display.hpp"
#include "io/percentage.hpp"
#include "io/text_file.hpp"
#include "io/units.hpp"
#include "results/isochronal.hpp"
#include "results/material_card.hpp"
#include "results/stored_composite.hpp"
#include "results/stored_document.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  fs::path results;
  std::string format;
  std::string stage;     ///< name of the stage; empty: the last one
  std::string boundary;  ///< boundary condition; empty: the only one
  std::string load;      ///< load; empty: the isotropic mean, shear, or the only load of shear
  std::string tolerance = "1 %";
  std::vector<std::string> times;
  std::string temperature;  ///< temperature of the moduli; empty: that of the run
  std::string bulk;         ///< bulk modulus; empty: from the bulk test
  std::string poisson;      ///< Poisson's ratio; empty: from the bulk test
  std::string units = "m-kg-s";
  std::string frequency = "1 Hz";  ///< frequency of the format `dma`
  /// Temperatures of the format `dma`; empty: those near that of the run that are covered.
  std::vector<std::string> temperatures;
  std::string step = "2 K";  ///< step between the temperatures
  fs::path output;           ///< file of the output; empty: standard output
  bool overwrite = false;
  std::vector<std::string> of_other_formats;  ///< options that were given, but that the format does not have
};

/// The names of an enumeration, for the check of an option and for its help.
template <class Enum>
std::vector<std::string> names_of_words() {
  std::vector<std::string> names;
  names.reserve(words<Enum>.size());
  for (const auto& [word, value] : words<Enum>) names.emplace_back(word);
  return names;
}

double read_share(const std::string& option, const std::string& text) {
  const auto share = parse_percentage(text);
  if (share && *share > 0.0 && *share < 1.0) return *share;
  throw InputError(
      fmt::format(R"({}: expected a share above 0 % and below 100 %, such as "1 %", got "{}")", option, text));
}

double read_poisson(const std::string& text) {
  std::size_t end = 0;
  double ratio = 1.0;
  try {
    ratio = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (!text.empty() && end == text.size() && ratio > -1.0 && ratio < 0.5) return ratio;
  throw InputError(fmt::format("--poisson: expected a number above -1 and below 0.5, got \"{}\"", text));
}

/// The name of the format that is no card: dynamic moduli against temperature.
constexpr auto isochronal_format = "dma";

std::vector<std::string> options_of_isochronal_format() {
  return {"--frequency", "--temperatures", "--step"};
}

std::vector<std::string> options_of_cards() {
  return {"--tolerance", "--times", "--temperature", "--bulk", "--poisson", "--units"};
}

struct ExportRequest {
  CompositeChoice choice;
  CardSettings settings;
  std::optional<AskedTemperature> temperature = {};  ///< temperature of a card
  double angular_frequency = 0.0;                    ///< [rad/s]
  std::optional<TemperatureRange> temperatures = {};
  double temperature_step = 0.0;  ///< [K]
};

/// The options of the format `dma`.
void read_isochronal_options(const ExportArguments& arguments, CollectedMistakes& options, ExportRequest& request) {
  options.collect([&] {
    request.angular_frequency =
        2.0 * std::numbers::pi *
        option_quantity("--frequency", arguments.frequency, Dimension::frequency, Range::positive());
  });
  options.collect([&] {
    if (arguments.temperatures.empty()) return;
    const auto temperature = [](const std::string& text) {
      return option_quantity("--temperatures", text, Dimension::temperature, Range::not_negative());
    };
    request.temperatures =
        TemperatureRange{temperature(arguments.temperatures[0]), temperature(arguments.temperatures[1])};
    if (request.temperatures->begin < request.temperatures->end) return;
    throw InputError(fmt::format("--temperatures: expected two rising temperatures, got {} and {}",
                                 arguments.temperatures[0], arguments.temperatures[1]));
  });
  options.collect([&] {
    request.temperature_step =
        option_quantity("--step", arguments.step, Dimension::temperature_difference, Range::positive());
  });
}

ExportRequest read_request(const ExportArguments& arguments) {
  ExportRequest request;
  auto& choice = request.choice;
  auto& settings = request.settings;
  choice.stage = arguments.stage;
  if (!arguments.boundary.empty()) choice.boundary = value_named<Boundary>(arguments.boundary);
  if (!arguments.load.empty()) choice.shear_load = value_named<TestLoad>(arguments.load);
  settings.format = value_named<CardFormat>(arguments.format).value_or(CardFormat::csv);
  settings.units = value_named<CardUnits>(arguments.units).value();
  CollectedMistakes options;
  options.collect([&] { settings.tolerance = read_share("--tolerance", arguments.tolerance); });
  options.collect([&] {
    if (arguments.times.empty()) return;
    const auto time = [](const std::string& text) {
      return option_quantity("--times", text, Dimension::time, Range::positive());
    };
    settings.times = TimeWindow{time(arguments.times[0]), time(arguments.times[1])};
    if (settings.times->begin < settings.times->end) return;
    throw InputError(
        fmt::format("--times: expected two rising times, got {} and {}", arguments.times[0], arguments.times[1]));
  });
  options.collect([&] {
    if (arguments.temperature.empty()) return;
    try {
      request.temperature = read_temperature(arguments.temperature);
    } catch (const InputError& error) {
      throw InputError(fmt::format("--temperature: {}", error.what()));
    }
  });
  options.collect([&] {
    if (arguments.bulk.empty()) return;
    settings.bulk = option_quantity("--bulk", arguments.bulk, Dimension::pressure, Range::positive());
  });
  options.collect([&] {
    if (!arguments.poisson.empty()) settings.poisson = read_poisson(arguments.poisson);
  });
  options.collect([&] {
    if (arguments.bulk.empty() || arguments.poisson.empty()) return;
    throw InputError("--bulk and --poisson: expected one of them");
  });
  read_isochronal_options(arguments, options, request);
  for (const auto& option : arguments.of_other_formats) {
    options.collect([&] { throw InputError(fmt::format("{}: the format {} has none", option, arguments.format)); });
  }
  options.collect([&] { refuse_existing(arguments.output, arguments.overwrite); });
  options.refuse();
  return request;
}

std::string in_words(const MaterialCard& card) {
  auto text = fmt::format("{}: G(t) within {:.2g} % by {}", card.name, 100.0 * card.shear_deviation,
                          display_count(card.shear.terms().size(), "term"));
  if (card.bulk_deviation) {
    text += fmt::format(", K(t) within {:.2g} % by {}", 100.0 * *card.bulk_deviation,
                        display_count(card.bulk.terms().size(), "term"));
  }
  return fmt::format("{}, from {} to {}", text, display_time(card.times.begin), display_time(card.times.end));
}

/// A composite, and reasons to doubt its moduli.
struct ExportedComposite {
  Composite composite;
  std::vector<std::string> warnings = {};
};

/// The composite at another temperature than that of the run, at the times of the run or at other ones, by the reduced
/// responses that the run has stored. Throws InputError where there are none, or the law of a material does not reach
/// that temperature; throws NotCovered, with the times that are covered, for times outside them.
ExportedComposite composite_at(const AskedTemperature& temperature, const std::optional<TimeWindow>& times,
                               const fs::path& results, const CompositeChoice& choice) {
  auto content = read_stored_content(results);
  content.times = times.value_or(content.times);
  const auto all_stages = read_responder(results);
  const auto asked = choice.stage.empty() ? all_stages : all_stages.chain_of(choice.stage);
  const auto responder = asked.at(temperature.kelvin).within(content.times);
  std::vector<StageSeries> series;
  std::vector<std::string> warnings;
  for (const auto& stage : responder.respond()) {
    std::ranges::move(series_of(stage), std::back_inserter(series));
    std::ranges::copy(stage.warnings, std::back_inserter(warnings));
  }
  content.title += " at " + temperature.name;
  content.materials = responder.materials();
  return {composite_of(content, series, choice, results.string()), std::move(warnings)};
}

ExportedComposite composite_for(const ExportRequest& request, const fs::path& results) {
  require_stored_study(results);
  if (request.temperature) return composite_at(*request.temperature, request.settings.times, results, request.choice);
  ExportedComposite exported{read_stored_composite(results, request.choice)};
  if (auto note = note_on_completeness(results, read_study_document(results))) {
    exported.warnings.push_back(*std::move(note));
  }
  return exported;
}

/// The exported text, and lines about it for the user.
struct ExportedText {
  std::string text;
  std::string summary;
  std::vector<std::string> warnings = {};
};

ExportedText exported(const ExportArguments& arguments) {
  const auto request = read_request(arguments);
  auto [composite, warnings] = composite_for(request, arguments.results);
  if (arguments.format == isochronal_format) {
    const auto samples =
        isochronal_curve(composite, request.angular_frequency, request.temperatures, request.temperature_step);
    return {table_of(samples, composite, request.angular_frequency),
            fmt::format("{}: {} at {}", composite.stage, display_count(samples.size(), "temperature"),
                        arguments.frequency)};
  }
  const auto card = material_card(composite, request.settings);
  std::ranges::copy(card.warnings, std::back_inserter(warnings));
  return {text_of(card, request.settings), in_words(card), std::move(warnings)};
}

void write_exported(const ExportArguments& arguments) {
  const auto [text, summary, warnings] = exported(arguments);
  for (const auto& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
  if (arguments.output.empty()) {
    fmt::print("{}", text);
    return;
  }
  write_text(arguments.output, text);
  fmt::print("{}\nThe {} is in {}\n", summary, arguments.format == isochronal_format ? "table" : "card",
             arguments.output.string());
}

}  // namespace

void add_export(CLI::App& application) {
  auto* command = application.add_subcommand(
      "export",
      "write the moduli of a composite as a material card of a finite element program, or against temperature");
  auto arguments = std::make_shared<ExportArguments>();
  auto formats = names_of_words<CardFormat>();
  formats.emplace_back(isochronal_format);
  command->add_option("DIR", arguments->results, "the results of `breccia run`")->required()->type_name("");
  command
      ->add_option(
          "--format", arguments->format,
          "the program that the card is for; csv: a table of its terms; dma: dynamic moduli against temperature")
      ->required()
      ->check(CLI::IsMember(formats).description(""))
      ->type_name(fmt::format("{}", fmt::join(formats, "|")));
  command->add_option("--stage", arguments->stage, "the stage (default: the last one)")->type_name("NAME");
  command->add_option("--boundary", arguments->boundary, "the boundary condition, if the stage has several")
      ->check(CLI::IsMember(names_of_words<Boundary>()).description(""))
      ->type_name(fmt::format("{}", fmt::join(names_of_words<Boundary>(), "|")));
  auto shear_loads = names_of_words<TestLoad>();
  std::erase(shear_loads, name_of(Load::bulk));
  command->add_option("--load", arguments->load, "the load of shear that gives G(t) (default: isotropic, else shear)")
      ->check(CLI::IsMember(names_of_words<TestLoad>()).description(""))
      ->type_name(fmt::format("{}", fmt::join(shear_loads, "|")));
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "how far G(t) and K(t) may deviate, which decides on the number of terms (default: \"1 %\")")
      ->type_name("SHARE");
  command
      ->add_option("--times", arguments->times,
                   R"(first and last time at which they are to hold, such as "1 us" "1 s" (default: those of the run))")
      ->expected(2)
      ->type_name("BEGIN END");
  command
      ->add_option("--temperature", arguments->temperature,
                   R"(of the moduli of a card, such as "60 degC" (default: that of the run))")
      ->type_name("TEMPERATURE");
  command
      ->add_option("--bulk", arguments->bulk,
                   "an elastic bulk modulus, such as \"8 GPa\", in place of that of the bulk test")
      ->type_name("MODULUS");
  command->add_option("--poisson", arguments->poisson, "a constant Poisson's ratio, in place of the bulk test")
      ->type_name("NUMBER");
  command->add_option("--units", arguments->units, "units of the card (default: m-kg-s)")
      ->check(CLI::IsMember(names_of_words<CardUnits>()).description(""))
      ->type_name(fmt::format("{}", fmt::join(names_of_words<CardUnits>(), "|")));
  command->add_option("--frequency", arguments->frequency, "of the format dma (default: \"1 Hz\")")
      ->type_name("FREQUENCY");
  command
      ->add_option(
          "--temperatures", arguments->temperatures,
          R"(first and last temperature of the format dma, such as "-40 degC" "60 degC" (default: those within 100 K of that of the run that its times cover))")
      ->expected(2)
      ->type_name("BEGIN END");
  command->add_option("--step", arguments->step, "between the temperatures (default: \"2 K\")")
      ->type_name("DIFFERENCE");
  command->add_option("--output", arguments->output, "the file (default: standard output)")->type_name("FILE");
  command->add_flag("--overwrite", arguments->overwrite, "replace that file");
  command->callback([arguments, command] {
    const bool is_card = arguments->format != isochronal_format;
    const auto others = is_card ? options_of_isochronal_format() : options_of_cards();
    for (const auto& option : others) {
      if (command->count(option) > 0) arguments->of_other_formats.push_back(option);
    }
    write_exported(*arguments);
  });
}

}  // namespace breccia::cli
