#include "meshing/text.hpp"

#include <iconv.h>

#include <stdexcept>

namespace springcheck {

bool is_utf8(const std::string& text) {
  // To UTF-16, which has no more characters than Unicode.
  const iconv_t conversion = iconv_open("UTF-16LE", "UTF-8");
  if (conversion == reinterpret_cast<iconv_t>(-1))
    throw std::runtime_error("iconv does not know UTF-8");
  std::string bytes = text, characters(2 * text.size(), '\0');
  char *from = bytes.data(), *to = characters.data();
  std::size_t left = bytes.size(), room = characters.size();
  const bool is_sound =
      iconv(conversion, &from, &left, &to, &room) != static_cast<std::size_t>(-1);
  iconv_close(conversion);
  return is_sound;
}

std::string quotation(std::string_view text) {
  std::string printable = "'";
  for (const char c : text.substr(0, 30)) printable += c >= ' ' && c <= '~' ? c : '?';
  return printable + (text.size() > 30 ? "...'" : "'");
}

}  // namespace springcheck
