// One elastic solution of the first stage of a deck, by the substructuring of Breccia or by PCBDDC, the BDDC of PETSc
// with one subdomain a process: iterations, processor time, memory, and the size of the coarse problem.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <petscdm.h>
#include <petscksp.h>
#include <sys/resource.h>

#include "breccia/deck/read_study.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"

#include "parallel/session.hpp"
#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/operator/petsc_handle.hpp"
#include "quasistatic/operator/square_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "quasistatic/solvers/substructuring/substructuring_solver.hpp"
#include "waiting.hpp"

namespace {

using namespace breccia;
using namespace breccia::quasistatic;

constexpr auto usage =
    "usage: mpirun -n PROCESSES pcbddc_bench substructures|pcbddc DECK SHEAR [KEY=VALUE ...] [-PETSC_OPTION ...]\n"
    "SHEAR is the shear modulus of the matrix [MPa]; KEY=VALUE overrides a setting of the deck.\n";

/// PCBDDC as it suits a high contrast: constraints from both components of the displacement together, for all modes
/// beyond a threshold, deluxe scaling, Cholesky factors by MUMPS.
constexpr auto pcbddc_options =
    "-pc_bddc_monolithic -pc_bddc_use_deluxe_scaling -pc_bddc_adaptive_threshold 2 "
    "-sub_schurs_mat_solver_type mumps "
    "-pc_bddc_dirichlet_pc_type cholesky -pc_bddc_dirichlet_pc_factor_mat_solver_type mumps "
    "-pc_bddc_neumann_pc_type cholesky -pc_bddc_neumann_pc_factor_mat_solver_type mumps "
    "-pc_bddc_coarse_pc_type cholesky -pc_bddc_coarse_pc_factor_mat_solver_type mumps";

using Viewer = PetscHandle<PetscViewer, PetscViewerDestroy>;
using Indices = PetscHandle<IS, ISDestroy>;
using Numbering = PetscHandle<ISLocalToGlobalMapping, ISLocalToGlobalMappingDestroy>;

struct Request {
  std::string solver, deck;
  double matrix_shear;  ///< [Pa]
  std::vector<std::string> overrides;
  std::string petsc_options;
};

Request read(const std::vector<std::string>& arguments) {
  if (arguments.size() < 3) throw InputError(usage);
  Request request = {arguments[0], arguments[1], 1e6 * std::stod(arguments[2]), {}, {}};
  if (request.solver != "substructures" && request.solver != "pcbddc") throw InputError(usage);
  for (std::size_t i = 3; i < arguments.size(); ++i) {
    const auto& argument = arguments[i];
    const bool is_override = argument.front() != '-' && argument.find('=') != std::string::npos;
    if (is_override) {
      request.overrides.push_back(argument);
    } else {
      request.petsc_options += " " + argument;
    }
  }
  return request;
}

/// The box, and the moduli [Pa] by material.
struct Problem {
  ElasticOperator<2> elastic_operator;
  std::vector<Moduli> moduli;
};

Problem make_problem(const Request& request) {
  const auto study = read_study(request.deck, request.overrides);
  const auto& stage = study.stages.front();
  const auto discretisation = discretise(stage, make_microstructure(stage), stage.cells, study.tests.mixing);
  std::vector<Moduli> moduli;
  for (const auto& material : materials_of(stage, std::get<Material>(stage.matrix))) {
    moduli.push_back({.bulk = material.bulk.unrelaxed(), .shear = material.shear.unrelaxed()});
  }
  moduli.front().shear = request.matrix_shear;
  return {{std::get<Discretisation<2>>(discretisation), Volumetric::averaged, Boundary::displacement}, moduli};
}

/// Largest memory that this process has taken so far [bytes].
double peak_memory() {
  rusage resources{};
  getrusage(RUSAGE_SELF, &resources);
  constexpr double kibibyte = 1024.0;
  return kibibyte * static_cast<double>(resources.ru_maxrss);
}

/// Processor time of all processes since the construction, without waiting [s].
class ProcessorTime {
 public:
  ProcessorTime() { MPI_Barrier(PETSC_COMM_WORLD); }

  [[nodiscard]] double seconds() const {
    double seconds = now() - start_;
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return seconds;
  }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec) - seconds_waited();
  }

  double start_ = now();
};

/// The cost of a solution, and its energy as a check.
struct Outcome {
  int iterations = 0;
  double setup = 0.0, solution = 0.0;  ///< processor time [s]
  double residual = 0.0;               ///< relative to the load [-]
  double energy = 0.0;                 ///< w' f [Pa cell^2]
  std::int64_t coarse_unknowns = 0;
};

/// Forces on w that balance those of the uniform strain of a unit shear.
Forces balancing_forces(const Problem& problem) {
  auto forces = forces_under(problem.elastic_operator, problem.moduli,
                             problem.elastic_operator.uniform_strain(Load::shear), unit_strain<2>(Load::shear));
  forces.scale(-1.0);
  return forces;
}

/// The load on the nodes after the elimination of the strains of the phases of mixed cells.
NodalVector condensed_load(const Problem& problem) {
  auto forces = balancing_forces(problem);
  problem.elastic_operator.condense(problem.moduli, forces);
  return forces.take_fluctuation();
}

double scalar_product(Vec a, Vec b) {
  double product = 0.0;
  check(VecDot(a, b, &product), "multiplying nodal vectors");
  return product;
}

Outcome solve_by_substructures(const Problem& problem) {
  Outcome outcome;
  LinearOptions options;
  options.threads = 1;
  const ProcessorTime setup;
  SubstructuringSolver solver(problem.elastic_operator, options);
  solver.set_moduli(problem.moduli);
  outcome.setup = setup.seconds();
  const ProcessorTime solution;
  const auto displacement = solver.solve(balancing_forces(problem), problem.elastic_operator.zero());
  outcome.solution = solution.seconds();
  outcome.iterations = solver.effort().iterations;
  outcome.residual = solver.effort().largest_residual;
  outcome.energy = scalar_product(condensed_load(problem).get(), displacement.fluctuation());
  outcome.coarse_unknowns = solver.coarse_unknowns();
  return outcome;
}

/// The nodes of the cells of this process, its subdomain, which it numbers cell by cell.
struct Subdomain {
  std::vector<PetscInt> number_of_seen;  ///< numbers by node that the process sees; -1 for nodes of other subdomains
  std::vector<PetscInt> seen;            ///< places of the nodes of the subdomain among those seen
  std::vector<PetscInt> held;            ///< numbers of the components that are held
};

Subdomain subdomain_of(const ElasticOperator<2>& elastic_operator) {
  const auto& layout = elastic_operator.nodes();
  const auto& [begin, end] = layout.seen_nodes();
  Subdomain subdomain;
  subdomain.number_of_seen.assign(
      static_cast<std::size_t>(end[0] - begin[0]) * static_cast<std::size_t>(end[1] - begin[1]), -1);
  layout.for_cells([&](const Index<2>& cell) {
    const auto places = layout.indices_of(cell);
    for (int corner = 0; corner < CellShape<2>::nodes; ++corner) {
      const auto place = places[static_cast<std::size_t>(corner)] / 2;
      auto& number = subdomain.number_of_seen[place];
      if (number >= 0) continue;
      number = static_cast<PetscInt>(subdomain.seen.size());
      subdomain.seen.push_back(static_cast<PetscInt>(place));
      const auto offset = CellShape<2>::corner(corner);
      for (int component = 0; component < 2; ++component) {
        const bool is_held = layout.is_held({cell[0] + offset[0], cell[1] + offset[1]}, component);
        if (is_held) subdomain.held.push_back(2 * number + component);
      }
    }
  });
  return subdomain;
}

/// The stiffness matrix as a sum over the subdomains of the processes.
Matrix stiffness_by_subdomains(const Problem& problem, const Subdomain& subdomain) {
  constexpr const char* what = "assembling the stiffness of subdomains";
  const auto& elastic_operator = problem.elastic_operator;
  const auto nodal = elastic_operator.zero().take_fluctuation();
  DM nodes = nullptr;
  ISLocalToGlobalMapping of_seen = nullptr;
  check(VecGetDM(nodal.get(), &nodes), what);
  check(DMGetLocalToGlobalMapping(nodes, &of_seen), what);
  const auto count = static_cast<PetscInt>(subdomain.seen.size());
  std::vector<PetscInt> numbers(subdomain.seen.size());
  check(ISLocalToGlobalMappingApplyBlock(of_seen, count, subdomain.seen.data(), numbers.data()), what);
  Numbering numbering;
  check(ISLocalToGlobalMappingCreate(PETSC_COMM_WORLD, 2, count, numbers.data(), PETSC_COPY_VALUES, numbering.put()),
        what);
  PetscInt own = 0;
  check(VecGetLocalSize(nodal.get(), &own), what);
  Matrix matrix;
  check(MatCreateIS(PETSC_COMM_WORLD, 2, own, own, PETSC_DETERMINE, PETSC_DETERMINE, numbering.get(), numbering.get(),
                    matrix.put()),
        what);
  constexpr PetscInt most_in_row = 18;
  check(MatISSetPreallocation(matrix.get(), most_in_row, nullptr, 0, nullptr), what);

  double stiffest = 0.0;
  for (const auto& [bulk, shear] : problem.moduli) stiffest = std::max(stiffest, bulk + shear);
  const auto by_kind = elastic_operator.kinds().stiffnesses(problem.moduli);
  const auto& layout = elastic_operator.nodes();
  layout.for_cells([&](const Index<2>& cell) {
    const CellShape<2>::Values free = layout.held_mask(cell);
    CellShape<2>::Stiffness stiffness =
        free.asDiagonal() * by_kind[elastic_operator.kinds().of(cell)] * free.asDiagonal();
    stiffness.diagonal() += stiffest * (CellShape<2>::Values::Ones() - free);
    std::array<PetscInt, CellShape<2>::nodes> corners{};
    std::ranges::transform(layout.indices_of(cell), corners.begin(),
                           [&](std::size_t index) { return subdomain.number_of_seen[index / 2]; });
    check(MatSetValuesBlockedLocal(matrix.get(), CellShape<2>::nodes, corners.data(), CellShape<2>::nodes,
                                   corners.data(), stiffness.data(), ADD_VALUES),
          what);
  });
  check(MatAssemblyBegin(matrix.get(), MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix.get(), MAT_FINAL_ASSEMBLY), what);
  check(MatSetOption(matrix.get(), MAT_SPD, PETSC_TRUE), what);
  elastic_operator.attach_rigid_motions(matrix.get());
  return matrix;
}

/// Number of unknowns of the coarse problem, which PCBDDC reports only in its description.
std::int64_t coarse_unknowns_of(PC preconditioner) {
  constexpr const char* what = "reading the description of PCBDDC";
  char* text = nullptr;
  std::size_t length = 0;
  std::FILE* file = open_memstream(&text, &length);
  {
    Viewer viewer;
    check(PetscViewerASCIIOpenWithFILE(PETSC_COMM_WORLD, file, viewer.put()), what);
    check(PCView(preconditioner, viewer.get()), what);
  }
  std::fclose(file);
  const std::string description(text, length);
  std::free(text);
  const std::string label = " coarse ";
  const auto sizes = description.find("Global dofs sizes:");
  const auto place = description.find(label, sizes);
  if (sizes == std::string::npos || place == std::string::npos) return 0;  // only the first process has the text
  return std::stol(description.substr(place + label.size()));
}

Outcome solve_by_pcbddc(const Problem& problem) {
  constexpr const char* what = "solving with PCBDDC";
  Outcome outcome;
  const auto load = condensed_load(problem);
  auto displacement = problem.elastic_operator.zero().take_fluctuation();
  const ProcessorTime setup;
  const auto subdomain = subdomain_of(problem.elastic_operator);
  const auto matrix = stiffness_by_subdomains(problem, subdomain);
  LinearSolver solver;
  check(KSPCreate(PETSC_COMM_WORLD, solver.put()), what);
  check(KSPSetType(solver.get(), KSPCG), what);
  check(KSPSetNormType(solver.get(), KSP_NORM_UNPRECONDITIONED), what);
  check(KSPSetTolerances(solver.get(), LinearOptions{}.tolerance, PETSC_DEFAULT, PETSC_DEFAULT, 2000), what);
  check(KSPSetOperators(solver.get(), matrix.get(), matrix.get()), what);
  PC preconditioner = nullptr;
  check(KSPGetPC(solver.get(), &preconditioner), what);
  check(PCSetType(preconditioner, PCBDDC), what);
  Indices held;
  check(ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(subdomain.held.size()), subdomain.held.data(),
                        PETSC_COPY_VALUES, held.put()),
        what);
  check(PCBDDCSetDirichletBoundariesLocal(preconditioner, held.get()), what);
  check(KSPSetFromOptions(solver.get()), what);
  check(KSPSetUp(solver.get()), what);
  outcome.setup = setup.seconds();
  const ProcessorTime solution;
  check(KSPSolve(solver.get(), load.get(), displacement.get()), what);
  outcome.solution = solution.seconds();

  PetscInt iterations = 0;
  check(KSPGetIterationNumber(solver.get(), &iterations), what);
  outcome.iterations = static_cast<int>(iterations);
  outcome.energy = scalar_product(load.get(), displacement.get());
  auto residual = problem.elastic_operator.zero().take_fluctuation();
  check(MatMult(matrix.get(), displacement.get(), residual.get()), what);
  check(VecAXPY(residual.get(), -1.0, load.get()), what);
  outcome.residual = std::sqrt(scalar_product(residual.get(), residual.get()) / scalar_product(load.get(), load.get()));
  outcome.coarse_unknowns = coarse_unknowns_of(preconditioner);
  return outcome;
}

void run(const Request& request) {
  parallel::start();
  if (request.solver == "pcbddc") parallel::set_petsc_options(pcbddc_options);
  if (!request.petsc_options.empty()) parallel::set_petsc_options(request.petsc_options);
  const auto problem = make_problem(request);
  std::array<double, 2> memory = {peak_memory(), 0.0};
  const auto outcome = request.solver == "pcbddc" ? solve_by_pcbddc(problem) : solve_by_substructures(problem);
  memory[1] = peak_memory();
  MPI_Allreduce(MPI_IN_PLACE, memory.data(), 2, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  if (!parallel::is_first()) return;
  constexpr double megabyte = 1e6;
  fmt::print("{:<14} {:>9} {:>10} {:>6} {:>8} {:>8} {:>8} {:>12} {:>12} {:>9} {:>9}  {}\n", "solver", "processes",
             "unknowns", "G, MPa", "coarse", "iter.", "set-up s", "solution s", "MB before", "MB peak", "residual",
             "energy");
  fmt::print("{:<14} {:>9} {:>10} {:>6g} {:>8} {:>8} {:>8.2f} {:>12.2f} {:>12.0f} {:>9.0f} {:>9.1e}  {:.9e}\n",
             request.solver, parallel::ranks(), problem.elastic_operator.unknowns(), 1e-6 * request.matrix_shear,
             outcome.coarse_unknowns, outcome.iterations, outcome.setup, outcome.solution, memory[0] / megabyte,
             memory[1] / megabyte, outcome.residual, outcome.energy);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    run(read({arguments + 1, arguments + count}));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    parallel::abort(1);
  }
  parallel::stop();
  return 0;
}
