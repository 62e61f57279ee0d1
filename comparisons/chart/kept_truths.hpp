#pragma once

#include <filesystem>
#include <optional>

#include "comparisons/results/known_results.hpp"

namespace springcheck {

/// Truths of earlier charts, kept for later ones of any scene in a result file that is
/// the user's: $XDG_CACHE_HOME/springcheck, or ~/.cache/springcheck. Each revision of the
/// numerics has its own. It may be removed at any time, and is begun anew beyond 500 MB.
///
/// A file that cannot be read or written, or that another process is writing, is told on
/// stderr once, and left alone for the rest.
class KeptTruths {
 public:
  explicit KeptTruths(std::filesystem::path file);

  /// The kept result with its fields; none where it is not kept.
  [[nodiscard]] std::optional<CaseResult> known(const Request& request,
                                                const std::string& key,
                                                MeshStore& meshes);

  /// Keeps an equilibrium that has its fields.
  void keep(const CaseResult& result, MeshStore& meshes);

 private:
  void leave_alone(const std::exception& why);

  std::filesystem::path file_;
  StoredCases stored_;
  bool is_left_alone_ = false;
};

/// The user's file; none where the environment names no place.
std::optional<std::filesystem::path> users_truths_file();

}  // namespace springcheck
