#include "results/meshes/stl_file.hpp"

#include <bit>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

using Place = std::array<float, 3>;

/// Appends the bytes of a number, the lowest first.
void append(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>((number >> shift) & 0xffU));
}

void append(std::string& bytes, const Place& place) {
  for (const float x : place) append(bytes, std::bit_cast<std::uint32_t>(x));
}

Place place_of(const Vector<3>& point, double scale) {
  Place place{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) place[axis] = static_cast<float>(scale * point[axis]);
  return place;
}

/// The normal of a triangle, of length 1; zeros where the triangle has no area.
Place normal_of(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
  const auto u = b - a, v = c - a;
  const Vector<3> product = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = norm(product);
  return length > 0.0 ? place_of(product, 1.0 / length) : Place{};
}

constexpr std::size_t header_bytes = 80;

}  // namespace

StlFile::StlFile(std::filesystem::path path, std::string_view header, double scale)
    : file_(std::move(path)), stream_(file_.temporary(), std::ios::binary), scale_(scale) {
  std::string bytes(header.substr(0, header_bytes));
  bytes.resize(header_bytes, ' ');
  append(bytes, 0U);  // number of triangles, which commit() writes
  stream_.write(bytes.data(), std::ssize(bytes));
  if (!stream_) throw FileError(fmt::format("{}: cannot write", file_.path().string()));
}

void StlFile::add(const ClosedSurface& surface) {
  std::string bytes;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto &first = surface.corners[a], &second = surface.corners[b], &third = surface.corners[c];
    const auto one = place_of(first, scale_), two = place_of(second, scale_), three = place_of(third, scale_);
    if (one == two || two == three || three == one) continue;
    append(bytes, normal_of(first, second, third));
    for (const auto& place : {one, two, three}) append(bytes, place);
    bytes.append(2, '\0');
    ++triangles_;
  }
  stream_.write(bytes.data(), std::ssize(bytes));
  if (!stream_) throw FileError(fmt::format("{}: cannot write", file_.path().string()));
  if (triangles_ > std::numeric_limits<std::uint32_t>::max()) {
    throw FileError(fmt::format("{}: more triangles than the format can count", file_.path().string()));
  }
}

void StlFile::commit() {
  std::string count;
  append(count, static_cast<std::uint32_t>(triangles_));
  stream_.seekp(header_bytes);
  stream_.write(count.data(), std::ssize(count));
  stream_.close();
  if (!stream_) throw FileError(fmt::format("{}: cannot write", file_.path().string()));
  file_.commit();
}

}  // namespace breccia
