#include "breccia/io/vtkhdf.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

namespace breccia {

namespace {

void check(const std::filesystem::path& path, const Lattice& lattice, const PointField& field) {
  const auto size = std::visit([](const auto& values) { return values.size(); }, field.values);
  const auto expected = lattice.nx * lattice.ny * field.components;
  if (field.components != 1 && field.components != 3 && field.components != 6) {
    throw InputError(fmt::format("{}: field {}: expected 1, 3 or 6 components, got {}", path.string(), field.name,
                                 field.components));
  }
  if (size != expected) {
    throw InputError(
        fmt::format("{}: field {}: expected {} values, got {}", path.string(), field.name, expected, size));
  }
}

}  // namespace

void write_vtkhdf(const std::filesystem::path& path, const Lattice& lattice, const std::vector<PointField>& fields) {
  for (const auto& field : fields) check(path, lattice, field);
  const auto last_x = static_cast<std::int64_t>(lattice.nx) - 1;
  const auto last_y = static_cast<std::int64_t>(lattice.ny) - 1;
  using Integers = std::vector<std::int64_t>;
  using Numbers = std::vector<double>;

  Hdf5Writer file(path);
  file.create_group("/VTKHDF");
  file.write_attribute("/VTKHDF", "Version", Integers{1, 0});
  file.write_attribute("/VTKHDF", "Type", "ImageData");
  file.write_attribute("/VTKHDF", "WholeExtent", Integers{0, last_x, 0, last_y, 0, 0});
  file.write_attribute("/VTKHDF", "Origin", Numbers{lattice.origin[0], lattice.origin[1], 0.0});
  file.write_attribute("/VTKHDF", "Spacing", Numbers{lattice.spacing, lattice.spacing, lattice.spacing});
  file.write_attribute("/VTKHDF", "Direction", Numbers{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  file.create_group("/VTKHDF/PointData");
  for (const auto& field : fields) {
    Hdf5Shape shape{1, lattice.ny, lattice.nx};
    if (field.components > 1) shape.push_back(field.components);
    std::visit([&](const auto& values) { file.write("/VTKHDF/PointData/" + field.name, values, shape); }, field.values);
  }
  file.commit();
}

}  // namespace breccia
