#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/stability/atlas.hpp"

namespace springcheck {

/// The cases of all methods at some values of the axes. Throws InputError.
std::vector<CaseSettings> cases_at(const AtlasPlan& plan,
                                   const std::vector<std::string>& values);

/// How cases fail: by locking too, judged by a control for each, where the plan wants it
/// judged. The keys of the controls go to `controls`, by the places of cases with one.
std::vector<Failure> failures_of(const AtlasPlan& plan, CaseRunner& runner,
                                 const std::vector<CaseResult>& results,
                                 std::map<std::size_t, std::string>* controls = nullptr);

}  // namespace springcheck
