#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "io/text_file.hpp"
#include "results/meshes/closed_surface.hpp"

namespace breccia {

/// A binary STL file. It has numbers of single precision; a triangle two of whose corners are equal then is left out,
/// by which a closed surface stays closed.
class StlFile {
 public:
  /// `scale` is the number of units of the file in a metre. The file begins with `header`, of which 80 bytes are kept.
  /// Throws FileError.
  StlFile(std::filesystem::path path, std::string_view header, double scale);

  /// Adds a surface. Throws FileError, also where the file has more triangles than the format can count.
  void add(const ClosedSurface& surface);
  [[nodiscard]] std::size_t triangles() const noexcept { return triangles_; }
  /// Gives the complete file its name. Throws FileError.
  void commit();

 private:
  AtomicFile file_;
  std::ofstream stream_;
  double scale_;
  std::size_t triangles_ = 0;
};

}  // namespace breccia
