#include "breccia/results/response_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

namespace breccia {
namespace {

constexpr std::int64_t format_version = 4;

void write_matrix(Hdf5Writer& file, const std::string& name, const Eigen::MatrixXd& matrix) {
  // HDF5 stores matrices by rows, Eigen by columns.
  const Eigen::MatrixXd rows = matrix.transpose();
  file.write(name, std::span(rows.data(), static_cast<std::size_t>(rows.size())),
             {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())});
}

void write_response(Hdf5Writer& file, const std::string& group, const ReducedResponse& response) {
  write_matrix(file, group + "/filler_Pa", response.constant);
  write_matrix(file, group + "/matrix_shear", response.part(ElasticModulus::shear));
  write_matrix(file, group + "/matrix_bulk", response.part(ElasticModulus::bulk));
  write_matrix(file, group + "/load_forces", response.load_forces);
  write_matrix(file, group + "/residual_products", response.residual_products);
  Eigen::MatrixXd snapshots(static_cast<Eigen::Index>(response.snapshots.size()), 3);
  for (Eigen::Index i = 0; i < snapshots.rows(); ++i) {
    const auto& [matrix, error] = response.snapshots[static_cast<std::size_t>(i)];
    snapshots.row(i) << matrix.shear, matrix.bulk, error;
  }
  write_matrix(file, group + "/snapshots_shear_bulk_error", snapshots);
  file.write_attribute(group, "residual_scale", response.residual_scale);
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
  const auto is_square = [size](const Eigen::MatrixXd& matrix) {
    return matrix.rows() == size && matrix.cols() == size;
  };
  const bool fits = size > 0 && is_square(response.constant) && is_square(response.part(ElasticModulus::shear)) &&
                    is_square(response.part(ElasticModulus::bulk)) && response.load_forces.size() == size &&
                    response.residual_products.rows() == 3 * size + 1 &&
                    response.residual_products.cols() == 3 * size + 1 && !response.snapshots.empty();
  group.require(fits, "matrices of one size");
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
    response.snapshots.push_back({{.bulk = snapshots(i, 1), .shear = snapshots(i, 0)}, snapshots(i, 2)});
  }
  require_consistent(response, group);
  return response;
}

/// The responses under one boundary and load, on all grids.
std::vector<StoredResponses::Entry> read_entries(const Group& group, Boundary boundary, Load load) {
  std::vector<StoredResponses::Entry> entries;
  for (const auto& name : group.file.names(group.name)) {
    const auto grid = grid_named(name);
    group.require(grid && !grid->is_extrapolated(), "numbers of cells");
    auto& entry = entries.emplace_back();
    entry.cells = grid->cells().value();
    entry.response = read_response({group.file, group.path, group.name + "/" + name});
    entry.response.load = load;
    entry.response.boundary = boundary;
  }
  return entries;
}

/// What the attributes of the file tell of the stage, all but its responses.
StoredResponses read_stage(const Group& root) {
  const auto number = [&root](const char* name) { return root.file.attribute<double>("/", name); };
  const auto text = [&root](const char* name) { return root.file.attribute<std::string>("/", name); };
  StoredResponses stored;
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
  stored.deck_hash = text("deck_hash");
  const auto range = value_named<SampledRange>(text("sampled_range"));
  root.require(range.has_value(), "a range that was sampled, matrix or times");
  stored.range = *range;
  const auto mixing = value_named<Mixing>(text("mixing"));
  root.require(mixing.has_value(), "a mixing, series or points");
  stored.mixing = *mixing;
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

}  // namespace

void write_responses(const std::filesystem::path& directory, const StoredResponses& responses) {
  if (responses.entries.empty()) return;
  Hdf5Writer file(directory / "response.h5");
  file.write_attribute("/", "format_version", format_version);
  file.write_attribute("/", "deck_hash", responses.deck_hash);
  file.write_attribute("/", "stage", responses.stage);
  file.write_attribute("/", "matrix", name_of(responses.matrix));
  const bool is_material = std::holds_alternative<Material>(responses.matrix);
  file.write_attribute("/", "matrix_is", std::string(is_material ? "material" : "stage"));
  file.write_attribute("/", "filler_density_kg_per_m3", responses.filler_density);
  file.write_attribute("/", "filler_fraction", responses.filler_fraction);
  file.write_attribute("/", "box_m", responses.side);
  file.write_attribute("/", "times_s", std::vector<double>{responses.times.begin, responses.times.end});
  file.write_attribute("/", "sampled_range", name_of(responses.range));
  file.write_attribute("/", "mixing", name_of(responses.mixing));
  file.write_attribute("/", "fit_tolerance", responses.fit_tolerance);
  file.write_attribute("/", "points_per_decade", std::int64_t{responses.points_per_decade});
  for (const auto& [cells, response] : responses.entries) {
    write_response(
        file, fmt::format("/{}/{}/{}", name_of(response.boundary), name_of(response.load), name_of(TestGrid(cells))),
        response);
  }
  file.commit();
}

StoredResponses read_responses(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  const auto version = file.attribute<std::int64_t>("/", "format_version");
  if (version != format_version) {
    throw FileError(
        fmt::format("{}: written in format {}; this program reads format {}", path.string(), version, format_version));
  }
  auto stored = read_stage({file, path, "/"});
  for (const auto& [boundary_name, boundary] : words<Boundary>) {
    for (const auto& [load_name, load] : words<Load>) {
      const auto group = fmt::format("/{}/{}", boundary_name, load_name);
      if (!file.has(group)) continue;
      for (auto& entry : read_entries({file, path, group}, boundary, load)) stored.entries.push_back(std::move(entry));
    }
  }
  return stored;
}

}  // namespace breccia
