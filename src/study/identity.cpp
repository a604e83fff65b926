#include "study/identity.hpp"

#include <bit>
#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "io/text_file.hpp"

namespace breccia {
namespace {

/// The bytes of a study. Each struct is taken apart by a structured binding, so that a member that is added to it does
/// not compile until it is added here.
class Content {
 public:
  void add(const Study& study) {
    const auto& [title, materials, stages, tests, measurements, provenance] = study;
    add_all(title, materials, stages, tests, measurements);
    static_cast<void>(provenance);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

  void add_bits(std::uint64_t bits) {
    constexpr int bits_of_a_byte = 8;
    for (std::size_t i = 0; i < sizeof bits; ++i) {
      bytes_ += static_cast<char>(bits & 0xffU);
      bits >>= bits_of_a_byte;
    }
  }

  template <std::integral Integer>
  void add(Integer value) {
    add_bits(static_cast<std::uint64_t>(value));
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void add(Enum value) { add_bits(static_cast<std::uint64_t>(value)); }
  void add(double value) { add_bits(std::bit_cast<std::uint64_t>(value)); }
  void add(const std::string& text) {
    add(text.size());
    bytes_ += text;
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(values.size());
    for (const auto& value : values) add(value);
  }
  template <class Value>
  void add(const std::optional<Value>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class... Values>
  void add(const std::variant<Values...>& value) {
    add(value.index());
    std::visit([this](const auto& one) { this->add(one); }, value);
  }
  /// All materials, then their shifts by name: the order of the versions that kept them apart.
  void add(const std::vector<ShiftedMaterial>& materials) {
    std::map<std::string, TemperatureShift> shifts;
    add(materials.size());
    for (const auto& [material, shift] : materials) {
      add(material);
      if (shift) shifts.emplace(material.name, *shift);
    }
    add(shifts.size());
    for (const auto& [material, shift] : shifts) add_all(material, shift);
  }

  void add(const PronySeries& series) { add_all(series.equilibrium(), series.terms()); }
  void add(const MaxwellTerm& term) {
    const auto& [relaxation_time, modulus] = term;
    add_all(relaxation_time, modulus);
  }
  void add(const Material& material) {
    const auto& [name, density, bulk, shear] = material;
    add_all(name, density, bulk, shear);
  }
  void add(const TemperatureShift& shift) {
    const auto& [law, temperature] = shift;
    // Without the index of the variant, so that the hashes of studies are those of versions that knew one law.
    std::visit([this](const auto& one) { this->add(one); }, law);
    add(temperature);
  }
  void add(const WilliamsLandelFerry& law) {
    const auto& [c1, c2, reference_temperature] = law;
    add_all(c1, c2, reference_temperature);
  }
  void add(const ShiftTable& table) {
    add_all(table.temperatures(), table.log10_factors(), table.reference_temperature());
  }
  void add(const TimeWindow& window) {
    const auto& [begin, end] = window;
    add_all(begin, end);
  }
  void add(const Sample& sample) {
    const auto& [time, modulus] = sample;
    add_all(time, modulus);
  }
  void add(const Measurement& measurement) {
    const auto& [label, stage, shear, times] = measurement;
    add_all(label, stage, shear, times);
  }

  void add(const EarlierStage& earlier) {
    const auto& [name] = earlier;
    add(name);
  }
  void add(const Stage& stage) {
    const auto& [name, matrix, side, cells, coarser_cells, fillers, packing] = stage;
    add_all(name, matrix, side, cells, coarser_cells, fillers);
    visit_nested([this](const auto& method) { this->add(method); }, packing);
    // A study in two dimensions keeps the content that it had before there were three.
    if (stage.dimensions() != 2) add_all(std::string("dimensions"), stage.dimensions());
  }
  void add(const Filler& filler) {
    const auto& [material, fraction, smallest, largest, sizes, gap, gap_source, coating, shape] = filler;
    add_all(material, fraction, smallest, largest, sizes, gap, gap_source, coating);
    // A study without shapes keeps the content that it had before there were any.
    if (shape) add(*shape);
  }
  void add(const Coating& coating) {
    const auto& [material, thickness] = coating;
    add_all(material, thickness);
  }
  void add(const SingleSize& sizes) {
    const auto& [diameter] = sizes;
    add(diameter);
  }
  void add(const ListedSizes& sizes) {
    const auto& [diameters] = sizes;
    add(diameters);
  }
  void add(const LognormalSizes& sizes) {
    const auto& [components] = sizes;
    add(components);
  }
  void add(const LognormalSizes::Component& component) {
    const auto& [weight, median, sigma] = component;
    add_all(weight, median, sigma);
  }
  void add(const TabulatedSizes& sizes) {
    const auto& [file, diameters, cumulative_volume_fractions] = sizes;
    add_all(diameters, cumulative_volume_fractions);
    static_cast<void>(file);
  }
  // Each packing begins with a number of its own, which is never given to another.
  template <int dim>
  void add(const LubachevskyStillingerPacking<dim>& packing) {
    const auto& [walls, seed] = packing;
    add_all(0, walls, seed);
  }
  void add(const RegularPacking& packing) {
    const auto& [columns, rows] = packing;
    add_all(1, columns, rows);
  }
  void add(const LatticePacking& packing) {
    const auto& [lattice, repeats] = packing;
    add_all(6, lattice, repeats);
  }
  template <int dim>
  void add(const ExplicitPacking<dim>& packing) {
    const auto& [file, particles, walls, fillers] = packing;
    // Discs once stood before the rest, and all others after it.
    std::vector<Disc> discs;
    if constexpr (dim == 2) {
      if (const auto* listed = std::get_if<std::vector<Disc>>(&particles)) discs = *listed;
    }
    add_all(2, discs, walls, fillers);
    const bool are_others = discs.empty() && packing.count() > 0;
    if (are_others) std::visit([this](const auto& listed) { this->add(listed); }, particles);
    static_cast<void>(file);
  }
  template <int dim>
  void add(const LaguerrePacking<dim>& packing) {
    const auto& [walls, wall_film, seed, film, file, sites, film_shares] = packing;
    add_all(3, walls, seed, film);
    // Sites of three dimensions stand after an empty list of those of two.
    if (dim == 3) add(std::vector<Site<2>>());
    if (dim == 2 || !sites.empty()) add(sites);
    if (!film_shares.empty()) add_all(std::string("shares of the films"), film_shares);
    if (wall_film == WallFilm::none) add(std::string("no film along the walls"));
    static_cast<void>(file);
  }
  template <int dim>
  void add(const ImagePacking<dim>& packing) {
    const auto& [file, array, image] = packing;
    add(4);
    if (image) add(*image);
    static_cast<void>(file);
    static_cast<void>(array);
  }
  template <int dim>
  void add(const LabelImage<dim>& image) {
    const auto& [pixels, pixel_side, walls, labels] = image;
    for (const int count : pixels) add(count);
    add_all(pixel_side, walls);
    // Eight bytes for each of millions of labels would be too many.
    add(content_hash({reinterpret_cast<const char*>(labels.data()), labels.size() * sizeof(Label)}));
  }
  template <int dim>
  void add(const RandomSequentialPacking<dim>& packing) {
    const auto& [walls, seed] = packing;
    add_all(5, walls, seed);
  }
  void add(const FillerShape& shape) {
    const auto& [outline, angle] = shape;
    add_all(outline, angle);
  }
  void add(const EllipticOutline& outline) {
    const auto& [aspect] = outline;
    add(aspect);
  }
  void add(const PolygonalOutline& outline) {
    const auto& [file, corners] = outline;
    add(corners);
    static_cast<void>(file);
  }
  void add(const Vector<2>& vector) {
    for (const double coordinate : vector) add(coordinate);
  }
  void add(const Ellipse& ellipse) {
    const auto& [axes] = ellipse;
    add(axes);
  }
  void add(const ConvexPolygon& polygon) {
    for (const auto& corner : polygon.corners()) add(corner);
  }
  void add(const Particle& particle) {
    const auto& [shape, pose] = particle;
    add_all(shape, pose.centre(), pose.angle());
  }
  void add(const Ellipsoid& ellipsoid) {
    const auto& [centre, axes, directions] = ellipsoid;
    for (const auto& vector : {centre, axes, directions[0], directions[1], directions[2]}) {
      for (const double coordinate : vector) add(coordinate);
    }
  }
  template <int dim>
  void add(const Site<dim>& site) {
    const auto& [position, weight] = site;
    for (const double coordinate : position) add(coordinate);
    add(weight);
  }
  template <int dim>
  void add(const Ball<dim>& ball) {
    const auto& [centre, diameter] = ball;
    for (const double coordinate : centre) add(coordinate);
    add(diameter);
  }

  void add(const Tests& tests) {
    const auto& [loads, boundaries, methods, model, films, mixing, volumetric, first_time, last_time, by_frequency,
                 points_per_decade, field_times, lists_field_times, fit_tolerance, quasistatic, varied, dynamic] =
        tests;
    add_all(loads, boundaries, methods, mixing, first_time, last_time, points_per_decade, field_times, fit_tolerance);
    add(quasistatic, volumetric);
    add(dynamic, volumetric);
    static_cast<void>(by_frequency);
    static_cast<void>(lists_field_times);
    // Nothing without such materials: a study from before there were any keeps its hash.
    if (!varied.empty()) add_all(std::string("varied materials"), varied);
    // Nor does one of cells change.
    if (model == Model::films) add_all(std::string("films"), films);
  }
  void add(const FilmOptions& options) {
    const auto& [face_share, layers] = options;
    add(face_share);
    // Nothing for thin films, as before there were others.
    if (layers) add_all(std::string("layers"), *layers);
  }
  void add(const VariedMaterial& material) {
    const auto& [name, shear, bulk] = material;
    add_all(name, shear, bulk);
  }
  void add(const ModulusInterval& interval) {
    const auto& [least, most] = interval;
    add_all(least, most);
  }
  // Both methods have the volumetric strains among their options, as in the versions that kept them there.
  void add(const QuasistaticOptions& options, Volumetric volumetric) {
    const auto& [solver, range, sampling, steps_per_decade, linear] = options;
    add_all(solver, range, volumetric, sampling, steps_per_decade, linear);
  }
  void add(const SamplingOptions& options) {
    const auto& [tolerance, most_snapshots] = options;
    add_all(tolerance, most_snapshots);
  }
  void add(const LinearOptions& options) {
    const auto& [method, most_unknowns_direct, most_unknowns_direct_in_3d, tolerance, energy_tolerance, threads] =
        options;
    // A limit for several processes that there once was stays in the content of all studies.
    constexpr std::int64_t most_on_several = 3'000'000;
    add_all(method, most_unknowns_direct, most_on_several, tolerance);
    static_cast<void>(threads);
    // A study with the defaults keeps the content that it had before there were three dimensions.
    const LinearOptions defaults;
    const bool has_defaults = most_unknowns_direct_in_3d == defaults.most_unknowns_direct_in_3d &&
                              energy_tolerance == defaults.energy_tolerance;
    if (!has_defaults) add_all(std::string("linear in 3D"), most_unknowns_direct_in_3d, energy_tolerance);
  }
  void add(const DynamicOptions& options, Volumetric volumetric) {
    const auto& [formulation, start, courant, ramp_transits, creep_ramp_transits, ramp_time, mass_scaling_factors,
                 overlap, reduction_tolerance] = options;
    add_all(formulation, start, volumetric, courant, ramp_transits, creep_ramp_transits, ramp_time,
            mass_scaling_factors, overlap, reduction_tolerance);
  }

  std::string bytes_;
};

}  // namespace

std::string content_of(const Study& study) {
  Content content;
  content.add(study);
  return content_hash(content.bytes());
}

Provenance provenance_of(const Study& study) {
  auto content = content_of(study);
  if (study.provenance.content == content) return study.provenance;
  Provenance provenance;
  provenance.inputs = study.provenance.inputs;
  provenance.hash = content;
  provenance.content = std::move(content);
  return provenance;
}

}  // namespace breccia
