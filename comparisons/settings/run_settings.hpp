#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/cases/status.hpp"
#include "comparisons/settings/given.hpp"
#include "comparisons/settings/method_choice.hpp"
#include "comparisons/settings/reference_method.hpp"

namespace springcheck {

/// What `run` computes: a case for each method, of otherwise equal settings.
struct RunSettings {
  CaseSettings common;      // its method is replaced by each of `methods`
  std::string cells_place;  // where the cell counts or the mesh were given, for messages
  std::vector<MethodChoice> methods;
  std::optional<ReferenceMethod> reference;  // none: chosen by the deformation
  std::vector<Status> expect;
};

/// Whether a method of the run, or its reference, is one of those.
bool runs(const RunSettings& run, const std::function<bool(const CaseSettings&)>& is_one);

/// Both lists, in which the second's values replace the first's.
inline GivenSettings operator+(GivenSettings all, const GivenSettings& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Builds the run of scene `name` from settings in order: a later one replaces an earlier
/// one of the same key. Every key must be known. `file` names the scene file in messages
/// about what is missing. Throws InputError.
RunSettings make_run_settings(const std::string& name, const std::string& file,
                              const GivenSettings& given);

/// Whether what the run ends with is a deformation of .02 or less.
bool deforms_little(const RunSettings& run);

enum class Deformations { small, any };

/// The reference of runs that name none, on their own mesh: fem-hooke:q1-sri where all
/// deform little, else fem-stvk:q1-sri, as in tests without a deformation.
ReferenceMethod usual_reference(Deformations deformations);

/// A request for each method, with the reference its deviations are measured against, the
/// usual one unless the run names another. The reference itself has none.
/// Throws InputError where the named reference's cells are no refinement of the run's.
std::vector<Request> requests(const RunSettings& run, const ReferenceMethod& usual);
std::vector<Request> requests(const RunSettings& run);  // usual for its own deformation

}  // namespace springcheck
