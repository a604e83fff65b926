#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "breccia/parallel/ordered_values.hpp"

#include "io/hdf5.hpp"

namespace breccia {

/// The calculation to which a state belongs. No other calculation may be resumed from it.
struct StateOwner {
  std::string deck_hash;  ///< hash of the deck's content, seeds included, and of its data files
  std::string version;    ///< version of Breccia
};

/// Writes the state of a calculation, numbers under names such as "/domains/0/steps", to a file with a checksum at its
/// end. The file gets its name only when it is complete. On several processes only the first one writes; calls on the
/// others only send it their part. Between these calls the processes may gather values, so that none may stop alone:
/// errors are thrown by commit().
class StateWriter {
 public:
  StateWriter(const std::filesystem::path& path, const StateOwner& owner);

  void write(const std::string& name, double value);
  void write(const std::string& name, std::int64_t value);
  void write(const std::string& name, std::span<const double> values);
  void write(const std::string& name, const std::string& text);
  /// Writes `count` values, of which each process has a part, in an order that does not depend on the number of
  /// processes. The first process receives them piece by piece. Every process must call the function.
  void write(const std::string& name, std::span<const double> own, const parallel::OrderedPlaces& places,
             std::size_t count);

  /// Gives the complete file its name. An existing file of that name is kept under older_state(). Throws FileError,
  /// also for earlier writes that failed.
  void commit();

 private:
  template <class Action>
  void attempt(const Action& action);

  std::filesystem::path path_;
  std::optional<Hdf5Writer> file_;
  std::exception_ptr failure_;  ///< the first failure to write
};

/// Reads the state of a calculation. All members throw FileError.
class StateReader {
 public:
  /// Throws FileError when the file is missing, incomplete, damaged or not a state that Breccia has written.
  explicit StateReader(const std::filesystem::path& path);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] const StateOwner& owner() const noexcept { return owner_; }
  [[nodiscard]] bool has(const std::string& name) const { return file_.has(name); }
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const { return file_.read_numbers(name); }
  /// The numbers of this name. Throws FileError also when there are not `count` of them.
  [[nodiscard]] std::vector<double> numbers(const std::string& name, std::size_t count) const;
  /// Reads the values of this process among `count` values of all.
  void read(const std::string& name, std::span<double> own, const parallel::OrderedPlaces& places,
            std::size_t count) const;
  [[nodiscard]] std::string text(const std::string& name) const;

 private:
  void require_count(const std::string& name, std::size_t expected, std::size_t found) const;

  std::string path_;
  Hdf5Reader file_;
  StateOwner owner_;
};

/// Function by which a calculation writes its state.
using WriteState = std::function<void(StateWriter&)>;

/// The path under which the last but one state is kept.
std::filesystem::path older_state(const std::filesystem::path& path);

}  // namespace breccia
