#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "comparisons/formats/table_format.hpp"

namespace springcheck {

// Texts of lists, {list: {name: text or {"description": text, ...}}}.

/// The lists as text: the entries of each below its name, in lines of at most `width`
/// characters.
std::string list_text(const nlohmann::ordered_json& lists,
                      std::optional<std::size_t> width);

/// One table with all keys of the entries as columns, the values of arrays with blanks
/// between; objects in an entry are left out. Throws std::logic_error for JSON, as which
/// the lists are a document already.
std::string lists_as_table(const nlohmann::ordered_json& lists, TableFormat format);

}  // namespace springcheck
