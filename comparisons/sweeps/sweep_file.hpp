#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// Many cases of equal make, from a TOML file:
///
///     scene = ["compression", "tension"]           names or paths of scenes
///     nu = {from = 0, to = 0.499, count = 11}      equal steps, both ends included
///     method = ["mss-cf", "fem-stvk"]              any option of `run`: one value, or
///     cells = [[5, 5, 5], [10, 10, 10]]            a list of them
///     fields = true                                store displacements, too (no: false)
///
///     [[cases]]                                    each in turn, with its own keys
///     deformation = ["5%", "20%"]
///
/// The cases are all combinations of the values, for each of the [[cases]] in turn, whose
/// keys replace those above; the last key varies fastest. A scene's own methods are taken
/// where no `method` is given.
struct Sweep {
  std::string name;
  bool with_fields;
  std::vector<Request> requests{};  // in order; some may be equal
};

/// The shipped sweep of that name or the file at that path. Throws InputError with file,
/// line and column, also where there would be more than `most` combinations.
Sweep read_sweep(const std::string& name_or_path, std::size_t most);

}  // namespace springcheck
