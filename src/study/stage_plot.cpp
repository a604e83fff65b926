#include "stage_plot.hpp"

#include <string>

#include <fmt/format.h>

#include "breccia/io/text_file.hpp"
#include "breccia/report/modulus_plot.hpp"

namespace breccia {
namespace {

/// "1030", not "1.03e+03".
std::string three_digits(double value) {
  return fmt::format("{:g}", std::stod(fmt::format("{:.3g}", value)));
}

/// Places in the palette: blue, red and green for the boundaries, others for the second shear test, black for what was
/// measured.
std::size_t colour_of(Boundary boundary, Load load) {
  return static_cast<std::size_t>(boundary) + (load == Load::diagonal_shear ? 3U : 0U);
}
constexpr std::size_t colour_of_measurements = 6;

PlotCurve plot_curve(std::string label, const Curve& modulus) {
  PlotCurve curve{.label = std::move(label)};
  for (const auto& sample : modulus) {
    curve.times.push_back(sample.time);
    curve.moduli.push_back(sample.modulus);
  }
  return curve;
}

std::string label_of(const Study& study, const TestResult& test) {
  auto label = bound_of(test.boundary);
  if (test.load == Load::diagonal_shear) label += ", xx-yy";
  if (study.tests.methods.size() > 1) label += ", " + name_of(test.method);
  return label;
}

/// Those of a stage that a test found, of several grids what they tell together, in a kind of load.
template <class Shown>
ModulusPlot plot_of(const Study& study, const Stage& stage, const StageResult& result, const Shown& shown) {
  ModulusPlot plot;
  plot.title = fmt::format("{}: {}", study.title, stage.name);
  bool has_windows = false;
  for (const auto& test : result.tests) {
    const auto* dynamic = std::get_if<DynamicTestResult>(&test.record);
    if (!shown(test)) continue;
    if (dynamic != nullptr && !has_windows) {
      has_windows = true;
      for (const auto& domain : dynamic->domains) {
        plot.windows.push_back(
            {fmt::format("density x {}", three_digits(domain.density_factor)), domain.window.begin, domain.window.end});
      }
    }
    if (!stage.coarser_cells.empty() && test.cells != 0) continue;
    auto curve = plot_curve(label_of(study, test), test.modulus);
    curve.colour = colour_of(test.boundary, test.load);
    if (dynamic != nullptr && study.tests.methods.size() > 1) curve.style = PlotStyle::dashed;
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

void write_plots(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                 const StageResult& result, const std::vector<ReferenceCurve>& references) {
  if (why_no_plots()) return;
  auto shear = plot_of(study, stage, result, [](const TestResult& test) { return test.load != Load::bulk; });
  if (!shear.curves.empty()) {
    for (const auto& [label, modulus, boundary] : references) {
      auto& curve = shear.curves.emplace_back(plot_curve(label, modulus));
      curve.colour = boundary ? colour_of(*boundary, Load::shear) : colour_of_measurements;
      if (boundary) curve.style = PlotStyle::dotted;
    }
    shear.quantity = "Relaxation modulus G(t)";
    write_text(directory / "modulus.svg", modulus_plot(shear));
  }
  auto bulk = plot_of(study, stage, result, [](const TestResult& test) { return test.load == Load::bulk; });
  if (bulk.curves.empty()) return;
  bulk.quantity = "Plane-strain bulk modulus K(t) + G(t)/3";
  write_text(directory / "bulk_modulus.svg", modulus_plot(bulk));
}

}  // namespace breccia
