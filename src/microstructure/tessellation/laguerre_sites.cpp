#include "breccia/microstructure/laguerre_sites.hpp"

#include "microstructure/tessellation/cell_builder.hpp"
#include "microstructure/tessellation/site_mistakes.hpp"

namespace breccia {

template <int dim>
std::vector<SiteMistake> mistakes(const LaguerreSites<dim>& sites) {
  auto found = mistakes_of_numbers(sites);
  return found.empty() ? empty_cells(sites, CellBuilder<dim>(sites).cells()) : found;
}

template std::vector<SiteMistake> mistakes(const LaguerreSites<2>&);
template std::vector<SiteMistake> mistakes(const LaguerreSites<3>&);

}  // namespace breccia
