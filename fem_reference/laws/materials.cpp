#include "fem_reference/laws/materials.hpp"

namespace springcheck::fem_reference {

Constitution constitution(const Material& material, const Settings& settings) {
  const LameConstants lame = lame_constants(material);
  switch (settings.law) {
    case Law::st_venant_kirchhoff:
      return st_venant_kirchhoff(lame);
    case Law::hencky:
      return hencky(lame);
    case Law::cauchy_born:
      return cauchy_born(material, settings.lattice);
    case Law::hooke:
      break;
  }
  return hooke(lame);
}

double energy(const Constitution& law, const Matrix3& displacement_gradient) {
  return std::visit(
      [&](const auto& part) {
        const double t = part.dilatation(displacement_gradient).value;
        return part.energy(displacement_gradient) + part.volumetric_energy(t).value;
      },
      law);
}

Matrix3 stress(const Constitution& law, const Matrix3& displacement_gradient) {
  return std::visit(
      [&](const auto& part) -> Matrix3 {
        const Dilatation t = part.dilatation(displacement_gradient);
        return part.stress(displacement_gradient) +
               part.volumetric_energy(t.value).first * t.first;
      },
      law);
}

}  // namespace springcheck::fem_reference
