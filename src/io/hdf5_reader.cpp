#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/hdf5_handle.hpp"

namespace breccia {

namespace {

Hdf5Handle open_file(const std::filesystem::path& path) {
  const Hdf5Silence silence;
  return file_handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
}

std::size_t value_count(const Hdf5Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

/// Reads an open attribute as numbers of type T: one for a scalar, otherwise a vector. False if it cannot be read.
template <class T>
bool read_numeric(const Hdf5Handle& attribute, hid_t type, Hdf5Attribute& value) {
  const auto space = space_handle(H5Aget_space(attribute.id()));
  const auto points = H5Sget_simple_extent_npoints(space.id());
  if (points < 0) return false;
  std::vector<T> numbers(static_cast<std::size_t>(points));
  if (H5Aread(attribute.id(), type, numbers.data()) < 0) return false;
  if (H5Sget_simple_extent_type(space.id()) == H5S_SCALAR) {
    value = numbers.at(0);
  } else {
    value = std::move(numbers);
  }
  return true;
}

bool read_string(const Hdf5Handle& attribute, const Hdf5Handle& type, Hdf5Attribute& value) {
  if (H5Tis_variable_str(type.id()) != 0) return false;
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), ascii_type(text.size()).id(), text.data()) < 0) return false;
  value = text.substr(0, text.find('\0'));
  return true;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path), file_(open_file(path)) {
  if (file_.id() < 0) fail("open", "it (missing, damaged or no HDF5 file)");
}

bool Hdf5Reader::has(const std::string& name) const {
  const Hdf5Silence silence;
  return object_handle(H5Oopen(file_.id(), name.c_str(), H5P_DEFAULT)).id() >= 0;
}

bool Hdf5Reader::has_attribute(const std::string& object, const std::string& attribute) const {
  const Hdf5Silence silence;
  return H5Aexists_by_name(file_.id(), object.c_str(), attribute.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::names(const std::string& group) const {
  const Hdf5Silence silence;
  const auto handle = group_handle(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT));
  if (handle.id() < 0) fail("open group", group);
  std::vector<std::string> found;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
  };
  if (H5Literate(handle.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &found) < 0) fail("list group", group);
  return found;
}

Hdf5Shape Hdf5Reader::shape(const std::string& name) const {
  const Hdf5Silence silence;
  const auto dataset = dataset_handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT));
  if (dataset.id() < 0) fail("open dataset", name);
  const auto space = space_handle(H5Dget_space(dataset.id()));
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 0) fail("read the shape of", name);
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
  return {extents.begin(), extents.end()};
}

std::vector<double> Hdf5Reader::read_numbers(const std::string& name) const {
  std::vector<double> values(value_count(shape(name)));
  read_raw(name, values.data(), H5T_NATIVE_DOUBLE);
  return values;
}

std::vector<double> Hdf5Reader::read_numbers(const std::string& name, std::size_t first, std::size_t count) const {
  auto extents = shape(name);
  if (extents.empty() || first + count > extents.front()) fail("find so many values in dataset", name);
  extents.front() = count;
  const std::vector<hsize_t> block(extents.begin(), extents.end());
  std::vector<hsize_t> begin(block.size(), 0);
  begin.front() = first;
  const Hdf5Silence silence;
  const auto dataset = dataset_handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT));
  if (dataset.id() < 0) fail("open dataset", name);
  const auto in_file = space_handle(H5Dget_space(dataset.id()));
  const auto in_memory = space_handle(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr));
  H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, begin.data(), nullptr, block.data(), nullptr);
  std::vector<double> values(value_count(extents));
  if (H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, in_memory.id(), in_file.id(), H5P_DEFAULT, values.data()) < 0) {
    fail("read dataset", name);
  }
  return values;
}

std::vector<std::int64_t> Hdf5Reader::read_integers(const std::string& name) const {
  std::vector<std::int64_t> values(value_count(shape(name)));
  read_raw(name, values.data(), H5T_NATIVE_INT64);
  return values;
}

void Hdf5Reader::read_raw(const std::string& name, void* values, std::int64_t type) const {
  const Hdf5Silence silence;
  const auto dataset = dataset_handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT));
  if (dataset.id() < 0) fail("open dataset", name);
  const auto stored = type_handle(H5Dget_type(dataset.id()));
  if (H5Tget_class(stored.id()) != H5Tget_class(type)) fail("read (it holds another type of number) dataset", name);
  if (H5Dread(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) fail("read dataset", name);
}

Hdf5Attribute Hdf5Reader::read_attribute(const std::string& object, const std::string& attribute) const {
  const Hdf5Silence silence;
  const auto owner = object_handle(H5Oopen(file_.id(), object.c_str(), H5P_DEFAULT));
  if (owner.id() < 0) fail("open", object);
  const auto handle = attribute_handle(H5Aopen(owner.id(), attribute.c_str(), H5P_DEFAULT));
  if (handle.id() < 0) fail(fmt::format("find attribute {} of", attribute), object);
  const auto type = type_handle(H5Aget_type(handle.id()));
  Hdf5Attribute value;
  bool done = false;
  switch (H5Tget_class(type.id())) {
    case H5T_STRING:
      done = read_string(handle, type, value);
      break;
    case H5T_FLOAT:
      done = read_numeric<double>(handle, H5T_NATIVE_DOUBLE, value);
      break;
    case H5T_INTEGER:
      done = read_numeric<std::int64_t>(handle, H5T_NATIVE_INT64, value);
      break;
    default:
      break;
  }
  if (!done) fail(fmt::format("read attribute {} of", attribute), object);
  return value;
}

void Hdf5Reader::fail(std::string_view action, std::string_view object) const {
  throw FileError(fmt::format("{}: cannot {} {}", path_.string(), action, object));
}

}  // namespace breccia
