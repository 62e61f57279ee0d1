#include "comparisons/cases/convergence_grids.hpp"

#include "comparisons/cases/grids.hpp"

namespace springcheck {

ThreeCases convergence_grids(const CaseSettings& settings) {
  check_not_cut(settings.body, "convergence on three grids");
  ThreeCases grids{settings, settings, settings};
  grids[1].body.block.cells = refined(settings.body.block.cells, 2);
  grids[2].body.block.cells = refined(settings.body.block.cells, 4);
  return grids;
}

}  // namespace springcheck
