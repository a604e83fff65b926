#include "breccia/report/modulus_plot.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

#include "child_process.hpp"
#include "log_axis.hpp"

namespace breccia {

namespace {

/// Dashes of lines, and of those for lower bounds, in each round of the colours.
constexpr std::array<std::string_view, 4> line_dashes{"solid", "(9,3,2,3)", "(9,3,2,3,2,3)", "(20,3)"};
constexpr std::array<std::string_view, 4> lower_dashes{"(12,7)", "(5,7)", "(12,7,3,7)", "(12,7,3,7,3,7)"};

/// Colours that remain distinct to the colour-blind (Okabe and Ito, 2008), without the yellow, which is lost on white.
constexpr std::array<std::string_view, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000"};

struct Point {
  double time;     // [s]
  double modulus;  // in the unit of the plot
};

/// The points of a curve that logarithmic axes can show.
std::vector<Point> visible_points(const PlotCurve& curve, double unit) {
  if (curve.times.size() != curve.moduli.size()) {
    throw InputError(fmt::format("plot: the curve \"{}\" has {} times but {} moduli", curve.label, curve.times.size(),
                                 curve.moduli.size()));
  }
  const auto can_show = [](double x) { return x > 0.0 && std::isfinite(x); };
  std::vector<Point> points;
  for (std::size_t i = 0; i < curve.times.size(); ++i) {
    if (can_show(curve.times[i]) && can_show(curve.moduli[i])) {
      points.push_back({curve.times[i], curve.moduli[i] / unit});
    }
  }
  return points;
}

/// A text as a string of gnuplot's language. Every sign with which a label could leave its quotes or start a command
/// is given by its octal code, and so is every digit, which gnuplot would take as part of a code before it.
/// Replaces control characters, such as line breaks, by spaces.
std::string gnuplot_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_control = code < 0x20 || code == 0x7f;
    const bool is_plain = std::isalpha(code) != 0 || code >= 0x80;
    result += is_control ? " " : is_plain ? std::string(1, c) : fmt::format("\\{:03o}", code);
  }
  return result + "\"";
}

std::string tick_list(const LogAxis& axis) {
  std::string list;
  for (const auto& tick : axis.ticks) {
    list += fmt::format("{}'{}' {:.17g} {}", list.empty() ? "" : ", ", tick.label, tick.at, tick.label.empty() ? 1 : 0);
  }
  return list;
}

std::string axes(const ModulusPlot& plot, const LogAxis& time, const LogAxis& modulus) {
  return fmt::format(
      "set logscale xy\n"
      "set xrange [{:.17g}:{:.17g}]\nset yrange [{:.17g}:{:.17g}]\n"
      "set xtics ({})\nset ytics ({})\n"
      "set xlabel {} noenhanced offset 0,0.5\nset ylabel {} noenhanced\nset title {} noenhanced\n",
      time.begin, time.end, modulus.begin, modulus.end, tick_list(time), tick_list(modulus),
      gnuplot_text(plot.abscissa), gnuplot_text(fmt::format("{} / {}", plot.quantity, plot.unit)),
      gnuplot_text(plot.title));
}

/// Position of a label centred between two times, as a share of the width of the graph, such that it stays in the
/// graph.
double label_position(const PlotWindow& window, double begin, double end, const LogAxis& time) {
  constexpr double width_of_a_sign = 0.0085;
  const double half_width = std::min(0.5, 0.5 * width_of_a_sign * static_cast<double>(window.label.size()));
  const double middle = std::log(std::sqrt(begin * end) / time.begin) / std::log(time.end / time.begin);
  return std::clamp(middle, half_width, 1.0 - half_width);
}

/// Transparent bands of alternating colour and height of label, so that both can be seen where two windows overlap.
std::string bands(const std::vector<PlotWindow>& windows, const LogAxis& time) {
  std::string script;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double begin = std::clamp(windows[i].begin, time.begin, time.end);
    const double end = std::clamp(windows[i].end, time.begin, time.end);
    if (!(begin < end)) continue;
    const bool is_even = i % 2 == 0;
    script += fmt::format(
        "set object rectangle from first {0:.17g}, graph 0 to first {1:.17g}, graph 1 behind "
        "fillcolor rgb '{2}' fillstyle transparent solid 0.12 noborder\n"
        "set label {3} at graph {4:.17g}, graph {5} center noenhanced textcolor rgb '#606060' font ',11'\n",
        begin, end, is_even ? "#4477aa" : "#998866", gnuplot_text(windows[i].label),
        label_position(windows[i], begin, end, time), is_even ? 0.96 : 0.92);
  }
  return script;
}

std::string drawing(const PlotCurve& curve, std::size_t position) {
  const std::size_t colour = curve.colour.value_or(position);
  // Each round of the colours has its own dashes.
  const auto round = colour / palette.size();
  const auto with_line = [&](std::string_view what, std::string_view dashes) {
    return fmt::format("with {} linewidth 2 dashtype {} pointtype 6 pointsize 0.7 linecolor rgb '{}'", what, dashes,
                       palette[colour % palette.size()]);
  };
  const auto plain = line_dashes[round % line_dashes.size()];
  switch (curve.style) {
    case PlotStyle::line:
      return with_line("lines", plain);
    case PlotStyle::dashed:
      return with_line("lines", lower_dashes[round % lower_dashes.size()]);
    case PlotStyle::dotted:
      return with_line("lines", "(3,4)");
    case PlotStyle::points:
      return with_line("points", plain);
    case PlotStyle::line_and_points:
      return with_line("linespoints", plain);
  }
  return {};
}

/// The data as blocks of the script, and the command that draws them.
std::string curves(const std::vector<PlotCurve>& curves, const std::vector<std::vector<Point>>& points) {
  std::string data;
  std::string command;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (points[i].empty()) continue;
    data += fmt::format("$curve{} << END\n", i);
    for (const auto& [time, modulus] : points[i]) {
      fmt::format_to(std::back_inserter(data), "{:.9g} {:.9g}\n", time, modulus);
    }
    data += "END\n";
    command += fmt::format("{} $curve{} using 1:2 {} title {}", command.empty() ? "plot" : ",", i,
                           drawing(curves[i], i), gnuplot_text(curves[i].label));
  }
  return data + command + "\n";
}

std::string gnuplot_script(const ModulusPlot& plot) {
  std::vector<std::vector<Point>> points;
  auto smallest = Point{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  auto largest = Point{0.0, 0.0};
  for (const auto& curve : plot.curves) {
    points.push_back(visible_points(curve, plot.unit_size));
    for (const auto& [time, modulus] : points.back()) {
      smallest = {std::min(smallest.time, time), std::min(smallest.modulus, modulus)};
      largest = {std::max(largest.time, time), std::max(largest.modulus, modulus)};
    }
  }
  if (!(largest.time > 0.0)) throw InputError(fmt::format("plot \"{}\": there is no point to show", plot.title));

  const auto time = log_axis(smallest.time, largest.time);
  // Room for the labels of the windows above the curves.
  const double headroom = plot.windows.empty() ? 1.0 : std::pow(1.7 * largest.modulus / smallest.modulus, 0.12);
  const auto modulus = log_axis(smallest.modulus, largest.modulus * headroom, 1.3);
  return "set encoding utf8\n"
         "set terminal svg enhanced size 900,600 dynamic rounded background rgb 'white' font 'sans-serif,15'\n"
         "set border linecolor rgb '#404040'\n"
         "set tics nomirror out\n"
         "set grid xtics ytics mxtics mytics linecolor rgb '#c8c8c8' linewidth 1, linecolor rgb '#e4e4e4' linewidth 1\n"
         "set key outside bottom center horizontal Left reverse noenhanced samplen 2.5 height 0.8\n" +
         axes(plot, time, modulus) + bands(plot.windows, time) + curves(plot.curves, points);
}

/// The output of a program as one line.
std::string in_one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

ProcessResult run_gnuplot(const std::string& script) {
  const std::string remedy = "plots need gnuplot (Debian: apt-get install gnuplot-nox)";
  try {
    auto result = run_program({"gnuplot", "--default-settings"}, script);
    if (result.exit_status == 0) return result;
    throw FileError(fmt::format("gnuplot failed with status {}: {}", result.exit_status, in_one_line(result.errors)));
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}; {}", error.what(), remedy));
  }
}

}  // namespace

std::string modulus_plot(const ModulusPlot& plot) {
  return run_gnuplot(gnuplot_script(plot)).output;
}

std::optional<std::string> write_modulus_plot(const std::filesystem::path& file, const ModulusPlot& plot) {
  std::string picture;
  try {
    picture = modulus_plot(plot);
  } catch (const FileError& error) {
    remove_files(file.parent_path(), std::vector{file.filename().string()});
    return error.what();
  }
  write_text(file, picture);
  return std::nullopt;
}

std::optional<std::string> why_no_plots() {
  try {
    run_gnuplot("exit\n");
    return std::nullopt;
  } catch (const FileError& error) {
    return error.what();
  }
}

}  // namespace breccia
