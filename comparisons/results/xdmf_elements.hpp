#pragma once

#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

namespace springcheck {

using XmlAttributes = std::vector<std::pair<const char*, std::string>>;

/// Appends an element with these attributes and returns it.
pugi::xml_node append_element(pugi::xml_node parent, const char* name,
                              const XmlAttributes& attributes);

/// Numbers of a dataset: doubles, or unsigned whole ones.
enum class XdmfNumbers { real, whole };

/// Appends a DataItem: `place` names a dataset, "results.h5:/meshes/...", of these
/// dimensions.
void append_data_item(pugi::xml_node parent, const std::string& dimensions,
                      const std::string& place, XdmfNumbers numbers);

}  // namespace springcheck
