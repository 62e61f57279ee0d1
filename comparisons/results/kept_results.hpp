#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// A result file to which results are added with their fields, each as soon as it is
/// complete: a program that ends early loses only what it was computing.
class KeptResults {
 public:
  /// Throws InputError like ResultFile and check_xdmf_writable.
  KeptResults(const std::filesystem::path& file, MeshStore& meshes);

  /// Adds a result, unless one of its key was added.
  void keep(const CaseResult& result);

  /// Adds those of the results that were not, out of the files they were taken from, with
  /// who computed them; and writes the .xdmf.
  void finish(std::span<const CaseResult> results,
              std::span<const std::filesystem::path> from);

 private:
  std::filesystem::path path_;
  ResultFile file_;
  MeshStore& meshes_;
  std::set<std::string> kept_;  // keys
};

}  // namespace springcheck
