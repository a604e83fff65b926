#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace breccia::quasistatic {

/// Linear forms of a few entries of a field each.
class LinearForms {
 public:
  /// Adds a part to the form that comes next.
  void add(std::size_t entry, double weight) { parts_.push_back({static_cast<std::uint32_t>(entry), weight}); }
  /// Ends that form.
  void end() { first_.push_back(parts_.size()); }

  [[nodiscard]] double of(std::size_t form, const double* field) const noexcept {
    double value = 0.0;
    for (auto part = first_[form]; part < first_[form + 1]; ++part)
      value += parts_[part].weight * field[parts_[part].entry];
    return value;
  }
  /// Adds a multiple of the weights of a form.
  void add_to(std::size_t form, double factor, double* field) const noexcept {
    for (auto part = first_[form]; part < first_[form + 1]; ++part)
      field[parts_[part].entry] += factor * parts_[part].weight;
  }
  /// Calls action(entry, weight) for the parts of a form.
  template <class Action>
  void for_parts(std::size_t form, const Action& action) const {
    for (auto part = first_[form]; part < first_[form + 1]; ++part) action(parts_[part].entry, parts_[part].weight);
  }

 private:
  struct Part {
    std::uint32_t entry;
    double weight;
  };
  std::vector<Part> parts_;
  std::vector<std::size_t> first_ = {0};  ///< first part by form
};

}  // namespace breccia::quasistatic
