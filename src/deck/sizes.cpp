#include "deck/sizes.hpp"

#include <cstdint>
#include <numeric>

#include <fmt/format.h>

#include "breccia/microstructure/draw_diameters.hpp"

#include "deck/size_table.hpp"

namespace breccia {

namespace {

std::optional<Sizes> read_file(const Section& filler) {
  const auto path = filler.file("sizes");
  std::optional<Sizes> sizes;
  if (!path.empty()) filler.report_errors_of("sizes", [&] { sizes = read_size_table(path); });
  return sizes;
}

/// The list of diameters, each repeated by its count.
ListedSizes read_list(const Section& sizes) {
  const auto diameters = sizes.quantities("list", Dimension::length, Range::positive());
  if (!sizes.has("counts")) return {diameters};
  constexpr auto most = static_cast<std::int64_t>(most_particles);
  const auto counts = sizes.integers("counts", {.lower = 1.0, .upper = static_cast<double>(most)});
  if (counts.size() != diameters.size()) {
    sizes.report("counts", fmt::format("expected as many as in list, {}, got {}", diameters.size(), counts.size()));
    return {};
  }
  const auto particles = std::reduce(counts.begin(), counts.end());
  if (particles > most) {
    sizes.report("counts", fmt::format("expected at most {} particles, got {}", most, particles));
    return {};
  }
  ListedSizes listed;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    listed.diameters.insert(listed.diameters.end(), static_cast<std::size_t>(counts[i]), diameters[i]);
  }
  return listed;
}

LognormalSizes read_lognormal(const Section& sizes) {
  LognormalSizes lognormal;
  double sum = 0.0;
  for (const auto& component : sizes.sections("lognormal")) {
    lognormal.components.push_back({component.optional_number("weight", Range::above_and_up_to(0.0, 1e6)).value_or(1.0),
                                    component.quantity("median", Dimension::length, Range::positive()),
                                    component.number("sigma", Range::positive())});
    sum += lognormal.components.back().weight;
  }
  for (auto& component : lognormal.components) component.weight /= sum;
  return lognormal;
}

}  // namespace

std::optional<Sizes> read_sizes(const Section& filler) {
  if (filler.kind("sizes") == Kind::text) return read_file(filler);
  if (filler.kind("sizes") != Kind::table) {
    const auto expected = "a file, { diameter = ... }, { list = [...] } or { lognormal = [...] }";
    filler.report("sizes", fmt::format("{}expected {}", filler.has("sizes") ? "" : "missing, ", expected));
    return std::nullopt;
  }
  const auto sizes = filler.section("sizes");
  const auto kind = sizes.exactly_one({"diameter", "list", "lognormal"});
  if (kind == "diameter") return SingleSize{sizes.quantity("diameter", Dimension::length, Range::positive())};
  if (kind == "list") return read_list(sizes);
  if (kind == "lognormal") return read_lognormal(sizes);
  return std::nullopt;
}

}  // namespace breccia
