#include "rasters/hdf5_raster.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "io/hdf5_handle.hpp"
#include "io/nearest_name.hpp"
#include "io/printable.hpp"
#include "rasters/raster_elements.hpp"
#include "rasters/raster_layout.hpp"

namespace breccia {

namespace {

/// The library's own message about the failure of its last call.
std::string hdf5_reason() {
  std::string reason;
  const auto take_first = [](unsigned depth, const H5E_error2_t* error, void* to) -> herr_t {
    if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(to) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &reason);
  return reason.empty() ? "it cannot be read" : printable(reason);
}

[[noreturn]] void refuse_damaged_hdf5(const std::filesystem::path& file) {
  throw InputError(fmt::format("{}: a damaged HDF5 file: {}", file.string(), hdf5_reason()));
}

std::vector<std::size_t> dataset_shape(const Hdf5Handle& dataset) {
  const auto space = space_handle(H5Dget_space(dataset.id()));
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(rank, 0)));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  return {shape.begin(), shape.end()};
}

bool is_dataset(const Hdf5Handle& file, const std::string& name) {
  const auto object = object_handle(H5Oopen(file.id(), name.c_str(), H5P_DEFAULT));
  return object.id() >= 0 && H5Iget_type(object.id()) == H5I_DATASET;
}

/// The names of all data sets of the file.
std::vector<std::string> dataset_names(const std::filesystem::path& path, const Hdf5Handle& file) {
  std::vector<std::string> links;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->push_back(fmt::format("/{}", name));
    return 0;
  };
  if (H5Lvisit(file.id(), H5_INDEX_NAME, H5_ITER_INC, collect, &links) < 0) refuse_damaged_hdf5(path);
  std::erase_if(links, [&](const std::string& name) { return !is_dataset(file, name); });
  return links;
}

/// The data set of this name or, without a name, the only data set.
std::string chosen_dataset(const std::filesystem::path& path, const Hdf5Handle& file, const std::string& name) {
  if (!name.empty() && is_dataset(file, name)) return name;
  constexpr std::size_t most_listed = 10;
  auto names = dataset_names(path, file);
  if (name.empty() && names.size() == 1) return names.front();
  if (!name.empty()) {
    throw InputError(
        fmt::format("{}: no data set {}{}", path.string(), shown_value(name), printable(suggestion(name, names))));
  }
  const auto count = names.size();
  names.resize(std::min(count, most_listed));
  throw InputError(fmt::format("{}: {} data sets; expected the name of one{}{}{}", path.string(), count,
                               names.empty() ? "" : ": ", printable(fmt::format("{}", fmt::join(names, ", "))),
                               count > most_listed ? ", ..." : ""));
}

/// The type of the numbers of a data set in memory.
ElementType element_type(const std::filesystem::path& file, const std::string& name, const Hdf5Handle& native) {
  using enum ElementType::Kind;
  const auto size = H5Tget_size(native.id());
  switch (H5Tget_class(native.id())) {
    case H5T_INTEGER:
      return {H5Tget_sign(native.id()) == H5T_SGN_NONE ? unsigned_integer : signed_integer, size};
    case H5T_ENUM:  // booleans of h5py
      return {signed_integer, size};
    case H5T_BITFIELD:  // booleans of PyTables
      return {unsigned_integer, size};
    case H5T_FLOAT:
      if (size <= sizeof(double)) return {floating_point, size};
      break;
    default:
      break;
  }
  throw InputError(fmt::format("{}: the data set {} holds no numbers, or too long ones; expected integers",
                               file.string(), shown_value(name)));
}

/// MATLAB stores arrays column by column: the last index of the data set counts rows.
bool is_from_matlab(const Hdf5Handle& dataset) {
  return H5Aexists(dataset.id(), "MATLAB_class") > 0;
}

/// Values row by row, from values that are column by column in each layer. The extents are those of the file.
std::vector<std::int32_t> with_columns_as_rows(const std::vector<std::int32_t>& values,
                                               std::span<const std::size_t> extents) {
  const auto height = extents[0], width = extents[1], layer = width * height;
  std::vector<std::int32_t> turned(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto row = i % height, column = i / height % width;
    turned[i / layer * layer + row * width + column] = values[i];
  }
  return turned;
}

}  // namespace

Raster read_hdf5_raster(const std::filesystem::path& path, const std::string& array) {
  const Hdf5Silence silence;
  const auto file = file_handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (file.id() < 0) refuse_damaged_hdf5(path);
  const auto name = chosen_dataset(path, file, array);
  const auto dataset = dataset_handle(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT));
  if (dataset.id() < 0) refuse_damaged_hdf5(path);
  const auto stored = type_handle(H5Dget_type(dataset.id()));
  const auto native = type_handle(H5Tget_native_type(stored.id(), H5T_DIR_ASCEND));
  if (native.id() < 0) refuse_damaged_hdf5(path);
  const auto type = element_type(path, name, native);

  auto extents = extents_of_array(path, dataset_shape(dataset));
  const auto pixels = pixel_count(path, extents);
  require_plausible_size(path, pixels * type.bytes, std::filesystem::file_size(path));
  std::string bytes(pixels * type.bytes, '\0');
  if (H5Dread(dataset.id(), native.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) refuse_damaged_hdf5(path);
  std::vector<std::int32_t> values;
  values.reserve(pixels);
  append_elements(values, path, bytes, type);
  if (is_from_matlab(dataset)) {
    values = with_columns_as_rows(values, extents);
    std::swap(extents[0], extents[1]);
  }
  return raster_from_top(std::move(extents), std::move(values));
}

}  // namespace breccia
