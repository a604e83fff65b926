#include "deck/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "deckfile/distribution.hpp"
#include "io/nearest_name.hpp"
#include "io/trimmed.hpp"
#include "study/limits.hpp"
#include "viscoelasticity/youngs_modulus.hpp"

namespace breccia {
namespace {

using Number = MaterialNumber;

bool is_modulus(Number number) {
  return number == Number::shear || number == Number::bulk || number == Number::young || number == Number::equilibrium;
}

std::optional<Dimension> dimension_of(Number number) {
  if (is_modulus(number)) return Dimension::pressure;
  if (number == Number::c2) return Dimension::temperature_difference;
  return std::nullopt;
}

Range range_of(Number number) {
  return number == Number::poisson ? allowed::poisson : Range::positive();
}

/// What is known of a number of a material without a distribution.
Distribution default_prior(const ShiftedMaterial& known, Number number) {
  constexpr double of_modulus = 3.0, of_times = 10.0, of_law = 1.2;
  const auto& material = known.material;
  const double bulk = material.bulk.equilibrium(), shear = material.shear.equilibrium();
  const auto& terms = material.shear.terms();
  const auto* const law = known.shift ? std::get_if<WilliamsLandelFerry>(&known.shift->law) : nullptr;
  switch (number) {
    case Number::shear:
      return LogNormal{shear, of_modulus};
    case Number::equilibrium:  // of a material that flows, about its slowest term
      return LogNormal{shear > 0.0 || terms.empty() ? shear : terms.front().modulus, of_modulus};
    case Number::bulk:
      return LogNormal{bulk, of_modulus};
    case Number::young:
      return LogNormal{youngs_modulus(bulk, shear), of_modulus};
    case Number::poisson:
      return Uniform{0.0, 0.5};
    case Number::modulus:
      return LogNormal{1.0, of_modulus};
    case Number::times:
      return LogNormal{1.0, of_times};
    case Number::c1:
      return LogNormal{law != nullptr ? law->c1 : 1.0, of_law};
    case Number::c2:
      break;
  }
  return LogNormal{law != nullptr ? law->c2 : 1.0, of_law};
}

/// Relaxation times, equally spaced in their logarithm.
std::vector<double> times_within(const TimeWindow& window, double per_decade) {
  const double decades = std::log10(window.end / window.begin);
  const int steps = std::max(1, static_cast<int>(std::lround(decades * per_decade)));
  std::vector<double> times;
  for (int i = 0; i <= steps; ++i) {
    times.push_back(window.begin * std::pow(window.end / window.begin, static_cast<double>(i) / steps));
  }
  return times;
}

/// What is known of each term of a spectrum: a tenth of the unrelaxed modulus of the study, shared by so many terms,
/// within a factor 100.
LogNormal prior_of_terms(const Material& material, std::size_t terms) {
  constexpr double share = 0.1, factor = 100.0;
  return {share * material.shear.unrelaxed() / static_cast<double>(terms), factor};
}

/// The times of observations, 1/omega of those over frequency, from the first to the last, at the temperature of a
/// material.
TimeWindow times_of(const std::vector<Observation>& observations, const ShiftedMaterial& material) {
  TimeWindow window = {1.0, 1.0};
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const auto& one = observations[i];
    double time = is_over_frequency(one.curve) ? 1.0 / one.at : one.at;
    if (const auto& shift = material.shift; shift && one.temperature) {
      time *= shift_factor(shift->law, shift->temperature) / shift_factor(shift->law, *one.temperature);
    }
    window = {i == 0 ? time : std::min(window.begin, time), i == 0 ? time : std::max(window.end, time)};
  }
  return window;
}

UnknownSpectrum read_spectrum(const Section& option, const ShiftedMaterial& known,
                              const std::vector<Observation>& observations) {
  constexpr double beyond = 10.0, usual = 2.0, most = 20.0;
  const auto measured = times_of(observations, known);
  TimeWindow window = {measured.begin / beyond, measured.end * beyond};
  double per_decade = usual;
  if (const auto table = option.optional_section("prior")) {
    window.begin = table->optional_quantity("from", Dimension::time, Range::positive()).value_or(window.begin);
    window.end = table->optional_quantity("to", Dimension::time, Range::positive()).value_or(window.end);
    per_decade = table->optional_number("per_decade", Range::above_and_up_to(0.0, most)).value_or(usual);
    if (window.end <= window.begin) table->report("to", "expected a longer time than from");
  }
  const bool is_known = window.end > window.begin && per_decade > 0.0;
  auto times = is_known ? times_within(window, per_decade) : std::vector<double>{};
  const auto terms = prior_of_terms(known.material, std::max<std::size_t>(times.size(), 1));
  return {known.material.name, std::move(times), terms};
}

/// The name and the distribution of an option; the latter is empty where there is none.
std::pair<std::string, std::string> split(const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos) return {std::string(detail::trimmed(text)), ""};
  return {std::string(detail::trimmed(text.substr(0, sign))), std::string(detail::trimmed(text.substr(sign + 1)))};
}

std::vector<std::string> names_of_numbers() {
  std::vector<std::string> names = {"spectrum"};
  for (const auto& [word, number] : words<Number>) names.emplace_back(word);
  return names;
}

/// The known material and the rest of a name such as "hmx.shear".
std::pair<const ShiftedMaterial*, std::string> material_in(const std::string& name,
                                                           const std::vector<ShiftedMaterial>& materials) {
  const auto dot = name.rfind('.');
  const auto of = name.substr(0, dot);
  const auto* const known = dot == std::string::npos ? nullptr : find_material(materials, of);
  if (known != nullptr) return {known, name.substr(dot + 1)};
  std::vector<std::string> names;
  names.reserve(materials.size());
  for (const auto& one : materials) names.push_back(one.material.name);
  if (dot == std::string::npos) {
    throw InputError(fmt::format("expected MATERIAL.NUMBER, such as {}.{}, got \"{}\"",
                                 names.empty() ? "binder" : names.front(), "times", name));
  }
  throw InputError(fmt::format("no material \"{}\"{}", of, suggestion(of, names)));
}

Unknown read(const std::string& text, const std::vector<ShiftedMaterial>& materials,
             const std::vector<Observation>& observations) {
  const auto [name, prior] = split(text);
  if (prior.empty() && text.find('=') != std::string::npos) {
    throw InputError(fmt::format("{}: expected what is known of it after the equals sign", name));
  }
  const auto [known, number] = material_in(name, materials);
  const auto document = Deck::from_text(prior.empty() ? "" : "prior = " + prior, name, {});
  const auto option = document.root();
  if (number == "spectrum") {
    Unknown spectrum = read_spectrum(option, *known, observations);
    document.finish();
    return spectrum;
  }
  const auto word = std::ranges::find(words<Number>, number, &Word<Number>::first);
  if (word == words<Number>.end()) {
    throw InputError(fmt::format("{} has no \"{}\" that could be unknown{}", known->material.name, number,
                                 suggestion(number, names_of_numbers())));
  }
  UnknownNumber unknown = {known->material.name, word->second, default_prior(*known, word->second)};
  if (option.has("prior") && option.kind("prior") != Kind::table) {
    option.report("prior",
                  R"(expected what is known, as in { value = "5 GPa", sd = "1 GPa" } or { from = 1, to = 3 })");
  } else if (option.has("prior")) {
    unknown.prior = read_distribution(option, "prior", reader_of(dimension_of(word->second)), range_of(word->second))
                        .value_or(unknown.prior);
  }
  document.finish();
  return unknown;
}

}  // namespace

Unknown read_unknown(const std::string& text, const std::vector<ShiftedMaterial>& materials,
                     const std::vector<Observation>& observations, const std::string& option) {
  try {
    return read(text, materials, observations);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", option, error.what()));
  }
}

}  // namespace breccia
