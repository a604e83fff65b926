#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "cli/command.hpp"
#include "cli/fit_law.hpp"
#include "cli/fit_material.hpp"
#include "cli/fit_results.hpp"
#include "cli/fitter.hpp"
#include "cli/modulus_kinds.hpp"
#include "cli/quantities.hpp"
#include "deck/column_words.hpp"
#include "deck/fit_data.hpp"
#include "io/display.hpp"
#include "io/units.hpp"
#include "tables/table_description.hpp"

namespace breccia::cli {
namespace {

const std::map<std::string, CurveKind> kinds = {
    {"relaxation", CurveKind::relaxation}, {"creep", CurveKind::creep}, {"dynamic", CurveKind::dynamic}};

struct FitArguments {
  FitChoices choices;
  std::vector<std::string> columns;  ///< QUANTITY=NAME
  std::string modulus;               ///< kind of modulus; empty: from the names of the columns
  std::string to;                    ///< kind of curve to write; empty: the kind of the data
  std::filesystem::path directory;   ///< empty: results/<name of the file>-fit
  bool overwrite = false;
  bool quiet = false;
};

/// The columns that the user has chosen. Throws InputError with all choices that are invalid.
std::vector<ColumnChoice> columns_of(const FitArguments& arguments) {
  std::vector<NamedColumn> columns;
  std::vector<std::string> mistakes;
  for (const auto& text : arguments.columns) {
    const auto sign = text.find('=');
    if (sign == std::string::npos || sign + 1 == text.size()) {
      mistakes.push_back(
          fmt::format(R"(--columns: expected QUANTITY=NAME, such as storage="E1 [MPa]", got "{}")", text));
    } else {
      columns.push_back({text.substr(0, sign), text.substr(sign + 1)});
    }
  }
  std::vector<ColumnChoice> choices;
  try {
    choices = column_choices(columns, "--columns");
  } catch (const InputError& error) {
    mistakes.emplace_back(error.what());
  }
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  return choices;
}

/// A temperature [K] in the unit of the data, kelvin or else degrees Celsius.
std::string temperature_in(std::string_view unit, double temperature) {
  constexpr double zero_celsius = 273.15;
  if (unit == "K") return fmt::format("{:.6g} K", temperature);
  constexpr double rounding = 1e6;  // rounding of 32 degF
  return fmt::format("{:.6g} degC", std::round(rounding * (temperature - zero_celsius)) / rounding + 0.0);
}

std::string shifts(const FitResult& result, std::string_view unit) {
  std::string text = fmt::format("\n{:>12}  {:>12}  {:>8}\n", "temperature", "log10 a_T", "+-");
  for (const auto& [temperature, log10_factor, standard_error] : result.master_curve->shift_factors) {
    text +=
        fmt::format("{:>12}  {:>12.4f}  {:>8.4f}\n", temperature_in(unit, temperature), log10_factor, standard_error);
  }
  if (const auto& law = result.shift_law) {
    const auto reference = temperature_in(unit, law->law.reference_temperature);
    if (law->c1_error == 0.0) {
      return text + fmt::format(
                        "\nWLF: c1 = {:.4g}, c2 = {:.4g} K at {} meet both factors, as some law does for any two: take "
                        "them as a table, as below\n",
                        law->law.c1, law->law.c2, reference);
    }
    text += fmt::format(
        "\nWLF: c1 = {:.4g} +- {:.2g}, c2 = {:.4g} +- {:.2g} K at {}; log10 a_T deviates by {:.2g} at worst, at {}\n",
        law->law.c1, law->c1_error, law->law.c2, law->c2_error, reference, law->worst_deviation,
        temperature_in(unit, law->worst_at));
    if (!follows_law(result)) text += "The factors do not follow this law: take them as a table, as below\n";
  } else {
    text += "\nWLF: these shift factors do not determine a law\n";
  }
  return text;
}

std::string describe(const FitResult& result) {
  const auto& series = result.modulus;
  const auto kind = result.kind == ModulusKind::unspecified ? "" : fmt::format("{}, ", name(result.kind));
  const auto terms = result.law ? name_of(result.law->form) : display_count(series.terms().size(), "term");
  if (!result.quality) {
    return fmt::format("{}{}; {} relaxing to {}", kind, terms, pressure(series.unrelaxed()),
                       pressure(series.equilibrium()));
  }
  // Beyond the data the fit may be anything.
  const auto& [begin, end] = result.reach;
  return fmt::format("{}{}; {} at {} relaxing to {} at {}", kind, terms, display(series.at(begin), "Pa"),
                     display_time(begin), display(series.at(end), "Pa"), display_time(end));
}

/// The temperatures of the frequency sweeps in words.
std::string sweeps_in_words(const FitData& input, std::string_view unit) {
  const auto* data = std::get_if<DynamicData>(&input);
  if (data == nullptr || data->sweeps.size() == 1) return "";
  const auto from = temperature_in(unit, data->sweeps.front().temperature);
  const auto to = temperature_in(unit, data->sweeps.back().temperature);
  if (data->is_of_ramp) {
    return fmt::format(
        "\n  the temperature changes through the measurement: moduli interpolated to {} temperatures from {} to {}",
        data->sweeps.size(), from, to);
  }
  return fmt::format("\n  {} sweeps at temperatures from {} to {}", data->sweeps.size(), from, to);
}

/// A note to the user about a modulus that the file does not name as shear, Young's or bulk modulus.
std::string note_on_kind(ModulusKind kind) {
  if (kind != ModulusKind::unspecified) return "";
  return "The file does not say which modulus it has: it is taken for G; --modulus young or bulk says otherwise\n";
}

std::string note_on_deviation(const FitResult& result) {
  constexpr double much = 0.1;
  if (result.law || result.quality->median_error < much) return "";
  return "These data are not those of a linear viscoelastic solid: see \"Accuracy and limits\" in docs/fitting.md\n";
}

/// How far a spectrum, which follows any linear solid, is from the data to which a law was fitted.
std::string note_on_spectrum(const FitResult& result) {
  if (!result.spectrum_quality) return "";
  const auto& spectrum = *result.spectrum_quality;
  constexpr double several = 3.0, negligible = 0.01;
  const bool is_of_other_shape = result.quality->median_error > std::max(negligible, several * spectrum.median_error) ||
                                 result.quality->worst_error > std::max(negligible, several * spectrum.worst_error);
  return fmt::format("a spectrum deviates by {:.2g} % in the median, by {:.2g} % at worst{}\n",
                     100.0 * spectrum.median_error, 100.0 * spectrum.worst_error,
                     is_of_other_shape ? ": these data do not follow this law" : "");
}

std::string quality(const FitResult& result) {
  const auto& [median, worst, worst_at, fitted, standard_errors] = *result.quality;
  const auto where = result.measured == CurveKind::dynamic ? fmt::format("{:.4g} rad/s", worst_at) : time(worst_at);
  const double error = *std::ranges::max_element(standard_errors);
  const auto in_words = std::isnan(error) ? "unknown, for the fit has as many terms as there are data"
                                          : fmt::format("at most {:.2g} %", 100.0 * error);
  return fmt::format("deviation from the data: median {:.2g} %, worst {:.2g} % at {}; standard error of the fit: {}\n",
                     100.0 * median, 100.0 * worst, where, in_words);
}

std::string law_table(const LawFit& law) {
  auto text = fmt::format("\n{:>16}  {:>14}  {}\n", name_of(law.form), "value", "standard error");
  for (const auto& [key, value, note] : parameters_in_words(law)) {
    text += fmt::format("{:>16}  {:>14}  {}\n", key, value, note);
  }
  return text;
}

std::string dynamic_table(const ConvertedCurve& curve, std::string_view letter) {
  auto text = fmt::format("\n{:>16}  {:>14}  {:>14}  {:>10}\n", "frequency", fmt::format("{}'", letter),
                          fmt::format("{}''", letter), "tan delta");
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    text += fmt::format("{:>16}  {:>14}  {:>14}  {:>10.4g}\n", fmt::format("{:.4g} rad/s", curve.at[i]),
                        pressure(curve.values[i]), pressure(curve.loss[i]), curve.loss[i] / curve.values[i]);
  }
  return text;
}

std::string time_table(const ConvertedCurve& curve, std::string_view letter, std::string (*in_words)(double)) {
  auto text = fmt::format("\n{:>16}  {:>18}\n", "time", letter);
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    text += fmt::format("{:>16}  {:>18}\n", time(curve.at[i]), in_words(curve.values[i]));
  }
  return text;
}

/// A table of the wanted curve at whole decades.
std::string table(const FitResult& result, CurveKind kind) {
  const auto curve = converted(result, kind, 1);
  if (kind == CurveKind::dynamic) return dynamic_table(curve, symbol(result.kind));
  if (kind == CurveKind::relaxation) return time_table(curve, symbol(result.kind), pressure);
  return time_table(curve, compliance_symbol(result.kind),
                    [](double value) { return fmt::format("{:.6g} 1/Pa", value); });
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  names.reserve(words<LawForm>.size());
  for (const auto& [name, form] : words<LawForm>) names.emplace_back(name);
  return names;
}

/// The default directory for the results; a study of the same name has another one.
std::filesystem::path default_directory(const std::filesystem::path& file) {
  return std::filesystem::path("results") / (file.stem().string() + "-fit");
}

/// The options that affect the fit, in the form of the command line, without those that have their default value.
std::string options_of(const FitArguments& arguments, const FitResult& result) {
  std::vector<std::string> options;
  if (!arguments.to.empty() && kinds.at(arguments.to) != result.measured)
    options.push_back(fmt::format("--to {}", arguments.to));
  if (arguments.choices.times_per_decade != FitOptions{}.times_per_decade) {
    options.push_back(fmt::format("--times-per-decade {}", arguments.choices.times_per_decade));
  }
  for (const auto& [name, value] :
       {std::pair("--modulus", arguments.modulus), std::pair("--ramp", arguments.choices.ramp),
        std::pair("--reference-temperature", arguments.choices.reference_temperature),
        std::pair("--law", arguments.choices.law)}) {
    if (!value.empty()) options.push_back(fmt::format("{} {}", name, value));
  }
  for (const auto& choice : arguments.columns) options.push_back(fmt::format("--columns {}", choice));
  for (const auto& parameter : arguments.choices.kept) options.push_back(fmt::format("--keep {}", parameter));
  return fmt::format("{}", fmt::join(options, " "));
}

void fit(const FitArguments& arguments) {
  const auto given = arguments.modulus.empty() ? ModulusKind::unspecified : modulus_kinds.at(arguments.modulus);
  const Fitter fitter(arguments.choices);
  const auto table_of_data = read_measured_table(arguments.choices.file, columns_of(arguments));
  const auto [data, modulus_kind] = fit_data_in(table_of_data, given);
  if (!arguments.quiet) {
    const auto unit =
        table_of_data.has({Quantity::temperature}) ? table_of_data.column(Quantity::temperature).unit : "";
    fmt::print("{}{}\n\n", description_of(table_of_data), sweeps_in_words(data, unit));
    std::fflush(stdout);  // the text must appear before the fit, which may take long or fail
  }
  auto result = std::visit(fitter, data);
  result.kind = modulus_kind;
  const auto kind = arguments.to.empty() ? result.measured : kinds.at(arguments.to);
  const auto directory = arguments.directory.empty() ? default_directory(arguments.choices.file) : arguments.directory;
  const auto files = write_fit({directory, arguments.choices.file, options_of(arguments, result), arguments.overwrite},
                               data, result, kind);
  if (arguments.quiet) return;
  fmt::print("{}: {}\n", arguments.choices.file.string(), describe(result));
  if (result.quality) fmt::print("{}{}{}", quality(result), note_on_spectrum(result), note_on_deviation(result));
  fmt::print("{}", note_on_kind(modulus_kind));
  if (result.law) fmt::print("{}", law_table(*result.law));
  if (result.master_curve) {
    fmt::print("{}", shifts(result, table_of_data.column(Quantity::temperature).unit));
  }
  fmt::print("{}\n", table(result, kind));
  fmt::print("For a material of a deck:\n{}\n", material_keys(result, (directory / "").string()));
  fmt::print("Results are in {}: {}\n", directory.string(), fmt::join(files, ", "));
}

}  // namespace

void add_fit(CLI::App& application) {
  auto* command = application.add_subcommand(
      "fit", "fit a Prony series to measured data; convert between relaxation, creep and dynamic moduli");
  auto arguments = std::make_shared<FitArguments>();
  command->add_option("FILE", arguments->choices.file, "measured data or a Prony series, a table as CSV or .xlsx")
      ->required()
      ->type_name("");
  command
      ->add_option("--columns", arguments->columns,
                   "which column of the file is which, where the names of the columns do not say it: time, frequency, "
                   "temperature, storage, loss, absolute, phase, tangent, modulus or compliance, as in "
                   "storage=\"E1 [MPa]\"; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("QUANTITY=NAME");
  command->add_option("--to", arguments->to, "kind of curve to write (default: that of the data)")
      ->check(CLI::IsMember(kinds).description(""))
      ->type_name("relaxation|creep|dynamic");
  command
      ->add_option("--modulus", arguments->modulus,
                   "kind of modulus that was measured, if the names of the columns do not say it")
      ->check(CLI::IsMember(modulus_kinds).description(""))
      ->type_name("shear|young|bulk");
  auto* law = command
                  ->add_option("--law", arguments->choices.law,
                               "fit this law of few parameters in place of a spectrum, as decks take it")
                  ->transform(CLI::IsMember(law_names(), CLI::ignore_case).description(""))
                  ->type_name(fmt::format("{}", fmt::join(law_names(), "|")));
  command
      ->add_option("--keep", arguments->choices.kept,
                   "value of a parameter of the law that is not to be fitted, as in time=\"1 day\"; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->needs(law)
      ->type_name("KEY=VALUE");
  command
      ->add_option("--times-per-decade", arguments->choices.times_per_decade,
                   "relaxation times per decade that are offered to the fit (default: 10)")
      ->type_name("X")
      ->check(CLI::Range(0.5, 50.0).description(""));
  command
      ->add_option("--ramp", arguments->choices.ramp,
                   "duration of the ramp of the load, from whose beginning times are counted, as in \"1 ms\"")
      ->type_name("TIME");
  command
      ->add_option("--reference-temperature", arguments->choices.reference_temperature,
                   "reference temperature of the master curve, that of one sweep, as in \"19 degC\"")
      ->type_name("TEMPERATURE");
  command
      ->add_option("--out", arguments->directory, "directory for the results (default: results/<name of the file>-fit)")
      ->type_name("DIR");
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the fit of other data or with other options in the directory");
  command->add_flag("--quiet", arguments->quiet, "print nothing but errors");
  command->callback([arguments] { fit(*arguments); });
}

}  // namespace breccia::cli
