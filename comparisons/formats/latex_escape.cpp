#include "comparisons/formats/latex_escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace springcheck {
namespace {

/// Takes the first code point from a text that is not empty.
char32_t take_code_point(std::string_view& text) {
  constexpr char32_t replacement = 0xFFFD;
  const auto lead = static_cast<unsigned char>(text.front());
  const auto length = static_cast<std::size_t>(std::countl_one(lead));  // 0: ASCII
  text.remove_prefix(1);
  if (length == 0) return lead;
  if (length == 1 || length > 4 || text.size() < length - 1) return replacement;
  char32_t point = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 0; i < length - 1; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0U) != 0x80U) return replacement;
    point = point << 6U | (byte & 0x3FU);
  }
  text.remove_prefix(length - 1);
  return point;
}

std::string escaped_ascii(char c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '^':
      return "\\textasciicircum{}";
    case '~':
      return "\\textasciitilde{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '{':
    case '}':
    case '%':
    case '&':
    case '#':
    case '_':
    case '$':
      return {'\\', c};
    default:
      return {c};
  }
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string out;
  auto backticks = std::ranges::count(text, '`');
  bool in_code = false, after_blank = true;
  while (!text.empty()) {
    const bool is_plus_minus = text.starts_with("+-");
    const bool is_two_hyphens = text.starts_with("--");
    const char first = text.front();
    const char32_t point = take_code_point(text);
    if (is_plus_minus) {
      text.remove_prefix(1);
      out += "$\\pm$";
    } else if (is_two_hyphens) {
      out += "-{}";  // two would become a dash
    } else if (first == '`') {
      const bool has_partner = in_code || --backticks > 0;
      if (in_code) --backticks;
      if (has_partner) in_code = !in_code;
      out += !has_partner ? "\\textasciigrave{}" : in_code ? "\\texttt{" : "}";
    } else if (first == '"') {
      out += after_blank ? "``" : "''";
    } else if (point < 0x80) {
      out += point < ' ' || point == 0x7F
                 ? fmt::format("U+{:04X}", static_cast<unsigned>(point))
                 : escaped_ascii(first);
    } else if (point >= 0xC0 && point <= 0x17F) {
      out += first;
      out += static_cast<char>(0x80U | (point & 0x3FU));
    } else {
      out += fmt::format("U+{:04X}", static_cast<unsigned>(point));
    }
    after_blank = first == ' ' || first == '(';
  }
  return out;
}

}  // namespace springcheck
