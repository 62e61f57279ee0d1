#pragma once

#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/results/case_rows.hpp"
#include "comparisons/store/lock_file.hpp"

namespace springcheck {

struct StoredChart;
struct StoredMap;

/// How many cases a file has of other revisions than this program's, by revision;
/// "unknown" are those of files from before there were any.
using OtherRevisions = std::map<std::string, std::size_t>;
inline constexpr std::string_view unknown_revision = "unknown";

/// The cases of a result file by their keys, and who computed them.
struct StoredKeys {
  std::map<std::string, Status> statuses;
  std::map<std::string, std::size_t> rows;  // of the table of cases
  std::set<std::string> with_fields;        // keys
  OtherRevisions others;
  // Keys of this program to those in the file, for cases that the file has of other
  // revisions alone:
  std::map<std::string, std::string> substitutes;
  OtherRevisions taken;  // of those others what Revisions::all takes
};

/// Whether a case is there, and where they are wanted its fields, or it was computed with
/// them and has none, as one that was refused.
bool holds(const StoredKeys& stored, const std::string& key, bool with_fields);

/// The keys of a file, or of one that is open (`file` is for messages). They throw like
/// read_cases.
StoredKeys stored_keys(const std::filesystem::path& file);
StoredKeys keys_in(hid_t root, const std::filesystem::path& file);

/// HDF5 layout 2; its groups and columns are told by layout.hpp.
///
/// Results are added whole or not at all, whatever ends the program
/// (comparisons/store/journal.hpp).
class ResultFile {
 public:
  /// Opens a result file to add to it; a missing one is made with the first results. What
  /// a killed program left is repaired. Throws InputError when it is not ours, of another
  /// layout, cannot be written, or another process is writing it.
  explicit ResultFile(const std::filesystem::path& file);

  /// What is in the file.
  [[nodiscard]] const StoredKeys& stored() const { return stored_; }

  /// Adds the results; those of keys in the file replace what it has. Fields are stored
  /// where results have them and `with_fields` says so. Nothing of status error is
  /// stored.
  void put(std::span<const CaseResult> results, bool with_fields, MeshStore& meshes);

  /// Keeps a map of cases, see write_map.
  void put_map(const StoredMap& map);

  /// Keeps a chart, see write_chart.
  void put_chart(const StoredChart& chart);

  /// Adds what another result file has and this one lacks: cases with their provenance,
  /// meshes, fields, maps, points of charts (see merged). Cases that both have stay as
  /// they are here, but get fields they lack. With `keys` those cases alone are added,
  /// and no maps or charts.
  struct Absorbed {
    std::size_t added = 0, already_there = 0;
    std::vector<std::string> conflicts{};  // cases of other figures, in words
    std::vector<std::string> roundings{};  // those that only rounding tells apart
  };
  Absorbed absorb(const std::filesystem::path& from,
                  const std::set<std::string>* keys = nullptr);

 private:
  void create();

  /// Commits what `change` does to the open file, wholly or not at all.
  void change(const std::function<void(hid_t root)>& change);

  /// Commits what `change` does with another result file open, which its writer may
  /// change meanwhile: `change` may be called again, and is committed when it saw one
  /// state of that file.
  void change_from(const std::filesystem::path& from,
                   const std::function<void(hid_t source, hid_t root)>& change);

  // Parts of absorb: fields of cases that both have, and cases that this file lacks.
  void copy_fields(const std::filesystem::path& from, std::vector<std::string> keys);
  void copy_cases(const std::filesystem::path& from, const Columns& theirs,
                  std::span<const std::size_t> rows, std::map<double, double>& sessions);

  std::filesystem::path file_;
  LockFile lock_;
  StoredKeys stored_;
  // Rows of this session by the revision of results, as CaseResult has it:
  std::map<std::string, std::size_t> sessions_;
};

/// Throws InputError unless write_xdmf_beside can write.
void check_xdmf_writable(const std::filesystem::path& file);

/// Writes an .xdmf for ParaView: FILE.xdmf beside the result file, of all cases that have
/// fields, or one elsewhere of those that are taken (see read_cases), which leads to the
/// result file by a relative path.
void write_xdmf_beside(const std::filesystem::path& file);
void write_xdmf_for(const std::filesystem::path& file, const std::filesystem::path& xdmf,
                    Revisions revisions);

/// Adds results with their fields, and writes the .xdmf.
void write_results(const std::filesystem::path& file, std::span<const CaseResult> results,
                   MeshStore& meshes);

/// Throws InputError unless write_results could write both files.
void check_results_writable(const std::filesystem::path& file);

/// The table of cases of a result file: those of this program's revision, and with
/// Revisions::all those of others of which it has none of this one, of several the
/// newest. Throws InputError for a file that is not HDF5, not ours, damaged, or of
/// another layout. A column other_revision has the revision of those of others.
Columns read_cases(const std::filesystem::path& file, Revisions revisions);

/// What is in the file, of any revision, superseded or not.
Columns all_cases(const std::filesystem::path& file);

/// Keys in an open file and their revisions, as CaseResult has them: of all its cases,
/// and of those that are taken.
std::map<std::string, std::string> all_revisions(hid_t root);
std::map<std::string, std::string> taken_revisions(hid_t root, Revisions revisions);

/// The cases of read_cases by the key that this program has for each, without fields.
/// Throws like read_cases and stored_case.
std::map<std::string, StoredCase> read_results(const std::filesystem::path& file,
                                               Revisions revisions);

/// Gives the result, whose key is in the file, the fields that are stored for it. Throws
/// InputError when they are not those of the mesh.
void read_fields(const std::filesystem::path& file, const Mesh& mesh, CaseResult& result);

}  // namespace springcheck
