#include "homogenisation/run/test_requests.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "discretisation/mixed_cells.hpp"
#include "homogenisation/box/crystal_orientations.hpp"
#include "homogenisation/box/debonded_films.hpp"
#include "homogenisation/mixtures.hpp"
#include "homogenisation/varying_phases.hpp"
#include "study/chain.hpp"
#include "study/filler_sizes.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// Times [s] at which a test of a stage saves fields: only under the first load and on the finest grid.
std::vector<double> field_times_of(const Study& study, const Stage& stage, int cells, Load load) {
  const bool are_wanted =
      load == loads_of(study, stage).front() && cells == stage.cells && has_fields(study.tests, stage);
  return are_wanted ? study.tests.field_times : std::vector<double>();
}

/// All solid fillers of a stage, averaged to one, and the voids.
struct ExpectedFiller {
  double voids = 0.0;            ///< share of the voids in all fillers [-]
  double density = 0.0;          ///< mean density [kg/m^3]
  double bulk_compliance = 0.0;  ///< unrelaxed bulk compliance times the share, summed over the solid fillers [1/Pa]
  double shear = 0.0;            ///< unrelaxed shear modulus of the stiffest filler [Pa]
};

/// Fillers whose fractions are not known have equal weights.
ExpectedFiller expected_filler(const Stage& stage) {
  const auto all = fraction_asked_of(stage);
  ExpectedFiller expected;
  for (const auto& filler : stage.fillers) {
    const double share = all ? *filler.fraction / *all : 1.0 / static_cast<double>(stage.fillers.size());
    if (is_void(filler.material)) {
      expected.voids += share;
      continue;
    }
    expected.density += share * filler.material.density;
    expected.bulk_compliance += share * (1.0 / filler.material.bulk.unrelaxed());
    expected.shear = std::max(expected.shear, filler.material.shear.unrelaxed());
  }
  return expected;
}

/// Alternative materials of the varying phases: every choice of the moduli over which the tests sample.
std::vector<std::vector<Material>> variants_of(const Tests& tests, const std::vector<VaryingPhase>& varying,
                                               const std::vector<Material>& materials) {
  std::vector<Material> of_phases;
  of_phases.reserve(varying.size());
  for (const auto& [index, name] : varying) of_phases.push_back(materials[index]);
  std::vector<std::vector<Material>> variants;
  for (const auto& choice : choices_of_varied(tests.varied, of_phases)) {
    if (choice.empty()) continue;
    auto& variant = variants.emplace_back(of_phases);
    for (const auto& material : choice) *std::ranges::find(variant, material.name, &Material::name) = material;
  }
  return variants;
}

}  // namespace

SamplingOptions sampling_of(const Tests& tests) {
  auto options = tests.quasistatic.sampling;
  // With every further modulus the basis takes up to three times as many snapshots.
  options.most_snapshots *= 1 + 2 * varied_moduli(tests.varied);
  return options;
}

namespace {

QuasistaticTest test_without_fields(const Study& study, const Stage& stage, const Material& matrix,
                                    QuasistaticComposite composite, Boundary boundary, int threads) {
  auto options = study.tests.quasistatic;
  options.linear.threads = threads;
  options.sampling = sampling_of(study.tests);
  const auto materials = materials_of(stage, matrix);
  const auto varying = varying_phases(study.tests, stage);
  return {.composite = std::move(composite),
          .materials = materials,
          .varying = varying,
          .variants = variants_of(study.tests, varying, materials),
          .volumetric = study.tests.volumetric,
          .boundary = boundary,
          .loads = solved_loads(study, stage, boundary),
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .options = options};
}

}  // namespace

template <int dim>
DynamicTest<dim> make_dynamic_test(const Study& study, const Stage& stage, const Material& matrix,
                                   const Discretisation<dim>& discretisation, Boundary boundary, Load load,
                                   int threads) {
  return {.discretisation = discretisation,
          .materials = with_mixtures(discretisation, materials_of(stage, matrix)),
          .volumetric = study.tests.volumetric,
          .boundary = boundary,
          .load = load,
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .field_times = field_times_of(study, stage, discretisation.grid().cells[0], load),
          .options = study.tests.dynamic,
          .threads = threads};
}

template DynamicTest<2> make_dynamic_test(const Study&, const Stage&, const Material&, const Discretisation<2>&,
                                          Boundary, Load, int);
template DynamicTest<3> make_dynamic_test(const Study&, const Stage&, const Material&, const Discretisation<3>&,
                                          Boundary, Load, int);

QuasistaticTest make_quasistatic_test(const Study& study, const Stage& stage, const Material& matrix,
                                      const StageCells& cells, Boundary boundary, int threads) {
  auto test = std::visit(
      [&](const auto& points) { return test_without_fields(study, stage, matrix, points, boundary, threads); },
      cells.discretisation);
  test.crystals = cells.crystals;
  for (const auto& [phase, crystal] : cells.crystals) test.materials.push_back(test.materials[crystal.shown_as]);
  test.field_times = field_times_of(study, stage, cells_along(cells.discretisation), test.loads.front());
  return test;
}

namespace {

template <int dim>
FilmElements<dim> elements_of(const FilmOptions& options) {
  if constexpr (dim == 2) {
    return {.face_share = options.face_share};
  } else {
    return {.divisions = options.divisions};
  }
}

/// The stiffness of each grain that is a crystal; none where they are isotropic.
std::vector<StiffnessTensor<3>> crystals_of(const Stage& stage, std::size_t grains) {
  std::vector<StiffnessTensor<3>> stiffnesses;
  for (const auto& angles : crystal_orientations(stage, 0, grains)) {
    stiffnesses.push_back(crystal_stiffness(*stage.fillers.front().crystal, angles));
  }
  return stiffnesses;
}

template <int dim>
FilmProblem<dim> film_problem(const Tests& tests, const Stage& stage, const StageMicrostructure& microstructure) {
  const auto& grains = std::get<Grains<dim>>(std::get<Box<dim>>(microstructure.box));
  const auto& material = stage.fillers.front().material;
  Tessellation<dim> tessellation(grains.sites);
  auto debonded = debonded_films(stage, tessellation).faces;
  const auto bonds = stage.bonds.value_or(FilmBonds{});
  return {.tessellation = std::move(tessellation),
          .thickness = grains.statistics.film,
          .grain = {.bulk = material.bulk.unrelaxed(), .shear = material.shear.unrelaxed()},
          .crystals = crystals_of(stage, grains.sites.sites.size()),
          .elements = elements_of<dim>(tests.films),
          .layers = tests.films.layers,
          .debonded = {.kind = bonds.kind, .faces = std::move(debonded), .springs = bonds.springs}};
}

}  // namespace

QuasistaticTest make_film_test(const Study& study, const Stage& stage, const Material& matrix,
                               const StageMicrostructure& grains, Boundary boundary, int threads) {
  auto problem = stage.dimensions() == 3 ? QuasistaticComposite(film_problem<3>(study.tests, stage, grains))
                                         : QuasistaticComposite(film_problem<2>(study.tests, stage, grains));
  auto test = test_without_fields(study, stage, matrix, std::move(problem), boundary, threads);
  if (has_fields(study.tests, stage)) test.field_times = study.tests.field_times;
  return test;
}

Material expected_matrix(const Study& study, const Stage& stage) {
  if (const auto* material = std::get_if<Material>(&stage.matrix)) return *material;
  const auto& name = std::get<EarlierStage>(stage.matrix).name;
  const auto& earlier = *std::ranges::find(study.stages, name, &Stage::name);
  auto matrix = expected_matrix(study, earlier);
  if (earlier.fillers.empty()) return matrix;
  const double fraction = fraction_asked_of(earlier).value_or(0.5);
  const auto [voids, density, bulk_compliance, shear] = expected_filler(earlier);
  // The shear modulus is that of rigid discs, or spheres, in an incompressible matrix (Hashin's lower bound), and the
  // bulk modulus that under uniform pressure (rule of mixtures).
  const double solid = (1.0 - voids) * fraction;
  const double rigid = stage.dimensions() == 3 ? 1.0 + 2.5 * solid / (1.0 - solid) : (1.0 + solid) / (1.0 - solid);
  // No composite is quite as stiff as its filler.
  constexpr double softer = 1.0 - 1e-6;
  const double stiffening = solid > 0.0 ? std::min(rigid, softer * shear / matrix.shear.unrelaxed()) : 1.0;
  const double bulk = 1.0 / mixed(1.0 / matrix.bulk.unrelaxed(), bulk_compliance, fraction);
  // Voids take as much off as Hashin's upper bound has it for a shear modulus of discs, in an incompressible matrix.
  const double porous = (1.0 - voids * fraction) / (1.0 + voids * fraction);
  return {name, mixed(matrix.density, density, fraction), PronySeries(porous * bulk),
          matrix.shear.scaled(porous * stiffening)};
}

}  // namespace breccia
