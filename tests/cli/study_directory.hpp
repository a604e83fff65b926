#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/virtual_test/curve.hpp"

#include "command.hpp"
#include "temporary_directory.hpp"

namespace breccia::test {

/// A directory with `deck.toml`, and with `out` for the results.
class StudyDirectory : public TemporaryDirectory {
 public:
  explicit StudyDirectory(std::string_view deck) { write("deck.toml", deck); }

  /// Runs `breccia COMMAND deck.toml --out out --threads 1 MORE...`.
  [[nodiscard]] Outcome breccia(const std::string& command, const std::vector<std::string>& more = {}) const;
  /// The arguments of the command that breccia() runs.
  [[nodiscard]] static std::vector<std::string> arguments(const std::string& command,
                                                          const std::vector<std::string>& more = {});
  /// A file of the results.
  [[nodiscard]] std::filesystem::path result(const std::string& name) const { return path() / "out" / name; }
  /// Names of all files under `out`, in alphabetical order.
  [[nodiscard]] std::vector<std::string> results() const;
};

/// The curve of a stage under a load in a file curves.csv.
Curve read_curve(const std::filesystem::path& curves, const std::string& stage, const std::string& load);

/// The curve of a stage under a load and by one method in a file curves.csv.
Curve read_curve(const std::filesystem::path& curves, const std::string& stage, const std::string& load,
                 const std::string& method);

/// The value of a curve at a time [s], with exponential interpolation between its samples.
double modulus_at(const Curve& curve, double time);

}  // namespace breccia::test
