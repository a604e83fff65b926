#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

/// The label of all pixels that have one value.
struct ValueLabel {
  std::int32_t value;  ///< value in the image, such as a grey level
  Label label;         ///< number of the phase
};

/// The contradictions between the values of an image and the table of labels, a line each; empty if there are none:
/// - all values without a label, with the number of their pixels and its share (the ten most frequent values);
/// - each value that is in the table twice;
/// - each value of the table that no pixel has. This is an error, not a warning: values are typed by hand, and a phase
///   that is left out because of a wrong digit would change the result unnoticed.
[[nodiscard]] std::vector<std::string> label_mistakes(std::span<const std::int32_t> values,
                                                      std::span<const ValueLabel> table);

/// The labels of the pixels with these values. Throws InputError with the mistakes above.
[[nodiscard]] std::vector<Label> pixel_labels(std::span<const std::int32_t> values, std::span<const ValueLabel> table);

}  // namespace breccia
