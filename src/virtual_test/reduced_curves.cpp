#include "virtual_test/reduced_curves.hpp"

#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {

QuasistaticResponse reduced_curves(const ReducedResponse& reduced, std::span<const Material> of_phases,
                                   const std::vector<double>& times) {
  const auto compliance = creep_compliance(reduced, of_phases);
  QuasistaticResponse response;
  response.load = reduced.load;
  response.series = relaxation_modulus(compliance);
  for (const double time : times) {
    response.modulus.push_back({time, response.series.at(time)});
    if (reduced.boundary == Boundary::traction) response.compliance.push_back({time, compliance.at(time)});
  }
  response.reduced = reduced;
  return response;
}

}  // namespace breccia
