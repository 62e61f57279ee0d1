#include "comparisons/formats/latex_escape.hpp"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>

namespace springcheck {
namespace {

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

std::string latex_escaped(std::string_view given) {
  const std::string sound = utf8::replace_invalid(given);
  std::string_view text = sound;
  std::string out;
  auto backticks = std::ranges::count(text, '`');
  bool in_code = false, after_blank = true;
  while (!text.empty()) {
    const bool is_plus_minus = text.starts_with("+-");
    const bool is_two_hyphens = text.starts_with("--");
    const char first = text.front();
    const auto* next = text.data();
    const char32_t point = utf8::next(next, text.data() + text.size());
    text.remove_prefix(static_cast<std::size_t>(next - text.data()));
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
      utf8::append(point, out);
    } else {
      out += fmt::format("U+{:04X}", static_cast<unsigned>(point));
    }
    after_blank = first == ' ' || first == '(';
  }
  return out;
}

}  // namespace springcheck
