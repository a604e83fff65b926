#include "deck/crystals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/error.hpp"

#include "io/nearest_name.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// The indices of a constant, as they are written.
using Number = std::array<std::size_t, 2>;

/// A constant that follows from those that are given: C_ij = sum of factor C_kl.
struct DependentConstant {
  Number number;
  std::vector<std::pair<double, Number>> terms;
};

/// The constants of crystals of one symmetry, in the axes of Nye (1985): the threefold, fourfold or sixfold axis is z,
/// the twofold one of a monoclinic crystal y. All others are zero.
struct Symmetry {
  std::string_view name;
  std::vector<Number> given;
  std::vector<DependentConstant> dependent = {};
};

std::vector<Symmetry> all_symmetries() {
  const auto equal = [](Number number, Number other) { return DependentConstant{number, {{1.0, other}}}; };
  const DependentConstant in_plane_shear = {{6, 6}, {{0.5, {1, 1}}, {-0.5, {1, 2}}}};
  const std::vector<DependentConstant> about_z = {equal({2, 2}, {1, 1}), equal({2, 3}, {1, 3}), equal({5, 5}, {4, 4})};
  const auto with = [](std::vector<DependentConstant> some, std::vector<DependentConstant> more) {
    some.insert(some.end(), more.begin(), more.end());
    return some;
  };
  std::vector<Number> all;
  for (std::size_t i = 1; i <= 6; ++i) {
    for (std::size_t j = i; j <= 6; ++j) all.push_back({i, j});
  }
  return {{"cubic",
           {{1, 1}, {1, 2}, {4, 4}},
           with(about_z, {equal({3, 3}, {1, 1}), equal({1, 3}, {1, 2}), equal({2, 3}, {1, 2}), equal({6, 6}, {4, 4})})},
          {"hexagonal", {{1, 1}, {1, 2}, {1, 3}, {3, 3}, {4, 4}}, with(about_z, {in_plane_shear})},
          {"trigonal",
           {{1, 1}, {1, 2}, {1, 3}, {1, 4}, {3, 3}, {4, 4}},
           with(about_z, {in_plane_shear, {{2, 4}, {{-1.0, {1, 4}}}}, equal({5, 6}, {1, 4})})},
          {"tetragonal", {{1, 1}, {1, 2}, {1, 3}, {3, 3}, {4, 4}, {6, 6}}, about_z},
          {"orthorhombic", {{1, 1}, {1, 2}, {1, 3}, {2, 2}, {2, 3}, {3, 3}, {4, 4}, {5, 5}, {6, 6}}},
          {"monoclinic",
           {{1, 1}, {1, 2}, {1, 3}, {1, 5}, {2, 2}, {2, 3}, {2, 5}, {3, 3}, {3, 5}, {4, 4}, {4, 6}, {5, 5}, {6, 6}}},
          {"triclinic", all}};
}

const std::vector<Symmetry>& symmetries() {
  static const auto known = all_symmetries();
  return known;
}

double& constant(ElasticConstants& constants, const Number& number) {
  return constants[place_of_constant(number[0], number[1])];
}

std::string name_of_constant(const Number& number) {
  return fmt::format("C{}{}", number[0], number[1]);
}

const Symmetry* read_symmetry(const Section& section) {
  std::vector<std::string> names;
  for (const auto& one : symmetries()) names.emplace_back(one.name);
  if (!section.has("symmetry")) {
    section.report("symmetry", fmt::format(R"(missing; expected one of "{}")", fmt::join(names, R"(", ")")));
    section.accept_all_keys();
    return nullptr;
  }
  const auto name = section.text("symmetry");
  const auto known = std::ranges::find(symmetries(), name, &Symmetry::name);
  if (known != symmetries().end()) return &*known;
  if (!name.empty()) {
    section.report("symmetry", fmt::format(R"(expected one of "{}", got "{}"{})", fmt::join(names, R"(", ")"), name,
                                           suggestion(name, names)));
  }
  section.accept_all_keys();
  return nullptr;
}

/// Reads the columns phi1_deg, phi_deg and phi2_deg of a file, of the rows of a filler if it has a column `filler`.
std::vector<EulerAngles> read_angles(const std::filesystem::path& file, std::size_t filler) {
  const auto table = read_csv(file);
  const auto is_of_other = [&](std::size_t row) {
    return table.has("filler") && table.numbers("filler")[row] != static_cast<double>(filler);
  };
  const auto& phi1 = table.numbers("phi1_deg");
  const auto& phi = table.numbers("phi_deg");
  const auto& phi2 = table.numbers("phi2_deg");
  std::vector<EulerAngles> angles;
  double last = -1.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (is_of_other(row)) continue;
    if (table.has("particle")) {
      if (!(table.numbers("particle")[row] > last)) {
        throw InputError(
            fmt::format("{}: expected particles in rising order, as they are in the box", table.location(row)));
      }
      last = table.numbers("particle")[row];
    }
    if (!std::isfinite(phi1[row] + phi[row] + phi2[row])) {
      throw InputError(fmt::format("{}: row {}: expected finite angles", file.string(), row + 1));
    }
    constexpr double degree = std::numbers::pi / 180.0;
    angles.push_back({phi1[row] * degree, phi[row] * degree, phi2[row] * degree});
  }
  if (angles.empty()) throw InputError(fmt::format("{}: no row of filler {}", file.string(), filler));
  return angles;
}

}  // namespace

std::optional<ElasticConstants> read_stiffness(const Section& material) {
  const auto section = material.section("stiffness");
  const auto* const symmetry = read_symmetry(section);
  if (symmetry == nullptr) return std::nullopt;
  ElasticConstants constants{};
  bool is_known = true;
  for (const auto& number : symmetry->given) {
    double& value = constant(constants, number);
    value = section.quantity(name_of_constant(number), Dimension::pressure, {});
    is_known = is_known && std::isfinite(value);
  }
  if (!is_known) return std::nullopt;
  for (const auto& [number, terms] : symmetry->dependent) {
    double sum = 0.0;
    for (const auto& [factor, other] : terms) sum += factor * constant(constants, other);
    constant(constants, number) = sum;
  }
  constexpr double least_share = 1e-6;
  if (const double least = least_stiffness<3>(stiffness_tensor(constants));
      !(least > least_share * std::ranges::max(constants))) {
    material.report(
        "stiffness",
        fmt::format("expected a positive definite stiffness; there is a strain whose energy is negative, or "
                    "all but zero (least eigenvalue {})",
                    readable(least, Dimension::pressure)));
    return std::nullopt;
  }
  return constants;
}

Orientations read_orientations(const Section& filler, std::size_t number) {
  if (!filler.has("orientations")) return RandomOrientations{};
  if (filler.kind("orientations") == Kind::table) {
    const auto section = filler.section("orientations");
    return RandomOrientations{static_cast<std::uint64_t>(section.integer("seed", Range::not_negative()))};
  }
  const auto text = filler.text("orientations");
  if (text == "random") return RandomOrientations{};
  if (text == "aligned") return AlignedOrientations{};
  ListedOrientations listed;
  if (text.find('.') == std::string::npos) {
    filler.report("orientations",
                  fmt::format(R"(expected "random", "aligned", {{ seed = 3 }} or the name of a file, got "{}"{})", text,
                              suggestion(text, std::array<std::string, 2>{"random", "aligned"})));
    return listed;
  }
  listed.file = filler.file("orientations");
  if (!listed.file.empty()) {
    filler.report_errors_of("orientations", [&] { listed.angles = read_angles(listed.file, number); });
  }
  return listed;
}

}  // namespace breccia
