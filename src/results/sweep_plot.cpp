#include "results/sweep_plot.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/text_file.hpp"
#include "report/modulus_plot.hpp"
#include "results/sweep_spread.hpp"

namespace breccia {

namespace {

constexpr std::size_t most_colours = 7;  // size of the palette
constexpr std::size_t most_labels = 14;

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

PlotCurve plotted(const TaskCurve& curve) {
  PlotCurve plot{.label = "", .style = style_of(curve)};
  for (const auto& [time, modulus] : curve.modulus) {
    plot.times.push_back(time);
    plot.moduli.push_back(modulus);
  }
  return plot;
}

}  // namespace

void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result) {
  const auto names = names_of_colours(sweep);
  const auto shown = last_stage_of(result);
  ModulusPlot plot;
  std::vector<std::string> colours;
  bool has_tractions = false;
  for (std::size_t task = 0; task < shown.size(); ++task) {
    for (const auto& curve : shown[task].curves) {
      auto plotted_curve = plotted(curve);
      const auto colour = std::ranges::find(colours, names[task]);
      plotted_curve.colour = static_cast<std::size_t>(colour - colours.begin());
      if (colour == colours.end()) {
        colours.push_back(names[task]);
        if (colours.size() <= most_labels) plotted_curve.label = names[task];
      }
      has_tractions = has_tractions || plotted_curve.style == PlotStyle::dashed;
      plot.curves.push_back(std::move(plotted_curve));
      plot.title = fmt::format("{}: {}", sweep.tasks[task].study.title, curve.stage);
    }
  }
  if (plot.curves.empty()) {
    remove_files(directory, std::vector<std::string>{"sweep.svg"});
    return;
  }
  if (has_tractions) plot.title += ", traction dashed";
  write_text(directory / "sweep.svg", modulus_plot(plot));
}

}  // namespace breccia
