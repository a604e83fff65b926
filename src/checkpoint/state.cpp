#include "checkpoint/state.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/seal.hpp"
#include "parallel/session.hpp"

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

/// Runs an action and keeps its failure for commit(); after a failure actions are left out.
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

void StateWriter::write(const std::string& name, std::span<const double> own, const parallel::OrderedPlaces& places,
                        std::size_t count) {
  if (file_) attempt([&] { file_->create<double>(name, {count}); });
  parallel::for_each_piece(count, [&](std::size_t begin, std::size_t end) {
    const auto piece = parallel::collect(own, places, begin, end);
    if (file_) attempt([&] { file_->write_part(name, begin, std::span(piece)); });
  });
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
  require_count(name, count, values.size());
  return values;
}

void StateReader::read(const std::string& name, std::span<double> own, const parallel::OrderedPlaces& places,
                       std::size_t count) const {
  const auto shape = file_.shape(name);
  require_count(name, count, shape.empty() ? 1 : shape.front());
  parallel::for_each_piece(count, [&](std::size_t begin, std::size_t end) {
    const auto from = places.before(begin), to = places.before(end);
    if (from == to) return;
    const auto values = file_.read_numbers(name, begin, end - begin);
    for (auto i = from; i < to; ++i) own[i] = values[places.place_of(i) - begin];
  });
}

void StateReader::require_count(const std::string& name, std::size_t expected, std::size_t found) const {
  if (found == expected) return;
  throw FileError(fmt::format("{}: expected {} numbers as {}, got {}", path_, expected, name, found));
}

std::string StateReader::text(const std::string& name) const {
  return file_.attribute<std::string>(name, "text");
}

}  // namespace breccia
