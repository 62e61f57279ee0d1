#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fem_reference/laws/settings.hpp"
#include "meshing/loads/scene.hpp"
#include "mss/networks/spring_model.hpp"

namespace springcheck {

/// What a simpler method or element leaves out, in words, and the one that has it. A
/// method may leave out by intent: then nothing has it, and it is good where the path to
/// the full load stays stable.
struct Omission {
  std::string_view what;
  std::string_view by{};  // name; empty: nothing
  /// Words in its place where nothing is lost; nullptr or empty: something is.
  std::string_view (*no_loss)(const Material&) = nullptr;
};

/// A finite element by its name on the command line.
struct ElementName {
  std::string_view name;
  fem_reference::Element element;
  std::string_view description;
  int order;      // of the error of displacements in the mean, where they are smooth
  int divisions;  // of a cell's edge by the element's nodes
  double multigrid_bytes;         // of memory for each of the parts so made, measured
  double entries_per_node;        // of a stiffness matrix, inside a large grid
  double coupling = 1;            // of its factor's memory, as in LinearSystems
  std::vector<Omission> omits{};  // elements that do not
  bool locks = false;             // too stiff near nu = 1/2
};

/// Settings of springs that a method fixes, whatever a case has.
struct FixedSprings {
  std::optional<mss::StrainMeasure> strain{};
  std::optional<mss::Axes> axes{};
  std::optional<double> diagonal_ratio{};
};

/// Springs whose continuum fem-cauchy-born is, by the name of their method.
struct LatticeName {
  std::string name{};
  fem_reference::Springs springs;
  std::vector<std::string_view> reads{};  // settings of springs that it has too
  FixedSprings fixed{};                   // those of their method
  bool of_cubes = true;  // springs on other cells have another continuum, or are refused
};

}  // namespace springcheck
