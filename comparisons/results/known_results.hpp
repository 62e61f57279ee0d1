#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// Cases of result files by the key that this program has for them, with the file that
/// holds their fields.
using StoredCases = std::map<std::string, std::pair<std::filesystem::path, StoredCase>>;

/// The cases of the files; of those that several have, the first with this program's
/// revision, or else the newest. Throws like read_results.
StoredCases stored_cases(const std::vector<std::filesystem::path>& files,
                         Revisions revisions);

/// All cases of the file by their keys in it, as its maps and charts name them.
std::map<std::string, StoredCase> results_by_stored_key(
    const std::filesystem::path& file);

/// What a file has of other revisions and is not taken, or with Revisions::all what is
/// taken of them, in words; empty where there is none.
std::string note_of_other_revisions(const StoredKeys& stored, Revisions revisions);

/// The cases that are of other revisions, each once.
OtherRevisions other_revisions(std::span<const CaseResult> results);
OtherRevisions other_revisions(const StoredCases& stored);

/// What a table or page says of cases of other revisions that it is made of.
std::string note_of_taken(const OtherRevisions& others);

/// Adds note_of_taken to the notes of what is made of these results, where it says
/// something.
void add_note_of_taken(std::vector<std::string>& notes,
                       std::span<const CaseResult> results);

/// Says what there is of other revisions on stderr.
void warn_of_other_revisions(const std::filesystem::path& file, const StoredKeys& stored,
                             Revisions revisions);

/// Supplies stored cases without fields; `stored` must outlive it.
KnownResult known_figures(const StoredCases& stored);

/// Supplies stored cases with the fields there are; `stored` and `meshes` must outlive
/// it.
KnownResult known_from(const StoredCases& stored, MeshStore& meshes);

/// Supplies known results, but those in an equilibrium only where they have their fields.
KnownResult only_with_fields(const KnownResult& known);

}  // namespace springcheck
