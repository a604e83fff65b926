#include "results/response_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/seal.hpp"
#include "study/limits.hpp"

namespace breccia {
namespace {

/// The number of the format of a file in which the moduli of the matrix alone vary, and of a file with other varying
/// phases.
constexpr std::int64_t format_of_matrix = 4, format_of_phases = 5;

/// The name of the attribute of a file that ends with a seal; files of older versions have neither.
constexpr auto sealed_attribute = "sealed";

void write_matrix(Hdf5Writer& file, const std::string& name, const Eigen::MatrixXd& matrix) {
  // HDF5 stores matrices by rows, Eigen by columns.
  const Eigen::MatrixXd rows = matrix.transpose();
  file.create<double>(name, {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())});
  file.write_part(name, 0, std::span(rows.data(), static_cast<std::size_t>(rows.size())));
}

/// Moduli of a phase in the snapshots: columns of shear and bulk modulus [Pa].
Eigen::MatrixXd snapshots_of(const ReducedResponse& response, std::size_t phase) {
  Eigen::MatrixXd moduli(static_cast<Eigen::Index>(response.snapshots.size()), 2);
  for (Eigen::Index i = 0; i < moduli.rows(); ++i) {
    const auto& [bulk, shear] = response.snapshots[static_cast<std::size_t>(i)].moduli[phase];
    moduli.row(i) << shear, bulk;
  }
  return moduli;
}

/// Name of the group of one of the phases other than the matrix, which are counted from 1.
std::string group_of_phase(const std::string& parent, std::size_t phase) {
  return fmt::format("{}/phase_{}", parent, phase);
}

void write_response(Hdf5Writer& file, const std::string& group, const ReducedResponse& response) {
  write_matrix(file, group + "/filler_Pa", response.constant);
  write_matrix(file, group + "/matrix_shear", response.part(ElasticModulus::shear));
  write_matrix(file, group + "/matrix_bulk", response.part(ElasticModulus::bulk));
  write_matrix(file, group + "/load_forces", response.load_forces);
  write_matrix(file, group + "/residual_products", response.residual_products);
  Eigen::MatrixXd snapshots(static_cast<Eigen::Index>(response.snapshots.size()), 3);
  snapshots.leftCols(2) = snapshots_of(response, 0);
  for (Eigen::Index i = 0; i < snapshots.rows(); ++i) {
    snapshots(i, 2) = response.snapshots[static_cast<std::size_t>(i)].error_before;
  }
  write_matrix(file, group + "/snapshots_shear_bulk_error", snapshots);
  const auto phases = response.phases();
  for (std::size_t phase = 1; phase < phases.size(); ++phase) {
    const auto of_phase = group_of_phase(group, phase);
    write_matrix(file, of_phase + "/shear", response.part({phases[phase], ElasticModulus::shear}));
    write_matrix(file, of_phase + "/bulk", response.part({phases[phase], ElasticModulus::bulk}));
    write_matrix(file, of_phase + "/snapshots_shear_bulk", snapshots_of(response, phase));
    file.write_attribute(of_phase, "phase", phases[phase]);
  }
  file.write_attribute(group, "residual_scale", response.residual_scale);
}

void write_series(Hdf5Writer& file, const std::string& group, const std::string& name, const PronySeries& series) {
  Eigen::MatrixXd terms(static_cast<Eigen::Index>(series.terms().size()), 2);
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    const auto& [time, modulus] = series.terms()[static_cast<std::size_t>(i)];
    terms.row(i) << time, modulus;
  }
  file.write_attribute(group, name + "_equilibrium_Pa", series.equilibrium());
  if (terms.rows() > 0) write_matrix(file, fmt::format("{}/{}_terms_s_Pa", group, name), terms);
}

/// The materials of the phases other than the matrix whose moduli vary.
void write_materials(Hdf5Writer& file, const std::map<std::string, Material>& by_phase) {
  std::size_t number = 0;
  for (const auto& [phase, material] : by_phase) {
    const auto group = group_of_phase("", ++number);
    file.create_group(group);
    file.write_attribute(group, "phase", phase);
    file.write_attribute(group, "material", material.name);
    file.write_attribute(group, "density_kg_per_m3", material.density);
    write_series(file, group, "bulk", material.bulk);
    write_series(file, group, "shear", material.shear);
  }
}

/// A group of a file that is being read.
struct Group {
  const Hdf5Reader& file;
  const std::filesystem::path& path;
  std::string name;

  /// Throws FileError where the group is not as write_responses writes it.
  void require(bool is_so, std::string_view expected) const {
    if (is_so) return;
    throw FileError(
        fmt::format("{}: {}: not a response that Breccia has written: expected {}", path.string(), name, expected));
  }
};

Eigen::MatrixXd read_matrix(const Group& group, const std::string& name) {
  const auto dataset = group.name + "/" + name;
  const auto shape = group.file.shape(dataset);
  const auto values = group.file.read_numbers(dataset);
  group.require(shape.size() == 2, name + " to be a matrix");
  const bool is_finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  group.require(is_finite, name + " to be of finite numbers");
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(shape[1]),
                                           static_cast<Eigen::Index>(shape[0]))
      .transpose();
}

/// Checks that all matrices of a response have the same size of the basis.
void require_consistent(const ReducedResponse& response, const Group& group) {
  const auto size = response.constant.rows();
  const auto is_square = [](const Eigen::MatrixXd& matrix, Eigen::Index side) {
    return matrix.rows() == side && matrix.cols() == side;
  };
  const auto parts = static_cast<Eigen::Index>(response.parts.size());
  const bool fits =
      size > 0 && is_square(response.constant, size) &&
      std::ranges::all_of(response.parts, [&](const auto& part) { return is_square(part.stiffness, size); }) &&
      response.load_forces.size() == size && is_square(response.residual_products, (parts + 1) * size + 1) &&
      !response.snapshots.empty();
  group.require(fits, "matrices of one size");
}

/// Adds the parts and the moduli of a phase other than the matrix.
void read_phase(const Group& group, ReducedResponse& response) {
  const auto phase = group.file.attribute<std::string>(group.name, "phase");
  const auto known = response.phases();
  group.require(std::ranges::find(known, phase) == known.end(), "each phase once");
  auto shear = read_matrix(group, "shear"), bulk = read_matrix(group, "bulk");
  response.parts.push_back({{phase, ElasticModulus::shear}, std::move(shear)});
  response.parts.push_back({{phase, ElasticModulus::bulk}, std::move(bulk)});
  const auto snapshots = read_matrix(group, "snapshots_shear_bulk");
  const auto count = static_cast<Eigen::Index>(response.snapshots.size());
  group.require(snapshots.cols() == 2 && snapshots.rows() == count, "shear and bulk modulus of each snapshot");
  for (Eigen::Index i = 0; i < count; ++i) {
    response.snapshots[static_cast<std::size_t>(i)].moduli.push_back(
        {.bulk = snapshots(i, 1), .shear = snapshots(i, 0)});
  }
}

ReducedResponse read_response(const Group& group) {
  ReducedResponse response;
  response.constant = read_matrix(group, "filler_Pa");
  response.parts = matrix_parts(read_matrix(group, "matrix_shear"), read_matrix(group, "matrix_bulk"));
  const auto load_forces = read_matrix(group, "load_forces");
  group.require(load_forces.cols() == 1, "one column of load_forces");
  response.load_forces = load_forces;
  response.residual_products = read_matrix(group, "residual_products");
  response.residual_scale = group.file.attribute<double>(group.name, "residual_scale");
  const auto snapshots = read_matrix(group, "snapshots_shear_bulk_error");
  group.require(snapshots.cols() == 3, "three columns of snapshots");
  for (Eigen::Index i = 0; i < snapshots.rows(); ++i) {
    response.snapshots.push_back({{{.bulk = snapshots(i, 1), .shear = snapshots(i, 0)}}, snapshots(i, 2)});
  }
  for (std::size_t phase = 1; group.file.has(group_of_phase(group.name, phase)); ++phase) {
    read_phase({group.file, group.path, group_of_phase(group.name, phase)}, response);
  }
  require_consistent(response, group);
  return response;
}

PronySeries read_series(const Group& group, const std::string& name) {
  std::vector<MaxwellTerm> terms;
  const auto dataset = name + "_terms_s_Pa";
  if (group.file.has(group.name + "/" + dataset)) {
    const auto values = read_matrix(group, dataset);
    group.require(values.cols() == 2, "times and moduli of terms");
    for (Eigen::Index i = 0; i < values.rows(); ++i) terms.push_back({values(i, 0), values(i, 1)});
  }
  const auto equilibrium = group.file.attribute<double>(group.name, name + "_equilibrium_Pa");
  try {
    return {equilibrium, std::move(terms)};
  } catch (const InputError& error) {
    throw FileError(fmt::format("{}: {}: {}", group.path.string(), group.name, error.what()));
  }
}

/// The materials of the phases other than the matrix whose moduli vary.
std::map<std::string, Material> read_materials(const Hdf5Reader& file, const std::filesystem::path& path) {
  std::map<std::string, Material> by_phase;
  for (std::size_t number = 1; file.has(group_of_phase("", number)); ++number) {
    const Group group = {file, path, group_of_phase("", number)};
    Material material = {.name = file.attribute<std::string>(group.name, "material"),
                         .density = file.attribute<double>(group.name, "density_kg_per_m3"),
                         .bulk = read_series(group, "bulk"),
                         .shear = read_series(group, "shear")};
    by_phase.emplace(file.attribute<std::string>(group.name, "phase"), std::move(material));
  }
  return by_phase;
}

/// Throws FileError unless every response has a material for each varying phase other than the matrix.
void require_materials(const StageResponses& stored, const Group& root) {
  for (const auto& [grid, response] : stored.entries) {
    auto names = response.phases();
    std::erase(names, name_of_matrix_phase);
    const bool fits = names.size() == stored.other_phases.size() &&
                      std::ranges::all_of(names, [&](const auto& name) { return stored.other_phases.contains(name); });
    root.require(fits, "a material for each phase of its responses");
  }
}

/// The responses under one boundary and load, on all grids.
std::vector<StageResponses::Entry> read_entries(const Group& group, Boundary boundary, Load load) {
  std::vector<StageResponses::Entry> entries;
  for (const auto& name : group.file.names(group.name)) {
    const auto grid = grid_named(name);
    group.require(grid && !grid->is_extrapolated(), "numbers of cells, or films");
    auto& entry = entries.emplace_back(StageResponses::Entry{*grid, {}});
    entry.response = read_response({group.file, group.path, group.name + "/" + name});
    entry.response.load = load;
    entry.response.boundary = boundary;
  }
  return entries;
}

/// The stage from the attributes of the file, without its responses.
StageResponses read_stage(const Group& root) {
  const auto number = [&root](const char* name) { return root.file.attribute<double>("/", name); };
  const auto text = [&root](const char* name) { return root.file.attribute<std::string>("/", name); };
  StageResponses stored;
  stored.stage = text("stage");
  if (text("matrix_is") == "stage") {
    stored.matrix = EarlierStage{text("matrix")};
  } else {
    stored.matrix.emplace<Material>().name = text("matrix");
  }
  stored.filler_density = number("filler_density_kg_per_m3");
  stored.filler_fraction = number("filler_fraction");
  stored.side = number("box_m");
  root.require(stored.side > 0.0 && std::isfinite(stored.side), "the side of a box");
  // Files of versions that had no three dimensions lack this number.
  if (root.file.has_attribute("/", "dimensions")) {
    const auto dimensions = root.file.attribute<std::int64_t>("/", "dimensions");
    root.require(accepts(allowed::dimensions, static_cast<double>(dimensions)), "2 or 3 dimensions");
    stored.dimensions = static_cast<int>(dimensions);
  }
  stored.deck_hash = text("deck_hash");
  const auto range = value_named<SampledRange>(text("sampled_range"));
  root.require(range.has_value(), "a range that was sampled, matrix or times");
  stored.range = *range;
  const auto mixing = value_named<Mixing>(text("mixing"));
  root.require(mixing.has_value(), "a mixing, series, flow or points");
  stored.mixing = *mixing;
  // Files of versions that had no isotropic mean lack this word.
  if (root.file.has_attribute("/", "shear")) {
    const auto shear = value_named<TestLoad>(text("shear"));
    root.require(shear && !shear->is_bulk(), "a load of shear");
    stored.shear = *shear;
  }
  stored.fit_tolerance = number("fit_tolerance");
  const auto times = root.file.attribute<std::vector<double>>("/", "times_s");
  const bool is_window = times.size() == 2 && times[0] > 0.0 && times[0] <= times[1] && std::isfinite(times[1]);
  root.require(is_window, "two positive times that do not fall");
  stored.times = {times[0], times[1]};
  const auto points_per_decade = root.file.attribute<std::int64_t>("/", "points_per_decade");
  constexpr std::int64_t most_points = 1'000'000;
  root.require(points_per_decade > 0 && points_per_decade <= most_points, "a number of points per decade");
  stored.points_per_decade = static_cast<int>(points_per_decade);
  return stored;
}

[[noreturn]] void fail_as_damaged(const std::filesystem::path& path, std::string_view how) {
  throw DamagedFile(fmt::format("{}: damaged: {}; resume its run, which computes it again", path.string(), how));
}

/// Throws DamagedFile if a sealed file has changed since it was written.
void refuse_damage(const std::filesystem::path& path) {
  try {
    require_sealed(path);
  } catch (const DamagedFile&) {
    fail_as_damaged(path, "its checksum is wrong");
  }
}

}  // namespace

void write_responses(const std::filesystem::path& directory, const StageResponses& responses) {
  if (responses.entries.empty()) return;
  Hdf5Writer file(directory / "response.h5");
  file.write_attribute("/", "format_version", responses.other_phases.empty() ? format_of_matrix : format_of_phases);
  file.write_attribute("/", sealed_attribute, std::int64_t{1});
  file.write_attribute("/", "deck_hash", responses.deck_hash);
  file.write_attribute("/", "stage", responses.stage);
  file.write_attribute("/", "matrix", name_of(responses.matrix));
  const bool is_material = std::holds_alternative<Material>(responses.matrix);
  file.write_attribute("/", "matrix_is", std::string(is_material ? "material" : "stage"));
  file.write_attribute("/", "filler_density_kg_per_m3", responses.filler_density);
  file.write_attribute("/", "filler_fraction", responses.filler_fraction);
  file.write_attribute("/", "box_m", responses.side);
  file.write_attribute("/", "dimensions", std::int64_t{responses.dimensions});
  file.write_attribute("/", "times_s", std::vector<double>{responses.times.begin, responses.times.end});
  file.write_attribute("/", "sampled_range", name_of(responses.range));
  file.write_attribute("/", "mixing", name_of(responses.mixing));
  file.write_attribute("/", "shear", name_of(responses.shear));
  file.write_attribute("/", "fit_tolerance", responses.fit_tolerance);
  file.write_attribute("/", "points_per_decade", std::int64_t{responses.points_per_decade});
  write_materials(file, responses.other_phases);
  for (const auto& [grid, response] : responses.entries) {
    write_response(file, fmt::format("/{}/{}/{}", name_of(response.boundary), name_of(response.load), name_of(grid)),
                   response);
  }
  file.close();
  seal(file.temporary());
  file.commit();
}

std::optional<std::string> note_on_responses(const std::filesystem::path& path) {
  if (is_sealed(path)) return std::nullopt;
  return fmt::format("{}: an older version of Breccia wrote it without a checksum, so that damage cannot be seen",
                     path.string());
}

StageResponses read_responses(const std::filesystem::path& path) {
  const bool has_seal = std::filesystem::exists(path) && is_sealed(path);
  if (has_seal) refuse_damage(path);
  const Hdf5Reader file(path);
  const auto version = file.attribute<std::int64_t>("/", "format_version");
  if (version != format_of_matrix && version != format_of_phases) {
    throw FileError(fmt::format("{}: written in format {}; this program reads formats {} and {}", path.string(),
                                version, format_of_matrix, format_of_phases));
  }
  if (!has_seal && file.has_attribute("/", sealed_attribute)) fail_as_damaged(path, "its checksum is missing");
  const Group root = {file, path, "/"};
  auto stored = read_stage(root);
  stored.other_phases = read_materials(file, path);
  for (const auto& [boundary_name, boundary] : words<Boundary>) {
    for (const auto& [load_name, load] : words<Load>) {
      const auto group = fmt::format("/{}/{}", boundary_name, load_name);
      if (!file.has(group)) continue;
      for (auto& entry : read_entries({file, path, group}, boundary, load)) stored.entries.push_back(std::move(entry));
    }
  }
  require_materials(stored, root);
  return stored;
}

}  // namespace breccia
