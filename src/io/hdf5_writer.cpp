#include <algorithm>
#include <cerrno>
#include <functional>
#include <numeric>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

#include "hdf5_handle.hpp"

namespace breccia {

namespace {

/// Address, count and type of an attribute's value for HDF5.
struct AttributeLayout {
  Hdf5Handle type;
  Hdf5Handle space;
  const void* data;
};

Hdf5Handle scalar() {
  return space_handle(H5Screate(H5S_SCALAR));
}

Hdf5Handle row(std::size_t length) {
  const hsize_t extent = length;
  return space_handle(H5Screate_simple(1, &extent, nullptr));
}

struct LayOut {
  AttributeLayout operator()(const std::string& text) const {
    return {ascii_type(std::max<std::size_t>(text.size(), 1)), scalar(), text.c_str()};
  }
  AttributeLayout operator()(const double& number) const {
    return {type_handle(H5Tcopy(H5T_NATIVE_DOUBLE)), scalar(), &number};
  }
  AttributeLayout operator()(const std::int64_t& number) const {
    return {type_handle(H5Tcopy(H5T_NATIVE_INT64)), scalar(), &number};
  }
  AttributeLayout operator()(const std::vector<double>& numbers) const {
    return {type_handle(H5Tcopy(H5T_NATIVE_DOUBLE)), row(numbers.size()), numbers.data()};
  }
  AttributeLayout operator()(const std::vector<std::int64_t>& numbers) const {
    return {type_handle(H5Tcopy(H5T_NATIVE_INT64)), row(numbers.size()), numbers.data()};
  }
};

Hdf5Handle create_file(const std::filesystem::path& path) {
  const Hdf5Silence silence;
  errno = 0;
  return file_handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
}

/// Creation properties of datasets without time stamps, so that the same numbers give the same bytes.
Hdf5Handle dataset_properties() {
  auto properties = property_handle(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(properties.id(), false);
  return properties;
}

}  // namespace

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  if (this != &other) {
    reset();
    id_ = std::exchange(other.id_, -1);
    close_ = other.close_;
  }
  return *this;
}

bool Hdf5Handle::reset() noexcept {
  const Hdf5Silence silence;
  const auto id = std::exchange(id_, -1);
  return id < 0 || close_(id) >= 0;
}

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path) : target_(path), file_(create_file(target_.temporary())) {
  if (file_.id() < 0) fail("create", fmt::format("the file: {}", std::generic_category().message(errno)));
}

void Hdf5Writer::create_group(const std::string& name) {
  const Hdf5Silence silence;
  const auto links = property_handle(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.id(), 1);
  const auto group = group_handle(H5Gcreate2(file_.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT));
  if (group.id() < 0) fail("create group", name);
}

void Hdf5Writer::write(const std::string& name, std::span<const double> values, const Hdf5Shape& shape) {
  write_raw(name, values.data(), values.size(), H5T_NATIVE_DOUBLE, shape, dataset_properties().id());
}

void Hdf5Writer::write(const std::string& name, std::span<const std::int64_t> values, const Hdf5Shape& shape) {
  write_raw(name, values.data(), values.size(), H5T_NATIVE_INT64, shape, dataset_properties().id());
}

void Hdf5Writer::write_compressed(const std::string& name, std::span<const double> values, const Hdf5Shape& shape) {
  write_in_chunks(name, values.data(), values.size(), H5T_NATIVE_DOUBLE, shape);
}

void Hdf5Writer::write_compressed(const std::string& name, std::span<const float> values, const Hdf5Shape& shape) {
  write_in_chunks(name, values.data(), values.size(), H5T_NATIVE_FLOAT, shape);
}

void Hdf5Writer::write_compressed(const std::string& name, std::span<const std::int64_t> values,
                                  const Hdf5Shape& shape) {
  write_in_chunks(name, values.data(), values.size(), H5T_NATIVE_INT64, shape);
}

void Hdf5Writer::write_compressed(const std::string& name, std::span<const std::uint8_t> values,
                                  const Hdf5Shape& shape) {
  write_in_chunks(name, values.data(), values.size(), H5T_NATIVE_UINT8, shape);
}

void Hdf5Writer::write_in_chunks(const std::string& name, const void* values, std::size_t count, std::int64_t type,
                                 const Hdf5Shape& shape) {
  const Hdf5Silence silence;
  constexpr hsize_t longest = 16384;
  std::vector<hsize_t> chunk;
  for (const auto extent : shape) chunk.push_back(std::clamp<hsize_t>(extent, 1, longest));
  const auto properties = dataset_properties();
  H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(properties.id());
  constexpr unsigned effort = 4;
  H5Pset_deflate(properties.id(), effort);
  write_raw(name, values, count, type, shape, properties.id());
}

void Hdf5Writer::write(const std::string& name, std::span<const double> values) {
  write(name, values, {values.size()});
}

void Hdf5Writer::write(const std::string& name, std::span<const std::int64_t> values) {
  write(name, values, {values.size()});
}

void Hdf5Writer::write_raw(const std::string& name, const void* values, std::size_t count, std::int64_t type,
                           const Hdf5Shape& shape, std::int64_t properties) {
  const Hdf5Silence silence;
  const auto capacity = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
  if (capacity != count) fail(fmt::format("fill a shape of {} with {} values:", capacity, count), name);
  const std::vector<hsize_t> extents(shape.begin(), shape.end());
  const auto space = space_handle(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr));
  const auto links = property_handle(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.id(), 1);
  const auto dataset =
      dataset_handle(H5Dcreate2(file_.id(), name.c_str(), type, space.id(), links.id(), properties, H5P_DEFAULT));
  if (dataset.id() < 0) fail("create dataset", name);
  if (H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) fail("write dataset", name);
}

void Hdf5Writer::write_attribute(const std::string& object, const std::string& attribute, const Hdf5Attribute& value) {
  const Hdf5Silence silence;
  const auto owner = object_handle(H5Oopen(file_.id(), object.c_str(), H5P_DEFAULT));
  if (owner.id() < 0) fail("attach an attribute to", object);
  const auto layout = std::visit(LayOut(), value);
  const auto handle = attribute_handle(
      H5Acreate2(owner.id(), attribute.c_str(), layout.type.id(), layout.space.id(), H5P_DEFAULT, H5P_DEFAULT));
  if (handle.id() < 0 || H5Awrite(handle.id(), layout.type.id(), layout.data) < 0) {
    fail(fmt::format("write attribute {} of", attribute), object);
  }
}

void Hdf5Writer::close() {
  errno = 0;
  if (!file_.reset()) fail("write", fmt::format("all of it: {}", std::generic_category().message(errno)));
}

void Hdf5Writer::commit() {
  close();
  target_.commit();
}

void Hdf5Writer::fail(std::string_view action, std::string_view object) const {
  throw FileError(fmt::format("{}: cannot {} {}", target_.path().string(), action, object));
}

}  // namespace breccia
