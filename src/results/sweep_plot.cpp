#include "results/sweep_plot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/text_file.hpp"
#include "report/modulus_plot.hpp"
#include "results/sweep_spread.hpp"
#include "study/abscissa_words.hpp"

namespace breccia {

namespace {

constexpr std::size_t most_colours = 7;  // size of the palette
constexpr std::size_t most_labels = 14;
constexpr int points_of_series_per_decade = 20;

PlotStyle style_of(const TaskCurve& curve) {
  if (curve.test.boundary == Boundary::traction) return PlotStyle::dashed;
  return curve.test.boundary == Boundary::periodic ? PlotStyle::line_and_points : PlotStyle::line;
}

/// The group of curves with one colour: a task, or, if there are many, all tasks that differ only in their seeds.
std::vector<std::string> names_of_colours(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const auto& task : sweep.tasks) {
    names.push_back(sweep.tasks.size() <= most_colours ? task.name : name_without_seeds(sweep, task));
  }
  return names;
}

/// A relaxation modulus over time or, where it is known, a complex modulus over the frequency in hertz.
PlotCurve plotted(const TaskCurve& curve) {
  PlotCurve plot{.label = "", .style = style_of(curve)};
  if (!curve.in_frequency.empty()) {
    for (const auto& sample : curve.in_frequency) {
      plot.times.push_back(hertz_of(1.0 / sample.angular_frequency));
      plot.moduli.push_back(std::hypot(sample.storage, sample.loss));
    }
    return plot;
  }
  for (const auto& [time, modulus] : curve.modulus) {
    plot.times.push_back(time);
    plot.moduli.push_back(modulus);
  }
  return plot;
}

/// A measurement over the abscissa of the tests: its own points, or a fitted series as a line; without points where it
/// is not known there.
PlotCurve plotted(const Measurement& measurement, const Tests& tests) {
  const TimeWindow window{tests.first_time, tests.last_time};
  auto times = measurement.points_within(window);
  const bool has_points = !times.empty();
  PlotCurve plot{.label = "measured, " + measurement.label,
                 .style = has_points ? PlotStyle::points : PlotStyle::dotted};
  const auto known = measurement.known_within(window);
  if (!known) return plot;
  if (!has_points) times = logarithmic_times(*known, points_of_series_per_decade);
  if (tests.abscissa() == Abscissa::frequency) {
    std::ranges::transform(times, times.begin(), [](double time) { return 1.0 / time; });
    for (const auto& [omega, storage, loss] : measurement.complex_within(window, times)) {
      plot.times.push_back(hertz_of(1.0 / omega));
      plot.moduli.push_back(std::hypot(storage, loss));
    }
    return plot;
  }
  for (const double time : times) {
    plot.times.push_back(time);
    plot.moduli.push_back(measurement.at(time));
  }
  return plot;
}

/// The measured shear moduli of a stage.
std::vector<PlotCurve> measured(const Study& study, const std::string& stage) {
  std::vector<PlotCurve> curves;
  for (const auto& measurement : study.measurements) {
    if (measurement.stage != stage || measurement.kind != ModulusKind::shear) continue;
    auto curve = plotted(measurement, study.tests);
    if (!curve.times.empty()) curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result) {
  const auto names = names_of_colours(sweep);
  const auto shown = last_stage_of(result);
  ModulusPlot plot;
  std::string stage;
  std::vector<std::string> colours;
  const auto abscissa = sweep.tasks.front().study.tests.abscissa();
  bool has_tractions = false, is_bulk = false;
  for (std::size_t task = 0; task < shown.size(); ++task) {
    for (const auto& curve : shown[task].curves) {
      if (curve.in_frequency.empty() && abscissa == Abscissa::frequency) continue;
      auto plotted_curve = plotted(curve);
      const auto colour = std::ranges::find(colours, names[task]);
      plotted_curve.colour = static_cast<std::size_t>(colour - colours.begin());
      if (colour == colours.end()) {
        colours.push_back(names[task]);
        if (colours.size() <= most_labels) plotted_curve.label = names[task];
      }
      has_tractions = has_tractions || plotted_curve.style == PlotStyle::dashed;
      plot.curves.push_back(std::move(plotted_curve));
      stage = curve.stage;
      is_bulk = curve.test.load.is_bulk();
      plot.title = fmt::format("{}: {}", sweep.tasks[task].study.title, stage);
    }
  }
  if (plot.curves.empty()) {
    remove_files(directory, std::vector<std::string>{"sweep.svg"});
    return;
  }
  const auto& study = sweep.tasks.front().study;
  std::ranges::move(measured(study, stage), std::back_inserter(plot.curves));
  if (has_tractions) plot.title += ", traction dashed";
  if (abscissa == Abscissa::frequency) {
    plot.quantity = is_bulk ? "Absolute value |K*|" : "Absolute value |G*|";
    plot.abscissa = "Frequency / Hz";
  }
  write_text(directory / "sweep.svg", modulus_plot(plot));
}

}  // namespace breccia
