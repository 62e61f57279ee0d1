#include "comparisons/known_results.hpp"

#include <spdlog/spdlog.h>

#include <set>
#include <string_view>

#include "comparisons/build_info.hpp"

namespace springcheck {

StoredCases stored_cases(const std::vector<std::filesystem::path>& files) {
  StoredCases all;
  for (const std::filesystem::path& file : files)
    for (auto& [key, stored] : read_results(file))
      all.try_emplace(key, file, std::move(stored));
  return all;
}

void warn_of_other_commits(const StoredCases& stored) {
  std::set<std::pair<std::string, std::string>> others;  // file, commit
  for (const auto& [key, place] : stored)
    if (const auto& [file, one] = place; one.commit != build_info::commit)
      others.emplace(file.string(), one.commit);
  for (const auto& [file, commit] : others)
    spdlog::warn("{} holds cases of commit {}, this program is {}", file, commit,
                 build_info::commit);
}

StoredCases of_this_commit(StoredCases stored) {
  const std::string_view commit = build_info::commit;
  const bool is_known = !commit.ends_with("-dirty") && commit != "unknown";
  std::erase_if(stored, [&](const auto& entry) {
    return !is_known || entry.second.second.commit != commit;
  });
  return stored;
}

KnownResult known_from(const StoredCases& stored, MeshStore& meshes) {
  return
      [&](const Request& request, const std::string& key) -> std::optional<CaseResult> {
        const auto found = stored.find(key);
        if (found == stored.end()) return std::nullopt;
        const auto& [file, stored_case] = found->second;
        CaseResult result = with_stored(request, key, stored_case);
        read_fields(file, meshes.mesh(request.settings.block), result);
        return result;
      };
}

}  // namespace springcheck
