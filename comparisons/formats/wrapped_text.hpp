#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace springcheck {

/// Characters of a text in UTF-8.
std::size_t characters_in(std::string_view text);

/// The text with line ends between words, so that no line is longer than `width`
/// characters, but for words that are. The first line continues one that has `first`
/// characters already; the others are indented by `indent` spaces. Without a line end
/// after the last one.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0,
                    std::size_t first = 0);

/// A line of a list, "  --out FILE   HDF5 file ...", whose text stands in a column of its
/// own, and below the name where that is too long or a word of the text is. With a line
/// end.
std::string wrapped_entry(std::string_view name, std::string_view text,
                          std::size_t column, std::size_t width);

}  // namespace springcheck
