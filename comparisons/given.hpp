#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace springcheck {

/// One value as the user wrote it, in a scene file or on the command line, with the place
/// that error messages name. The readers throw InputError when it is not what they want.
class Given {
 public:
  using Scalar = std::variant<bool, std::int64_t, double, std::string>;

  /// place: "scene.toml:4:7: nu" or "--nu".
  Given(std::string place, std::vector<Scalar> values)
      : place_(std::move(place)), values_(std::move(values)) {}

  /// From command-line text: commas separate the values of a list; each is read as a
  /// truth value, an integer, a number or else as text.
  static Given from_text(std::string place, std::string_view text);

  [[nodiscard]] const std::string& place() const { return place_; }

  [[nodiscard]] double finite_number() const;
  [[nodiscard]] double positive_number() const;
  [[nodiscard]] std::int64_t integer() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::vector<std::string> texts() const;  // at least one
  [[nodiscard]] std::array<double, 3> three_numbers() const;
  [[nodiscard]] std::array<std::int64_t, 3> three_integers() const;

  /// A number, or text with a unit: "5%" is 0.05, "45deg" is pi/4.
  [[nodiscard]] double deformation() const;

  /// Throws InputError for this value.
  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  [[nodiscard]] const Scalar& single(const char* expected) const;

  std::string place_;
  std::vector<Scalar> values_;
};

}  // namespace springcheck
