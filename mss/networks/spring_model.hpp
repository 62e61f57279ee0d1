#pragma once

#include <optional>

#include "mss/networks/stiffness.hpp"
#include "mss/networks/virtual_springs.hpp"

namespace springcheck::mss {

enum class SpringModel {
  baudet,     // edges and inner diagonals by Baudet's formulas, no correction
  nfd,        // no face diagonals (A = 0), with volume correction
  fd,         // face diagonals, no correction: right at nu = 1/4 only
  cf,         // face diagonals and volume correction: the thesis's method
  uniform,    // one stiffness for all springs of a cell, no correction
  custom,     // constants of the user's choice
  affine,     // virtual springs in every cell, springs against hourglasses: any cells
  vangelder,  // edges of tetrahedra by Van Gelder's formula
  lloyd       // edges of tetrahedra by Lloyd's formula
};

enum class StiffnessForm { shear_modulus, young_modulus };

enum class VolumeCorrection { on, off };

struct NetworkSettings {
  SpringModel model;
  StiffnessForm stiffness_form = StiffnessForm::shear_modulus;  // of nfd, fd and cf
  double diagonal_ratio = 1;                                    // A of fd and cf on cubes
  // The constants of custom, which needs them, as they stand: they belong to the mesh's
  // cell size, and the same material in cells of edge h' has the stiffness times h'/h,
  // kappa unchanged. Without them std::invalid_argument is thrown.
  std::optional<LatticeConstants> constants{};
  VolumeCorrection volume_correction = VolumeCorrection::on;  // of vangelder and lloyd
  StrainMeasure strain_measure = StrainMeasure::engineering;
  Axes axes = Axes::sixteen;  // of affine
};

}  // namespace springcheck::mss
