#include "breccia/microstructure/cell_faces.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "microstructure/uniform.hpp"

namespace breccia {
namespace {

template <int dim>
double area_of(const std::vector<MeasuredFace<dim>>& faces) {
  double sum = 0.0;
  for (const auto& face : faces) sum += face.area;
  return sum;
}

/// Takes faces from the first on, until the next one would lead farther away from the share of their area.
template <int dim>
CellFaces<dim> first_faces(const std::vector<MeasuredFace<dim>>& faces, double share) {
  if (!(share >= 0.0 && share <= 1.0)) {
    throw InputError(fmt::format("faces of cells: expected a share of their area from 0 to 1, got {}", share));
  }
  const double all = area_of(faces), wanted = share * all;
  CellFaces<dim> taken;
  double area = 0.0;
  for (const auto& face : faces) {
    if (area + 0.5 * face.area > wanted) break;
    area += face.area;
    taken.faces.push_back(face.face);
  }
  if (all > 0.0) taken.share = area / all;
  return taken;
}

/// Whether a face is the one, or one of those, of a pair of sites, in either order.
template <int dim>
bool is_between(const CellFace<dim>& face, const SitePair& pair) {
  const auto fits = [&](std::size_t first, std::size_t second, int sign) {
    if (pair.sites != std::array{first, second}) return false;
    if (pair.image.empty()) return true;
    return std::ranges::equal(pair.image, face.image, [sign](int one, int other) { return one == sign * other; });
  };
  return fits(face.first, face.second, 1) || fits(face.second, face.first, -1);
}

}  // namespace

std::string name_of(const SitePair& pair) {
  const auto sites = fmt::format("{}-{}", pair.sites[0], pair.sites[1]);
  return pair.image.empty() ? sites : fmt::format("{}:{}", sites, fmt::join(pair.image, ","));
}

template <int dim>
std::vector<MeasuredFace<dim>> measured_faces(const Tessellation<dim>& tessellation) {
  std::vector<MeasuredFace<dim>> all;
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto& cell = tessellation.cell(site);
    const auto areas = face_measures(cell);
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const auto& half_space = cell.half_spaces()[i];
      const auto across = Tessellation<dim>::neighbour(half_space);
      const auto image = Tessellation<dim>::image(half_space);
      // The cell on the other side has the same face.
      if (!across || std::tuple(*across, image) < std::tuple(site, Index<dim>{})) continue;
      all.push_back({{site, *across, image}, half_space.normal, areas[i]});
    }
  }
  return all;
}

template <int dim>
CellFaces<dim> random_faces(const Tessellation<dim>& tessellation, double share, std::uint64_t seed) {
  auto faces = measured_faces(tessellation);
  std::mt19937_64 engine(seed);
  for (std::size_t left = faces.size(); left > 1; --left) {
    const auto chosen = static_cast<std::size_t>(static_cast<double>(left) * uniform(engine));
    std::swap(faces[left - 1], faces[chosen]);
  }
  return first_faces(faces, share);
}

template <int dim>
CellFaces<dim> faces_across(const Tessellation<dim>& tessellation, double share, const Vector<dim>& direction) {
  double square = 0.0;
  for (const double component : direction) square += component * component;
  if (!(square > 0.0 && std::isfinite(square))) {
    throw InputError("faces of cells: expected a direction with a length");
  }
  const auto inclination = [&](const MeasuredFace<dim>& face) {
    double product = 0.0;
    for (std::size_t axis = 0; axis < direction.size(); ++axis) product += face.normal[axis] * direction[axis];
    return -std::abs(product);
  };
  auto faces = measured_faces(tessellation);
  std::ranges::stable_sort(faces, {}, inclination);
  return first_faces(faces, share);
}

template <int dim>
CellFaces<dim> faces_of_pairs(const Tessellation<dim>& tessellation, std::span<const SitePair> pairs) {
  const auto all = measured_faces(tessellation);
  std::vector<bool> is_taken(all.size(), false);
  std::vector<std::string> unknown, apart;
  for (const auto& pair : pairs) {
    if (std::ranges::max(pair.sites) >= tessellation.size()) {
      unknown.push_back(name_of(pair));
      continue;
    }
    bool has_face = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!is_between(all[i].face, pair)) continue;
      is_taken[i] = has_face = true;
    }
    if (!has_face) apart.push_back(name_of(pair));
  }
  std::vector<std::string> mistakes;
  if (!unknown.empty()) {
    mistakes.push_back(fmt::format("the {} grains have numbers from 0 to {}, got {}", tessellation.size(),
                                   tessellation.size() - 1, fmt::join(unknown, ", ")));
  }
  if (!apart.empty()) mistakes.push_back(fmt::format("no film is between the grains {}", fmt::join(apart, ", ")));
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "; ")));
  CellFaces<dim> taken;
  double area = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_taken[i]) continue;
    taken.faces.push_back(all[i].face);
    area += all[i].area;
  }
  taken.share = area / area_of(all);
  return taken;
}

template CellFaces<2> random_faces(const Tessellation<2>&, double, std::uint64_t);
template CellFaces<3> random_faces(const Tessellation<3>&, double, std::uint64_t);
template CellFaces<2> faces_across(const Tessellation<2>&, double, const Vector<2>&);
template CellFaces<3> faces_across(const Tessellation<3>&, double, const Vector<3>&);
template CellFaces<2> faces_of_pairs(const Tessellation<2>&, std::span<const SitePair>);
template CellFaces<3> faces_of_pairs(const Tessellation<3>&, std::span<const SitePair>);
template std::vector<MeasuredFace<2>> measured_faces(const Tessellation<2>&);
template std::vector<MeasuredFace<3>> measured_faces(const Tessellation<3>&);

}  // namespace breccia
