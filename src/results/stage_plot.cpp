#include "results/stage_plot.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "homogenisation/stage_materials.hpp"
#include "io/display.hpp"
#include "io/text_file.hpp"
#include "report/modulus_plot.hpp"
#include "study/chain.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// A relaxation modulus that is drawn for comparison with those of the tests.
struct ReferenceCurve {
  std::string label;
  Curve modulus;
  /// Boundary condition of the tests to which the curve belongs; nothing for a measured modulus.
  std::optional<Boundary> boundary;
};

/// Index in the palette: blue, red and green for the boundaries, other colours for the second shear test, black for
/// measured moduli.
std::size_t colour_of(Boundary boundary, TestLoad load) {
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
  auto label = name_of(test.id.boundary);
  if (test.id.load == Load::diagonal_shear) label += ", xx-yy";
  if (study.tests.methods.size() > 1) label += ", " + name_of(test.id.method);
  return label;
}

/// The curves of a stage that `drawn` accepts; for each load, boundary and method the curve of the preferred test. The
/// windows are those of the first dynamic test that `belongs` accepts.
template <class Belongs, class Drawn>
ModulusPlot plot_of(const Study& study, const Stage& stage, const StageResult& result, const Belongs& belongs,
                    const Drawn& drawn) {
  ModulusPlot plot;
  plot.title = fmt::format("{}: {}", study.title, stage.name);
  bool has_windows = false;
  for (const auto& test : result.tests) {
    const auto* dynamic = std::get_if<DynamicRecord>(&test.record);
    if (dynamic != nullptr && !has_windows && belongs(test)) {
      has_windows = true;
      for (const auto& domain : dynamic->domains) {
        plot.windows.push_back(
            {fmt::format("density x {}", three_digits(domain.mass_scaling)), domain.window.begin, domain.window.end});
      }
    }
    if (!belongs(test) || !drawn(test)) continue;
    if (find_preferred_test(result.tests, test.id.load, test.id.boundary, test.id.method) != &test) continue;
    auto curve = plot_curve(label_of(study, test), test.modulus);
    curve.colour = colour_of(test.id.boundary, test.id.load);
    if (test.id.method == Method::dynamic && study.tests.methods.size() > 1) curve.style = PlotStyle::dashed;
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

/// The shear moduli of the matrix of a stage, one for every boundary where it is an earlier stage, and the measured
/// ones.
std::vector<ReferenceCurve> references(const Study& study, const Stage& stage, const StudyResult& result) {
  std::vector<ReferenceCurve> curves;
  const bool is_one = std::holds_alternative<Material>(stage.matrix);
  for (const auto boundary : study.tests.boundaries) {
    const auto& matrix = matrix_of(stage.name, stage.matrix, result.stages, boundary, study.tests.methods.front());
    auto& curve = curves.emplace_back();
    curve.label = is_one ? "matrix" : fmt::format("matrix, {}", name_of(boundary));
    curve.boundary = boundary;
    for (const double time :
         logarithmic_times({study.tests.first_time, study.tests.last_time}, study.tests.points_per_decade)) {
      curve.modulus.push_back({time, matrix.shear.at(time)});
    }
    if (is_one) break;
  }
  for (const auto& measurement : study.measurements) {
    if (measurement.stage != stage.name || measurement.kind != ModulusKind::shear) continue;
    const auto known = measurement.known_within({study.tests.first_time, study.tests.last_time});
    if (!known) continue;
    auto& curve = curves.emplace_back(ReferenceCurve{"measured, " + measurement.label, {}, {}});
    for (const double time : logarithmic_times(*known, study.tests.points_per_decade)) {
      curve.modulus.push_back({time, measurement.at(time)});
    }
  }
  return curves;
}

}  // namespace

void write_plots(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                 const StudyResult& study_result) {
  const auto& result = study_result.stages.back();
  const auto is_bulk = [](const TestResult& test) { return test.id.load.is_bulk(); };
  const auto is_shear = [&](const TestResult& test) { return !is_bulk(test); };
  const auto is_no_part_of_a_mean = [&](const TestResult& test) {
    return !asks_for_isotropic(study.tests) || test.id.load.is_isotropic() ||
           !is_in_mean(test.id.load, stage.dimensions());
  };
  auto shear = plot_of(study, stage, result, is_shear, is_no_part_of_a_mean);
  if (!shear.curves.empty()) {
    for (const auto& [label, modulus, boundary] : references(study, stage, study_result)) {
      auto& curve = shear.curves.emplace_back(plot_curve(label, modulus));
      curve.colour = boundary ? colour_of(*boundary, Load::shear) : colour_of_measurements;
      if (boundary) curve.style = PlotStyle::dotted;
    }
    shear.quantity = "Relaxation modulus G(t)";
    write_text(directory / "modulus.svg", modulus_plot(shear));
  }
  auto bulk = plot_of(study, stage, result, is_bulk, is_bulk);
  if (!bulk.curves.empty()) {
    bulk.quantity =
        is_plane_strain(stage.dimensions()) ? "Plane-strain bulk modulus K(t) + G(t)/3" : "Bulk modulus K(t)";
    write_text(directory / "bulk_modulus.svg", modulus_plot(bulk));
  }
}

}  // namespace breccia
