#include "cli/fit_results.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/virtual_test/curve.hpp"

#include "cli/fit_material.hpp"
#include "cli/fit_page.hpp"
#include "deck/prony_file.hpp"
#include "io/text_file.hpp"
#include "io/whole_results.hpp"
#include "report/modulus_plot.hpp"
#include "tables/csv.hpp"

namespace breccia::cli {
namespace {

constexpr int points_per_decade = 20;

/// The name of a column of a modulus or compliance: "shear_modulus_Pa".
std::string column_of(const char* name, ModulusKind kind) {
  return fmt::format("{}{}", column_prefix(kind), name);
}

/// An empty plot with the axes for a kind of curve.
ModulusPlot empty_plot(CurveKind kind, const std::string& title) {
  ModulusPlot plot = {.title = title, .curves = {}};
  if (kind == CurveKind::creep) {
    plot.quantity = "Creep compliance";
    plot.unit = "(1/MPa)";
    plot.unit_size = 1e-6;
  } else if (kind == CurveKind::dynamic) {
    plot.quantity = "Storage and loss modulus";
    plot.abscissa = "Angular frequency / (rad/s)";
  }
  return plot;
}

void draw(ModulusPlot& plot, CurveKind kind, const ConvertedCurve& curve, ModulusKind modulus) {
  const auto letter = symbol(modulus);
  if (kind == CurveKind::dynamic) {
    plot.curves.push_back(
        {.label = fmt::format("{}'", letter), .times = curve.at, .moduli = curve.values, .colour = 0});
    plot.curves.push_back({.label = fmt::format("{}''", letter), .times = curve.at, .moduli = curve.loss, .colour = 1});
  } else {
    const auto label = fmt::format("{}(t)", kind == CurveKind::creep ? compliance_symbol(modulus) : letter);
    plot.curves.push_back({.label = label, .times = curve.at, .moduli = curve.values, .colour = 0});
  }
}

/// The data as curves of points.
struct DrawData {
  ModulusPlot& plot;
  const FitResult& result;

  void marks(const std::string& label, const std::vector<double>& at, const std::vector<double>& values,
             std::size_t colour) const {
    plot.curves.push_back(
        {.label = label, .times = at, .moduli = values, .style = PlotStyle::points, .colour = colour});
  }
  void operator()(const RelaxationData& data) const {
    marks(fmt::format("{}(t), data", symbol(result.kind)), data.times, data.moduli, 0);
  }
  void operator()(const CreepData& data) const {
    marks(fmt::format("{}(t), data", compliance_symbol(result.kind)), data.times, data.compliances, 0);
  }
  void operator()(const DynamicData& data) const {
    if (result.master_curve) {
      const auto& curve = *result.master_curve;
      dynamic(curve.frequencies, curve.storage, curve.loss);
    } else {
      const auto& sweep = data.sweeps.front();
      dynamic(sweep.frequencies, sweep.storage, sweep.loss);
    }
  }
  void dynamic(const std::vector<double>& frequencies, const std::vector<double>& storage,
               const std::vector<double>& loss) const {
    marks(fmt::format("{}', data", symbol(result.kind)), frequencies, storage, 0);
    marks(fmt::format("{}'', data", symbol(result.kind)), frequencies, loss, 1);
  }
  void operator()(const PronySeries&) const {}
};

std::vector<double> deviations(const std::vector<double>& fitted, const std::vector<double>& data) {
  std::vector<double> relative(data.size());
  std::ranges::transform(fitted, data, relative.begin(), [](double fit, double datum) { return fit / datum - 1.0; });
  return relative;
}

std::vector<double> first_half(const std::vector<double>& values) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2)};
}
std::vector<double> second_half(const std::vector<double>& values) {
  return {values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end()};
}

/// Data, fit, relative deviation of the fit from the data and standard error of the fit.
struct FitColumns {
  const FitResult& result;

  std::vector<CsvColumn> operator()(const RelaxationData& data) const {
    const auto& quality = *result.quality;
    return {{"time_s", data.times},
            {column_of("modulus_Pa", result.kind), data.moduli},
            {"fit_Pa", quality.fitted},
            {"deviation", deviations(quality.fitted, data.moduli)},
            {"standard_error", quality.standard_errors}};
  }
  std::vector<CsvColumn> operator()(const CreepData& data) const {
    const auto& quality = *result.quality;
    return {{"time_s", data.times},
            {column_of("compliance_1_per_Pa", result.kind), data.compliances},
            {"fit_1_per_Pa", quality.fitted},
            {"deviation", deviations(quality.fitted, data.compliances)},
            {"standard_error", quality.standard_errors}};
  }
  std::vector<CsvColumn> operator()(const DynamicData& data) const {
    const auto& sweep = data.sweeps.front();
    if (!result.master_curve)
      return dynamic("angular_frequency_rad_per_s", sweep.frequencies, sweep.storage, sweep.loss);
    const auto& curve = *result.master_curve;
    return dynamic("reduced_angular_frequency_rad_per_s", curve.frequencies, curve.storage, curve.loss);
  }
  std::vector<CsvColumn> operator()(const PronySeries&) const { return {}; }

 private:
  [[nodiscard]] std::vector<CsvColumn> dynamic(const std::string& name, const std::vector<double>& frequencies,
                                               const std::vector<double>& storage,
                                               const std::vector<double>& loss) const {
    const auto& quality = *result.quality;
    const auto fitted_storage = first_half(quality.fitted), fitted_loss = second_half(quality.fitted);
    return {{name, frequencies},
            {column_of("storage_modulus_Pa", result.kind), storage},
            {column_of("loss_modulus_Pa", result.kind), loss},
            {"fit_storage_Pa", fitted_storage},
            {"fit_loss_Pa", fitted_loss},
            {"storage_deviation", deviations(fitted_storage, storage)},
            {"loss_deviation", deviations(fitted_loss, loss)},
            {"storage_standard_error", first_half(quality.standard_errors)},
            {"loss_standard_error", second_half(quality.standard_errors)}};
  }
};

std::vector<CsvColumn> curve_columns(CurveKind kind, const ConvertedCurve& curve, ModulusKind modulus) {
  switch (kind) {
    case CurveKind::relaxation:
      return {{"time_s", curve.at}, {column_of("modulus_Pa", modulus), curve.values}};
    case CurveKind::creep:
      return {{"time_s", curve.at}, {column_of("compliance_1_per_Pa", modulus), curve.values}};
    case CurveKind::dynamic:
      break;
  }
  std::vector<double> loss_factors(curve.at.size());
  std::ranges::transform(curve.loss, curve.values, loss_factors.begin(), std::divides{});
  return {{"angular_frequency_rad_per_s", curve.at},
          {column_of("storage_modulus_Pa", modulus), curve.values},
          {column_of("loss_modulus_Pa", modulus), curve.loss},
          {"tan_delta", loss_factors}};
}

std::vector<CsvColumn> retardation_columns(const CreepCompliance& compliance, ModulusKind modulus) {
  std::vector<double> times, compliances;
  for (const auto& term : compliance.terms()) {
    times.push_back(term.retardation_time);
    compliances.push_back(term.compliance);
  }
  times.push_back(0.0);
  compliances.push_back(compliance.instantaneous());
  return {{"retardation_time_s", times}, {column_of("compliance_1_per_Pa", modulus), compliances}};
}

std::vector<CsvColumn> shift_columns(const FitResult& result) {
  std::vector<double> temperatures, factors, errors;
  for (const auto& factor : result.master_curve->shift_factors) {
    temperatures.push_back(factor.temperature);
    factors.push_back(factor.log10_factor);
    errors.push_back(factor.standard_error);
  }
  std::vector<CsvColumn> columns = {
      {"temperature_K", temperatures}, {"log10_shift_factor", factors}, {"standard_error", errors}};
  if (result.shift_law) {
    std::vector<double> by_law(temperatures.size());
    std::ranges::transform(temperatures, by_law.begin(), [&](double temperature) {
      return std::log10(result.shift_law->law.shift_factor(temperature));
    });
    columns.push_back({"wlf_log10_shift_factor", by_law});
  }
  return columns;
}

/// Writes files to a directory and collects their names.
class Writer {
 public:
  explicit Writer(const FitDestination& destination) : results_(destination.directory, origin_of(destination)) {}
  void table(const std::string& name, const std::vector<CsvColumn>& columns, const std::string& comment) {
    write_csv(results_.place() / name, columns, comment);
    names_.push_back(name);
  }
  void series(const std::string& name, const PronySeries& series, ModulusKind kind, const std::string& comment) {
    write_prony_file(results_.place() / name, series, kind, comment);
    names_.push_back(name);
  }
  void picture(const std::string& name, const ModulusPlot& plot) { text(name, modulus_plot(plot)); }
  void text(const std::string& name, const std::string& text) {
    write_text(results_.place() / name, text);
    names_.push_back(name);
  }
  /// Moves the files into the directory and returns their names.
  std::vector<std::string> commit() {
    results_.commit();
    return std::move(names_);
  }

 private:
  static ResultsOrigin origin_of(const FitDestination& destination) {
    const auto& [directory, source, options, overwrite] = destination;
    const std::vector<std::string> files = {"prony.csv",      "retardation.csv", "fit.csv",           "relaxation.csv",
                                            "creep.csv",      "dynamic.csv",     "shift_factors.csv", "fit.svg",
                                            "relaxation.svg", "creep.svg",       "dynamic.svg",       "report.html",
                                            "material.toml"};
    refuse_to_replace(directory, files, {&source, 1});
    return {.command = "fit",
            .source = options.empty() ? source.string() : fmt::format("{} ({})", source.string(), options),
            .identity = content_hash(fmt::format("{}\n{}", content_hash(read_text(source)), options)),
            .files = files,
            .overwrite = overwrite};
  }

  WholeResults results_;
  std::vector<std::string> names_;
};

}  // namespace

std::string word_for(CurveKind kind) {
  switch (kind) {
    case CurveKind::relaxation:
      return "relaxation";
    case CurveKind::creep:
      return "creep";
    case CurveKind::dynamic:
      return "dynamic";
  }
  return {};
}

std::string_view compliance_symbol(ModulusKind kind) {
  if (kind == ModulusKind::young) return "D";
  return kind == ModulusKind::bulk ? "B" : "J";
}

ConvertedCurve converted(const FitResult& result, CurveKind kind, int per_decade) {
  ConvertedCurve curve;
  if (kind == CurveKind::dynamic) {
    curve.at = logarithmic_times({1.0 / result.reach.end, 1.0 / result.reach.begin}, per_decade);
    for (const double omega : curve.at) {
      const auto modulus = result.modulus.complex_modulus(omega);
      curve.values.push_back(modulus.real());
      curve.loss.push_back(modulus.imag());
    }
  } else {
    curve.at = logarithmic_times(result.reach, per_decade);
    for (const double t : curve.at) {
      curve.values.push_back(kind == CurveKind::creep ? result.compliance.at(t) : result.modulus.at(t));
    }
  }
  return curve;
}

std::vector<std::string> write_fit(const FitDestination& destination, const FitData& data, const FitResult& result,
                                   CurveKind kind) {
  Writer writer(destination);
  const auto& source = destination.source;
  const auto title = source.filename().string();
  auto origin = fmt::format("From {} by breccia {}.", title, BRECCIA_VERSION);
  if (result.master_curve) origin += fmt::format(" At {:.6g} K.", result.master_curve->reference_temperature);
  const auto reach = fmt::format("The data reach from {:.3g} to {:.3g} s.", result.reach.begin, result.reach.end);

  writer.series("prony.csv", result.modulus, result.kind,
                fmt::format("Prony series of {}. {}\n{}",
                            result.kind == ModulusKind::unspecified ? "a modulus of unknown kind" : name(result.kind),
                            origin, reach));
  if (result.measured == CurveKind::creep || kind == CurveKind::creep) {
    writer.table("retardation.csv", retardation_columns(result.compliance, result.kind),
                 fmt::format("Retardation spectrum; time 0: the instantaneous compliance. {}\n{}\n"
                             "Fluidity [1/(Pa s)]: {}",
                             origin, reach, result.compliance.fluidity()));
  }
  if (result.quality) {
    writer.table("fit.csv", std::visit(FitColumns{result}, data),
                 fmt::format("Data and fit; deviations and standard errors are relative. {}", origin));
  }
  const auto curve = converted(result, kind, points_per_decade);
  writer.table(word_for(kind) + ".csv", curve_columns(kind, curve, result.kind), fmt::format("{} {}", origin, reach));
  if (result.master_curve) {
    writer.table("shift_factors.csv", shift_columns(result), fmt::format("Shift factors a_T. {}", origin));
  }

  if (result.quality) {
    auto plot = empty_plot(result.measured, title);
    std::visit(DrawData{plot, result}, data);
    draw(plot, result.measured, converted(result, result.measured, points_per_decade), result.kind);
    writer.picture("fit.svg", plot);
  }
  if (!result.quality || kind != result.measured) {
    auto plot = empty_plot(kind, title);
    draw(plot, kind, curve, result.kind);
    writer.picture(word_for(kind) + ".svg", plot);
  }
  writer.text("material.toml", material_file(result, title));
  writer.text("report.html", fit_report(title, data, result));
  return writer.commit();
}

}  // namespace breccia::cli
