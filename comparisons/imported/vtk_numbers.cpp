#include "comparisons/imported/vtk_numbers.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view blanks = " \t\r\n";

/// What is wrong with the data, without the place.
struct Broken {
  std::string expected, got;
};

std::vector<double> from_ascii(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    double value = 0;
    const auto [rest, error] =
        std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || rest != word.data() + word.size())
      throw Broken{"numbers", fmt::format("'{:.40}'", word)};
    numbers.push_back(value);
    at = text.find_first_not_of(blanks, end);
  }
  return numbers;
}

/// The value of a base64 digit, 0 to 63.
unsigned sextet(char c) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t found = digits.find(c);
  if (found == std::string_view::npos)
    throw Broken{"base64", fmt::format("the character '{}'", c)};
  return static_cast<unsigned>(found);
}

/// The bytes of base64 pieces one behind the other, each of which may end in '='.
std::string from_base64(std::string_view text) {
  std::string bytes, group;
  for (const char c : text) {
    if (blanks.find(c) != std::string_view::npos) continue;
    group += c;
    if (group.size() < 4) continue;
    const int padding = group.ends_with("==") ? 2 : group.ends_with('=') ? 1 : 0;
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i)
      bits =
          bits << 6 | (i < 4 - padding ? sextet(group[static_cast<std::size_t>(i)]) : 0);
    for (int i = 0; i < 3 - padding; ++i)
      bytes += static_cast<char>(bits >> (16 - 8 * i) & 0xFF);
    group.clear();
  }
  if (!group.empty())
    throw Broken{"base64 in groups of four", fmt::format("'{}' at the end", group)};
  return bytes;
}

/// Takes unsigned numbers, then pieces of bytes, from the front.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number(std::size_t width) {
    std::uint64_t value = 0;
    const std::string_view bytes = piece(width);
    std::memcpy(&value, bytes.data(), width);
    return value;
  }
  std::string_view piece(std::uint64_t size) {
    if (size > rest_.size())
      throw Broken{fmt::format("{} more bytes", size),
                   fmt::format("the end after {}", rest_.size())};
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

 private:
  std::string_view rest_;
};

std::string inflated(Bytes bytes, std::size_t header_bytes, std::size_t expected) {
  const std::uint64_t blocks = bytes.number(header_bytes),
                      whole = bytes.number(header_bytes),
                      given_last = bytes.number(header_bytes),
                      last = given_last == 0 ? whole : given_last;
  // The sizes are checked before anything of them is allocated.
  if (blocks == 0 || blocks > expected || (blocks > 1 && whole > expected) ||
      last > expected || (blocks - 1) * whole + last != expected)
    throw Broken{fmt::format("{} bytes", expected),
                 fmt::format("{} blocks of {}, the last of {}", blocks, whole, last)};
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t i = 0; i < blocks; ++i) sizes.push_back(bytes.number(header_bytes));
  std::string all(expected, '\0');
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::string_view compressed = bytes.piece(sizes[i]);
    const uLong wanted = i + 1 < blocks ? whole : last;
    uLongf size = wanted;
    const int result =
        uncompress(reinterpret_cast<Bytef*>(all.data() + i * whole), &size,
                   reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
    if (result != Z_OK || size != wanted)
      throw Broken{fmt::format("{} bytes of zlib in block {}", wanted, i + 1),
                   result == Z_OK ? fmt::to_string(size) : "broken data"};
  }
  return all;
}

template <class Real>
std::vector<double> reals(std::string_view bytes) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at + sizeof(Real) <= bytes.size(); at += sizeof(Real)) {
    Real value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    numbers.push_back(value);
  }
  return numbers;
}

std::vector<double> from_binary(std::string_view text, const VtkEncoding& encoding,
                                std::size_t count) {
  const bool is_double = encoding.type == VtkReal::float64;
  const std::size_t expected = count * (is_double ? sizeof(double) : sizeof(float));
  const std::string decoded = from_base64(text);
  Bytes bytes(decoded);
  std::string data;
  if (encoding.compression == VtkEncoding::Compression::zlib)
    data = inflated(bytes, encoding.header_bytes, expected);
  else
    data = bytes.piece(bytes.number(encoding.header_bytes));
  return is_double ? reals<double>(data) : reals<float>(data);
}

}  // namespace

std::vector<double> vtk_numbers(const std::string& place, std::string_view text,
                                const VtkEncoding& encoding, std::size_t count) {
  try {
    std::vector<double> numbers = encoding.format == VtkEncoding::Format::ascii
                                      ? from_ascii(text)
                                      : from_binary(text, encoding, count);
    if (numbers.size() != count)
      throw Broken{fmt::format("{} numbers", count), fmt::to_string(numbers.size())};
    return numbers;
  } catch (const Broken& broken) {
    throw InputError(place, "", broken.expected, broken.got);
  }
}

}  // namespace springcheck
