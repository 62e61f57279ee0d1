#include "tissue/solid.hpp"

#include <sstream>

#include "meshing/basics/input_error.hpp"
#include "tissue/checks.hpp"

namespace springcheck::tissue {

void check(const Solid& solid) {
  check(solid.shear);
  check_positive("bulk over shear modulus", solid.bulk_ratio);
}

double bulk_ratio_of(double poisson_ratio) {
  const double nu = poisson_ratio;
  if (!(nu > -1 && nu < 0.5)) {
    std::ostringstream got;
    got << nu;
    throw InputError("tissue", "Poisson ratio", "a number above -1 and below 0.5",
                     got.str());
  }
  return 2 * (1 + nu) / (3 * (1 - 2 * nu));
}

double instantaneous_modulus(const MaxwellModel& model) {
  double sum = model.elastic.linear;
  for (const MaxwellBranch& branch : model.branches) sum += branch.moduli.linear;
  return sum;
}

}  // namespace springcheck::tissue
