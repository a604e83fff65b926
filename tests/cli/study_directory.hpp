#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/virtual_test/curve.hpp"

#include "command.hpp"
#include "temporary_directory.hpp"

namespace breccia::test {

/// A directory with `deck.toml`, and `out`, where its results go.
class StudyDirectory : public TemporaryDirectory {
 public:
  explicit StudyDirectory(std::string_view deck) { write("deck.toml", deck); }

  /// `breccia COMMAND deck.toml --out out --threads 1 MORE...`
  [[nodiscard]] Outcome breccia(const std::string& command, const std::vector<std::string>& more = {}) const;
  /// The arguments of that.
  [[nodiscard]] static std::vector<std::string> arguments(const std::string& command,
                                                          const std::vector<std::string>& more = {});
  /// A file of the results.
  [[nodiscard]] std::filesystem::path result(const std::string& name) const { return path() / "out" / name; }
  /// Names of all files under `out`, in alphabetical order.
  [[nodiscard]] std::vector<std::string> results() const;
};

/// The curve of a stage under a load in a file curves.csv.
Curve read_curve(const std::filesystem::path& curves, const std::string& stage, const std::string& load);

/// The same by one method.
Curve read_curve(const std::filesystem::path& curves, const std::string& stage, const std::string& load,
                 const std::string& method);

/// A curve between its samples, where it is taken as exponential.
double modulus_at(const Curve& curve, double time);

}  // namespace breccia::test
