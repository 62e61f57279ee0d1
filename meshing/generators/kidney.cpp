#include "meshing/generators/kidney.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <stdexcept>

#include "meshing/basics/input_error.hpp"
#include "meshing/generators/between_plates.hpp"
#include "meshing/generators/extent.hpp"
#include "meshing/gmsh/algorithms.hpp"
#include "meshing/gmsh/cells.hpp"
#include "meshing/gmsh/session.hpp"

namespace springcheck {
namespace {

std::string describe(const Kidney& kidney) {
  return fmt::format("kidney {} m in {} cells, {}", fmt::join(kidney.size, " x "),
                     fmt::join(kidney.cells, " x "), name_of(kidney.pattern));
}

void check(const Kidney& kidney) {
  check_extent(describe(kidney), kidney.size, kidney.cells);
  if (kidney.pattern != CellPattern::free_tetrahedron &&
      kidney.pattern != CellPattern::free_hexahedron)
    throw InputError(describe(kidney), "pattern", "free-tetrahedron or free-hexahedron",
                     "one for blocks");
}

/// An ellipsoid of these half axes in gmsh's current model; returns its number.
int add_ellipsoid(const Vector3& centre, const Vector3& half) {
  namespace occ = ::gmsh::model::occ;
  const int sphere = occ::addSphere(centre.x(), centre.y(), centre.z(), 1);
  occ::dilate({{3, sphere}}, centre.x(), centre.y(), centre.z(), half.x(), half.y(),
              half.z());
  return sphere;
}

/// size  of the trimmed kidney, in units of its largest
void add_geometry(const Vector3& size) {
  namespace occ = ::gmsh::model::occ;
  // Four fifths of the ellipsoid's height are left; its flat faces have three fifths of
  // its width and depth.
  const Vector3 half(size.x() / 2, size.y() / 2, size.z() / 2 / 0.8);
  const Vector3 centre(0, 0, size.z() / 2);
  const int body = add_ellipsoid(centre, half);
  // A fifth of the width deep, as high as the body where it is deepest, and clear of the
  // flat faces.
  const int hilum = add_ellipsoid(centre + 1.1 * half.x() * Vector3::UnitX(),
                                  half.cwiseProduct(Vector3(0.5, 0.4, 1)));
  ::gmsh::vectorpair hollowed, trimmed;
  std::vector<::gmsh::vectorpair> origins;
  occ::cut({{3, body}}, {{3, hilum}}, hollowed, origins);
  const int slab = occ::addBox(-1, -1, 0, 2, 2, size.z());
  occ::intersect(hollowed, {{3, slab}}, trimmed, origins);
  occ::synchronize();
}

MeshParts kidney_cells(const Kidney& kidney, double unit) {
  const GmshSession session("kidney");
  const Vector3 size = Vector3(kidney.size.data()) / unit;
  add_geometry(size);
  const double edge_length = (size[0] / kidney.cells[0] + size[1] / kidney.cells[1] +
                              size[2] / kidney.cells[2]) /
                             3;
  if (kidney.pattern == CellPattern::free_hexahedron)
    generate_hexahedra(edge_length);
  else
    generate_tetrahedra(edge_length);
  return gmsh_cells();
}

}  // namespace

Mesh generate_kidney(const Kidney& kidney) try {
  check(kidney);
  // OpenCASCADE's tolerances are lengths: it works in units of the kidney's largest.
  const double unit = std::ranges::max(kidney.size), height = kidney.size[2];
  return mesh_between_plates(describe(kidney), kidney_cells(kidney, unit), unit, height);
} catch (const std::string& message) {  // what gmsh throws
  throw std::runtime_error("gmsh: " + message);
}

}  // namespace springcheck
