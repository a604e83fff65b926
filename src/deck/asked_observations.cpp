#include "deck/asked_observations.hpp"

#include <fmt/format.h>

#include "breccia/tables/measured_table_reader.hpp"

#include "deck/observations.hpp"

namespace breccia {

std::vector<Observation> read_observations(const AskedObservations& asked, std::vector<std::string>& notes,
                                           CollectedMistakes& mistakes) {
  constexpr double any = 0.01;  // where the noise is not known only the ratios of deviations matter
  std::vector<Observation> observations;
  for (const auto& data : asked.data) {
    mistakes.collect([&] {
      const auto read = observations_in(read_measured_table(data.file), asked.modulus);
      if (read.kind == ModulusKind::unspecified) {
        notes.push_back(fmt::format("{} does not say which modulus it has: it is taken for G", data.file.string()));
      }
      for (auto observation : read.observations) {
        observation.composite = data.composite;
        observation.deviation = asked.noise.value_or(any);
        observations.push_back(observation);
      }
    });
  }
  return observations;
}

}  // namespace breccia
