#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

/// Footnotes of the comparison tables: what a reader must know before comparing a printed
/// figure of Golec 2018 with ours. Measured statements come from the project's own runs.
namespace springcheck::table_notes {

inline constexpr const char* wrinkled =
    "A wrinkled state is one of many: which one is reached depends on mesh, path and "
    "perturbation, so that only its order of magnitude can be compared.";
inline constexpr const char* law_of_springs =
    "Springs that follow another law than the thesis's have two rows: beside elements "
    "of their own law and beside those of the thesis's.";
inline constexpr const char* deviation =
    "Printed against LS-DYNA's large-rotation law, ours against the reference named: "
    "at this deformation the difference of the laws is part of ours, and most of it "
    "at nu = 0.499. `--reference fem-hencky` compares with that law.";
inline constexpr const char* layer =
    "The middle layer is taken at half height. The thesis's figure 5.11 may show the "
    "vertical mid-plane instead.";
inline constexpr const char* torsion_angle =
    "The thesis calls 1 and 45 degrees 5 % and 20 %; the angles are inferred from its "
    "torques.";
inline constexpr const char* exact_volume =
    "e = |V - V0|/V0 is the change of the body's volume, which the thesis calls "
    "volume error; how far it is off is told by the reference's. V is the exact "
    "trilinear volume. The mean-edge volume of Eq. 5.19, which drives the correction, "
    "differs by up to 0.02 points.";
inline constexpr const char* units =
    "The thesis computed its centimetres as metres: its printed unit stands for 1e-4 "
    "N of force and 1e-6 N m of torque in SI.";
inline constexpr const char* figures_only =
    "The thesis shows these beams as curves only (figures 5.15 to 5.19), without "
    "numbers; the instabilities are those its text names for figure 5.15, whose mesh "
    "it does not state.";

/// Notes of single figures, by the names that printed.csv gives them.
inline constexpr std::array<std::pair<std::string_view, const char*>, 12> of_figures{{
    {"fem-column",
     "The thesis's FEM (LS-DYNA, \"Hooke\") follows a large-rotation law in "
     "logarithmic strain, of three laws nearest to fem-hencky. Small-strain Hooke "
     "and St-Venant-Kirchhoff are other laws, and at 20 % the laws differ."},
    {"young-form",
     "The printed value was computed with the E-forms of Eq. 5.12, which are right "
     "at nu = 0.25 only; the row marked E-form reproduces it, the other row is the "
     "material asked for."},
    {"young-form-wrinkles",
     "Neither form reproduces the printed value: mss-nfd is unstable here, and the "
     "E-form at nu = 0 (E_eff = 2E/3, nu_eff = -1/6) more so."},
    {"no-compression",
     "mss-nfd has no face diagonals to carry the negative volume modulus of nu = 0: "
     "beyond this deformation its energy has no minimum, and the printed value "
     "cannot be a static equilibrium."},
    {"no-tension",
     "No static equilibrium beyond about 17.5 %: the homogeneous lattice at nu = 0 "
     "loses its lateral minimum at 19.5 %, so that the printed value cannot be a "
     "static equilibrium."},
    {"tension-nu-0",
     "The printed value is reproduced neither by the mu-form nor by the E-form of "
     "the spring constants (7.8 %)."},
    {"tension-mesh",
     "The printed FEM column fits a beam of 4 x 4 x 16 cells, not the stated 4 x 4 x "
     "24."},
    {"baudet",
     "The printed value could not be reproduced by any reading of the method. At nu "
     "= 0.25 mss-baudet and mss-nfd are the same network."},
    {"same-network",
     "At nu = 0.25 mss-baudet and mss-nfd are the same network; the thesis prints "
     "different wrinkled states of it."},
    {"dynamics",
     "Printed after 10 s of dynamics whose damping is not stated. The static "
     "equilibrium fits it; the same run without damping, centimetres as metres, ends "
     "lower (shear 3307 at 5 %)."},
    {"small-strain",
     "A small-strain law at 45 degrees, its lever arms undeformed: outside its "
     "range."},
    {"st-venants-volume",
     "St-Venant and Kirchhoff's law changes the volume here, springs or elements: "
     "near nu = 1/2 it is incompressible in small strain alone."},
}};

/// The text of the note of this name. Throws std::logic_error where there is none.
inline const char* text(std::string_view name) {
  const auto* const note = std::ranges::find(
      of_figures, name, &std::pair<std::string_view, const char*>::first);
  if (note == of_figures.end())
    throw std::logic_error("printed.csv: unknown note " + std::string(name));
  return note->second;
}

}  // namespace springcheck::table_notes
