#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/text_file.hpp"

namespace breccia {

/// The value of an HDF5 attribute. Text is stored as a fixed-length ASCII string.
using Hdf5Attribute = std::variant<std::string, double, std::int64_t, std::vector<double>, std::vector<std::int64_t>>;

/// The extents of a dataset; the last index runs fastest.
using Hdf5Shape = std::vector<std::size_t>;

/// A handle of the HDF5 library that closes itself.
class Hdf5Handle {
 public:
  using Close = int (*)(std::int64_t);
  Hdf5Handle(std::int64_t id, Close close) noexcept : id_(id), close_(close) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  Hdf5Handle(Hdf5Handle&& other) noexcept;
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  ~Hdf5Handle() { reset(); }

  [[nodiscard]] std::int64_t id() const noexcept { return id_; }
  /// Closes the handle. Returns false if the library fails to close it.
  bool reset() noexcept;

 private:
  std::int64_t id_;
  Close close_;
};

/// Writes an HDF5 file, which gets its name when commit() is called. Objects have absolute names such as
/// "/history/time"; missing parent groups are created. All members throw FileError with file and object.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path& path);

  void create_group(const std::string& name);
  /// Writes a one-dimensional dataset.
  void write(const std::string& name, std::span<const double> values);
  void write(const std::string& name, std::span<const std::int64_t> values);
  /// Creates a dataset, to be filled by write_part(). The last index of the shape runs fastest through the values.
  /// `Number` is double or std::int64_t.
  template <class Number>
  void create(const std::string& name, const Hdf5Shape& shape);
  /// Creates a compressed dataset, whose numbers may also be float and std::uint8_t. A part that begins and ends at a
  /// multiple of 16384 of the first index, or at the end, is compressed once; other parts take longer.
  template <class Number>
  void create_compressed(const std::string& name, const Hdf5Shape& shape);
  /// Writes values of a dataset of this type, from a value of its first index on.
  template <class Number>
  void write_part(const std::string& name, std::size_t first, std::span<const Number> values);
  /// Adds an attribute to an existing group or dataset.
  void write_attribute(const std::string& object, const std::string& attribute, const Hdf5Attribute& value);
  /// Closes the file, which still has its temporary name.
  void close();
  [[nodiscard]] const std::filesystem::path& temporary() const noexcept { return target_.temporary(); }
  /// Closes the file if it is open, and gives it its name.
  void commit();

 private:
  /// `type` and `properties` are the HDF5 identifiers of the type and of the creation properties of the dataset.
  void create_raw(const std::string& name, std::int64_t type, const Hdf5Shape& shape, std::int64_t properties);
  [[noreturn]] void fail(std::string_view action, std::string_view object) const;

  AtomicFile target_;
  Hdf5Handle file_;
};

/// Reads an HDF5 file. All members throw FileError with file and object.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& attribute) const;
  /// The names of the objects in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const;
  [[nodiscard]] Hdf5Shape shape(const std::string& name) const;
  [[nodiscard]] std::vector<double> read_numbers(const std::string& name) const;
  /// Reads `count` entries of a dataset along its first index, from `first` on, each with all values of its further
  /// indices.
  [[nodiscard]] std::vector<double> read_numbers(const std::string& name, std::size_t first, std::size_t count) const;
  [[nodiscard]] std::vector<std::int64_t> read_integers(const std::string& name) const;
  [[nodiscard]] Hdf5Attribute read_attribute(const std::string& object, const std::string& attribute) const;

  /// An attribute of one of the types of Hdf5Attribute.
  template <class T>
  [[nodiscard]] T attribute(const std::string& object, const std::string& attribute_name) const {
    const auto value = read_attribute(object, attribute_name);
    if (const auto* typed = std::get_if<T>(&value)) return *typed;
    fail("read", object + " (attribute " + attribute_name + " has another type)");
  }

 private:
  void read_raw(const std::string& name, void* values, std::int64_t type) const;
  [[noreturn]] void fail(std::string_view action, std::string_view object) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace breccia
