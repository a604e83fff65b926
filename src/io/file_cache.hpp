#pragma once

#include <map>
#include <memory>
#include <string>
#include <typeindex>
#include <utility>

namespace breccia {

/// A cache of objects that are made from the files that a deck names. The tasks of a sweep share it, so that each file
/// is read once and there is one copy of its content in memory.
class FileCache {
 public:
  /// The object that was kept under a key, which names the file and the kind of object; nullptr if there is none.
  template <class Made>
  [[nodiscard]] std::shared_ptr<const Made> find(const std::string& key) const {
    const auto kept = kept_.find({typeid(Made), key});
    return kept == kept_.end() ? nullptr : std::static_pointer_cast<const Made>(kept->second);
  }

  /// Keeps a value under a key and returns it.
  template <class Made>
  std::shared_ptr<const Made> keep(const std::string& key, Made made) {
    auto shared = std::make_shared<const Made>(std::move(made));
    kept_[{typeid(Made), key}] = shared;
    return shared;
  }

 private:
  std::map<std::pair<std::type_index, std::string>, std::shared_ptr<const void>> kept_;
};

}  // namespace breccia
