#pragma once

#include <initializer_list>
#include <span>

namespace breccia {

/// Throws InputError unless there are at least three data at times or frequencies that are positive and do not fall,
/// and all columns of values are positive and as long. `what` names the data in the message.
void require_fitted_data(std::span<const double> at, std::initializer_list<std::span<const double>> values,
                         const char* what);

}  // namespace breccia
