#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// Cases of result files by key, with the file that holds their fields.
using StoredCases = std::map<std::string, std::pair<std::filesystem::path, StoredCase>>;

/// All cases of the files. Throws like read_results.
StoredCases stored_cases(const std::vector<std::filesystem::path>& files);

/// Warns of commits other than this program's, by which cases of the file were computed.
void warn_of_other_commits(const std::filesystem::path& file,
                           const std::set<std::string>& commits);
void warn_of_other_commits(const StoredCases& stored);

/// Leaves those that this very program computed: none if its sources were changed since
/// the commit.
StoredCases of_this_commit(StoredCases stored);

/// Supplies stored cases without fields; `stored` must outlive it.
KnownResult known_figures(const StoredCases& stored);

/// Supplies stored cases with the fields there are; `stored` and `meshes` must outlive
/// it.
KnownResult known_from(const StoredCases& stored, MeshStore& meshes);

/// Of known results in an equilibrium those alone that have their fields.
KnownResult only_with_fields(const KnownResult& known);

}  // namespace springcheck
