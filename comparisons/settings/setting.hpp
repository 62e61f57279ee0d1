#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/settings/run_settings.hpp"
#include "comparisons/settings/value_type.hpp"

namespace springcheck {

/// The places where a setting may stand: scene files alone, or also options of `run`,
/// sweeps and axes of `stability`. `plan` are those that say what a run compares: they
/// are no axis.
enum class Standing { scene_file, everywhere, plan };

/// What a chart and `advise` do with a setting: take it from scene and options, choose it
/// for each of their models, or have no use for it.
enum class InCharts { taken, chosen, unused };

/// What becomes of a setting that no method of the run reads, nor its reference: it is
/// refused; refused as an option, since a scene may be meant for other methods too; or
/// left unread.
enum class Unread { refused, refused_as_option, accepted };

/// How a setting's value enters a run, and how a case's key and JSON tell it.
struct Access {
  /// Reads the setting of a run into which all settings further up in the table have been
  /// read. Throws InputError.
  void (*read)(RunSettings&, const Given&);
  /// What keys and JSON tell of the setting; nothing, or null, where it is not told.
  nlohmann::json (*told)(const CaseSettings&) = nullptr;
  ValueType type;
};

/// Who reads a setting, beyond what its test has.
struct Readers {
  bool (*is_one)(const CaseSettings&) = nullptr;  // nullptr: all
  Unread unread = Unread::accepted;
  std::string_view without{};  // for refusals; empty: the methods that list it
  bool of_methods = false;     // those alone that list it as their own (Method::reads)
};

/// What there is to say of some settings.
struct Particulars {
  Dimension dimension = Dimension::none;
  Standing standing = Standing::everywhere;
  std::string_view label{};       // of figures' axes; the key where it is empty
  std::string_view usual_axis{};  // values of a stability axis that is named alone
  bool counts = false;            // whole numbers between whose values nothing lies
  std::string_view beside{};      // a setting without which it has no meaning
  std::string_view instead{};     // one that stands in its place
  int replaces = 0;               // settings of one number replace each other; 0: none
  bool (*has)(Test) = nullptr;    // tests that have it, others refuse it; nullptr: all
  std::string_view needed{};      // what is missing where it is needed and not given
  bool (*is_needed)(const RunSettings&) = nullptr;  // nullptr: where it has readers
  std::string_view variant{};  // what names of methods get where it is not the default,
                               // {} for its value; empty: nothing
  std::string_view default_text{};  // the default in words, where `otherwise` is not all
};

/// Settings that belong together: in documentation and in the explorer under their name,
/// in a command's help, which has fewer, under the heading.
struct SettingGroup {
  std::string_view name, heading;
};

/// A setting, declared in setting_table.cpp alone: scene and sweep files, command line,
/// refusals, case keys, result columns, stability axes, charts and documentation read it
/// there.
struct Setting : Particulars {
  constexpr Setting(std::string_view its_key, SettingGroup its_group, InCharts charts,
                    const Readers& its_readers, const Access& its_access,
                    std::string_view its_default, std::string_view its_help,
                    const Particulars& particulars = {})
      : Particulars(particulars),
        key(its_key),
        group(its_group),
        in_charts(charts),
        readers(its_readers),
        access(its_access),
        otherwise(its_default),
        help(its_help) {}

  std::string_view key;
  SettingGroup group;
  InCharts in_charts;
  Readers readers;
  Access access;
  std::string_view otherwise;  // the default, as a user would write it; empty: none
  std::string_view help;       // without its default
};

/// Every setting, in the order in which they are read.
std::span<const Setting> all_settings();

/// The setting of that key; nullptr where there is none.
const Setting* find_setting(std::string_view key);

/// Whether test, method and solver of the case read it; or method and solver, whatever
/// the test.
bool reads(const CaseSettings& settings, const Setting& setting);
bool is_reader(const CaseSettings& settings, const Setting& setting);

/// Why nothing reads the setting: "without mss-custom as method or reference".
std::string without_readers(const Setting& setting);

/// What the setting is, and its default: "Poisson ratio, in (-1, 0.5)".
std::string help_of(const Setting& setting);

/// What names of methods get where the setting has that value: ", E-form", " (mss-cf)";
/// nothing for a default, and for settings that are in no name.
std::string variant_of(const Setting& setting, const std::string& value);

/// The case's method with its variants: "fem-stvk:q1-sri", "mss-cf, E-form, A = 0.5".
std::string variant_label(const CaseSettings& settings);

/// The keys of all settings; and of those alone that are options.
std::vector<std::string_view> setting_keys();
std::vector<std::string_view> option_keys();

/// Whether it is an option of `run`, and so a key of sweeps and gates too.
inline bool is_option(const Setting& setting) {
  return setting.standing != Standing::scene_file;
}

}  // namespace springcheck
