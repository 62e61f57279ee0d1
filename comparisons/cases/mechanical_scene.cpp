#include "comparisons/cases/mechanical_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "comparisons/names/suggestion.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/loads/traction.hpp"

namespace springcheck {
namespace {

constexpr Held only_z{false, false, true};

Vector3 area_centre(const Mesh& mesh, const std::string& region) {
  const std::vector<double> areas = nodal_areas(mesh, mesh.region(region));
  Vector3 sum = Vector3::Zero();
  double area = 0;
  for (std::size_t n = 0; n < areas.size(); ++n) {
    sum += areas[n] * mesh.nodes()[n];
    area += areas[n];
  }
  return sum / area;
}

/// The extent of a region's nodes along z [m].
double height_of(const Mesh& mesh, const std::string& region) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const NodeIndex node : mesh.region(region).nodes) {
    low = std::min(low, mesh.nodes()[node].z());
    high = std::max(high, mesh.nodes()[node].z());
  }
  return high - low;
}

/// Centre and distance of a body's plates.
struct PlateGeometry {
  Vector3 centre;   // of the moved plate [m]
  double distance;  // along z [m]
};

PlateGeometry plate_geometry(const CaseSettings& settings, const Mesh& mesh) {
  const Body& body = settings.body;
  if (body.shape == BodyShape::block) {
    const auto [width, depth, height] = body.block.size;
    return {.centre = Vector3(width / 2, depth / 2, height), .distance = height};
  }
  if (!entry_of(settings.test).upper_plate)
    return {.centre = Vector3::Zero(), .distance = 0};
  if (body.moved == body.fixed)
    throw InputError(mesh.source(), "plates", "two regions",
                     fmt::format("'{}' as the fixed and the moved one", body.fixed));
  const Vector3 upper = area_centre(mesh, body.moved);
  const double distance = upper.z() - area_centre(mesh, body.fixed).z();
  if (!(distance > 0))
    throw InputError(mesh.source(), fmt::format("region '{}'", body.moved),
                     fmt::format("a plate above '{}', along z", body.fixed),
                     fmt::format("one {:.3g} m below it", -distance));
  // The plates of a body that lies along x or y are beside each other:
  constexpr double least_ratio = 0.1;
  const double height =
      std::max(height_of(mesh, body.moved), height_of(mesh, body.fixed));
  if (distance < least_ratio * height)
    throw InputError(mesh.source(), fmt::format("region '{}'", body.moved),
                     fmt::format("a plate above '{}', along z", body.fixed),
                     fmt::format("one {:.3g} m above it that is {:.3g} m high itself: "
                                 "the body's axis is not z",
                                 distance, height));
  return {.centre = upper, .distance = distance};
}

/// The cut that took the last faces of a surface; nullptr where the whole body has none.
const WantedCut* cut_that_took(const Body& body, const std::string& surface) {
  const auto has = [&](std::size_t cuts) {
    Body before = body;
    before.cuts.resize(cuts);
    return build_mesh(before).regions().contains(surface);
  };
  for (std::size_t i = body.cuts.size(); i-- > 0;)
    if (has(i)) return &body.cuts[i];
  return nullptr;
}

/// Pins hold corners of a block, which a cut may take away or part.
void check_pins(const Scene& scene, const Body& body, const Mesh& mesh) {
  if (body.cuts.empty()) return;
  for (const Pin& pin : scene.pins)
    if (std::ranges::count(mesh.nodes(), pin.point) != 1)
      throw InputError(body.cuts.front().place, "",
                       fmt::format("a corner left whole at ({:.6g}, {:.6g}, {:.6g}) m, "
                                   "where a pin holds the body",
                                   pin.point.x(), pin.point.y(), pin.point.z()),
                       "one that is parted or gone");
}

/// Refuses a plate's surface that the mesh does not have. gmsh's surfaces without a name
/// have their number as one.
void check_surface(const Mesh& mesh, const Body& body, const char* key,
                   const std::string& name) {
  if (mesh.regions().contains(name) || mesh.surfaces_elsewhere().contains(name)) return;
  if (const WantedCut* cut = cut_that_took(body, name))
    throw InputError(cut->place, fmt::format("cut '{}'", cut->name),
                     fmt::format("faces left on '{}', which is held or moved", name),
                     "none");
  std::vector<std::string_view> names;
  for (const auto& [known, region] : mesh.regions()) names.push_back(known);
  const std::string place = fmt::format("{}: {}", mesh.source(), key);
  const auto is_number = [](std::string_view text) {
    return text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (name.empty()) throw InputError(place, "", "the name of a surface", "none");
  if (!std::ranges::all_of(names, is_number)) refuse_name(place, "surface", name, names);
  const std::string there =
      names.empty() ? "a surface with the name"
                    : fmt::format("one of {}, or the name", fmt::join(names, ", "));
  throw InputError(
      place, "", fmt::format("{} '{}'", there, name),
      fmt::format("{} (in gmsh, before meshing, Physical Surface(\"{}\") = "
                  "{{...}}; gives it)",
                  names.empty() ? "none with a name" : "'" + name + "'", name));
}

}  // namespace

Scene mechanical_scene(const CaseSettings& settings, const Mesh& mesh) {
  const Body& body = settings.body;
  if (entry_of(settings.test).lower_plate) check_surface(mesh, body, "fixed", body.fixed);
  if (entry_of(settings.test).upper_plate) check_surface(mesh, body, "moved", body.moved);
  const PlateGeometry plates = plate_geometry(settings, mesh);
  const double height = plates.distance;
  const bool slides =
      entry_of(settings.test).slides ||
      (settings.test == Test::traction && settings.plates == PlateContact::sliding);
  Plate lower{.region = body.fixed,
              .motion = {.translation = Vector3::Zero(),
                         .axis = Vector3::UnitZ(),
                         .centre = plates.centre,
                         .angle = 0},
              .held = slides ? only_z : all_components};
  Plate upper = lower;
  upper.region = body.moved;
  RigidMotion& motion = upper.motion;
  Scene scene{.material = settings.material, .gravity = settings.gravity};
  if (slides)
    scene.pins = {
        {.point = Vector3::Zero(), .held = {true, true, false}},
        {.point = Vector3(body.block.size[0], 0, 0), .held = {false, true, false}}};
  check_pins(scene, body, mesh);

  switch (settings.test) {
    case Test::compression:
      motion.translation.z() = -settings.deformation.value() * height;
      break;
    case Test::tension:
    case Test::uniaxial:
      motion.translation.z() = settings.deformation.value() * height;
      break;
    case Test::shearing:
      motion.translation.x() = settings.deformation.value() * height;
      break;
    case Test::torsion:
      motion.angle = settings.deformation.value();
      break;
    case Test::bending:
      scene.plates = {lower};
      return scene;
    case Test::traction:
      scene.plates = {lower};
      scene.tractions = {{.region = body.moved, .stress = settings.traction}};
      return scene;
    case Test::affine:
      scene.boundary_gradient = settings.gradient;
      return scene;
  }
  scene.plates = {lower, upper};
  return scene;
}

}  // namespace springcheck
