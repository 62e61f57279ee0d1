#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/cases/status.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

/// A method with the element and the grid it runs on, as the user names it:
///
///     METHOD[:ELEMENT]              the element is q1-sri when none is named; the
///                                   case's own mesh
///     METHOD[:ELEMENT]@NX,NY,NZ     this many cells: whole multiples of the case's
///     METHOD[:ELEMENT]@N            N along x, the others in proportion
///     METHOD[:ELEMENT]@converged    extrapolated, see converged.hpp
struct ReferenceMethod {
  Method method;
  ElementName element;
  std::vector<int> cells{};  // none, N, or three
  ReferenceGrid grid = ReferenceGrid::one;
  std::string place{}, text{};  // where and how it was given, for messages
};

/// What `run` computes: a case for each method, of otherwise equal settings.
struct RunSettings {
  CaseSettings common;      // its method is replaced by each of `methods`
  std::string cells_place;  // where the cell counts or the mesh were given, for messages
  std::vector<Method> methods;
  std::optional<ReferenceMethod> reference;  // none: chosen by the deformation
  std::vector<Status> expect;
};

/// Reads a reference; whether its cells fit the case's is seen in requests().
ReferenceMethod reference_named(const Given& given);

/// One setting's name and help text.
struct SettingKey {
  std::string_view name;
  std::string_view help;
};

/// Every setting of scene files; those that are options of `run` too, and the others.
const std::vector<SettingKey>& option_keys();
const std::vector<SettingKey>& scene_only_keys();

/// A setting as given, by its key.
struct GivenSetting {
  std::string key;
  Given value;
};

/// Builds the run of scene `name` from settings in order: a later one replaces an earlier
/// one of the same key. Every key must be known. `file` names the scene file in messages
/// about what is missing. Throws InputError.
RunSettings make_run_settings(const std::string& name, const std::string& file,
                              const std::vector<GivenSetting>& given);

/// A request for each method, with the reference its deviations are measured against:
/// on the same mesh, fem-hooke:q1-sri up to a deformation of .02 and fem-stvk:q1-sri
/// above (and in tests without a deformation) unless the run names one. The reference
/// itself has none.
/// Throws InputError where the named reference's cells are no refinement of the run's.
std::vector<Request> requests(const RunSettings& run);

}  // namespace springcheck
