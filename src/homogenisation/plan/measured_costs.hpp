#pragma once

/// The costs of the parts of a calculation. They were measured on one core of an AMD EPYC (Zen 5) with 32 MB of
/// last-level cache, g++ 12 and Debian 12 in November 2026 (docs/performance.md, docs/three-dimensions.md), and on
/// other machines the times differ by a factor of two and more. All other numbers of a plan are counted.
namespace breccia::measured_costs {

/// Memory of the program with its libraries, MPI and PETSc [B].
inline constexpr double program = 60e6;

// Quasi-static method on cells, in bytes or seconds for each unknown.

/// Memory of sparse Cholesky factors, ordered by nested dissection: constant + of_logarithm log2(unknowns) [B].
inline constexpr double factors = 640.0, factors_of_logarithm = 60.0;
/// Memory of substructures, with a dozen nodal vectors [B].
inline constexpr double substructures = 340.0, vectors_among_others = 12.0;
/// Memory of a cube in addition to the counted data, at the peak of a run of 96 cells a side [B].
inline constexpr double rest_of_cube = 20.0;

/// Sparse factors, and a solution with them, for 20 000 unknowns; for more unknowns the time of the factors grows with
/// this power [s].
inline constexpr double factorisation = 2.2e-6, solution_by_factors = 0.8e-6;
inline constexpr double unknowns_of_factorisation = 2e4, power_of_factorisation = 0.2;
/// Set-up of the substructures and a solution on them [s].
inline constexpr double setup_of_substructures = 1.2e-6, solution_on_substructures = 1.5e-6;
/// Mixed cells under one load and one set of moduli, for each unknown that they have [s].
inline constexpr double mixed_cells = 1e-6;

/// Time of a test in the plane with flow through gaps, over that of as many unknowns without: 2.7 to 3.2 from 50 000 to
/// 2 million unknowns.
inline constexpr double flow_in_plane = 2.9;
/// Time of a test in three dimensions with crystals, whose cells have a stiffness of full rank, over that with
/// isotropic fillers: 1.8 with 15 %, 2.0 with 45 % of them. In the plane, where factors take the time, there is no
/// difference.
inline constexpr double crystals_in_space = 1.9;
/// Unknowns of discs and spheres with flow through gaps, relative to the displacements of the nodes: 1.4 to 1.7 were
/// measured, in space 1.2 to 2.
inline constexpr double unknowns_with_flow = 1.6;

/// Division into parts of a cell that an interface of shaped particles crosses, for each such cell [s]; cells with
/// balls take no time.
inline constexpr double mixing_of_shapes = 2e-4;

/// Conjugate gradients on a cube by fast transforms.
struct IterationsOfCube {
  double of_root;  ///< number of iterations over the square root of the contrast
  double seconds;  ///< time of an iteration [s]
};
inline constexpr IterationsOfCube periodic_cube = {6.5, 29e-9}, held_cube = {7.0, 30e-9}, drawn_cube = {13.0, 33e-9};
/// Minimal residuals on a cube with flow through gaps: the number of iterations over the cells a side to the power 1.5,
/// the time of an iteration [s], and the memory with the factors of the coarse space [B], of many small spheres. Of a
/// few large ones it is half as much.
inline constexpr double iterations_with_flow = 1.5, seconds_with_flow = 3.0e-7, saddle_point_of_cube = 4.2e3;
/// Memory of sparse factors of a cube with flow through gaps, 24 000 to 140 000 unknowns [B] (docs/gaps-in-space.md).
inline constexpr double factors_of_cube_with_flow = 27e3;
/// Forces of a part of the stiffness of a cube on a displacement [s], and the numbers of such products in addition to
/// the counted ones.
inline constexpr double forces_of_cube = 50e-9, forces_of_step = 14.0, forces_of_solution = 10.0;
/// Share of the iterations of a solution that a solution for a basis takes: it begins with the approximation of the
/// basis, and ends at the accuracy that the basis needs.
inline constexpr double share_of_iterations = 0.8;

// Numbers of snapshots of a reduced basis.

/// Snapshots for a box whose phases relax: constant + of_decade for each decade of each shear modulus, up to `most`
/// decades.
inline constexpr double snapshots = 3.5, snapshots_of_decade = 1.5, most_decades = 5.0;
/// Snapshots of cubes over those of squares [-].
inline constexpr double snapshots_of_cubes = 0.85;
/// Factor of the number of snapshots where a material that relaxes may be others (VariedMaterial::others) [-].
inline constexpr double snapshots_of_others = 1.5;

/// Relative increase of the number of snapshots for each decade of an elastic modulus that varies (Tests::varied) [-].
inline constexpr double snapshots_of_varied_decade = 0.85;

// Grains and films.

/// Memory for each unknown [B]: of the factors alone, of all matrices with factors in memory, and of all matrices with
/// factors in files; and the size of the factors [B] from which on they are in files.
inline constexpr double film_factors = 1.55e3, films_in_memory = 2.0e3, films_in_files = 1.35e3, most_factors = 2e9;
/// Memory for writing files of fields [B]: a constant part, one for each grain, and one for each grain and time.
inline constexpr double field_files = 100e6, fields_of_grain = 9e4, fields_of_grain_and_time = 1e4;
/// Memory for each grain and time in space with one element along an edge; it grows with the square of their number.
inline constexpr double fields_of_polyhedron_and_time = 8e4;
/// Time of a snapshot for each unknown, with 1e5 unknowns [s]; it grows with this power of the number of unknowns.
inline constexpr double film_snapshot = 5e-6, unknowns_of_film_snapshot = 1e5, power_of_film_snapshot = 0.2;
/// Grains and films in space: memory of matrices and factors with one unknown [B], and the power of the number of
/// unknowns with which it grows; the number of unknowns with which a snapshot takes one second, and the power.
inline constexpr double films_in_space = 400.0, power_of_films_in_space = 4.0 / 3.0;
inline constexpr double unknowns_of_space_snapshot = 2.35e4, power_of_space_snapshot = 1.7;
/// The same with compressed factors: memory for each unknown [B], and time of the factors and of a solution for each
/// unknown [s].
inline constexpr double compressed_films = 1.6e4;
inline constexpr double compressed_snapshot = 1e-4, solution_by_compressed = 1.5e-5;
/// Memory and time of resolved films in space over those of as many unknowns of thin films.
inline constexpr double memory_of_resolved_films_in_space = 2.2, time_of_resolved_films_in_space = 3.0;

}  // namespace breccia::measured_costs
