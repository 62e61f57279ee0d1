#include "comparisons/tables/theory/beam_cells.hpp"

#include <fmt/format.h>

namespace springcheck {

BeamCells::BeamCells(const CaseSettings& settings, const Mesh& mesh)
    : mesh_(mesh),
      beam_{.length = settings.body.block.size[2],
            .edge = settings.body.block.size[0],
            .material = settings.material} {}

std::vector<Cell> BeamCells::next(const Eigen::VectorXd& shape) {
  const BeamMotion motion = beam_motion(mesh_, shape);
  const int n = ++count_[motion];
  const Cell name{fmt::format("{} {}", name_of(motion), n)};
  switch (motion) {
    case BeamMotion::bending:
      return {name, euler_bernoulli_frequency(beam_, n), timoshenko_frequency(beam_, n)};
    case BeamMotion::torsion:
      return {name, {}, torsion_frequency(beam_, n)};
    case BeamMotion::stretching:
      return {name, {}, stretching_frequency(beam_, n)};
    case BeamMotion::other:
      break;
  }
  return {name, {}, {}};
}

}  // namespace springcheck
