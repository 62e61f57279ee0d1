#pragma once

#include <string>
#include <variant>
#include <vector>

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// A column of a table of cases, of texts or of numbers in SI units, a value a row: empty
/// or NaN where a case lacks it.
struct CaseColumn {
  std::string name;  // in the result file; of vectors and matrices with ".x", ".xy"
  std::string unit;  // empty: none
  std::variant<std::vector<std::string>, std::vector<double>> values;
};

/// Cases of a result file, a row each, in the file's order, as other programs read them.
///
/// Columns are those of the names chosen, of vectors and matrices all components where
/// none is named, and empty where no case has what is asked for. With none chosen: which
/// case it is, settings that differ between cases, measures that one has, how it ended
/// and at what cost; the reference's settings, which fill a line, only where chosen.
/// Throws InputError for a name that there is not.
std::vector<CaseColumn> case_table(const Columns& cases,
                                   const std::vector<std::string>& chosen);

/// The value of a text or number column in a row, in words, "0.05/0.05/0.2"; empty where
/// the case lacks it.
std::string value_at(const Columns& cases, const std::string& key, std::size_t row);

/// Keys of the settings that differ between those of the rows that have them, or that
/// only some of the same test, method and solver have; in the order of the settings.
std::vector<std::string> differing_settings(const Columns& cases,
                                            const std::vector<std::size_t>& rows);

}  // namespace springcheck
