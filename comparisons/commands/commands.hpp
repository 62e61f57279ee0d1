#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/named.hpp"
#include "comparisons/formats/table_format.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/settings/run_settings.hpp"

namespace springcheck {

/// Exit statuses that scripts depend on.
enum ExitStatus { done = 0, fell_short = 1, bad_input = 2, unexpected_status = 3 };

enum class Output { text, json };

enum class ErrorSplit { not_wanted, wanted };

/// When a run is no success: where one of its cases ends in a status that the scene does
/// not expect, where all of them do, or never.
enum class FailOn { any, all, none };

template <>
inline constexpr std::array value_names<FailOn>{
    Named{FailOn::any, "any"}, Named{FailOn::all, "all"}, Named{FailOn::none, "none"}};

struct RunOptions {
  std::optional<std::filesystem::path> out;  // result file
  Output output;
  ErrorSplit error_split;
  std::optional<FailOn> fail_on;  // none given: any of one case, none of several
  int parallel;                   // simulations that split the error
};

/// `springcheck run`: prints the results, and writes them to a file. A checkpoint is of
/// one method in dynamics, or InputError is thrown.
ExitStatus run_command(const std::string& scene, const std::vector<GivenSetting>& given,
                       const RunOptions& options, const Watch& watch);

/// Result files of a table: what to take cases from, where to write all of them.
struct TableFiles {
  std::vector<std::filesystem::path> from;
  std::optional<std::filesystem::path> out;
  Revisions revisions;  // of those that are taken
};

/// `springcheck table`: prints one table.
ExitStatus table_command(const std::string& name, const TableFiles& files,
                         const std::string& reference, TableFormat format, int parallel);

/// `springcheck table --list`: prints what tables there are, for a terminal where no
/// format is given.
ExitStatus list_tables_command(const std::optional<TableFormat>& format);

/// `springcheck list`; an empty `what` lists everything. Throws InputError for a list
/// that there is not.
ExitStatus list_command(const std::string& what, Output output);

/// What list_command prints as JSON: an empty `what` is everything, and nothing is there
/// of a list that there is not; its schema.
nlohmann::ordered_json list_json(const std::string& what);
nlohmann::ordered_json list_schema();

/// `springcheck schema`: prints the JSON schema of scene files, sweep files, gate files
/// or what commands print with --json. Throws InputError for another.
ExitStatus schema_command(const std::string& what);

/// "methods, scenes, ...": what list_command takes.
std::string list_names();

/// What is printed of a mesh: how much there is, or how good it is too.
enum class MeshReport { counts, quality };

/// `springcheck mesh`: writes the file, where one is named, and prints the report.
ExitStatus mesh_command(const std::string& scene,
                        const std::vector<GivenSetting>& options,
                        const std::optional<std::filesystem::path>& file,
                        MeshReport report);

}  // namespace springcheck
