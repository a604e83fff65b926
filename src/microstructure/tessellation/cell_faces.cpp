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
struct MeasuredFace {
  CellFace<dim> face;
  Vector<dim> normal;
  double area = 0.0;  ///< [m^(dim - 1)]
};

/// All faces between cells, each once.
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

}  // namespace

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
CellFaces<dim> faces_of_pairs(const Tessellation<dim>& tessellation,
                              std::span<const std::array<std::size_t, 2>> pairs) {
  const auto all = measured_faces(tessellation);
  std::vector<MeasuredFace<dim>> found;
  std::vector<std::string> apart;
  for (const auto& [one, other] : pairs) {
    const auto [first, second] = std::minmax(one, other);
    const auto before = found.size();
    std::ranges::copy_if(all, std::back_inserter(found), [first, second](const MeasuredFace<dim>& face) {
      return face.face.first == first && face.face.second == second;
    });
    if (found.size() == before) apart.push_back(fmt::format("[{}, {}]", one, other));
  }
  if (!apart.empty()) {
    throw InputError(fmt::format("these pairs of grains, of {} with numbers from 0, share no face: {}",
                                 tessellation.size(), fmt::join(apart, ", ")));
  }
  CellFaces<dim> taken;
  for (const auto& face : found) taken.faces.push_back(face.face);
  taken.share = area_of(found) / area_of(all);
  return taken;
}

template CellFaces<2> random_faces(const Tessellation<2>&, double, std::uint64_t);
template CellFaces<3> random_faces(const Tessellation<3>&, double, std::uint64_t);
template CellFaces<2> faces_across(const Tessellation<2>&, double, const Vector<2>&);
template CellFaces<3> faces_across(const Tessellation<3>&, double, const Vector<3>&);
template CellFaces<2> faces_of_pairs(const Tessellation<2>&, std::span<const std::array<std::size_t, 2>>);
template CellFaces<3> faces_of_pairs(const Tessellation<3>&, std::span<const std::array<std::size_t, 2>>);

}  // namespace breccia
