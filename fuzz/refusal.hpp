#pragma once

#include <stdexcept>
#include <string_view>

#include "breccia/error.hpp"

namespace breccia::fuzz {

/// Runs a reader, which may refuse its input by InputError or FileError. Any other exception is passed on, so that the
/// fuzzer finds it.
template <class Read>
void allow_refusal(const Read& read) {
  const auto require_reason = [](const Error& error) {
    if (std::string_view(error.what()).empty()) throw std::logic_error("refused without a reason");
  };
  try {
    read();
  } catch (const InputError& error) {
    require_reason(error);
  } catch (const FileError& error) {
    require_reason(error);
  }
}

}  // namespace breccia::fuzz
