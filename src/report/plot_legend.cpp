#include "report/plot_legend.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "report/plot_text.hpp"

namespace breccia {
namespace {

constexpr double row_height = 22.0;
constexpr double sample_width = 40.0;
constexpr double before_label = 8.0, after_label = 22.0, beside_legend = 20.0;

double width_of_column(const std::vector<LegendEntry>& entries, double widest) {
  double label = 0.0;
  for (const auto& entry : entries) label = std::max(label, plot_text_width(entry.label));
  return std::min(sample_width + before_label + label + after_label, widest);
}

}  // namespace

PlotLegend::PlotLegend(std::vector<LegendEntry> entries, double width_of_picture)
    : entries_(std::move(entries)),
      width_of_picture_(width_of_picture),
      width_of_column_(width_of_column(entries_, width_of_picture - 2.0 * beside_legend)),
      columns_(std::clamp(static_cast<std::size_t>((width_of_picture - 2.0 * beside_legend) / width_of_column_),
                          std::size_t{1}, std::max(entries_.size(), std::size_t{1}))) {}

double PlotLegend::height() const {
  const auto rows = (entries_.size() + columns_ - 1) / columns_;
  return row_height * static_cast<double>(rows);
}

std::string PlotLegend::drawn_at(double y) const {
  const double left = 0.5 * (width_of_picture_ - width_of_column_ * static_cast<double>(columns_) + after_label);
  std::string svg;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& [pen, label] = entries_[i];
    const auto row = i / columns_, column = i % columns_;
    const double begin = left + width_of_column_ * static_cast<double>(column);
    const double middle = y + row_height * (static_cast<double>(row) + 0.5);
    svg += fmt::format("<g fill=\"none\">{}</g>\n", drawn_by(pen, {{begin, middle}, {begin + sample_width, middle}},
                                                             {{begin + 0.5 * sample_width, middle}}));
    svg += plot_text(begin + sample_width + before_label, middle + middle_of_plot_text, label,
                     width_of_column_ - sample_width - before_label - after_label);
  }
  return svg;
}

}  // namespace breccia
