#include "breccia/study/stage.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace breccia {

const std::string& name_of(const StageMatrix& matrix) {
  return std::visit([](const auto& named) -> const std::string& { return named.name; }, matrix);
}

namespace {

struct NameOf {
  template <class Packing>
  PackingName operator()(const Packing&) const {
    return Packing::name;
  }
};

struct KeepsGaps {
  template <class Packing>
  bool operator()(const Packing&) const {
    return requires {
      Packing::keeps_gaps;
    };
  }
};

struct SeedOf {
  using Seed = std::optional<std::uint64_t>;

  template <int dim>
  Seed operator()(const LaguerrePacking<dim>& packing) const {
    return packing.is_random() ? Seed(packing.seed) : std::nullopt;
  }
  template <class Packing>
  Seed operator()([[maybe_unused]] const Packing& packing) const {
    if constexpr (requires { packing.seed; }) return packing.seed;
    return std::nullopt;
  }
};

struct WallsOf {
  template <int dim>
  Walls operator()(const ImagePacking<dim>& packing) const {
    return packing.image ? packing.image->walls : Walls::hard;
  }
  template <class Packing>
  Walls operator()(const Packing& packing) const {
    return packing.walls;
  }
};

}  // namespace

int Stage::dimensions() const {
  return std::holds_alternative<PackingMethod<2>>(packing) ? 2 : 3;
}

PackingName Stage::packing_name() const {
  return visit_nested(NameOf(), packing);
}

bool Stage::is_random() const {
  return visit_nested(KeepsGaps(), packing);
}

std::optional<std::uint64_t> Stage::seed() const {
  return visit_nested(SeedOf(), packing);
}

bool Stage::is_periodic() const {
  return visit_nested(WallsOf(), packing) == Walls::periodic;
}

bool Stage::has_voids() const {
  return std::ranges::any_of(fillers, [](const Filler& filler) { return is_void(filler.material); });
}

bool Stage::has_crystals() const {
  return std::ranges::any_of(fillers, [](const Filler& filler) { return filler.crystal.has_value(); });
}

bool Stage::has_cut_grains() const {
  return has_grains() && !fillers.empty() && !is_periodic() && !has_films_along_walls();
}

bool Stage::has_films_along_walls() const {
  const auto runs_along_walls = [](const auto& method) {
    if constexpr (requires { method.wall_film; }) return method.wall_film == WallFilm::half;
    return false;
  };
  return !fillers.empty() && visit_nested(runs_along_walls, packing) && !is_periodic();
}

std::vector<int> Stage::grids() const {
  auto grids = coarser_cells;
  grids.push_back(cells);
  return grids;
}

std::string cells_in_words(const Stage& stage, int cells) {
  return stage.dimensions() == 3 ? fmt::format("{0} x {0} x {0}", cells) : fmt::format("{0} x {0}", cells);
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
