#include "breccia/checkpoint/state.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/seal.hpp"
#include "breccia/parallel/session.hpp"

namespace breccia {
namespace {

std::filesystem::path sealed(const std::filesystem::path& path) {
  require_sealed(path);
  return path;
}

}  // namespace

std::filesystem::path older_state(const std::filesystem::path& path) {
  auto older = path;
  return older.replace_extension(fmt::format(".older{}", path.extension().string()));
}

StateWriter::StateWriter(const std::filesystem::path& path, const StateOwner& owner) : path_(path) {
  if (parallel::rank() != 0) return;
  attempt([&] {
    file_.emplace(path);
    file_->write_attribute("/", "program", std::string("breccia"));
    file_->write_attribute("/", "version", owner.version);
    file_->write_attribute("/", "deck_hash", owner.deck_hash);
  });
}

/// Keeps the failure of an action for commit(), and leaves out what would be written after it.
template <class Action>
void StateWriter::attempt(const Action& action) {
  try {
    action();
  } catch (const FileError&) {
    failure_ = std::current_exception();
    file_.reset();
  }
}

void StateWriter::write(const std::string& name, double value) {
  write(name, std::span<const double>(&value, 1));
}

void StateWriter::write(const std::string& name, std::int64_t value) {
  if (file_) attempt([&] { file_->write(name, std::span(&value, 1)); });
}

void StateWriter::write(const std::string& name, std::span<const double> values) {
  if (file_) attempt([&] { file_->write(name, values); });
}

void StateWriter::write(const std::string& name, const std::string& text) {
  if (!file_) return;
  attempt([&] {
    file_->create_group(name);
    file_->write_attribute(name, "text", text);
  });
}

void StateWriter::commit() {
  if (failure_) std::rethrow_exception(failure_);
  if (!file_) return;
  file_->close();
  seal(file_->temporary());
  std::error_code is_new;
  std::filesystem::rename(path_, older_state(path_), is_new);
  file_->commit();
}

StateReader::StateReader(const std::filesystem::path& path) : path_(path.string()), file_(sealed(path)) {
  owner_ = {file_.attribute<std::string>("/", "deck_hash"), file_.attribute<std::string>("/", "version")};
}

double StateReader::number(const std::string& name) const {
  return numbers(name, 1).front();
}

std::int64_t StateReader::integer(const std::string& name) const {
  const auto values = file_.read_integers(name);
  if (values.size() != 1) throw FileError(fmt::format("{}: expected one number as {}", path_, name));
  return values.front();
}

std::vector<double> StateReader::numbers(const std::string& name, std::size_t count) const {
  auto values = numbers(name);
  if (values.size() != count) {
    throw FileError(fmt::format("{}: expected {} numbers as {}, got {}", path_, count, name, values.size()));
  }
  return values;
}

std::string StateReader::text(const std::string& name) const {
  return file_.attribute<std::string>(name, "text");
}

}  // namespace breccia
