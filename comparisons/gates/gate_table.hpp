#pragma once

#include <string>
#include <vector>

#include "comparisons/gates/gate.hpp"
#include "comparisons/settings/toml_values.hpp"

namespace springcheck::gates {

/// Another case that a gate compares with.
struct OtherCase {
  Selection where;
  std::string measure;
};

/// One [[gate]] table, whose readers throw InputError with file, line and column.
class GateTable {
 public:
  /// Both arguments must outlive this.
  GateTable(const toml::table& table, const std::string& file)
      : table_(table), file_(file) {}

  /// Throws InputError for keys that no gate has.
  void check_keys() const;

  [[nodiscard]] std::string place() const;
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
  [[nodiscard]] toml::source_region source(std::string_view key) const;
  [[nodiscard]] Given value(std::string_view key) const;  // of a key that is there

  /// A text of one line, which must be there.
  [[nodiscard]] std::string line(std::string_view key) const;
  [[nodiscard]] std::string text_or(std::string_view key, std::string otherwise) const;
  [[nodiscard]] std::string along() const { return line("along"); }

  /// The conditions in a table of settings; none where there is no table.
  [[nodiscard]] Selection selection(std::string_view key) const;

  /// The gate's own case with other settings, or another measure.
  [[nodiscard]] OtherCase other_case(std::string_view key, const Gate& own) const;

  /// Throws InputError at the key, or at the table where it is not there.
  [[noreturn]] void refuse(std::string_view key, const std::string& expected,
                           const std::string& got) const;

 private:
  const toml::table& table_;
  const std::string& file_;
};

/// The file's outermost table.
class GateFileTable {
 public:
  /// Throws InputError for unknown keys and where there is no gate.
  GateFileTable(const toml::table& table, const std::string& file);

  [[nodiscard]] const std::vector<GateTable>& gates() const { return gates_; }
  [[nodiscard]] const Selection& common() const { return common_; }
  [[nodiscard]] bool is_fixed() const { return is_fixed_; }

 private:
  std::vector<GateTable> gates_;
  Selection common_;
  bool is_fixed_;
};

}  // namespace springcheck::gates
