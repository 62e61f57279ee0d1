#include "comparisons/results/known_results.hpp"

#include <spdlog/spdlog.h>

#include <set>
#include <string_view>

#include "comparisons/build_info/build_info.hpp"

namespace springcheck {

StoredCases stored_cases(const std::vector<std::filesystem::path>& files) {
  StoredCases all;
  for (const std::filesystem::path& file : files)
    for (auto& [key, stored] : read_results(file))
      all.try_emplace(key, file, std::move(stored));
  return all;
}

void warn_of_other_commits(const StoredCases& stored) {
  std::map<std::filesystem::path, std::set<std::string>> commits;
  for (const auto& [key, place] : stored)
    commits[place.first].insert(place.second.commit);
  for (const auto& [file, all] : commits) warn_of_other_commits(file, all);
}

void warn_of_other_commits(const std::filesystem::path& file,
                           const std::set<std::string>& commits) {
  for (const std::string& commit : commits)
    if (commit != build_info::commit)
      spdlog::warn("{} holds cases of commit {}, this program is {}", file.string(),
                   commit, build_info::commit);
}

StoredCases of_this_commit(StoredCases stored) {
  const std::string_view commit = build_info::commit;
  const bool is_known = !commit.ends_with("-dirty") && commit != "unknown";
  std::erase_if(stored, [&](const auto& entry) {
    return !is_known || entry.second.second.commit != commit;
  });
  return stored;
}

KnownResult known_figures(const StoredCases& stored) {
  return
      [&](const Request& request, const std::string& key) -> std::optional<CaseResult> {
        const auto found = stored.find(key);
        if (found == stored.end()) return std::nullopt;
        return with_stored(request, key, found->second.second);
      };
}

KnownResult known_from(const StoredCases& stored, MeshStore& meshes) {
  return [&, figures = known_figures(stored)](const Request& request,
                                              const std::string& key) {
    auto result = figures(request, key);
    if (result)
      read_fields(stored.at(key).first, meshes.mesh(request.settings.body), *result);
    return result;
  };
}

KnownResult only_with_fields(const KnownResult& known) {
  return [known](const Request& request, const std::string& key) {
    auto result = known(request, key);
    if (result && result->measures.volume_error && result->solution.displacements.empty())
      result.reset();
    return result;
  };
}

}  // namespace springcheck
