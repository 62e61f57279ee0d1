#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/settings/reference_method.hpp"
#include "comparisons/settings/scene_file.hpp"

namespace springcheck {

/// A key with the values it takes in turn.
struct Choices {
  std::string key;
  std::vector<Given> values;
};

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
/// where no `method` is given. One law is the usual reference of all, or there would be a
/// step where the deformation passes a limit.
struct Sweep {
  std::string name;
  std::string file;  // as messages name it
  bool with_fields;
  std::vector<std::vector<Choices>> products{};  // of each of the [[cases]]
  std::map<std::string, SceneFile> scenes{};     // by their names in the file
  ReferenceMethod usual_reference{};             // of cases that name none
};

/// Whether any case takes the usual reference, judged by what the first of each of the
/// [[cases]] is: tissue takes none.
bool takes_usual_reference(const Sweep& sweep);

/// The shipped sweep of that name or the file at that path. Throws InputError with file,
/// line and column, also where there would be more than `most` combinations.
Sweep read_sweep(const std::string& name_or_path, std::size_t most);

/// How many combinations of values there are.
std::size_t combination_count(const Sweep& sweep);

/// The requests of one combination, for each of its methods; those of several
/// combinations may be equal. Throws InputError where no test allows the combination.
std::vector<Request> requests_of(const Sweep& sweep, std::size_t combination);

/// The requests of all combinations in order, which are to be few: a request takes some
/// 10 kB.
std::vector<Request> all_requests(const Sweep& sweep);

}  // namespace springcheck
