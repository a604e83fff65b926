#include "cli/summary.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/campaign/run.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "cli/quantities.hpp"
#include "homogenisation/crystal_words.hpp"
#include "homogenisation/debonding_words.hpp"
#include "io/display.hpp"
#include "io/units.hpp"
#include "study/abscissa_words.hpp"
#include "study/chain.hpp"
#include "study/filler_shapes.hpp"
#include "study/filler_sizes.hpp"
#include "study/gap.hpp"
#include "study/picture_words.hpp"
#include "study/test_rules.hpp"
#include "viscoelasticity/poisson_ratio.hpp"

namespace breccia::cli {

namespace {

/// What a modulus is at the first and the last time of the tests or, of tests over frequency, its absolute value at the
/// first and the last frequency.
std::string at_both_ends(const PronySeries& modulus, const Tests& tests) {
  if (!tests.by_frequency) {
    return fmt::format("{} at {}, {} at {}", display(modulus.at(tests.first_time), "Pa"), time(tests.first_time),
                       display(modulus.at(tests.last_time), "Pa"), time(tests.last_time));
  }
  const auto size_at = [&](double instant) {
    return fmt::format("{} at {}", display(std::abs(modulus.complex_modulus(1.0 / instant)), "Pa"),
                       display_in(Abscissa::frequency, instant));
  };
  return fmt::format("|M*| {}, {}", size_at(tests.last_time), size_at(tests.first_time));
}

std::string describe(const PronySeries& modulus, const Tests& tests) {
  if (modulus.is_elastic()) return pressure(modulus.equilibrium());
  const auto& terms = modulus.terms();
  const auto fastest = time(terms.back().relaxation_time), slowest = time(terms.front().relaxation_time);
  return fmt::format("{} relaxing to {}, {} {}; {}", pressure(modulus.unrelaxed()), pressure(modulus.equilibrium()),
                     display_count(terms.size(), "term"),
                     terms.size() == 1 ? "of " + slowest : fmt::format("from {} to {}", fastest, slowest),
                     at_both_ends(modulus, tests));
}

/// Poisson's ratio at the first and last time.
std::string poisson_ratios(const Material& material, const Tests& tests) {
  const auto ratio_at = [&](double instant) {
    return fmt::format("{:.5g}", poisson_ratio(material.bulk.at(instant), material.shear.at(instant)));
  };
  auto first = ratio_at(tests.first_time);
  const auto last = ratio_at(tests.last_time);
  if (first == last) return first;
  return fmt::format("{} at {}, {} at {}", first, time(tests.first_time), last, time(tests.last_time));
}

std::string describe(const ShiftedMaterial& shifted, const Tests& tests) {
  const auto& material = shifted.material;
  auto text = fmt::format("  {}{}\n    density  {}\n    bulk     {}\n    shear    {}\n    Poisson  {}\n", material.name,
                          shifted.constants ? ", a crystal: isotropic means by Hill" : "",
                          readable(material.density, Dimension::density), describe(material.bulk, tests),
                          describe(material.shear, tests), poisson_ratios(material, tests));
  if (shifted.thermal_expansion) text += fmt::format("    expands  {:.4g}e-6 /K\n", 1e6 * *shifted.thermal_expansion);
  return text;
}

struct DescribeSizes {
  std::string operator()(const SingleSize& sizes) const { return fmt::format("all of {}", length(sizes.diameter)); }
  std::string operator()(const ListedSizes& sizes) const {
    const auto [smallest, largest] = std::ranges::minmax(sizes.diameters);
    return fmt::format("{} listed, {} to {}", sizes.diameters.size(), length(smallest), length(largest));
  }
  std::string operator()(const LognormalSizes& sizes) const {
    std::vector<std::string> parts;
    for (const auto& component : sizes.components) {
      parts.push_back(fmt::format("{:.4g} x (median {}, sigma {:.4g})", component.weight, length(component.median),
                                  component.sigma));
    }
    return fmt::format("lognormal, {}", fmt::join(parts, " + "));
  }
  std::string operator()(const TabulatedSizes& sizes) const {
    const auto rows = sizes.diameters.size();
    if (!sizes.file.empty()) return fmt::format("{}, {} rows", sizes.file.string(), rows);
    return rows == 2 ? "equal volumes in equal ratios of the diameter" : fmt::format("a table of {} rows", rows);
  }
  std::string operator()(const FullerSizes& sizes) const {
    return fmt::format("Fuller's curve to {}, exponent {:.4g}", length(sizes.largest), sizes.exponent);
  }
  std::string operator()(const RosinRammlerSizes& sizes) const {
    return fmt::format("Rosin and Rammler, 63.2 % below {}, exponent {:.4g}", length(sizes.size), sizes.exponent);
  }
  std::string operator()(const QuantileSizes& sizes) const {
    return fmt::format("d10 {}, d50 {}, d90 {}, lognormal between and beyond them", length(sizes.d10),
                       length(sizes.d50), length(sizes.d90));
  }
};

struct ParticleNames {
  const char* operator()(const std::vector<Disc>&) const { return "discs"; }
  const char* operator()(const std::vector<Particle>&) const { return "particles"; }
  const char* operator()(const std::vector<Sphere>&) const { return "spheres"; }
  const char* operator()(const std::vector<Ellipsoid>&) const { return "ellipsoids"; }
};

struct DescribePacking {
  template <int dim>
  std::string operator()(const LaguerrePacking<dim>& packing) const {
    const auto* hard =
        packing.wall_film == WallFilm::half ? "half a film along the walls" : "cut by the walls like a window";
    const auto* walls = packing.walls == Walls::hard ? hard : "periodic";
    const auto grains = packing.is_random() ? fmt::format("seed {}", packing.seed)
                                            : fmt::format("{}, {} sites", packing.file.string(), packing.sites.size());
    const auto film = packing.film ? fmt::format(", films of {}", length(*packing.film)) : "";
    const auto* shares = packing.film_shares.empty() ? "" : ", by the shares of the grains";
    return fmt::format("Laguerre tessellation, {}, {}{}{}", walls, grains, film, shares);
  }
  template <int dim>
  std::string operator()(const ImagePacking<dim>& packing) const {
    const auto& image = *packing.image;
    return fmt::format("{}{}{}, {} {} of {}{}", packing.file.string(), packing.array.empty() ? "" : ":/", packing.array,
                       fmt::join(image.pixels, " x "), name_of_pixels(dim), length(image.pixel_side),
                       image.walls == Walls::periodic ? ", periodic" : "");
  }
  template <int dim>
  std::string operator()(const LubachevskyStillingerPacking<dim>& packing) const {
    return fmt::format("Lubachevsky-Stillinger, {}, seed {}", packing.walls == Walls::hard ? "hard walls" : "periodic",
                       packing.seed);
  }
  template <int dim>
  std::string operator()(const RandomSequentialPacking<dim>& packing) const {
    return fmt::format("random sequential, {}, seed {}", packing.walls == Walls::hard ? "hard walls" : "periodic",
                       packing.seed);
  }
  std::string operator()(const RegularPacking& packing) const {
    return fmt::format("regular, {} columns x {} rows", packing.columns, packing.rows);
  }
  std::string operator()(const LatticePacking& packing) const {
    return fmt::format("cubic lattice \"{}\", {}, periodic", name_of(packing.lattice),
                       display_count(static_cast<std::size_t>(packing.repeats), "repeat"));
  }
  template <int dim>
  std::string operator()(const ExplicitPacking<dim>& packing) const {
    const auto* const particles = std::visit(ParticleNames(), packing.particles);
    return fmt::format("{}, {} {}{}", packing.file.string(), packing.count(), particles,
                       packing.walls == Walls::periodic ? ", periodic" : "");
  }
};

std::string describe_filler(const Stage& stage, const Filler& filler) {
  auto text = fmt::format("    filler   {}", filler.material.name);
  if (filler.fraction) text += fmt::format(", {:.6g} of the box", *filler.fraction);
  if (filler.sizes) text += fmt::format("\n    sizes    {}", std::visit(DescribeSizes(), *filler.sizes));
  if (filler.smallest && filler.largest) {
    text += fmt::format(", cut to {} .. {}", length(*filler.smallest), length(*filler.largest));
  }
  constexpr double whole = 0.9995;
  const auto distribution = distribution_of(filler);
  if (distribution && distribution->share_of_law() < whole) {
    text += fmt::format(" ({:.3g} % of the volume)", 100.0 * distribution->share_of_law());
  }
  text += '\n';
  if (filler.shape) text += fmt::format("    shape    {}\n", in_words(*filler.shape, stage.dimensions()));
  if (filler.coating) {
    text += fmt::format("    coating  {}, {} ({:.3g} cells)\n", filler.coating->material.name,
                        length(filler.coating->thickness), filler.coating->thickness / stage.cell_size());
  }
  return text;
}

std::string describe_gap(const Stage& stage, const Filler& filler) {
  const bool follows_grid = filler.gap_source == GapSource::points;
  return fmt::format(
      "    gap      {}{}{}\n", stage.fillers.size() > 1 ? filler.material.name + ": " : "", gap_in_words(stage, filler),
      follows_grid ? ": it depends on the grid; other cells give another gap, and so another material" : "");
}

std::string describe_fillers(const Stage& stage) {
  if (stage.fillers.empty()) return "    filler   none\n";
  std::string text;
  for (const auto& filler : stage.fillers) text += describe_filler(stage, filler);
  text += fmt::format("    packing  {}\n", visit_nested(DescribePacking(), stage.packing));
  if (const auto crop = words_on_crop(stage); !crop.empty()) text += fmt::format("    crop     {}\n", crop);
  if (const auto grey = words_on_threshold(stage); !grey.empty()) {
    text += fmt::format("    grey     {}\n", fmt::join(grey, "\n             "));
  }
  if (const auto sides = words_on_sides(stage); !sides.empty()) text += fmt::format("    sides    {}\n", sides);
  if (const auto bonds = words_on_bonds(stage); !bonds.empty()) text += fmt::format("    bonds    {}\n", bonds);
  for (const auto& line : words_on_crystals(stage)) text += fmt::format("    {}\n", line);
  if (!stage.is_random()) return text;
  for (const auto& filler : stage.fillers) text += describe_gap(stage, filler);
  return text;
}

/// The grid of a stage, or of the labels of grains that are computed with films.
std::string describe_grid(const Stage& stage, Model model) {
  if (model == Model::films) {
    return fmt::format("    model    grains and films; {} cells for labels alone\n",
                       cells_in_words(stage, stage.cells));
  }
  const auto grids = stage.coarser_cells.empty() ? ""
                                                 : fmt::format("             and one of {} cells per side\n",
                                                               fmt::join(stage.coarser_cells, " and "));
  return fmt::format("    grid     {} cells of {}, {} material points\n{}", cells_in_words(stage, stage.cells),
                     length(stage.cell_size()), point_count(stage, stage.cells), grids);
}

std::string describe(const Stage& stage, Model model) {
  return fmt::format("  {}\n    matrix   {}\n    box      {}\n{}{}", stage.name, name_of(stage.matrix),
                     length(stage.side), describe_grid(stage, model), describe_fillers(stage));
}

std::string describe(Volumetric volumetric) {
  return volumetric == Volumetric::averaged ? "averaged volumetric" : "standard volumetric";
}

std::string describe(const DynamicOptions& options, Volumetric volumetric) {
  const auto ramp = options.ramp_time ? time(*options.ramp_time)
                                      : fmt::format("{:.4g} transits of the shear wave", options.ramp_transits);
  return fmt::format(
      "    method   dynamic, {}, from the {}, courant {:.4g}, {} strain\n    ramp     {}\n    scaling  mass scaling "
      "factors {}\n",
      options.formulation == Formulation::classical ? "classical" : "total Lagrangian",
      options.start == Start::affine ? "whole field" : "boundary", options.courant, describe(volumetric), ramp,
      options.mass_scaling_factors.empty() ? "chosen from the times"
                                           : fmt::format("{}", fmt::join(options.mass_scaling_factors, ", ")));
}

/// The moduli over which elastic materials vary: ", and over interphase with shear 10 MPa .. 1 GPa".
std::string describe(const std::vector<VariedMaterial>& varied) {
  std::string text;
  for (const auto& [name, shear, bulk, others] : varied) {
    if (!others.empty()) text += fmt::format(", and over all that {} may be", name);
    if (!shear && !bulk) continue;
    text += fmt::format(", and over {} with", name);
    if (shear) text += fmt::format(" shear {} .. {}", pressure(shear->least), pressure(shear->most));
    if (bulk) text += fmt::format("{} bulk {} .. {}", shear ? "," : "", pressure(bulk->least), pressure(bulk->most));
  }
  return text;
}

std::string describe(const QuasistaticOptions& options, const std::vector<VariedMaterial>& varied,
                     Volumetric volumetric) {
  const auto how = options.solver == Solver::reduced
                       ? fmt::format("reduced basis to within {:.1g} over {}{}", options.sampling.tolerance,
                                     options.range == SampledRange::matrix ? "the whole relaxation of the matrix"
                                                                           : "the times of the tests",
                                     describe(varied))
                       : fmt::format("log-time stepping, {} steps a decade", options.steps_per_decade);
  return fmt::format("    method   quasi-static, {}, {} strain\n", how, describe(volumetric));
}

/// The cells that an interface crosses.
std::string describe_mixing(const Study& study) {
  const auto how = [&]() -> std::string {
    switch (study.tests.mixing) {
      case Mixing::series:
        return "mixed in series";
      case Mixing::flow:
        return fmt::format("mixed in series, with flow through gaps below 1.5 cells between stiffer fillers{},",
                           std::ranges::any_of(study.stages, &Stage::has_voids) ? " in stages without voids" : "");
      case Mixing::points:
        return "each point of the phase at its place";
    }
    return {};
  };
  return fmt::format("    cells    {} where an interface crosses them\n", how());
}

std::string describe(const FilmOptions& films, int dimensions) {
  const auto layers =
      films.layers ? fmt::format(", {} layer{} across", *films.layers, *films.layers == 1 ? "" : "s") : "";
  if (dimensions == 3) {
    return fmt::format("    films    {} element{} along each edge of a grain{}\n", films.divisions,
                       films.divisions == 1 ? "" : "s", layers);
  }
  return fmt::format("    films    elements along the faces up to {:.4g} of a grain{}\n", films.face_share, layers);
}

/// The loads of the tests, and those that stages need beside them: "shear; A also bulk".
std::string describe_loads(const Study& study) {
  const auto& asked = study.tests.loads;
  std::vector<std::string> names;
  for (const auto load : asked) names.push_back(name_of(load));
  auto text = fmt::format("{}{}", fmt::join(names, ", "),
                          study.tests.whole_stiffness ? ", pairs of loads for the whole stiffness" : "");
  for (const auto& stage : study.stages) {
    std::vector<std::string> added;
    for (const auto load : loads_of(study, stage)) {
      const bool is_of_mean = asks_for_isotropic(study.tests) && load != Load::bulk;
      if (!is_of_mean && std::ranges::find(asked, TestLoad(load)) == asked.end()) added.push_back(name_of(load));
    }
    if (!added.empty()) text += fmt::format("; {} also {}", stage.name, fmt::join(added, ", "));
  }
  return text;
}

std::string describe(const Study& study) {
  const auto& tests = study.tests;
  std::vector<std::string> boundaries;
  for (const auto boundary : tests.boundaries) boundaries.push_back(name_of(boundary));
  const auto hertz = [](double time) { return display_in(Abscissa::frequency, time); };
  const auto range = tests.by_frequency
                         ? fmt::format("frequencies {} to {}", hertz(tests.last_time), hertz(tests.first_time))
                         : fmt::format("times    {} to {}", time(tests.first_time), time(tests.last_time));
  auto text = fmt::format("    loads    {}\n    boundary {}\n    {}, {} a decade\n", describe_loads(study),
                          fmt::join(boundaries, ", "), range, tests.points_per_decade);
  if (tests.accuracy) text += fmt::format("    accuracy {:.3g} % of the moduli\n", 100.0 * *tests.accuracy);
  const auto has_some = [&tests](const Stage& stage) { return has_fields(tests, stage); };
  if (std::ranges::any_of(study.stages, has_some)) {
    std::vector<std::string> times;
    for (const double at : tests.field_times) times.push_back(time(at));
    text += fmt::format("    fields   at {}\n", fmt::join(times, ", "));
  }
  if (tests.model == Model::films) {
    text += describe(tests.films, study.stages.front().dimensions());
  }
  const auto has_cells = [&tests](const Stage& stage) { return model_of(tests, stage) == Model::cells; };
  if (std::ranges::any_of(study.stages, has_cells)) text += describe_mixing(study);
  for (const auto method : tests.methods) {
    text += method == Method::dynamic ? describe(tests.dynamic, tests.volumetric)
                                      : describe(tests.quasistatic, tests.varied, tests.volumetric);
  }
  return text;
}

}  // namespace

std::string summary(const Study& study) {
  auto text = fmt::format("{}\n{} (hash {})\n\nmaterials\n", study.title, study.provenance.deck.string(),
                          study.provenance.hash);
  for (const auto& shifted : study.materials) text += describe(shifted, study.tests);
  text += "\nstages\n";
  for (const auto& stage : study.stages) text += describe(stage, model_of(study.tests, stage));
  return text + "\ntests\n" + describe(study);
}

}  // namespace breccia::cli
