#include "breccia/study/stage.hpp"

namespace breccia {

const std::string& name_of(const StageMatrix& matrix) {
  return std::visit([](const auto& named) -> const std::string& { return named.name; }, matrix);
}

std::vector<int> Stage::grids() const {
  auto grids = coarser_cells;
  grids.push_back(cells);
  return grids;
}

}  // namespace breccia
