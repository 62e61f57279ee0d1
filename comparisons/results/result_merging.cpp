#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>

#include "comparisons/measures/measure_list.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/results/stored_chart.hpp"
#include "comparisons/results/stored_map.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/stored_columns.hpp"

namespace springcheck {
namespace {

/// The unit of what measures may cancel against: forces, torques and energies are sums of
/// the same terms, times lengths of about a metre.
std::string_view scale_of_unit(std::string_view unit) {
  return unit == "N m" || unit == "J" ? "N" : unit;
}

/// The largest measure of two rows among those of each scale, by which tiny ones are
/// rounding.
std::map<std::string_view, double> largest_measures(const Row& a, const Row& b) {
  std::map<std::string_view, double> largest;
  for (const Measure& measure : measure_list)
    for (const Row* row : {&a, &b})
      if (const auto found = row->find(std::string(measure.name)); found != row->end())
        if (const auto* values = std::get_if<std::vector<double>>(&found->second))
          for (const double x : *values)
            if (double& most = largest[scale_of_unit(measure.unit)]; std::isfinite(x))
              most = std::max(most, std::abs(x));
  return largest;
}

/// Whether numbers differ by rounding, as other instructions or another BLAS give them
/// for the same formula: by up to 1e-9 of themselves, or 1e-12 of the largest that they
/// cancel against, as sums that vanish do.
bool is_rounding(const Row::mapped_type& a, const Row::mapped_type& b, double largest) {
  const auto* ours = std::get_if<std::vector<double>>(&a);
  const auto* theirs = std::get_if<std::vector<double>>(&b);
  if (ours == nullptr || theirs == nullptr || ours->size() != theirs->size())
    return false;
  for (std::size_t i = 0; i < ours->size(); ++i) {
    const double x = (*ours)[i], y = (*theirs)[i];
    const double least =
        std::max(1e-9 * std::max(std::abs(x), std::abs(y)), 1e-12 * largest);
    if (!(std::abs(x - y) <= least) && !(std::isnan(x) && std::isnan(y))) return false;
  }
  return true;
}

struct Difference {
  std::string column;
  bool is_rounding;
};

/// The first column by which two rows of a key differ by more than rounding, or else the
/// first that differs at all; but for times, provenance, and what older files lack.
std::optional<Difference> difference(Row a, Row b) {
  const auto leave_out = [&](std::string_view name) {
    for (Row* row : {&a, &b}) row->erase(std::string(name));
  };
  for (const char* free : {"provenance", "family", "identity"}) leave_out(free);
  for (const Measure& measure : measure_list)
    if (measure.traits.is_time) leave_out(measure.name);
  const std::map<std::string_view, double> largest = largest_measures(a, b);
  const auto largest_beside = [&](const std::string& column) {
    const Measure* measure = find_measure(column);
    if (measure == nullptr) return 0.;
    const auto found = largest.find(scale_of_unit(measure->unit));
    return found == largest.end() ? 0. : found->second;
  };
  std::optional<Difference> found;
  for (const Row* row : {&a, &b})
    for (const auto& [name, value] : *row) {
      if (a.contains(name) && b.contains(name) && a.at(name) == b.at(name)) continue;
      const bool rounding = a.contains(name) && b.contains(name) &&
                            is_rounding(a.at(name), b.at(name), largest_beside(name));
      if (!rounding) return Difference{name, false};
      if (!found) found = Difference{name, true};
    }
  return found;
}

/// What the row's session computed with: "avx512 GenuineIntel, OpenBLAS 0.3.21 SkylakeX".
std::string computed_with(const Columns& sessions, const Row& row) {
  const auto session = static_cast<std::size_t>(
      std::get<std::vector<double>>(row.at("provenance")).front());
  const auto told = [&](const char* name) {
    const auto column = sessions.texts.find(name);
    const bool is_told =
        column != sessions.texts.end() && !column->second.at(session).empty();
    return is_told ? column->second[session] : fmt::format("unknown {}", name);
  };
  return told("instructions") + ", " + told("BLAS");
}

/// What a row is a case of: "compression, fem-stvk:q1".
std::string question_of(const Row& row) {
  const auto text = [&](const char* name) {
    const auto found = row.find(name);
    return found == row.end() ? std::string() : std::get<std::string>(found->second);
  };
  const std::string element = text("element");
  return fmt::format("{}, {}{}{}", text("scene"), text("method"),
                     element.empty() ? "" : ":", element);
}

Columns sessions_of(const std::filesystem::path& file) {
  return reading(file, [](hid_t root) {
    return read_columns(hdf5::open_group(root, "provenance"));
  });
}

}  // namespace

ResultFile::Absorbed ResultFile::absorb(const std::filesystem::path& from,
                                        const std::set<std::string>* keys) {
  constexpr std::size_t at_once = 500;  // bounds what a commit keeps in memory
  if (std::error_code none; std::filesystem::equivalent(from, file_, none))
    return {.added = 0, .already_there = stored_.rows.size()};
  const Columns theirs = all_cases(from);
  Absorbed absorbed;
  std::vector<std::size_t> lacking;
  std::vector<std::string> without_fields;  // here, of cases that both have
  {
    const bool exists = std::filesystem::exists(file_);
    const Columns ours = exists ? all_cases(file_) : Columns{},
                  our_sessions = exists ? sessions_of(file_) : Columns{},
                  their_sessions = sessions_of(from);
    for (std::size_t i = 0; i < theirs.rows; ++i) {
      const std::string& key = theirs.texts.at("key")[i];
      if (keys != nullptr && !keys->contains(key)) continue;
      const auto known = stored_.rows.find(key);
      if (known == stored_.rows.end()) {
        lacking.push_back(i);
        continue;
      }
      ++absorbed.already_there;
      const Row own = row_at(ours, known->second), other = row_at(theirs, i);
      const auto found = difference(own, other);
      if (!found || found->is_rounding) {
        if (!stored_.with_fields.contains(key)) without_fields.push_back(key);
      }
      if (!found) continue;
      auto& list = found->is_rounding ? absorbed.roundings : absorbed.conflicts;
      list.push_back(fmt::format(
          "case {} ({}): {} differs in {}{}; computed with {} here, with {} there", key,
          question_of(own), found->column, from.string(),
          found->is_rounding ? " by rounding" : "", computed_with(our_sessions, own),
          computed_with(their_sessions, other)));
    }
  }
  copy_fields(from, std::move(without_fields));
  std::map<double, double> sessions;  // theirs to ours
  for (std::size_t first = 0; first < lacking.size(); first += at_once)
    copy_cases(
        from, theirs,
        std::span(lacking).subspan(first, std::min(at_once, lacking.size() - first)),
        sessions);
  absorbed.added = lacking.size();
  if (keys != nullptr) return absorbed;
  const auto has = [&](const char* group) {
    return reading(from, [&](hid_t source) { return hdf5::has_link(source, group); });
  };
  if (has("maps"))
    change_from(from, [](hid_t source, hid_t root) {
      merge_maps(hdf5::open_group(source, "maps"), hdf5::group_made_in(root, "maps"));
    });
  if (has("charts"))
    change_from(from, [](hid_t source, hid_t root) {
      merge_charts(hdf5::open_group(source, "charts"),
                   hdf5::group_made_in(root, "charts"));
    });
  return absorbed;
}

void ResultFile::copy_fields(const std::filesystem::path& from,
                             std::vector<std::string> keys) {
  const std::vector<std::string> stored = reading(
      from, [](hid_t source) { return hdf5::links(hdf5::open_group(source, "fields")); });
  const std::set<std::string> there(stored.begin(), stored.end());
  std::erase_if(keys, [&](const std::string& key) { return !there.contains(key); });
  if (keys.empty()) return;
  change_from(from, [&](hid_t source, hid_t root) {
    const auto theirs = hdf5::open_group(source, "fields"),
               ours = hdf5::open_group(root, "fields");
    for (const std::string& key : keys) hdf5::copy_link(theirs, ours, key);
  });
  stored_.with_fields.insert(keys.begin(), keys.end());
}

void ResultFile::copy_cases(const std::filesystem::path& from, const Columns& theirs,
                            std::span<const std::size_t> rows,
                            std::map<double, double>& sessions) {
  std::vector<Row> added;
  std::vector<std::string> with_fields;
  std::map<double, double> sessions_then;
  change_from(from, [&](hid_t source, hid_t root) {
    added.clear();
    with_fields.clear();
    sessions_then = sessions;
    const auto their_meshes = hdf5::open_group(source, "meshes"),
               their_fields = hdf5::open_group(source, "fields"),
               meshes = hdf5::open_group(root, "meshes"),
               fields = hdf5::open_group(root, "fields"),
               provenance = hdf5::open_group(root, "provenance");
    const Columns their_sessions = read_columns(hdf5::open_group(source, "provenance"));
    for (const std::size_t i : rows) {
      Row row = row_at(theirs, i);
      const auto& key = std::get<std::string>(row.at("key"));
      const auto& mesh = std::get<std::string>(row.at("mesh"));
      double& session = std::get<std::vector<double>>(row.at("provenance")).front();
      const auto [place, is_new] =
          sessions_then.try_emplace(session, static_cast<double>(row_count(provenance)));
      if (is_new)
        append_rows(provenance,
                    {{row_at(their_sessions, static_cast<std::size_t>(session))}});
      session = place->second;
      if (!hdf5::has_link(meshes, mesh)) hdf5::copy_link(their_meshes, meshes, mesh);
      if (hdf5::has_link(their_fields, key)) {
        hdf5::copy_link(their_fields, fields, key);
        with_fields.push_back(key);
      }
      added.push_back(std::move(row));
    }
    append_rows(hdf5::open_group(root, "cases"), added);
  });
  sessions = std::move(sessions_then);
  stored_.with_fields.insert(with_fields.begin(), with_fields.end());
  for (const Row& row : added) {
    const auto& key = std::get<std::string>(row.at("key"));
    stored_.rows.emplace(key, stored_.rows.size());
    stored_.statuses.emplace(
        key, status_named(std::get<std::string>(row.at("status")), from.string()));
  }
}

}  // namespace springcheck
