#pragma once

#include <string_view>
#include <vector>

#include "fem_reference/laws/settings.hpp"

namespace springcheck {

/// A finite element by its name on the command line.
struct ElementName {
  std::string_view name;
  fem_reference::Element element;
  std::string_view description;
  int divisions;           // of a cell's edge by the element's nodes
  double multigrid_bytes;  // of memory for each of the parts so made, measured
};

/// Springs whose continuum fem-cauchy-born is, by the name of their method.
struct LatticeName {
  std::string_view name;
  fem_reference::Springs springs;
  std::vector<std::string_view> reads;  // settings of springs that it has too
};

}  // namespace springcheck
