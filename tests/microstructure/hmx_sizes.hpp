#pragma once

#include "breccia/microstructure/size_distribution.hpp"

namespace breccia::test {

/// The HMX of PBX-9501: three parts by volume of coarse grains to one of fine grains.
inline SizeDistribution hmx() {
  return SizeDistribution::lognormal_mixture({{3.0, 154e-6, 0.76}, {1.0, 12.7e-6, 1.09}});
}

}  // namespace breccia::test
