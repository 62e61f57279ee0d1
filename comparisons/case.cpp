#include "comparisons/case.hpp"

#include <nlohmann/json.hpp>

namespace springcheck {

std::string_view name_of(Test test) {
  switch (test) {
    case Test::compression:
      return "compression";
    case Test::tension:
      return "tension";
    case Test::shearing:
      return "shearing";
    case Test::torsion:
      return "torsion";
    case Test::bending:
      return "bending";
  }
  return {};
}

std::string_view name_of(mss::Solver solver) {
  return solver == mss::Solver::static_equilibrium ? "static" : "semi-implicit";
}

std::string_view name_of(mss::StiffnessForm form) {
  return form == mss::StiffnessForm::shear_modulus ? "mu" : "E";
}

Scene mechanical_scene(const CaseSettings& settings) {
  const auto [width, depth, height] = settings.block.size;
  const RigidMotion at_rest{.translation = Vector3::Zero(),
                            .axis = Vector3::UnitZ(),
                            .centre = Vector3(width / 2, depth / 2, height),
                            .angle = 0};
  Scene scene{.material = settings.material,
              .plates = {{.region = "bottom", .motion = at_rest}},
              .gravity = settings.gravity};
  if (settings.test == Test::bending) return scene;

  RigidMotion motion = at_rest;
  const double deformation = settings.deformation.value();
  switch (settings.test) {
    case Test::compression:
      motion.translation.z() = -deformation * height;
      break;
    case Test::tension:
      motion.translation.z() = deformation * height;
      break;
    case Test::shearing:
      motion.translation.x() = deformation * height;
      break;
    case Test::torsion:
      motion.angle = deformation;
      break;
    case Test::bending:
      break;
  }
  scene.plates.push_back({.region = "top", .motion = motion});
  return scene;
}

nlohmann::json settings_json(const CaseSettings& settings) {
  nlohmann::json json{
      {"scene", settings.scene},
      {"test", name_of(settings.test)},
      {"size", settings.block.size},
      {"cells", settings.block.cells},
      {"young", settings.material.young_modulus},
      {"nu", settings.material.poisson_ratio},
      {"density", settings.material.density},
      {"method", settings.method.name},
  };
  if (settings.deformation) json["deformation"] = *settings.deformation;
  if (settings.test == Test::bending)
    json["gravity"] = {settings.gravity.x(), settings.gravity.y(), settings.gravity.z()};
  if (is_finite_element(settings.method)) {
    json["element"] = settings.element.name;
    json["solver"] = "static";
    return json;
  }
  const auto springs = std::get<mss::Method>(settings.method.model);
  if (springs != mss::Method::baudet)
    json["stiffness-form"] = name_of(settings.stiffness_form);
  if (springs == mss::Method::fd || springs == mss::Method::cf)
    json["diagonal-ratio"] = settings.diagonal_ratio;
  json["solver"] = name_of(settings.solver);
  if (settings.solver == mss::Solver::static_equilibrium) {
    json["seed"] = settings.seed;
    return json;
  }
  json["duration"] = settings.dynamics.duration;
  json["damping"] = settings.dynamics.damping_ratio;
  json["force-dt"] = settings.dynamics.force_time_step;
  if (settings.dynamics.time_step)
    json["dt"] = *settings.dynamics.time_step;
  else
    json["dt"] = "auto";
  return json;
}

std::string label(const CaseSettings& settings) {
  std::string text(settings.method.name);
  if (is_finite_element(settings.method))
    text += ":" + std::string(settings.element.name);
  return text;
}

}  // namespace springcheck
