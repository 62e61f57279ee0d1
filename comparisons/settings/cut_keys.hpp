#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/settings/given.hpp"
#include "comparisons/settings/value_type.hpp"
#include "meshing/cutting/wanted_cut.hpp"

namespace springcheck {

/// A key of a [[cut]], or of the text that an option gives.
struct CutKey {
  std::string_view name;
  ValueType type;
  std::string_view description;
};
const std::vector<CutKey>& cut_keys();

/// Cuts in the order in which they are made: tables, or texts such as
///
///     split,name=slit,plane=0,0,1,0.025,within=0,0,0,0.025,0.05,0.05,remove,box=...
///
/// Throws InputError for what is no cut, and for two of one name. An empty text is none.
std::vector<WantedCut> cuts_of(const Given& given);

/// That text, of numbers in SI units; empty without cuts.
std::string text_of(const std::vector<WantedCut>& cuts);

/// JSON schema of a list of cuts.
nlohmann::json cuts_schema();

}  // namespace springcheck
