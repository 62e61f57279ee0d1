#include "comparisons/results/known_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <set>
#include <string_view>

#include "comparisons/build_info/build_info.hpp"

namespace springcheck {

StoredCases stored_cases(const std::vector<std::filesystem::path>& files,
                         Revisions revisions) {
  StoredCases all;
  for (const std::filesystem::path& file : files)
    for (auto& [key, stored] : read_results(file, revisions)) {
      const auto [place, is_new] = all.try_emplace(key, file, stored);
      const StoredCase& first = place->second.second;
      const bool is_better = !first.revision.empty() &&
                             (stored.revision.empty() || stored.date > first.date);
      if (!is_new && is_better) place->second = {file, std::move(stored)};
    }
  return all;
}

namespace {

/// "3 of a1b2c3d4e5f6, 60 of an unknown one"
std::string listed(const OtherRevisions& others) {
  std::vector<std::string> all;
  for (const auto& [revision, cases] : others)
    all.push_back(fmt::format(
        "{} of {}", cases, revision == unknown_revision ? "an unknown one" : revision));
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

std::string note_of_other_revisions(const StoredKeys& stored, Revisions revisions) {
  const OtherRevisions& others =
      revisions == Revisions::all ? stored.taken : stored.others;
  if (others.empty()) return "";
  std::size_t all = 0;
  for (const auto& [revision, cases] : others) all += cases;
  return fmt::format(
      "{} cases of other revisions of the numerics ({}) than this program's {} are {}",
      all, listed(others), build_info::revision,
      revisions == Revisions::all ? "taken where there are none of its own"
                                  : "not taken without --accept-other-revisions");
}

OtherRevisions other_revisions(std::span<const CaseResult> results) {
  OtherRevisions others;
  std::set<std::string_view> seen;
  for (const CaseResult& result : results)
    if (!result.revision.empty() && seen.insert(result.key).second)
      ++others[result.revision];
  return others;
}

OtherRevisions other_revisions(const StoredCases& stored) {
  OtherRevisions others;
  for (const auto& [key, place] : stored)
    if (!place.second.revision.empty()) ++others[place.second.revision];
  return others;
}

std::string note_of_taken(const OtherRevisions& others) {
  return fmt::format(
      "Made of cases of other revisions of the numerics ({}) than this program's {}, as "
      "asked.",
      listed(others), build_info::revision);
}

void add_note_of_taken(std::vector<std::string>& notes,
                       std::span<const CaseResult> results) {
  if (const OtherRevisions others = other_revisions(results); !others.empty())
    notes.push_back(note_of_taken(others));
}

void warn_of_other_revisions(const std::filesystem::path& file, const StoredKeys& stored,
                             Revisions revisions) {
  const std::string note = note_of_other_revisions(stored, revisions);
  if (!note.empty()) spdlog::warn("{}: {}", file.string(), note);
}

std::map<std::string, StoredCase> results_by_stored_key(
    const std::filesystem::path& file) {
  const Columns cases = all_cases(file);
  std::map<std::string, StoredCase> all;
  for (std::size_t row = 0; row < cases.rows; ++row) {
    StoredCase stored = stored_case(cases, row, file.string());
    const std::string key = stored.key;
    all.emplace(key, std::move(stored));
  }
  return all;
}

KnownResult known_figures(const StoredCases& stored) {
  return
      [&](const Request& request, const std::string& key) -> std::optional<CaseResult> {
        const auto found = stored.find(key);
        if (found == stored.end()) return std::nullopt;
        return with_stored(request, found->second.second);
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
