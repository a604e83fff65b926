#include "properties/random_composite.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "breccia/microstructure/packing.hpp"

namespace breccia::test {

namespace {

using Random = std::mt19937_64;

/// A random number between 0 and 1, which is the same with every standard library.
double share(Random& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

double between(double low, double high, Random& random) {
  return low + share(random) * (high - low);
}

/// A random number between two values, uniform in its logarithm.
double over_decades(double low, double high, Random& random) {
  return low * std::pow(high / low, share(random));
}

/// A box of discs that fill about 0.2 to 0.55 of it.
Microstructure<2> random_box(Random& random) {
  PackingRequest request;
  request.side = 2e-3;
  request.walls = random() % 2 == 0 ? Walls::hard : Walls::periodic;
  request.seed = random();
  request.minimum_gap = 0.01 * request.side;
  const double fraction = between(0.2, 0.55, random);
  const auto count = 2 + random() % 6;
  double area = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    request.diameters.push_back(between(0.5, 1.0, random));
    area += std::numbers::pi / 4.0 * request.diameters.back() * request.diameters.back();
  }
  const double scale = request.side * std::sqrt(fraction / area);
  for (double& diameter : request.diameters) diameter *= scale;
  return {request.side, request.walls, pack<2>(request).balls};
}

/// A modulus that begins at about `unrelaxed` [Pa].
PronySeries random_spectrum(double unrelaxed, Random& random) {
  std::vector<MaxwellTerm> terms;
  const auto count = 1 + random() % 6;
  for (std::size_t i = 0; i < count; ++i) {
    terms.push_back({over_decades(1e-4, 1.0, random), unrelaxed * over_decades(0.01, 1.0, random)});
  }
  return {unrelaxed * over_decades(1e-3, 0.1, random), std::move(terms)};
}

}  // namespace

Composite random_composite(std::uint64_t seed, FillerKind kind) {
  Random random(seed);
  Composite composite;
  composite.box = random_box(random);
  const double unrelaxed = over_decades(1e5, 1e8, random), contrast = over_decades(0.1, 1e3, random);
  const auto shear = random_spectrum(unrelaxed, random);
  const double bulk = unrelaxed * over_decades(1.0, 100.0, random);
  const bool bulk_relaxes = random() % 2 == 0;
  composite.materials = {
      {"matrix", 1000.0, bulk_relaxes ? random_spectrum(bulk, random) : PronySeries(bulk), shear},
      {"filler", 1500.0, PronySeries(3.0 * contrast * unrelaxed), PronySeries(contrast * unrelaxed)}};
  if (kind == FillerKind::relaxing) composite.materials[filler].shear = random_spectrum(contrast * unrelaxed, random);
  composite.volumetric = random() % 2 == 0 ? Volumetric::averaged : Volumetric::standard;
  return composite;
}

QuasistaticTest quasistatic_test(const Composite& composite, Boundary boundary) {
  QuasistaticTest test{.composite = discretise(composite.box, cells, matrix, filler),
                       .materials = composite.materials,
                       .varying = {{matrix, "matrix"}},
                       .boundary = boundary,
                       .loads = {Load::shear, Load::bulk},
                       .times = window,
                       .points_per_decade = 4};
  test.volumetric = composite.volumetric;
  return test;
}

DynamicTest<2> dynamic_test(const Composite& composite, Boundary boundary) {
  DynamicTest<2> test{.discretisation = discretise(composite.box, cells, matrix, filler),
                      .materials = composite.materials,
                      .boundary = boundary,
                      .times = window,
                      .points_per_decade = 4,
                      .threads = 1};
  test.volumetric = composite.volumetric;
  return test;
}

}  // namespace breccia::test
