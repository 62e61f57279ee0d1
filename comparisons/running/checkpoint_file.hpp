#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "comparisons/measures/history.hpp"
#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// The state that a case in dynamics is in, and what was sampled on the way there.
struct CaseCheckpoint {
  dynamics::Checkpoint march;
  History history{};
  HistoryFrames frames{};
  std::string revision{};  // see CaseResult
};

/// The case that a checkpoint belongs to: case_identity, which decides together with the
/// revision of the numerics, and settings_json, which tell what differs.
struct CheckpointOwner {
  std::string identity;
  nlohmann::json settings;
};

/// Writes it as an HDF5 file that appears whole or not at all: what was there before
/// stays until then. A program that is killed meanwhile leaves FILE.unfinished, which the
/// next one writes over. Throws std::runtime_error when not all could be written.
void write_checkpoint(const std::filesystem::path& file, const CheckpointOwner& owner,
                      const CaseCheckpoint& checkpoint);

/// The checkpoint of the file; none where there is no such file. Throws InputError where
/// it is no checkpoint, or one of another scene or mesh; the message tells which settings
/// differ. It also throws for one of another revision of the numerics, unless that is
/// accepted: then a warning says so, and what comes of it is of both revisions,
/// "theirs+ours", in this program as in others.
std::optional<CaseCheckpoint> read_checkpoint(const std::filesystem::path& file,
                                              const CheckpointOwner& owner,
                                              std::size_t nodes,
                                              Revisions revisions = Revisions::own);

}  // namespace springcheck
