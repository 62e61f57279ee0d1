#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace springcheck {

/// Reads the bytes of a .msh file from front to back. Everything that is not there, or
/// not what was asked for, throws InputError.
class MshCursor {
 public:
  /// Throws InputError for what is not a regular file that can be read.
  explicit MshCursor(const std::filesystem::path& file);

  /// Makes number() and real() read binary data, in the machine's byte order, from now
  /// on.
  void set_binary() { is_binary_ = true; }
  [[nodiscard]] bool is_binary() const { return is_binary_; }

  /// What errors name as the place: "$Nodes" or "node 7".
  void set_entity(std::string entity) { entity_ = std::move(entity); }

  [[nodiscard]] bool at_end();  // but for white space
  std::string_view word();      // up to white space
  std::string quoted();         // "a name"
  std::int64_t text_number();   // decimal even in binary files
  double text_real();
  void skip_line_end();
  void skip_behind(std::string_view text);

  /// Integer of `Binary` type in binary files, decimal in others.
  template <class Binary>
  std::int64_t number();
  double real();

  /// Such a number, of things that take so many bytes each at least. A number that the
  /// rest of the file has no room for is refused before anybody reserves memory for it.
  template <class Binary>
  std::size_t count(std::size_t bytes_each);
  std::size_t text_count(std::size_t bytes_each);

  [[noreturn]] void refuse(std::string_view expected, std::string_view got) const;

 private:
  void skip_space();
  void copy_bytes(void* target, std::size_t size);
  std::size_t checked_count(std::int64_t count, std::size_t bytes_each) const;

  std::string file_;
  std::string bytes_;
  std::size_t place_ = 0;
  bool is_binary_ = false;
  std::string entity_;
};

}  // namespace springcheck
