#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "comparisons/settings/run_settings.hpp"

namespace springcheck {

/// A scene as its file states it.
struct SceneFile {
  std::string name;  // without folder and extension
  std::string file;  // as messages name it
  std::vector<GivenSetting> settings;
};

/// Reads the shipped scene of that name, or the file at that path (a name that ends in
/// .toml or holds a slash). Unknown keys, wrong types, unreadable and empty files throw
/// InputError with file, line and column.
SceneFile read_scene(const std::string& name_or_path);

/// The same of a scene that a file names: a relative path stands beside that file, and
/// messages say where it is named.
SceneFile read_scene(const Given& name_or_path);

/// The run of that scene with options, which replace its settings. Throws InputError.
RunSettings read_run(const std::string& scene, const std::vector<GivenSetting>& options);

/// Another value for a setting of a scene: a number, a name, or a text as users write it,
/// "5%".
struct Change {
  std::string key;
  Given value;

  Change(std::string_view name, double number) : Change(name, Given::Scalar(number)) {}
  Change(std::string_view name, int number)
      : Change(name, Given::Scalar(std::int64_t{number})) {}
  Change(std::string_view name, std::string_view text)
      : Change(name, Given::Scalar(std::string(text))) {}
  Change(std::string_view name, const std::string& text)
      : Change(name, Given::Scalar(text)) {}
  Change(std::string_view name, const char* text)
      : Change(name, Given::Scalar(std::string(text))) {}
  template <std::size_t N>
  Change(std::string_view name, const std::array<double, N>& numbers)
      : key(name),
        value("table", std::vector<Given::Scalar>(numbers.begin(), numbers.end())) {}
  Change(std::string_view name, const std::array<int, 3>& counts)
      : key(name),
        value("table",
              std::vector<Given::Scalar>{std::int64_t{counts[0]}, std::int64_t{counts[1]},
                                         std::int64_t{counts[2]}}) {}

 private:
  Change(std::string_view name, Given::Scalar scalar)
      : key(name), value("table", std::move(scalar)) {}
};
using Changes = std::vector<Change>;

/// Both lists, the second's values over the first's.
inline Changes operator+(Changes all, const Changes& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The one simulation of a shipped scene with settings changed, without a reference.
CaseSettings case_of_scene(const std::string& scene, const Changes& changes);

}  // namespace springcheck
