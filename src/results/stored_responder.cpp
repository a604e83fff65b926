#include "breccia/results/stored_responder.hpp"

#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/stored_composite.hpp"
#include "results/stored_document.hpp"
#include "results/stored_responses.hpp"

namespace breccia {

Responder read_responder(const std::filesystem::path& directory) {
  require_stored_study(directory);
  const auto document = read_study_document(directory);
  auto stages = read_stored_responses(directory, document);
  if (stages.empty()) {
    throw InputError(fmt::format(
        "{}: no stage with a response.h5, which `breccia run` leaves for tests by the quasi-static method with "
        "the reduced solver; where it is missing, resume the run, which computes it again",
        directory.string()));
  }
  return Responder(std::move(stages), materials_of(document));
}

}  // namespace breccia
