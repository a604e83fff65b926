#include <algorithm>
#include <cerrno>
#include <functional>
#include <numeric>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/hdf5_handle.hpp"

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

template <class Number>
hid_t type_of() {
  if constexpr (std::is_same_v<Number, double>) {
    return H5T_NATIVE_DOUBLE;
  } else if constexpr (std::is_same_v<Number, float>) {
    return H5T_NATIVE_FLOAT;
  } else if constexpr (std::is_same_v<Number, std::int64_t>) {
    return H5T_NATIVE_INT64;
  } else {
    static_assert(std::is_same_v<Number, std::uint8_t>);
    return H5T_NATIVE_UINT8;
  }
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

void Hdf5Writer::write(const std::string& name, std::span<const double> values) {
  create<double>(name, {values.size()});
  write_part(name, 0, values);
}

void Hdf5Writer::write(const std::string& name, std::span<const std::int64_t> values) {
  create<std::int64_t>(name, {values.size()});
  write_part(name, 0, values);
}

template <class Number>
void Hdf5Writer::create(const std::string& name, const Hdf5Shape& shape) {
  create_raw(name, type_of<Number>(), shape, dataset_properties().id());
}

template <class Number>
void Hdf5Writer::create_compressed(const std::string& name, const Hdf5Shape& shape) {
  const Hdf5Silence silence;
  constexpr hsize_t longest = 16384;
  std::vector<hsize_t> chunk;
  for (const auto extent : shape) chunk.push_back(std::clamp<hsize_t>(extent, 1, longest));
  const auto properties = dataset_properties();
  H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(properties.id());
  constexpr unsigned effort = 4;
  H5Pset_deflate(properties.id(), effort);
  create_raw(name, type_of<Number>(), shape, properties.id());
}

void Hdf5Writer::create_raw(const std::string& name, std::int64_t type, const Hdf5Shape& shape,
                            std::int64_t properties) {
  const Hdf5Silence silence;
  const std::vector<hsize_t> extents(shape.begin(), shape.end());
  const auto space = space_handle(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr));
  const auto links = property_handle(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.id(), 1);
  const auto dataset =
      dataset_handle(H5Dcreate2(file_.id(), name.c_str(), type, space.id(), links.id(), properties, H5P_DEFAULT));
  if (dataset.id() < 0) fail("create dataset", name);
}

template <class Number>
void Hdf5Writer::write_part(const std::string& name, std::size_t first, std::span<const Number> values) {
  const Hdf5Silence silence;
  const auto dataset = dataset_handle(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT));
  if (dataset.id() < 0) fail("open dataset", name);
  const auto in_file = space_handle(H5Dget_space(dataset.id()));
  std::vector<hsize_t> part(static_cast<std::size_t>(H5Sget_simple_extent_ndims(in_file.id())));
  H5Sget_simple_extent_dims(in_file.id(), part.data(), nullptr);
  const auto all = part.front();
  const auto each = std::accumulate(part.begin() + 1, part.end(), hsize_t{1}, std::multiplies<>());
  part.front() = values.size() / each;
  if (part.front() * each != values.size() || first + part.front() > all) {
    fail(fmt::format("put {} values, of {} each and from {} on, into the {} of", values.size(), each, first, all),
         name);
  }
  if (values.empty()) return;
  std::vector<hsize_t> begin(part.size(), 0);
  begin.front() = first;
  const auto in_memory = space_handle(H5Screate_simple(static_cast<int>(part.size()), part.data(), nullptr));
  H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, begin.data(), nullptr, part.data(), nullptr);
  if (H5Dwrite(dataset.id(), type_of<Number>(), in_memory.id(), in_file.id(), H5P_DEFAULT, values.data()) < 0) {
    fail("write dataset", name);
  }
}

template void Hdf5Writer::create<double>(const std::string&, const Hdf5Shape&);
template void Hdf5Writer::create<std::int64_t>(const std::string&, const Hdf5Shape&);
template void Hdf5Writer::create_compressed<double>(const std::string&, const Hdf5Shape&);
template void Hdf5Writer::create_compressed<float>(const std::string&, const Hdf5Shape&);
template void Hdf5Writer::create_compressed<std::int64_t>(const std::string&, const Hdf5Shape&);
template void Hdf5Writer::create_compressed<std::uint8_t>(const std::string&, const Hdf5Shape&);
template void Hdf5Writer::write_part(const std::string&, std::size_t, std::span<const double>);
template void Hdf5Writer::write_part(const std::string&, std::size_t, std::span<const float>);
template void Hdf5Writer::write_part(const std::string&, std::size_t, std::span<const std::int64_t>);
template void Hdf5Writer::write_part(const std::string&, std::size_t, std::span<const std::uint8_t>);

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
