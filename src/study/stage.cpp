#include "breccia/study/stage.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace breccia {

const std::string& name_of(const StageMatrix& matrix) {
  return std::visit([](const auto& named) -> const std::string& { return named.name; }, matrix);
}

namespace {

struct SeedOf {
  using Answer = std::optional<std::uint64_t>;

  Answer operator()(const LubachevskyStillingerPacking& packing) const { return packing.seed; }
  Answer operator()(const RandomSequentialPacking& packing) const { return packing.seed; }
  Answer operator()(const LaguerrePacking& packing) const {
    return packing.is_random() ? Answer(packing.seed) : std::nullopt;
  }
  Answer operator()(const RegularPacking&) const { return std::nullopt; }
  Answer operator()(const LatticePacking&) const { return std::nullopt; }
  Answer operator()(const ExplicitPacking&) const { return std::nullopt; }
  Answer operator()(const ImagePacking&) const { return std::nullopt; }
};

struct WallsOf {
  Walls operator()(const RegularPacking&) const { return Walls::hard; }
  Walls operator()(const LatticePacking&) const { return Walls::periodic; }
  Walls operator()(const ImagePacking& packing) const {
    if (packing.stack) return packing.stack->walls;
    return packing.image ? packing.image->walls : Walls::hard;
  }
  template <class Packing>
  Walls operator()(const Packing& packing) const {
    return packing.walls;
  }
};

}  // namespace

std::optional<std::uint64_t> Stage::seed() const {
  return std::visit(SeedOf(), packing);
}

bool Stage::is_periodic() const {
  return std::visit(WallsOf(), packing) == Walls::periodic;
}

bool Stage::has_films_along_walls() const {
  return !fillers.empty() && grains() != nullptr && grains()->walls == Walls::hard &&
         grains()->wall_film == WallFilm::half;
}

std::vector<int> Stage::grids() const {
  auto grids = coarser_cells;
  grids.push_back(cells);
  return grids;
}

std::string cells_in_words(const Stage& stage, int cells) {
  return stage.dimensions == 3 ? fmt::format("{0} x {0} x {0}", cells) : fmt::format("{0} x {0}", cells);
}

std::vector<Material> named_materials(const Stage& stage) {
  std::vector<Material> materials;
  if (const auto* matrix = std::get_if<Material>(&stage.matrix)) materials.push_back(*matrix);
  const auto add = [&materials](const Material& material) {
    if (std::ranges::find(materials, material.name, &Material::name) == materials.end()) materials.push_back(material);
  };
  for (const auto& filler : stage.fillers) {
    add(filler.material);
    if (filler.coating) add(filler.coating->material);
  }
  return materials;
}

}  // namespace breccia
