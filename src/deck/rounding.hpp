#pragma once

namespace breccia {

/// A number rounded as a user would write it, to 12 significant digits: 0.6, not 0.6000000000000001.
double as_typed(double value);

}  // namespace breccia
