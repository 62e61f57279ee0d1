#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "comparisons/formats/table_format.hpp"

namespace springcheck {

// Texts of lists, {list: {name: text or {"description": text, ...}}}.

/// Below the name of each list its entries; in lines of at most `width` characters.
std::string list_text(const nlohmann::ordered_json& lists,
                      std::optional<std::size_t> width);

/// One table with all keys of the entries as columns, the values of arrays with blanks
/// between; objects in an entry are left out. As JSON the lists are a document already:
/// std::logic_error.
std::string lists_as_table(const nlohmann::ordered_json& lists, TableFormat format);

}  // namespace springcheck
