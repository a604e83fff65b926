#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

/// What the pixels of one value are.
struct ValueLabel {
  std::int32_t value;  ///< in the image, such as a grey level
  Label label;         ///< number of the phase
};

/// What is wrong between the values of an image and the table of labels, a line each; empty if nothing is:
/// - all values without a label, with the number of their pixels and its share (the ten most frequent values);
/// - each value that stands in the table twice;
/// - each value of the table that no pixel has. It is an error and no warning: values are typed by hand, and a phase
///   that is left out by a wrong digit would change the result without being seen.
[[nodiscard]] std::vector<std::string> label_mistakes(std::span<const std::int32_t> values,
                                                      std::span<const ValueLabel> table);

/// The label of each value. Throws InputError with the mistakes above.
[[nodiscard]] std::vector<Label> pixel_labels(std::span<const std::int32_t> values, std::span<const ValueLabel> table);

}  // namespace breccia
