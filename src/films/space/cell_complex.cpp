#include "films/space/cell_complex.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "breccia/error.hpp"

#include "microstructure/uniform.hpp"

namespace breccia::films {
namespace {

using Image = Eigen::Vector3i;

std::array<int, 3> key_of(const Image& image) {
  return {image.x(), image.y(), image.z()};
}

bool is_before(const CellImage& one, const CellImage& other) {
  return std::tuple(one.cell, key_of(one.image)) < std::tuple(other.cell, key_of(other.image));
}

bool is_same(const VertexImage& one, const VertexImage& other) {
  return one.vertex == other.vertex && one.image == other.image;
}

/// Cells that meet, in their order, as a key of maps.
template <std::size_t count>
using Meeting = std::array<std::pair<std::size_t, std::array<int, 3>>, count>;

/// The meeting of cells in that place among its periodic images which comes first, and the displacement from there.
template <std::size_t count>
struct PlacedMeeting {
  Meeting<count> key;
  std::array<CellImage, count> cells;  ///< the cells in that place
  Image image;
};

template <std::size_t count>
PlacedMeeting<count> placed(const std::array<CellImage, count>& cells) {
  std::optional<PlacedMeeting<count>> first;
  for (const auto& reference : cells) {
    PlacedMeeting<count> one{{}, cells, reference.image};
    for (auto& cell : one.cells) cell.image -= reference.image;
    std::ranges::sort(one.cells, is_before);
    for (std::size_t i = 0; i < count; ++i) one.key[i] = {one.cells[i].cell, key_of(one.cells[i].image)};
    if (!first || one.key < first->key) first = one;
  }
  return *first;
}

/// The same sites with slightly other positions and weights, so that planes which meet in a point by symmetry meet
/// there no longer. Sites move away from the nearer side of the box, and so stay in it.
Tessellation<3> without_symmetry(const Tessellation<3>& tessellation) {
  constexpr double share = 1e-7;
  constexpr std::uint64_t seed = 1;
  auto sites = tessellation.sites();
  const double width = sites.side / std::cbrt(static_cast<double>(sites.sites.size()));
  std::mt19937_64 engine(seed);
  for (auto& site : sites.sites) {
    site.weight += share * width * width * uniform(engine);
    for (double& x : site.position) x += (x < 0.5 * sites.side ? share : -share) * width * uniform(engine);
  }
  return Tessellation<3>(std::move(sites));
}

/// Finds faces, edges and points from cell to cell.
class Finder {
 public:
  explicit Finder(const Tessellation<3>& tessellation) : tessellation_(tessellation) {
    for (std::size_t cell = 0; cell < tessellation.size(); ++cell) find_points(cell);
    for (const auto& [key, cells_there] : cells_at_) {
      if (cells_there != cells_at_a_point) {
        throw InputError(
            "films: the cells of the grains do not agree on their vertices, as where a grain touches images of "
            "itself on several sides; a box of more grains avoids it");
      }
    }
    for (std::size_t cell = 0; cell < tessellation.size(); ++cell) {
      find_edges(cell);
      find_faces(cell);
    }
  }

  [[nodiscard]] CellComplex take() { return std::move(complex_); }

 private:
  static constexpr std::size_t cells_at_a_point = 4;

  /// The cell beyond a plane of a cell.
  [[nodiscard]] CellImage beyond(std::size_t cell, std::uint32_t plane) const {
    const auto& face = tessellation_.cell(cell).half_spaces()[plane];
    const auto image = Tessellation<3>::image(face);
    return {*Tessellation<3>::neighbour(face), {image[0], image[1], image[2]}};
  }

  [[nodiscard]] Eigen::Vector3d site(const CellImage& at) const {
    const auto& position = tessellation_.sites().sites[at.cell].position;
    return Eigen::Vector3d(position[0], position[1], position[2]) / tessellation_.side() + at.image.cast<double>();
  }

  void find_points(std::size_t cell) {
    auto& vertices = vertices_of_.emplace_back();
    for (const auto& corner : tessellation_.cell(cell).corners()) {
      const std::array<CellImage, cells_at_a_point> cells = {
          CellImage{cell, Image::Zero()}, beyond(cell, corner.planes[0]), beyond(cell, corner.planes[1]),
          beyond(cell, corner.planes[2])};
      const auto meeting = placed(cells);
      const auto [found, is_new] = point_.try_emplace(meeting.key, complex_.points.size());
      ++cells_at_[meeting.key];
      if (is_new) {
        const Eigen::Vector3d from_site(corner.position[0], corner.position[1], corner.position[2]);
        complex_.vertices.emplace_back(site(cells[0]) + from_site / tessellation_.side() -
                                       meeting.image.cast<double>());
        complex_.points.push_back({upright(meeting.cells), {found->second, Image::Zero()}});
      }
      vertices.push_back({found->second, meeting.image});
    }
  }

  /// The cells in an order in which the tetrahedron of their sites has a positive volume.
  [[nodiscard]] std::array<CellImage, 4> upright(std::array<CellImage, 4> cells) const {
    const auto from = site(cells[0]);
    const double volume = (site(cells[1]) - from).cross(site(cells[2]) - from).dot(site(cells[3]) - from);
    if (volume < 0.0) std::swap(cells[2], cells[3]);
    return cells;
  }

  void find_edges(std::size_t cell) {
    const auto& body = tessellation_.cell(cell);
    for (std::size_t corner = 0; corner < body.corners().size(); ++corner) {
      for (std::size_t slot = 0; slot < 3; ++slot) {
        const auto& planes = body.corners()[corner].planes;
        auto meeting = placed(std::array{CellImage{cell, Image::Zero()}, beyond(cell, planes[(slot + 1) % 3]),
                                         beyond(cell, planes[(slot + 2) % 3])});
        if (!has_edge_.insert(meeting.key).second) continue;
        std::array ends = {vertices_of_[cell][corner], vertices_of_[cell][body.corner_across(corner, slot)]};
        for (auto& end : ends) end.image -= meeting.image;
        auto& cells = meeting.cells;
        const auto from = site(cells[0]);
        const Eigen::Vector3d along = complex_.position(ends[1]) - complex_.position(ends[0]);
        if ((site(cells[1]) - from).cross(site(cells[2]) - from).dot(along) < 0.0) std::swap(cells[1], cells[2]);
        complex_.edges.push_back({cells, ends});
      }
    }
  }

  void find_faces(std::size_t cell) {
    const auto& body = tessellation_.cell(cell);
    std::vector<bool> is_done(body.half_spaces().size(), false);
    for (std::size_t corner = 0; corner < body.corners().size(); ++corner) {
      for (const auto plane : body.corners()[corner].planes) {
        if (is_done[plane]) continue;
        is_done[plane] = true;
        const auto across = beyond(cell, plane);
        if (is_before(across, {cell, Image::Zero()})) continue;
        complex_.faces.push_back({cell, across, corners_around(cell, plane, corner)});
      }
    }
  }

  /// The corners of a plane of a cell, from one of them on.
  [[nodiscard]] std::vector<VertexImage> corners_around(std::size_t cell, std::uint32_t plane,
                                                        std::size_t start) const {
    const auto& body = tessellation_.cell(cell);
    const auto slot_of = [&](std::size_t corner, std::uint32_t number) {
      const auto& planes = body.corners()[corner].planes;
      return static_cast<std::size_t>(std::ranges::find(planes, number) - planes.begin());
    };
    std::vector<VertexImage> corners;
    // An edge of the face lies in one more plane; the next one leads away from it.
    auto left = slot_of(start, plane) == 0 ? std::size_t{1} : std::size_t{0};
    for (auto at = start; corners.empty() || at != start;) {
      corners.push_back(vertices_of_[cell][at]);
      const auto& planes = body.corners()[at].planes;
      const auto along = planes[3 - slot_of(at, plane) - left];
      at = body.corner_across(at, left);
      left = slot_of(at, along);
    }
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    const auto first = complex_.position(corners[0]);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      area += (complex_.position(corners[i]) - first).cross(complex_.position(corners[i + 1]) - first);
    }
    const auto& normal = body.half_spaces()[plane].normal;
    if (area.dot(Eigen::Vector3d(normal[0], normal[1], normal[2])) < 0.0) std::ranges::reverse(corners);
    return corners;
  }

  const Tessellation<3>& tessellation_;
  CellComplex complex_;
  std::map<Meeting<4>, std::size_t> point_, cells_at_;
  std::set<Meeting<3>> has_edge_;
  std::vector<std::vector<VertexImage>> vertices_of_;  ///< vertices by cell and corner
};

/// For each vertex the one that takes its place: edges shorter than this length [sides] vanish.
std::vector<VertexImage> merged_vertices(const CellComplex& complex, double shortest) {
  std::vector<std::vector<VertexImage>> close(complex.vertices.size());
  for (const auto& edge : complex.edges) {
    const auto& [begin, end] = edge.ends;
    if ((complex.position(end) - complex.position(begin)).norm() > shortest) continue;
    close[begin.vertex].push_back({end.vertex, end.image - begin.image});
    close[end.vertex].push_back({begin.vertex, begin.image - end.image});
  }
  std::vector<std::optional<VertexImage>> merged(complex.vertices.size());
  for (std::size_t start = 0; start < merged.size(); ++start) {
    if (merged[start]) continue;
    merged[start] = VertexImage{start, Image::Zero()};
    std::vector<std::size_t> waiting = {start};
    while (!waiting.empty()) {
      const auto from = waiting.back();
      waiting.pop_back();
      for (const auto& [to, image] : close[from]) {
        if (merged[to]) continue;
        // The vertex `to`, displaced by `image`, is where `from` is, which is at the start's image.
        merged[to] = VertexImage{start, merged[from]->image - image};
        waiting.push_back(to);
      }
    }
  }
  std::vector<VertexImage> found;
  found.reserve(merged.size());
  for (const auto& one : merged) found.push_back(*one);
  return found;
}

/// The complex with merged vertices, without the edges and faces that vanish.
CellComplex merged(CellComplex complex, const std::vector<VertexImage>& vertices) {
  const auto place = [&](VertexImage& at) {
    const auto& to = vertices[at.vertex];
    at = {to.vertex, at.image + to.image};
  };
  for (auto& point : complex.points) place(point.vertex);
  for (auto& edge : complex.edges) std::ranges::for_each(edge.ends, place);
  std::erase_if(complex.edges, [](const SharedEdge& edge) { return is_same(edge.ends[0], edge.ends[1]); });
  for (auto& face : complex.faces) {
    auto& corners = face.corners;
    std::ranges::for_each(corners, place);
    corners.erase(std::unique(corners.begin(), corners.end(), is_same), corners.end());
    while (corners.size() > 1 && is_same(corners.front(), corners.back())) corners.pop_back();
  }
  constexpr std::size_t fewest = 3;
  std::erase_if(complex.faces, [](const SharedFace& face) { return face.corners.size() < fewest; });
  return complex;
}

}  // namespace

CellComplex cell_complex(const Tessellation<3>& tessellation) {
  constexpr double least_share = 1e-4;
  const auto generic = without_symmetry(tessellation);
  auto complex = Finder(generic).take();
  const double width = 1.0 / std::cbrt(static_cast<double>(tessellation.size()));
  const auto vertices = merged_vertices(complex, least_share * width);
  return merged(std::move(complex), vertices);
}

}  // namespace breccia::films
