#include "comparisons/results/xdmf_elements.hpp"

namespace springcheck {

pugi::xml_node append_element(pugi::xml_node parent, const char* name,
                              const XmlAttributes& attributes) {
  pugi::xml_node element = parent.append_child(name);
  for (const auto& [attribute, value] : attributes)
    element.append_attribute(attribute).set_value(value.c_str());
  return element;
}

void append_data_item(pugi::xml_node parent, const std::string& dimensions,
                      const std::string& place, XdmfNumbers numbers) {
  const bool are_real = numbers == XdmfNumbers::real;
  XmlAttributes attributes{{"Format", "HDF"},
                           {"NumberType", are_real ? "Float" : "UInt"}};
  if (are_real) attributes.emplace_back("Precision", "8");
  attributes.emplace_back("Dimensions", dimensions);
  append_element(parent, "DataItem", attributes).text().set(place.c_str());
}

}  // namespace springcheck
