#include "meshing/files/msh_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>

#include "meshing/basics/input_error.hpp"
#include "meshing/basics/text.hpp"

namespace springcheck {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

template <class Number>
Number parsed(const MshCursor& cursor, std::string_view word, std::string_view expected) {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);  // which from_chars does not take
  Number number{};
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (error != std::errc{} || stop != end) cursor.refuse(expected, quotation(word));
  return number;
}

}  // namespace

MshCursor::MshCursor(const std::filesystem::path& file) : file_(file.string()) {
  const auto refuse_file = [&](const char* got) {
    throw InputError(file_, "", "a gmsh file that can be read", got);
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    refuse_file("no such file (gmsh -3 BODY.geo -o BODY.msh makes one)");
  if (std::filesystem::is_directory(status)) refuse_file("a directory");
  if (!std::filesystem::is_regular_file(status)) refuse_file("no regular file");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse_file("one without permission to read");
  bytes_.resize(std::filesystem::file_size(file));
  in.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
  if (!in) refuse_file("one that breaks off");
  if (bytes_.empty()) refuse_file("an empty one");
}

void MshCursor::refuse(std::string_view expected, std::string_view got) const {
  const auto line =
      1 + std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(place_),
                     '\n');
  throw InputError(is_binary_ ? file_ : fmt::format("{}:{}", file_, line), entity_,
                   expected, got);
}

void MshCursor::skip_space() {
  while (place_ < bytes_.size() && is_space(bytes_[place_])) ++place_;
}

bool MshCursor::at_end() {
  skip_space();
  return place_ == bytes_.size();
}

std::string_view MshCursor::word() {
  if (at_end()) refuse("more of it", "the end of the file");
  const std::size_t start = place_;
  while (place_ < bytes_.size() && !is_space(bytes_[place_])) ++place_;
  return std::string_view(bytes_).substr(start, place_ - start);
}

std::string MshCursor::quoted() {
  skip_space();
  const std::size_t end = bytes_.find_first_of("\"\n", place_ + 1);
  if (place_ == bytes_.size() || bytes_[place_] != '"' || end == std::string::npos ||
      bytes_[end] != '"')
    refuse("a name in quotes", at_end() ? "the end of the file" : quotation(word()));
  std::string name = bytes_.substr(place_ + 1, end - place_ - 1);
  place_ = end + 1;
  return name;
}

std::int64_t MshCursor::text_number() {
  return parsed<std::int64_t>(*this, word(), "a whole number");
}

double MshCursor::text_real() {
  return parsed<double>(*this, word(), "a number");
}

void MshCursor::skip_line_end() {
  place_ = std::min(bytes_.find('\n', place_), bytes_.size() - 1) + 1;
}

void MshCursor::skip_behind(std::string_view text) {
  const std::size_t found = bytes_.find(text, place_);
  if (found == std::string::npos) refuse(quotation(text), "the end of the file");
  place_ = found + text.size();
}

void MshCursor::copy_bytes(void* target, std::size_t size) {
  if (bytes_.size() - place_ < size) refuse("more of it", "the end of the file");
  std::memcpy(target, bytes_.data() + place_, size);
  place_ += size;
}

template <class Binary>
std::int64_t MshCursor::number() {
  if (!is_binary_) return text_number();
  Binary value{};
  copy_bytes(&value, sizeof value);
  return static_cast<std::int64_t>(value);
}
template std::int64_t MshCursor::number<std::int32_t>();
template std::int64_t MshCursor::number<std::uint64_t>();

double MshCursor::real() {
  if (!is_binary_) return text_real();
  double value = 0;
  copy_bytes(&value, sizeof value);
  return value;
}

std::size_t MshCursor::checked_count(std::int64_t count, std::size_t bytes_each) const {
  const std::size_t most = (bytes_.size() - place_) / bytes_each;
  if (count < 0 || static_cast<std::uint64_t>(count) > most)
    refuse(fmt::format("from 0 to the {} that the rest of the file has room for", most),
           std::to_string(count));
  return static_cast<std::size_t>(count);
}

template <class Binary>
std::size_t MshCursor::count(std::size_t bytes_each) {
  return checked_count(number<Binary>(), bytes_each);
}
template std::size_t MshCursor::count<std::int32_t>(std::size_t);
template std::size_t MshCursor::count<std::uint64_t>(std::size_t);

std::size_t MshCursor::text_count(std::size_t bytes_each) {
  return checked_count(text_number(), bytes_each);
}

}  // namespace springcheck
