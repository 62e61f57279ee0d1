#pragma once

#include <optional>
#include <string>

#include "comparisons/names/named.hpp"
#include "dynamics/precision.hpp"
#include "meshing/cell_type.hpp"

namespace springcheck {

template <>
inline constexpr std::array value_names<dynamics::Precision>{
    Named{dynamics::Precision::double_precision, "double"},
    Named{dynamics::Precision::single_precision, "float"}};

/// A way to simulate a scene, as charts compare them.
struct Model {
  std::string method{};                            // its name
  std::string element{};                           // of methods that read one
  CellType cells = CellType::hexahedron;           // all of one type
  std::string linear_solver{};                     // empty: by size
  std::optional<dynamics::Precision> precision{};  // of explicit steps; none at rest

  bool operator==(const Model&) const = default;
};

/// "fem-stvk:q1-sri, direct", "mss-affine on tetrahedra, double": what people read.
std::string name_of(const Model& model);

/// The model of that name; for files of before 0.3.0, which keep no more of it.
Model model_in(const std::string& name);

}  // namespace springcheck
