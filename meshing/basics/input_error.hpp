#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace springcheck {

/// What the user gave cannot be used. The message is one line:
///
///     file: entity: expected what, got what
///
/// and an empty entity leaves its part out. `file` may carry ":line:column", or
/// be the name of a command-line option.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(std::string_view file, std::string_view entity, std::string_view expected,
             std::string_view got)
      : std::runtime_error(std::string(file) + ": " +
                           (entity.empty() ? "" : std::string(entity) + ": ") +
                           "expected " + std::string(expected) + ", got " +
                           std::string(got)) {}
};

}  // namespace springcheck
