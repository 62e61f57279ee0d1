#include "comparisons/modes/body_modes.hpp"

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/methods/methods.hpp"
#include "fem_reference/statics/modes.hpp"
#include "mss/statics/modes.hpp"

namespace springcheck {
namespace {

MethodModes stable_or_not(const std::string& method, std::optional<NaturalModes> modes) {
  const char* reason = modes ? "" : "indefinite";
  return {.method = method, .modes = std::move(modes), .reason = reason};
}

MethodModes spring_modes(const Method& method, const CaseSettings& settings,
                         const Mesh& mesh, const std::vector<bool>& is_free, int count) {
  const auto network = method.network(settings, mesh);
  if (!network) return {.method = method.name, .reason = "refused"};
  return stable_or_not(method.name, mss::rest_modes(*network, is_free, count));
}

}  // namespace

std::vector<MethodModes> body_modes(const CaseSettings& settings, const Mesh& mesh,
                                    Hold hold, int count) {
  Scene scene = mechanical_scene(settings, mesh);
  if (hold == Hold::free) scene.plates.clear();
  using fem_reference::Element, fem_reference::MassMatrix;
  const auto elements = [&](const char* name, Element element, MassMatrix masses) {
    return stable_or_not(
        name, fem_reference::rest_modes(
                  mesh, scene, {.law = fem_reference::Law::hooke, .element = element},
                  masses, count));
  };
  std::vector<MethodModes> all{
      elements("FEM", Element::q1_sri, MassMatrix::consistent),
      elements("lumped FEM", Element::q1_sri, MassMatrix::lumped),
      elements("nodal FEM", Element::q1_nodal, MassMatrix::lumped)};
  const auto is_free = free_components(mesh, prescribed_components(mesh, scene));
  for (const char* name : {"mss-cf", "mss-affine", "mss-nfd"})
    all.push_back(spring_modes(*find_method(name), settings, mesh, is_free, count));
  return all;
}

}  // namespace springcheck
