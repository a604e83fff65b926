#include "study/identity.hpp"

#include <bit>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "io/text_file.hpp"

namespace breccia {
namespace {

/// The bytes of a study. Each struct is decomposed by a structured binding, so that a new member causes a compilation
/// error until it is added here.
class Content {
 public:
  void add(const Study& study) {
    const auto& [title, materials, stages, tests, measurements, uncertain, provenance] = study;
    add_all(title, materials, stages, tests, measurements);
    // What is not certain changes no result but by the materials that vary.
    static_cast<void>(uncertain);
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
  void add(const TestLoad& load) {
    constexpr int isotropic = -1;
    const auto of_test = load.of_test();
    add(of_test ? static_cast<int>(*of_test) : isotropic);
  }
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
  /// Adds nothing for the name of a file: the values that were read from it are in the study.
  void add(const std::filesystem::path& file) { static_cast<void>(file); }

  void add(const PronySeries& series) { add_all(series.equilibrium(), series.terms()); }
  void add(const MaxwellTerm& term) {
    const auto& [relaxation_time, modulus] = term;
    add_all(relaxation_time, modulus);
  }
  void add(const Material& material) {
    const auto& [name, density, bulk, shear] = material;
    add_all(name, density, bulk, shear);
  }
  void add(const ShiftedMaterial& shifted) {
    const auto& [material, shift, constants, expansion] = shifted;
    add_all(material, shift);
    if (constants) add_all(std::string("crystal"), *constants);
    if (expansion) add_all(std::string("thermal expansion"), *expansion);
  }
  void add(const TemperatureShift& shift) {
    const auto& [law, temperature] = shift;
    add_all(law, temperature);
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
    const auto& [label, stage, modulus, times, dynamic, kind] = measurement;
    add_all(label, stage, modulus, times);
    if (kind != ModulusKind::shear) add(std::string(name(kind)));
  }

  void add(const EarlierStage& earlier) {
    const auto& [name] = earlier;
    add(name);
  }
  void add(const Stage& stage) {
    const auto& [name, matrix, side, cells, coarser_cells, fillers, packing, bonds] = stage;
    add_all(name, matrix, side, cells, coarser_cells, fillers, packing);
    // A stage whose films are all bonded is what it was before there were others.
    if (bonds) add_all(std::string("bonds"), *bonds);
  }
  void add(const FilmBonds& bonds) {
    const auto& [debonded, kind, seed, normal, films, springs] = bonds;
    add_all(debonded, kind, seed, normal, films);
    if (kind == Debonding::spring) add_all(springs.normal, springs.tangential);
  }
  void add(const SitePair& pair) {
    const auto& [sites, image] = pair;
    add_all(sites[0], sites[1], image);
  }
  void add(const Filler& filler) {
    const auto& [material, fraction, smallest, largest, sizes, gap, gap_source, coating, shape, crystal] = filler;
    add_all(material, fraction, smallest, largest, sizes, gap, gap_source, coating, shape);
    if (crystal) add_all(std::string("crystal"), *crystal);
  }
  void add(const ElasticConstants& constants) {
    for (const double constant : constants) add(constant);
  }
  void add(const Crystal& crystal) {
    const auto& [constants, orientations] = crystal;
    add_all(constants, orientations);
  }
  void add(const RandomOrientations& random) {
    const auto& [seed] = random;
    add(seed);
  }
  void add(const AlignedOrientations&) {}
  void add(const ListedOrientations& listed) {
    const auto& [file, angles] = listed;
    add_all(file, angles);
  }
  void add(const EulerAngles& angles) {
    const auto& [phi1, phi, phi2] = angles;
    add_all(phi1, phi, phi2);
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
    add_all(file, diameters, cumulative_volume_fractions);
  }
  void add(const FullerSizes& sizes) {
    const auto& [largest, exponent] = sizes;
    add_all(largest, exponent);
  }
  void add(const RosinRammlerSizes& sizes) {
    const auto& [size, exponent] = sizes;
    add_all(size, exponent);
  }
  void add(const QuantileSizes& sizes) {
    const auto& [d10, d50, d90] = sizes;
    add_all(d10, d50, d90);
  }
  template <int dim>
  void add(const LubachevskyStillingerPacking<dim>& packing) {
    const auto& [walls, seed] = packing;
    add_all(walls, seed);
  }
  void add(const RegularPacking& packing) {
    const auto& [columns, rows] = packing;
    add_all(columns, rows);
  }
  void add(const LatticePacking& packing) {
    const auto& [lattice, repeats] = packing;
    add_all(lattice, repeats);
  }
  template <int dim>
  void add(const ExplicitPacking<dim>& packing) {
    const auto& [file, particles, walls, fillers] = packing;
    add_all(file, particles, walls, fillers);
  }
  template <int dim>
  void add(const LaguerrePacking<dim>& packing) {
    const auto& [walls, wall_film, seed, film, file, sites, film_shares] = packing;
    add_all(walls, wall_film, seed, film, file, sites, film_shares);
  }
  template <int dim>
  void add(const ImagePacking<dim>& packing) {
    const auto& [file, array, image, crop, segmentation] = packing;
    if (image) add(*image);
    static_cast<void>(array), static_cast<void>(crop), static_cast<void>(segmentation);  // how it was made, like `file`
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
    add_all(walls, seed);
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
    add_all(file, corners);
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
    const auto& [loads, whole_stiffness, boundaries, methods, model, films, mixing, volumetric, first_time, last_time,
                 by_frequency, points_per_decade, accuracy, field_times, lists_field_times, fit_tolerance, quasistatic,
                 varied, dynamic] = tests;
    add_all(loads, boundaries, methods, model, films, mixing, volumetric, first_time, last_time, points_per_decade,
            accuracy, field_times, fit_tolerance, quasistatic, varied, dynamic);
    if (whole_stiffness) add(std::string("whole stiffness"));
    // The two members hold the wording of the times in the deck, on which no result depends.
    static_cast<void>(by_frequency);
    static_cast<void>(lists_field_times);
  }
  void add(const FilmOptions& options) {
    const auto& [face_share, layers, divisions] = options;
    add_all(face_share, layers);
    // A study with the default number is what it was before there was this option; a name keeps another number apart
    // from what follows.
    if (divisions != FilmOptions{}.divisions) add_all(std::string("divisions"), divisions);
  }
  void add(const VariedMaterial& material) {
    const auto& [name, shear, bulk, others] = material;
    add_all(name, shear, bulk);
    if (!others.empty()) add_all(std::string("others"), others);
  }
  void add(const ModulusInterval& interval) {
    const auto& [least, most] = interval;
    add_all(least, most);
  }
  void add(const QuasistaticOptions& options) {
    const auto& [solver, range, sampling, steps_per_decade, linear] = options;
    add_all(solver, range, sampling, steps_per_decade, linear);
  }
  void add(const SamplingOptions& options) {
    const auto& [tolerance, most_snapshots] = options;
    add_all(tolerance, most_snapshots);
  }
  void add(const LinearOptions& options) {
    const auto& [method, most_unknowns_direct, most_unknowns_direct_in_3d, tolerance, energy_tolerance, threads] =
        options;
    add_all(method, most_unknowns_direct, most_unknowns_direct_in_3d, tolerance, energy_tolerance);
    static_cast<void>(threads);  // results are the same for any number of threads
  }
  void add(const DynamicOptions& options) {
    const auto& [formulation, start, courant, ramp_transits, creep_ramp_transits, ramp_time, mass_scaling_factors,
                 overlap, reduction_tolerance] = options;
    add_all(formulation, start, courant, ramp_transits, creep_ramp_transits, ramp_time, mass_scaling_factors, overlap,
            reduction_tolerance);
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
