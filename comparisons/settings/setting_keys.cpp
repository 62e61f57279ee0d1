#include "comparisons/settings/run_settings.hpp"

namespace springcheck {

const std::vector<SettingKey>& option_keys() {
  static const std::vector<SettingKey> keys{
      {"method", "comma-separated list of methods, see 'springcheck list methods'"},
      {"element", "finite element: q1, q1-sri (default), or q2 on hexahedra"},
      {"nu", "Poisson ratio, in (-1, 0.5)"},
      {"young", "Young's modulus [Pa]"},
      {"density", "mass density [kg/m^3]"},
      {"deformation",
       "strain, or angle of torsion [rad]; '5%' and '45deg' are understood; in uniaxial "
       "positive pulls and negative presses"},
      {"traction", "force per undeformed area x,y,z on the upper face in traction [Pa]"},
      {"plates", "how the lower plate holds in traction: glued (default) or sliding"},
      {"gradient",
       "displacement gradient of the boundary in affine, nine numbers by rows"},
      {"diagonal-ratio",
       "A = k_f/k_c of mss-fd, mss-cf and their lattices in fem-cauchy-born (default 1)"},
      {"stiffness-form",
       "spring constants from mu (default) or, as Eq. 5.12 prints, E; of "
       "fem-cauchy-born's lattice too"},
      {"stiffness",
       "KE,KF,KC of mss-custom: lattice values of its edge, face-diagonal and "
       "inner-diagonal springs at the scene's cell size [N/m]"},
      {"kappa", "modulus of mss-custom's volume correction [Pa] (default 0: none)"},
      {"correction",
       "volume correction of mss-vangelder and mss-lloyd: on (default), off"},
      {"lattice",
       "springs whose continuum fem-cauchy-born is: mss-baudet, mss-nfd, mss-fd, mss-cf "
       "(default), mss-affine"},
      {"lattice-direction",
       "direction of fem-cauchy-born's lattice along z: 100 (default), 110, 111"},
      {"cells", "number of cells along x,y,z"},
      {"size", "size of the block along x,y,z [m]"},
      {"cell-type",
       "how the block is cut: hexahedron (default), tetrahedron, prism, pyramid, mixed "
       "or another of 'springcheck list cell-types'"},
      {"distortion",
       "how far nodes inside the block are moved along each axis, as a fraction of the "
       "cell edge (default 0)"},
      {"mesh", "a .msh file (gmsh 2.2 or 4.1) in place of the block"},
      {"mesh-unit", "length unit of the .msh file: m (default), cm or mm"},
      {"fixed",
       "name of the .msh file's surface on the lower, fixed plate (default "
       "bottom)"},
      {"moved",
       "name of the one on the upper plate, which is moved or loaded (default "
       "top)"},
      {"solver",
       "of spring methods: static (default), limit (static, to where the path loses its "
       "stability or a cell is turned inside out), or dynamics by explicit (Euler), "
       "semi-implicit (Euler), verlet or implicit (Euler); fem-explicit methods are "
       "never static or implicit (default semi-implicit), other finite elements always "
       "static"},
      {"linear-solver",
       "of finite elements: auto (default: by size), direct or multigrid"},
      {"dt",
       "time step [s], or auto (default): 0.9 of the stability limit, followed as the "
       "body deforms"},
      {"dt-ratio",
       "of dt = auto: the step over the stability limit (default 0.9; above 1 to see "
       "what becomes of it)"},
      {"force-dt", "run even with a time step above the stability limit"},
      {"duration", "time over which the load grows in dynamics [s] (default 10)"},
      {"rate",
       "of the deformation or the largest component of a gradient, in place of a "
       "duration [1/s]: it is reached in deformation/rate"},
      {"load-times", "times [s], ascending, of load-fractions; in place of a duration"},
      {"load-fractions",
       "of the load at those times, straight between them and from 0 at rest: "
       "'0,1' after '1,2' holds still for a second"},
      {"angular-frequency",
       "of a load that swings, sin(omega t) [rad/s]; in place of a duration"},
      {"cycles", "of that load, also parts of one (default 5)"},
      {"organ", "liver, kidney or spleen: Golec 2018's law of it, for methods of tissue"},
      {"law",
       "K,n,GAMMA_LIM,p of tissue's bi-power law, but for mss-thesis-tissue: K [Pa s^n], "
       "others without unit"},
      {"branches", "Maxwell branches of tissue, 2 to 32 (default 5)"},
      {"time-steps",
       "of tissue's static solver, on each straight piece of the load (default 50), of a "
       "load "
       "that swings on each 64th of a cycle (default 1)"},
      {"damping",
       "in dynamics, fraction of critical (default 0.05): dashpots of springs, drag of "
       "fem-explicit methods"},
      {"precision", "of explicit steps: double (default) or float"},
      {"history",
       "samples of deformation, volume, plate force and torque, and energies at equal "
       "distances in time, on each straight piece of the load; in dynamics and of tissue "
       "(default: none)"},
      {"seed",
       "of distorted and mixed meshes, and of the choice between equal directions out of "
       "an unstable state (default 1)"},
      {"noise",
       "of static spring solutions: noise on the nodes' positions, in cell edges, from "
       "which they are solved again (default 0: none)"},
      {"reference",
       "METHOD[:ELEMENT][@CELLS|@converged] that deviations are measured against "
       "(default on the same mesh: fem-hooke:q1-sri up to a deformation of .02, "
       "fem-stvk:q1-sri above and in tests without a deformation)"}};
  return keys;
}

const std::vector<SettingKey>& scene_only_keys() {
  static const std::vector<SettingKey> keys{
      {"test",
       "compression, tension, shearing, torsion, bending, uniaxial, traction or affine"},
      {"body", "block (default), kidney or disc"},
      {"gravity", "acceleration in bending [m/s^2]"},
      {"expect", "statuses that end a run of one method with exit status 0"}};
  return keys;
}

}  // namespace springcheck
