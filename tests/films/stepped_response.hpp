#pragma once

#include <cstddef>
#include <span>

#include <gtest/gtest.h>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "films/film_sampling.hpp"
#include "films/film_stepping.hpp"
#include "films/grains_and_films.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"

namespace breccia::test {

/// Expects that the moduli of a problem with a relaxing binder, stepped through time, are those of its reduced basis.
template <int dim>
void expect_steps_of_the_reduced_response(const FilmProblem<dim>& problem, std::span<const Load> loads) {
  const auto material = relaxing_binder();
  constexpr int per_decade = 40;
  const auto times = logarithmic(1e-9, 1e-5, per_decade);
  const auto stepped = run_film_stepping(problem, material, loads, times);
  const auto sampled = sample_film_responses(problem, loads, carson_path(material, {1e-8, 1e-5}));
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const auto modulus = relaxation_modulus(creep_compliance(sampled.responses[l], material));
    for (std::size_t i = per_decade; i < times.size(); i += per_decade) {
      EXPECT_NEAR(stepped.responses[l].values[i] / modulus.at(times[i]), 1.0, 1e-3) << times[i];
    }
  }
}

}  // namespace breccia::test
