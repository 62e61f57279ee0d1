#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/text.hpp"

namespace springcheck {
namespace {

/// The inverse of flat.
std::vector<Vector3> vectors(const std::vector<double>& values) {
  std::vector<Vector3> all;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    all.emplace_back(values[i], values[i + 1], values[i + 2]);
  return all;
}

/// Throws std::runtime_error unless the names can be those of groups in the file: others
/// would lead elsewhere.
void check_names(const std::vector<std::string>& names, const char* column) {
  for (const std::string& name : names)
    if (name.empty() || name == "." || name.find('/') != std::string::npos)
      throw std::runtime_error(fmt::format("column '{}' has {}, which names no group",
                                           column, quotation(name)));
}

void check_sessions(std::span<const double> rows, std::size_t sessions) {
  for (const double row : rows)
    if (!(row >= 0 && row < static_cast<double>(sessions) && row == std::floor(row)))
      throw std::runtime_error(
          fmt::format("column 'provenance' refers to row {} of {}", row, sessions));
}

/// The columns of cases, with what all files of ours have.
Columns cases_in(hid_t root) {
  Columns cases = read_columns(hdf5::open_group(root, "cases"));
  if (cases.rows == 0) return cases;
  for (const char* name : {"key", "status", "mesh"})
    if (!cases.texts.contains(name))
      throw std::runtime_error(fmt::format("the cases have no column '{}'", name));
  const std::size_t sessions = read_columns(hdf5::open_group(root, "provenance")).rows;
  const auto provenance = cases.numbers.find("provenance");
  if (provenance == cases.numbers.end() || provenance->second.width != 1)
    throw std::runtime_error("the cases have no column 'provenance'");
  check_sessions(provenance->second.values, sessions);
  for (const char* column : {"key", "mesh"}) check_names(cases.texts.at(column), column);
  std::set<std::string_view> keys;
  for (const std::string& key : cases.texts.at("key"))
    if (!keys.insert(key).second)
      throw std::runtime_error("case " + key + " is there twice");
  return cases;
}

std::string known_revision(const std::string& text) {
  return text.empty() ? std::string(unknown_revision) : text;
}

/// What a case's session tells of it.
struct Origin {
  std::string revision, date;
};

/// The origin of each case, by its session.
std::vector<Origin> origins_of(std::span<const double> sessions, hid_t root) {
  const auto provenance = hdf5::open_group(root, "provenance");
  const auto revisions = read_texts(provenance, "revision"),
             dates = read_texts(provenance, "date");
  std::vector<Origin> all;
  for (const double session : sessions) {
    const auto place = static_cast<std::size_t>(session);
    const auto text_in = [&](const std::vector<std::string>& column) {
      return place < column.size() ? column[place] : "";
    };
    all.push_back(
        {.revision = known_revision(text_in(revisions)), .date = text_in(dates)});
  }
  return all;
}

/// Cases whose figures are taken: rows in ascending order, and this program's keys of
/// them, those in the file where a file is too old to tell what was asked.
struct Taken {
  std::vector<std::size_t> rows;
  std::vector<std::string> keys;
};

Taken taken(const std::vector<std::string>& keys,
            const std::vector<std::string>& identities,
            const std::vector<Origin>& origins, Revisions accepted) {
  std::map<std::size_t, std::string> key_of_row;
  std::set<std::string> seen;
  const auto take = [&](std::size_t row, const std::string& key) {
    if (seen.insert(key).second) key_of_row.emplace(row, key);
  };
  std::vector<std::size_t> others;
  for (std::size_t row = 0; row < keys.size(); ++row)
    if (origins[row].revision == build_info::revision)
      take(row, keys[row]);
    else
      others.push_back(row);
  if (accepted == Revisions::all) {
    // Of several cases the newest is taken, of one date the last row:
    std::ranges::sort(others, std::ranges::greater{},
                      [&](std::size_t row) { return std::pair(origins[row].date, row); });
    for (const std::size_t row : others) {
      const bool is_told = row < identities.size() && !identities[row].empty();
      take(row, is_told ? key_of_identity(identities[row]) : keys[row]);
    }
  }
  Taken all;
  for (const auto& [row, key] : key_of_row) {
    all.rows.push_back(row);
    all.keys.push_back(key);
  }
  return all;
}

}  // namespace

StoredKeys keys_in(hid_t root, const std::filesystem::path& file) {
  StoredKeys stored;
  const auto cases = hdf5::open_group(root, "cases");
  const auto keys = read_texts(cases, "key"), statuses = read_texts(cases, "status");
  if (keys.size() != row_count(cases) || statuses.size() != keys.size())
    throw std::runtime_error("columns 'key' and 'status' do not belong together");
  for (std::size_t row = 0; row < keys.size(); ++row) {
    stored.statuses[keys[row]] = status_named(statuses[row], file.string());
    stored.rows[keys[row]] = row;
  }
  if (stored.statuses.size() != keys.size())
    throw std::runtime_error("a case is there twice");
  for (std::string& key : hdf5::links(hdf5::open_group(root, "fields")))
    stored.with_fields.insert(std::move(key));
  const std::vector<double> sessions = read_number_column(cases, "provenance");
  check_names(keys, "key");
  if (!keys.empty()) check_names(read_texts(cases, "mesh"), "mesh");
  check_sessions(sessions, row_count(hdf5::open_group(root, "provenance")));
  const std::vector<Origin> origins = origins_of(sessions, root);
  if (origins.size() != keys.size())
    throw std::runtime_error("columns 'key' and 'provenance' do not belong together");
  for (const auto& [revision, date] : origins)
    if (revision != build_info::revision) ++stored.others[revision];
  const Taken all = taken(keys, read_texts(cases, "identity"), origins, Revisions::all);
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    const std::string& revision = origins[all.rows[i]].revision;
    if (revision != build_info::revision) ++stored.taken[revision];
    if (keys[all.rows[i]] != all.keys[i])
      stored.substitutes.emplace(all.keys[i], keys[all.rows[i]]);
  }
  return stored;
}

StoredKeys stored_keys(const std::filesystem::path& file) {
  return reading(file, [&](hid_t root) { return keys_in(root, file); });
}

Columns all_cases(const std::filesystem::path& file) {
  return reading(file, [](hid_t root) { return cases_in(root); });
}

namespace {

/// What read_cases and read_results take.
struct TakenCases {
  Columns cases;
  std::vector<std::string> keys, revisions;  // the latter as CaseResult has them
  std::vector<std::string> dates;            // of their sessions
};

std::string revision_in_result(const std::string& revision) {
  return revision == build_info::revision ? "" : revision;
}

TakenCases taken_cases(hid_t root, Revisions accepted) {
  const Columns cases = cases_in(root);
  if (cases.rows == 0) return {};
  const auto origins = origins_of(cases.numbers.at("provenance").values, root);
  const auto identities = cases.texts.find("identity");
  Taken found = taken(
      cases.texts.at("key"),
      identities == cases.texts.end() ? std::vector<std::string>{} : identities->second,
      origins, accepted);
  std::vector<std::string> of_rows, dates;
  for (const std::size_t row : found.rows) {
    of_rows.push_back(revision_in_result(origins[row].revision));
    dates.push_back(origins[row].date);
  }
  return {.cases = selected(cases, found.rows),
          .keys = std::move(found.keys),
          .revisions = std::move(of_rows),
          .dates = std::move(dates)};
}

}  // namespace

std::map<std::string, std::string> all_revisions(hid_t root) {
  const Columns cases = cases_in(root);
  if (cases.rows == 0) return {};
  const auto origins = origins_of(cases.numbers.at("provenance").values, root);
  std::map<std::string, std::string> all;
  for (std::size_t row = 0; row < cases.rows; ++row)
    all.emplace(cases.texts.at("key")[row], revision_in_result(origins[row].revision));
  return all;
}

std::map<std::string, std::string> taken_revisions(hid_t root, Revisions revisions) {
  const TakenCases found = taken_cases(root, revisions);
  std::map<std::string, std::string> all;
  for (std::size_t row = 0; row < found.cases.rows; ++row)
    all.emplace(found.cases.texts.at("key")[row], found.revisions[row]);
  return all;
}

Columns read_cases(const std::filesystem::path& file, Revisions revisions) {
  return reading(file, [&](hid_t root) {
    TakenCases found = taken_cases(root, revisions);
    if (revisions == Revisions::all && found.cases.rows > 0)
      found.cases.texts["other_revision"] = std::move(found.revisions);
    return std::move(found.cases);
  });
}

std::map<std::string, StoredCase> read_results(const std::filesystem::path& file,
                                               Revisions revisions) {
  return reading(file, [&](hid_t root) {
    const TakenCases found = taken_cases(root, revisions);
    std::map<std::string, StoredCase> all;
    for (std::size_t row = 0; row < found.cases.rows; ++row) {
      StoredCase stored = stored_case(found.cases, row, file.string());
      stored.revision = found.revisions[row];
      if (!stored.revision.empty()) stored.date = found.dates[row];
      all.emplace(found.keys[row], std::move(stored));
    }
    return all;
  });
}

void read_fields(const std::filesystem::path& file, const Mesh& mesh,
                 CaseResult& result) {
  reading(file, [&](hid_t root) {
    const auto fields = hdf5::open_group(root, "fields");
    if (!hdf5::has_link(fields, result.key)) return 0;
    const auto group = hdf5::open_group(fields, result.key);
    const std::string partial = result.measures.volume_error ? "" : "partial_";
    const auto table = [&](const std::string& name, std::size_t count) {
      auto values = hdf5::read_table(group, name);
      if (values && values->size() != count)
        throw InputError(file.string(), fmt::format("{} of case {}", name, result.key),
                         fmt::format("{} numbers", count),
                         fmt::to_string(values->size()));
      return values;
    };
    const std::size_t nodes = mesh.nodes().size(), cells = mesh.cells().size();
    if (const auto displacements = table(partial + "displacement", 3 * nodes))
      result.solution.displacements = vectors(*displacements);
    if (const auto reactions = table(partial + "reaction", 3 * nodes))
      result.solution.reactions = vectors(*reactions);
    if (const auto ratios = table(partial + "cell_volume_ratio", cells)) {
      result.solution.cell_volumes = *ratios;
      for (std::size_t c = 0; c < cells; ++c)
        result.solution.cell_volumes[c] *= mesh.cell_volumes()[c];
    }
    if (auto strains = table(partial + "spring_strain", cells))
      result.solution.spring_strains = std::move(*strains);
    if (const auto deviation = table("deviation", 3 * nodes))
      result.deviation = vectors(*deviation);
    return 0;
  });
}

}  // namespace springcheck
