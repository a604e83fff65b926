#include "results/complex_columns.hpp"

#include <cmath>
#include <numbers>

#include "results/test_columns.hpp"

namespace breccia {

void ComplexColumns::add(const ComplexSample& sample) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  angular_frequencies_.push_back(sample.angular_frequency);
  frequencies_.push_back(sample.angular_frequency / (2.0 * std::numbers::pi));
  storage_.push_back(sample.storage);
  loss_.push_back(sample.loss);
  loss_tangents_.push_back(sample.loss / sample.storage);
  sizes_.push_back(std::hypot(sample.storage, sample.loss));
  phases_.push_back(degrees * std::atan2(sample.loss, sample.storage));
  errors_.push_back(text_if_known(sample.error));
}

void ComplexColumns::append_to(std::vector<CsvColumn>& table) const {
  table.insert(table.end(), {{"angular_frequency_rad_per_s", angular_frequencies_},
                             {"frequency_Hz", frequencies_},
                             {"storage_modulus_Pa", storage_},
                             {"loss_modulus_Pa", loss_},
                             {"loss_tangent", loss_tangents_},
                             {"absolute_modulus_Pa", sizes_},
                             {"phase_angle_deg", phases_},
                             {"error", errors_}});
}

}  // namespace breccia
