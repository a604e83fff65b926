#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace breccia {

/// A location in a deck, by line and column, or on the command line.
struct Location {
  std::string option;  ///< option on the command line, such as `--set key.path=value` (ValueOrigins); empty for a
                       ///< location in the deck
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// The names, in messages, of the sources of values that do not come from the deck. Each front end has its own.
struct ValueOrigins {
  std::string overrides = "--set";     ///< name of an override `key.path=value`
  std::string sweep_keys = "--sweep";  ///< name of a swept key `key.path=[value, ...]`
};

/// A mistake and its location.
struct Mistake {
  Location location;
  std::string message;
};

/// Throws one InputError with all mistakes in a deck, each once, in the order of the deck's lines:
/// `pbx9501.toml:14:9: materials.binder.bulk: expected a pressure, got "3.6 um"`.
void refuse_mistakes(const std::filesystem::path& deck, std::vector<Mistake> mistakes);

/// A value of a deck that is neither an array nor a table.
using Scalar = std::variant<bool, std::int64_t, double, std::string>;

/// The text of a value as it is written in a deck: `"3.6 GPa"`, `1.0`, `true`.
std::string toml_text(const Scalar& value);

/// The text of a value as it is written in a CSV file: `3.6 GPa`, `1`, `true`.
std::string plain_text(const Scalar& value);

/// A value with its location.
struct LocatedScalar {
  Scalar value;
  Location location;
};

/// A value for a key of a deck, and the locations of both.
struct Setting {
  std::string path;  ///< path of the key, as in `--set`
  Location path_location;
  LocatedScalar value;
};

/// The steps of a dotted path; a step in double quotes may contain dots. Returns nothing when a step is empty or there
/// are more than a hundred steps.
std::optional<std::vector<std::string>> split_path(std::string_view path);

}  // namespace breccia
