#include "comparisons/running/checkpoint_file.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "comparisons/system/processor.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

constexpr long long layout = 5;

std::vector<Vector3> vectors(const std::vector<double>& numbers) {
  std::vector<Vector3> all;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    all.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return all;
}

/// "nu = 0.3, solver = verlet": of the settings those that the other has not as well.
std::string own_settings(const nlohmann::json& settings, const nlohmann::json& other) {
  std::vector<std::string> own;
  for (const auto& [name, value] : settings.items())
    if (!other.contains(name) || other[name] != value)
      own.push_back(fmt::format("{} = {}", name, value.dump()));
  return fmt::format("{}", fmt::join(own, ", "));
}

/// Throws InputError: a checkpoint that stores these settings is not the owner's.
[[noreturn]] void refuse_other(const std::filesystem::path& file,
                               const CheckpointOwner& owner,
                               const nlohmann::json& stored) {
  std::string expected = own_settings(owner.settings, stored),
              got = own_settings(stored, owner.settings);
  if (expected.empty() && got.empty()) {
    expected = "this mesh";
    got = "the same settings with another mesh";
  }
  const auto or_default = [](const std::string& text) {
    return text.empty() ? std::string("none of these settings") : text;
  };
  throw InputError(file.string(), "checkpoint of another case", or_default(expected),
                   or_default(got));
}

/// The revision of what goes on from this one.
std::string continued(const std::string& revision) {
  const std::string own = build_info::revision;
  return revision.ends_with("+" + own) ? revision : revision + "+" + own;
}

/// The same case, by other numerics.
void check_revision(const std::filesystem::path& file, const std::string& revision,
                    Revisions accepted) {
  if (accepted == Revisions::own)
    throw InputError(
        file.string(), "checkpoint of another revision of the numerics",
        build_info::revision,
        revision + "; --accept-other-revisions goes on from it all the same");
  spdlog::warn("{}: going on from revision {} of the numerics, this program's is {}",
               file.string(), revision, build_info::revision);
}

/// What an open checkpoint has. Throws InputError where it is not as expected.
class Reader {
 public:
  Reader(hid_t root, const std::filesystem::path& file)
      : root_(root), file_(file.string()) {}

  [[noreturn]] void refuse(const std::string& entity, const std::string& expected,
                           const std::string& got) const {
    throw InputError(file_, entity, expected, got);
  }

  [[nodiscard]] double number(const char* name) const {
    const auto values = hdf5::read_numbers(root_, name);
    if (!values || values->size() != 1)
      refuse(fmt::format("attribute '{}'", name),
             "a number, in a checkpoint of springcheck", "none");
    return values->front();
  }

  [[nodiscard]] int count(const char* name) const {
    const double value = number(name);
    if (!(value >= 0 && value <= std::numeric_limits<int>::max()))
      refuse(fmt::format("attribute '{}'", name), "a number of steps",
             fmt::to_string(value));
    return static_cast<int>(value);
  }

  [[nodiscard]] std::vector<double> table(const char* name,
                                          std::optional<std::size_t> size) const {
    const auto values = hdf5::read_table(root_, name);
    if (!values || (size && values->size() != *size))
      refuse(fmt::format("table '{}'", name), fmt::format("{} numbers", size.value_or(0)),
             fmt::to_string(values ? values->size() : 0));
    return *values;
  }

 private:
  hid_t root_;
  std::string file_;
};

History history(hid_t root, const Reader& reader) {
  History samples;
  if (!hdf5::has_link(root, "history")) return samples;
  const std::vector<double> rows = reader.table("history", std::nullopt);
  constexpr std::size_t columns = history_columns.size();
  if (rows.size() % columns != 0)
    reader.refuse("table 'history'", fmt::format("rows of {} numbers", columns),
                  fmt::format("{} numbers", rows.size()));
  for (std::size_t i = 0; i < rows.size(); i += columns)
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(i), columns,
                samples.emplace_back().begin());
  return samples;
}

HistoryFrames frames(hid_t root, const Reader& reader, std::size_t nodes) {
  HistoryFrames kept;
  if (!hdf5::has_link(root, "frame_sample")) return kept;
  const std::vector<double> samples = reader.table("frame_sample", std::nullopt);
  const std::vector<double> all =
      reader.table("frame_displacement", 3 * nodes * samples.size());
  for (std::size_t f = 0; f < samples.size(); ++f) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(3 * nodes * f);
    kept.push_back({.sample = static_cast<std::size_t>(samples[f]),
                    .displacements = vectors(
                        {begin, begin + static_cast<std::ptrdiff_t>(3 * nodes)})});
  }
  return kept;
}

/// Throws InputError, or warns, where the checkpoint is not of this layout, this case,
/// this revision or this kind of processor; returns the revision, empty of this one.
std::string checked_revision(hid_t root, const Reader& reader,
                             const std::filesystem::path& file,
                             const CheckpointOwner& owner, Revisions revisions) {
  if (reader.number("layout") != static_cast<double>(layout))
    reader.refuse("attribute 'layout'", fmt::to_string(layout),
                  fmt::to_string(reader.number("layout")));
  const auto identity = hdf5::read_text(root, "identity");
  if (!identity)
    reader.refuse("attribute 'identity'", "a checkpoint that tells what was asked",
                  "none, as of programs before 0.3.0");
  if (*identity != owner.identity)
    refuse_other(file, owner,
                 nlohmann::json::parse(hdf5::read_text(root, "settings").value_or("{}"),
                                       nullptr, false));
  const std::string revision = hdf5::read_text(root, "revision").value_or("unknown");
  const bool is_own = revision == build_info::revision;
  if (!is_own) check_revision(file, revision, revisions);
  const std::string set = hdf5::read_text(root, "instructions").value_or("unknown");
  if (set != instructions())
    spdlog::warn(
        "{}: computed with instructions {}, here they are {}: the digits of an "
        "uninterrupted run come back only to rounding",
        file.string(), set, instructions());
  return is_own ? "" : continued(revision);
}

CaseCheckpoint read(const std::filesystem::path& file, const CheckpointOwner& owner,
                    std::size_t nodes, Revisions revisions) {
  const auto root = hdf5::open_file(file);
  const Reader reader(root, file);
  std::string revision = checked_revision(root, reader, file, owner, revisions);
  CaseCheckpoint checkpoint{
      .march = {.state = {.displacements =
                              vectors(reader.table("displacement", 3 * nodes)),
                          .velocities = vectors(reader.table("velocity", 3 * nodes))},
                .step = reader.count("step"),
                .time = reader.number("time"),
                .dt = reader.number("dt"),
                .last_dt = reader.number("last_dt"),
                .steps_left = reader.count("steps_left"),
                .limit = reader.number("limit"),
                .look_evaluations = reader.count("look_evaluations")},
      .history = history(root, reader),
      .frames = frames(root, reader, nodes),
      .revision = std::move(revision)};
  if (hdf5::has_link(root, "stiffest"))
    checkpoint.march.stiffest = reader.table("stiffest", 3 * nodes);
  if (hdf5::read_numbers(root, "excess_limit"))
    checkpoint.march.excess = {.step = reader.count("excess_step"),
                               .dt = reader.number("excess_dt"),
                               .limit = reader.number("excess_limit")};
  return checkpoint;
}

void write_content(OverlayFile& overlay, const std::filesystem::path& file,
                   const CheckpointOwner& owner, const CaseCheckpoint& checkpoint) {
  const hdf5::Handle root(overlay.create(), H5Fclose, file.string());
  const auto& [state, step, time, dt, last_dt, steps_left, limit, stiffest,
               look_evaluations, excess] = checkpoint.march;
  hdf5::write_attribute(root, "layout", layout);
  hdf5::write_attribute(root, "identity", owner.identity);
  hdf5::write_attribute(
      root, "revision",
      checkpoint.revision.empty() ? build_info::revision : checkpoint.revision);
  hdf5::write_attribute(root, "settings", owner.settings.dump());
  hdf5::write_attribute(root, "instructions", instructions());
  hdf5::write_attribute(root, "step", static_cast<double>(step));
  hdf5::write_attribute(root, "time", time);
  hdf5::write_attribute(root, "dt", dt);
  hdf5::write_attribute(root, "last_dt", last_dt);
  hdf5::write_attribute(root, "steps_left", static_cast<double>(steps_left));
  hdf5::write_attribute(root, "limit", limit);
  hdf5::write_attribute(root, "look_evaluations", static_cast<double>(look_evaluations));
  if (excess) {
    hdf5::write_attribute(root, "excess_step", static_cast<double>(excess->step));
    hdf5::write_attribute(root, "excess_dt", excess->dt);
    hdf5::write_attribute(root, "excess_limit", excess->limit);
  }
  hdf5::write_table(root, "displacement", state.displacements);
  hdf5::write_table(root, "velocity", state.velocities);
  if (!stiffest.empty()) hdf5::write_table(root, "stiffest", stiffest, 3);
  if (!checkpoint.history.empty()) {
    std::vector<double> rows;
    for (const HistorySample& sample : checkpoint.history)
      rows.insert(rows.end(), sample.begin(), sample.end());
    hdf5::write_table(root, "history", rows, history_columns.size());
  }
  if (checkpoint.frames.empty()) return;
  const JoinedFrames frames = joined_frames(checkpoint.frames);
  hdf5::write_table(root, "frame_sample", frames.samples, 1);
  hdf5::write_table(root, "frame_displacement", frames.displacements);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const CheckpointOwner& owner,
                      const CaseCheckpoint& checkpoint) {
  const std::filesystem::path place = link_target(file);
  const std::filesystem::path unfinished = place.string() + ".unfinished";
  try {
    if (!std::ofstream(unfinished, std::ios::trunc).flush())
      throw std::runtime_error(unfinished.string() + " cannot be written");
    if (std::filesystem::exists(place))
      std::filesystem::permissions(unfinished,
                                   std::filesystem::status(place).permissions());
    OverlayFile overlay(unfinished);
    write_content(overlay, unfinished, owner, checkpoint);
    write_pages_of_new_file(unfinished, overlay.writes());
    std::filesystem::rename(unfinished, place);
    sync_folder_of(place);
  } catch (...) {
    std::error_code ignored;  // the first failure is the one to report
    std::filesystem::remove(unfinished, ignored);
    throw;
  }
}

std::optional<CaseCheckpoint> read_checkpoint(const std::filesystem::path& file,
                                              const CheckpointOwner& owner,
                                              std::size_t nodes, Revisions revisions) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    return read(file, owner, nodes, revisions);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {  // HDF5's
    throw InputError(file.string(), "", "a checkpoint of springcheck", error.what());
  }
}

}  // namespace springcheck
