#include "breccia/results/response_file.hpp"

#include <string>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

namespace breccia {
namespace {

constexpr std::int64_t format_version = 3;

void write_matrix(Hdf5Writer& file, const std::string& name, const Eigen::MatrixXd& matrix) {
  // HDF5 stores matrices by rows, Eigen by columns.
  const Eigen::MatrixXd rows = matrix.transpose();
  file.write(name, std::span(rows.data(), static_cast<std::size_t>(rows.size())),
             {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())});
}

Eigen::MatrixXd read_matrix(const Hdf5Reader& file, const std::string& name) {
  const auto shape = file.shape(name);
  const auto values = file.read_numbers(name);
  if (shape.size() != 2) throw FileError(fmt::format("{}: expected a matrix", name));
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(shape[1]),
                                           static_cast<Eigen::Index>(shape[0]))
      .transpose();
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

void require(bool is_so, const std::string& group, const char* expected) {
  if (!is_so) throw FileError(fmt::format("{}: not a response that Breccia has written: expected {}", group, expected));
}

/// Checks that all matrices of a response have the same size of the basis.
void require_consistent(const ReducedResponse& response, const std::string& group) {
  const auto size = response.constant.rows();
  const auto is_square = [size](const Eigen::MatrixXd& matrix) {
    return matrix.rows() == size && matrix.cols() == size;
  };
  const bool fits = size > 0 && is_square(response.constant) && is_square(response.part(ElasticModulus::shear)) &&
                    is_square(response.part(ElasticModulus::bulk)) && response.load_forces.size() == size &&
                    response.residual_products.rows() == 3 * size + 1 &&
                    response.residual_products.cols() == 3 * size + 1 && !response.snapshots.empty();
  require(fits, group, "matrices of one size");
}

int read_cells(const std::string& name, const std::string& group) {
  const auto grid = grid_named(name);
  require(grid && !grid->is_extrapolated(), group, "numbers of cells");
  return grid->cells().value();
}

ReducedResponse read_response(const Hdf5Reader& file, const std::string& group) {
  ReducedResponse response;
  response.constant = read_matrix(file, group + "/filler_Pa");
  response.parts = matrix_parts(read_matrix(file, group + "/matrix_shear"), read_matrix(file, group + "/matrix_bulk"));
  response.load_forces = read_matrix(file, group + "/load_forces");
  response.residual_products = read_matrix(file, group + "/residual_products");
  response.residual_scale = file.attribute<double>(group, "residual_scale");
  const auto snapshots = read_matrix(file, group + "/snapshots_shear_bulk_error");
  require(snapshots.cols() == 3, group, "three columns of snapshots");
  for (Eigen::Index i = 0; i < snapshots.rows(); ++i) {
    response.snapshots.push_back({{.bulk = snapshots(i, 1), .shear = snapshots(i, 0)}, snapshots(i, 2)});
  }
  require_consistent(response, group);
  return response;
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
  StoredResponses stored;
  stored.stage = file.attribute<std::string>("/", "stage");
  const auto matrix = file.attribute<std::string>("/", "matrix");
  if (file.attribute<std::string>("/", "matrix_is") == "stage") {
    stored.matrix = EarlierStage{matrix};
  } else {
    stored.matrix.emplace<Material>().name = matrix;
  }
  stored.filler_density = file.attribute<double>("/", "filler_density_kg_per_m3");
  stored.filler_fraction = file.attribute<double>("/", "filler_fraction");
  stored.side = file.attribute<double>("/", "box_m");
  stored.deck_hash = file.attribute<std::string>("/", "deck_hash");
  const auto range = value_named<SampledRange>(file.attribute<std::string>("/", "sampled_range"));
  require(range.has_value(), path.string(), "a range that was sampled, matrix or times");
  stored.range = *range;
  stored.fit_tolerance = file.attribute<double>("/", "fit_tolerance");
  const auto times = file.attribute<std::vector<double>>("/", "times_s");
  require(times.size() == 2, path.string(), "two times");
  stored.times = {times[0], times[1]};
  stored.points_per_decade = static_cast<int>(file.attribute<std::int64_t>("/", "points_per_decade"));
  for (const auto& [boundary_name, boundary] : words<Boundary>) {
    for (const auto& [load_name, load] : words<Load>) {
      const auto group = fmt::format("/{}/{}", boundary_name, load_name);
      if (!file.has(group)) continue;
      for (const auto& cells : file.names(group)) {
        auto response = read_response(file, fmt::format("{}/{}", group, cells));
        response.load = load;
        response.boundary = boundary;
        stored.entries.push_back({read_cells(cells, group), std::move(response)});
      }
    }
  }
  return stored;
}

}  // namespace breccia
