#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "breccia/io/hdf5.hpp"

namespace breccia {

/// Which calculation a state belongs to. Another one is not to take it up.
struct StateOwner {
  std::string deck_hash;  ///< of what the deck says, seeds included, and its data files
  std::string version;    ///< of Breccia
};

/// Writes the state of a calculation, numbers under names such as "/domains/0/steps", to a file that appears whole,
/// with a checksum behind its last byte, or not at all. Of several processes the first writes; what the others say is
/// dropped. All members throw FileError.
class StateWriter {
 public:
  StateWriter(const std::filesystem::path& path, const StateOwner& owner);

  void write(const std::string& name, double value);
  void write(const std::string& name, std::int64_t value);
  void write(const std::string& name, std::span<const double> values);
  void write(const std::string& name, const std::string& text);

  /// Gives the file its name, once its bytes are on the disk. A file that has the name is kept as the older one.
  void commit();

 private:
  std::filesystem::path path_;
  std::optional<Hdf5Writer> file_;
};

/// Reads a state. All members throw FileError.
class StateReader {
 public:
  /// Throws FileError when there is no such file, or when it is torn or damaged or none of Breccia.
  explicit StateReader(const std::filesystem::path& path);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] const StateOwner& owner() const noexcept { return owner_; }
  [[nodiscard]] bool has(const std::string& name) const { return file_.has(name); }
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const { return file_.read_numbers(name); }
  /// Throws FileError, too, when there are not as many.
  [[nodiscard]] std::vector<double> numbers(const std::string& name, std::size_t count) const;
  [[nodiscard]] std::string text(const std::string& name) const;

 private:
  std::string path_;
  Hdf5Reader file_;
  StateOwner owner_;
};

/// What a calculation does to leave its state.
using WriteState = std::function<void(StateWriter&)>;

/// The name under which the state before the last one is kept.
std::filesystem::path older_state(const std::filesystem::path& path);

}  // namespace breccia
