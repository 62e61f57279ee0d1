#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "comparisons/results/known_results.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/results/stored_map.hpp"

namespace springcheck {

/// Runs cases one batch after another, each once: what an earlier batch or the result
/// file holds is not computed again. Results have no fields.
class CaseRunner {
 public:
  /// Takes cases from `file` and adds them to it; without one they are kept until the end
  /// alone.
  CaseRunner(const std::optional<std::filesystem::path>& file, int parallel,
             Revisions revisions = Revisions::own);

  /// The results in the order of the settings.
  std::vector<CaseResult> run(const std::vector<CaseSettings>& settings);

  /// The keys of cases in the order of the settings; those in the file for cases that are
  /// taken from there.
  std::vector<std::string> keys_of(const std::vector<CaseSettings>& settings);

  /// Keeps a map of cases in the result file, if there is one.
  void keep(const StoredMap& map);

  /// The other revisions of the cases so far, run or asked for their keys.
  [[nodiscard]] OtherRevisions others() const;

  /// How many cases were computed, because nothing held them.
  [[nodiscard]] std::size_t computed() const { return written_.size(); }

 private:
  std::vector<std::string> own_keys_of(const std::vector<CaseSettings>& settings);

  StoredCases stored_;  // of the file, before
  std::optional<ResultFile> file_;
  MeshStore meshes_;
  int parallel_;
  std::map<std::string, CaseResult> results_;  // by this program's key
  std::set<std::string> written_;              // keys
  std::set<std::string> asked_;                // this program's keys
};

}  // namespace springcheck
