#include "results/mesh_parsers.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace breccia::test {
namespace {

constexpr std::size_t header_bytes = 80, triangle_bytes = 50;

std::uint32_t integer_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 4; k-- > 0;) number = (number << 8U) | static_cast<unsigned char>(bytes.at(at + k));
  return number;
}

Point point_at(std::string_view bytes, std::size_t at) {
  Point point{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    point[axis] = static_cast<double>(std::bit_cast<float>(integer_at(bytes, at + 4 * axis)));
  }
  return point;
}

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double triple_product(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Reads the words of a text.
class Words {
 public:
  explicit Words(const std::string& text) : stream_(text) {}

  template <class Value>
  Value next() {
    Value value;
    if (!(stream_ >> value)) throw std::runtime_error("msh: the file ends, or a word is no number");
    return value;
  }
  void expect(const std::string& word) {
    if (next<std::string>() != word) throw std::runtime_error("msh: expected " + word);
  }
  /// The next section; empty at the end.
  std::string section() {
    std::string word;
    stream_ >> word;
    return word;
  }
  /// The text in quotes that comes next.
  std::string quoted() {
    std::string text;
    std::getline(stream_, text, '"');
    std::getline(stream_, text, '"');
    return text;
  }

 private:
  std::istringstream stream_;
};

MshElement read_element(Words& words) {
  MshElement element;
  static_cast<void>(words.next<std::size_t>());
  element.type = words.next<int>();
  if (words.next<int>() != 2) throw std::runtime_error("msh: expected two tags");
  element.group = words.next<int>();
  element.entity = words.next<int>();
  const std::map<int, std::size_t> corners = {{1, 2}, {2, 3}, {4, 4}};
  for (std::size_t k = 0; k < corners.at(element.type); ++k) element.nodes.push_back(words.next<std::size_t>());
  return element;
}

MshPeriodic read_periodic(Words& words) {
  MshPeriodic pair;
  pair.dimension = words.next<int>();
  pair.entity = words.next<int>();
  pair.master = words.next<int>();
  words.expect("Affine");
  for (double& number : pair.affine) number = words.next<double>();
  for (auto count = words.next<std::size_t>(); count > 0; --count) {
    const auto node = words.next<std::size_t>(), master = words.next<std::size_t>();
    pair.nodes.push_back({node, master});
  }
  return pair;
}

}  // namespace

std::vector<StlTriangle> parse_stl(std::string_view bytes) {
  const std::size_t count = integer_at(bytes, header_bytes);
  if (bytes.size() != header_bytes + 4 + triangle_bytes * count) throw std::runtime_error("stl: not of this size");
  std::vector<StlTriangle> triangles(count);
  for (std::size_t t = 0; t < count; ++t) {
    const auto at = header_bytes + 4 + triangle_bytes * t;
    triangles[t].normal = point_at(bytes, at);
    for (std::size_t k = 0; k < 3; ++k) triangles[t].corners[k] = point_at(bytes, at + 12 * (k + 1));
  }
  return triangles;
}

std::vector<std::vector<StlTriangle>> closed_bodies(const std::vector<StlTriangle>& triangles) {
  std::vector<std::vector<StlTriangle>> bodies(1);
  std::set<std::pair<Point, Point>> open, met;
  for (const auto& triangle : triangles) {
    bodies.back().push_back(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &begin = triangle.corners[k], &end = triangle.corners[(k + 1) % 3];
      if (!met.insert({begin, end}).second) throw std::runtime_error("stl: an edge is met twice");
      if (open.erase({end, begin}) == 0) open.insert({begin, end});
    }
    if (open.empty()) {
      bodies.emplace_back();
      met.clear();
    }
  }
  if (!bodies.back().empty()) throw std::runtime_error("stl: a body is open");
  bodies.pop_back();
  return bodies;
}

double volume_of(const std::vector<StlTriangle>& body) {
  double sixfold = 0.0;
  const auto& origin = body.at(0).corners[0];
  for (const auto& [normal, corners] : body) {
    sixfold += triple_product(minus(corners[0], origin), minus(corners[1], origin), minus(corners[2], origin));
  }
  return sixfold / 6.0;
}

std::vector<MshElement> Msh::of_group(const std::string& name) const {
  const auto& [dimension, number] = groups.at(name);
  std::vector<MshElement> found;
  for (const auto& element : elements) {
    if (element.group == number) found.push_back(element);
  }
  return found;
}

double Msh::content(const MshElement& element) const {
  const auto& origin = nodes.at(element.nodes[0]);
  const auto a = minus(nodes.at(element.nodes[1]), origin), b = minus(nodes.at(element.nodes[2]), origin);
  if (element.type == 2) return 0.5 * (a[0] * b[1] - a[1] * b[0]);
  return triple_product(a, b, minus(nodes.at(element.nodes.at(3)), origin)) / 6.0;
}

double Msh::content(const std::string& group) const {
  double sum = 0.0;
  for (const auto& element : of_group(group)) sum += content(element);
  return sum;
}

Msh parse_msh(const std::string& text) {
  Words words(text);
  Msh msh;
  words.expect("$MeshFormat");
  words.expect("2.2");
  words.expect("0");
  words.expect("8");
  words.expect("$EndMeshFormat");
  for (auto section = words.section(); !section.empty(); section = words.section()) {
    for (auto count = words.next<std::size_t>(); count > 0; --count) {
      if (section == "$PhysicalNames") {
        const auto dimension = words.next<int>(), number = words.next<int>();
        msh.groups[words.quoted()] = {dimension, number};
      } else if (section == "$Nodes") {
        auto& point = msh.nodes[words.next<std::size_t>()];
        for (double& x : point) x = words.next<double>();
      } else if (section == "$Elements") {
        msh.elements.push_back(read_element(words));
      } else if (section == "$Periodic") {
        msh.periodic.push_back(read_periodic(words));
      } else {
        throw std::runtime_error("msh: unknown section " + section);
      }
    }
    words.expect("$End" + section.substr(1));
  }
  return msh;
}

}  // namespace breccia::test
