#include "comparisons/stability/case_runner.hpp"

#include "comparisons/results/result_writer.hpp"
#include "comparisons/running/progress.hpp"

namespace springcheck {
namespace {

CaseResult without_fields(CaseResult result) {
  result.solution.displacements.clear();
  result.solution.reactions.clear();
  result.solution.cell_volumes.clear();
  result.solution.spring_strains.clear();
  result.deviation.clear();
  return result;
}

}  // namespace

CaseRunner::CaseRunner(const std::optional<std::filesystem::path>& file, int parallel,
                       Revisions revisions)
    : parallel_(parallel) {
  if (!file) return;
  if (std::filesystem::exists(*file)) {
    stored_ = stored_cases({*file}, revisions);
    warn_of_other_revisions(*file, stored_keys(*file), revisions);
  }
  file_.emplace(*file);
}

std::vector<std::string> CaseRunner::keys_of(const std::vector<CaseSettings>& settings) {
  std::vector<std::string> keys = own_keys_of(settings);
  for (std::string& key : keys)
    if (const auto found = stored_.find(key); found != stored_.end())
      key = found->second.second.key;
  return keys;
}

std::vector<std::string> CaseRunner::own_keys_of(
    const std::vector<CaseSettings>& settings) {
  std::vector<std::string> keys;
  for (const CaseSettings& one : settings)
    keys.push_back(case_key({.settings = one}, meshes_.mesh(one.body)));
  asked_.insert(keys.begin(), keys.end());
  return keys;
}

OtherRevisions CaseRunner::others() const {
  StoredCases taken;
  for (const std::string& key : asked_)
    if (const auto found = stored_.find(key); found != stored_.end())
      taken.insert(*found);
  return other_revisions(taken);
}

void CaseRunner::keep(const StoredMap& map) {
  if (file_) file_->put_map(map);
}

std::vector<CaseResult> CaseRunner::run(const std::vector<CaseSettings>& settings) {
  if (settings.empty()) return {};
  std::vector<Request> requests;
  for (const CaseSettings& one : settings) requests.push_back({.settings = one});
  const std::vector<std::string> keys = own_keys_of(settings);
  const KnownResult from_file = known_figures(stored_);
  const KnownResult known = [&](const Request& request, const std::string& key) {
    const auto found = results_.find(key);
    return found != results_.end() ? std::optional(found->second)
                                   : from_file(request, key);
  };
  std::vector<CaseResult> all(settings.size());
  {
    Progress progress("simulations");
    std::optional<ResultWriter> writer;
    if (file_) writer.emplace(*file_, false, meshes_);
    run_study(
        requests, meshes_, parallel_,
        [&](std::size_t done, std::size_t of) { progress.show(done, of); }, known,
        [&](std::size_t i, CaseResult&& result) {
          all[i] = without_fields(std::move(result));
          if (stored_.contains(keys[i]) || !written_.insert(keys[i]).second) return;
          if (writer) writer->put(CaseResult(all[i]));
        });
    if (writer) writer->finish();
  }
  for (std::size_t i = 0; i < all.size(); ++i) results_.insert_or_assign(keys[i], all[i]);
  return all;
}

}  // namespace springcheck
