#include "meshing/basics/text.hpp"

#include <utf8.h>

namespace springcheck {

bool is_utf8(const std::string& text) {
  return utf8::is_valid(text);
}

std::string quotation(std::string_view text) {
  std::string printable = "'";
  for (const char c : text.substr(0, 30)) printable += c >= ' ' && c <= '~' ? c : '?';
  return printable + (text.size() > 30 ? "...'" : "'");
}

}  // namespace springcheck
