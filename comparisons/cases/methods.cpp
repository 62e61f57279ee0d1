#include "comparisons/cases/methods.hpp"

#include <algorithm>

namespace springcheck {
namespace {

template <class Entries>
auto find(const Entries& entries, std::string_view name) {
  const auto found = std::ranges::find_if(
      entries, [&](const auto& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<Method>& methods() {
  using fem_reference::ExplicitElement;
  using fem_reference::Law;
  static const std::vector<Method> all{
      {"mss-baudet", mss::Method::baudet, "edge and inner-diagonal springs after Baudet"},
      {"mss-nfd", mss::Method::nfd,
       "edge and inner-diagonal springs with volume correction"},
      {"mss-fd", mss::Method::fd,
       "all springs without correction: right at nu = 0.25 only"},
      {"mss-cf", mss::Method::cf, "all springs with volume correction (Golec 2018)"},
      {"mss-affine", mss::Method::affine, "virtual springs, on any cells of any shape"},
      {"mss-vangelder", mss::Method::vangelder,
       "edges of tetrahedra after Van Gelder (option --correction)"},
      {"mss-lloyd", mss::Method::lloyd,
       "edges of tetrahedra after Lloyd (option --correction)"},
      {"mss-custom", mss::Method::custom,
       "springs and volume correction of your own (options --stiffness, --kappa)"},
      {"mss-tissue", TissueModel::springs,
       "springs that remember, of a bi-power law (options --organ, --law)"},
      {"fem-tissue", TissueModel::elements,
       "finite elements of the same law, with a memory at 2x2x2 points; without inertia"},
      {"mss-thesis-tissue", TissueModel::thesis_springs,
       "springs of Golec 2018, Eq. 4.4, as printed, with hand-fitted limits"},
      {"mss-thesis-tissue-relative", TissueModel::thesis_springs_relative,
       "the same, elongations over the rest length: a force of any unit of length"},
      {"fem-hooke", Law::hooke, "finite elements, small-strain Hooke"},
      {"fem-stvk", Law::st_venant_kirchhoff, "finite elements, St-Venant-Kirchhoff"},
      {"fem-hencky", Law::hencky, "finite elements, Hencky (logarithmic strain)"},
      {"fem-cauchy-born", Law::cauchy_born,
       "finite elements, the continuum of a spring lattice (option --lattice)"},
      {"fem-explicit-1p", ExplicitElement::one_point,
       "finite elements stepped explicitly, St-Venant-Kirchhoff at one point with "
       "hourglass control; hexahedra only"},
      {"fem-explicit-8p", ExplicitElement::eight_points,
       "the same at 2x2x2 points: locks near nu = 0.5"}};
  return all;
}

const std::vector<ElementName>& elements() {
  using fem_reference::Element;
  static const std::vector<ElementName> all{
      {"q1", Element::q1, "linear or trilinear, full integration: locks near nu = 0.5"},
      {"q1-sri", Element::q1_sri,
       "the same, volumetric part from the cell's mean (selective reduced integration; "
       "on "
       "tetrahedra it is q1)"},
      {"q2", Element::q2, "triquadratic (27 nodes), 3x3x3 points; hexahedra only"}};
  return all;
}

const std::vector<LatticeName>& lattices() {
  using fem_reference::Springs;
  static const std::vector<LatticeName> all{{"mss-baudet", Springs::baudet},
                                            {"mss-nfd", Springs::nfd},
                                            {"mss-fd", Springs::fd},
                                            {"mss-cf", Springs::cf},
                                            {"mss-affine", Springs::affine}};
  return all;
}

const Method* find_method(std::string_view name) {
  return find(methods(), name);
}
const ElementName* find_element(std::string_view name) {
  return find(elements(), name);
}
const LatticeName* find_lattice(std::string_view name) {
  return find(lattices(), name);
}

}  // namespace springcheck
