#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "comparisons/settings/units.hpp"

namespace springcheck {

struct GivenSetting;

/// One value as the user wrote it, in a scene file or on the command line, with the place
/// that error messages name. The readers throw InputError when it is not what they want.
class Given {
 public:
  /// Values under keys.
  struct Table {
    std::string place;  // where it begins
    std::shared_ptr<const std::vector<GivenSetting>> entries;
  };
  /// A nested list or a date: no setting takes one. The text is for messages.
  struct Unreadable {
    std::string text;
  };
  using Scalar = std::variant<bool, std::int64_t, double, std::string, Table, Unreadable>;

  /// `place` is as "scene.toml:4:7: nu" or "--nu".
  Given(std::string place, Scalar value)
      : place_(std::move(place)), values_{std::move(value)} {}
  Given(std::string place, std::vector<Scalar> list)
      : place_(std::move(place)), values_(std::move(list)), is_list_(true) {}

  /// What this program gives itself, where a user could have: a number, a name, a text as
  /// users write it, "5%", or a list.
  Given(double number) : Given(own, Scalar(number)) {}
  Given(int number) : Given(own, Scalar(std::int64_t{number})) {}
  Given(const char* text) : Given(own, Scalar(std::string(text))) {}
  Given(std::string text) : Given(own, Scalar(std::move(text))) {}
  Given(std::string_view text) : Given(own, Scalar(std::string(text))) {}
  template <std::size_t N>
  Given(const std::array<double, N>& numbers)
      : Given(own, std::vector<Scalar>(numbers.begin(), numbers.end())) {}
  Given(const std::array<int, 3>& counts)
      : Given(own, std::vector<Scalar>{std::int64_t{counts[0]}, std::int64_t{counts[1]},
                                       std::int64_t{counts[2]}}) {}

  Given(bool) = delete;  // would be the integer 1
  Given(char) = delete;
  Given(std::nullptr_t) = delete;

  /// The value of command-line text: commas separate the values of a list; each is read
  /// as a truth value, an integer, a number or else as text.
  static Given from_text(std::string place, std::string_view text);

  [[nodiscard]] const std::string& place() const { return place_; }

  /// The file that it stands in, or "--" for an option.
  [[nodiscard]] std::string source() const;

  [[nodiscard]] double number(const std::string& expected) const;  // finite
  [[nodiscard]] double finite_number() const;
  [[nodiscard]] double positive_number() const;
  [[nodiscard]] std::int64_t integer() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string path() const;  // a relative one of a file stands beside it
  [[nodiscard]] std::vector<std::string> texts() const;  // at least one
  [[nodiscard]] std::string joined() const;              // a list's with commas
  [[nodiscard]] std::string toml() const;                // as a scene file writes it
  [[nodiscard]] bool has_tables() const;                 // one at least
  [[nodiscard]] std::vector<Table> tables(const std::string& expected) const;
  /// The value's numbers, at least one and all finite.
  [[nodiscard]] std::vector<double> any_numbers(
      const std::string& expected = "finite numbers") const;
  [[nodiscard]] std::array<std::int64_t, 3> three_integers() const;

  /// The value's N numbers, all finite.
  template <std::size_t N>
  [[nodiscard]] std::array<double, N> numbers() const {
    std::array<double, N> all{};
    const std::string expected = std::to_string(N) + " finite numbers";
    if (values_.size() != N) refuse(expected);
    std::ranges::copy(any_numbers(expected), all.begin());
    return all;
  }

  /// The value whose numbers with a unit, "10kPa", are numbers in the dimension's SI
  /// unit. Throws InputError for a unit of another dimension.
  [[nodiscard]] Given in_si_units(Dimension dimension) const;

  /// Whether in_si_units() has converted its first value.
  [[nodiscard]] bool had_units() const;

  /// The value's only number in the dimension's SI unit, finite.
  [[nodiscard]] double in(Dimension dimension) const;

  /// Throws InputError for this value.
  [[noreturn]] void refuse(const std::string& expected) const;

  /// Throws InputError for a name among its values that is none of the candidates, of
  /// which the one that was meant is named.
  [[noreturn]] void refuse_name(std::string_view name,
                                const std::vector<std::string_view>& candidates) const;

 private:
  static constexpr const char* own = "springcheck";  // the place of its own values

  [[nodiscard]] const Scalar& single(const std::string& expected) const;

  std::string place_;
  std::vector<Scalar> values_;
  std::vector<Scalar> written_{};  // before a conversion of units, for messages
  bool is_list_ = false;
};

/// A setting as given, by its key.
struct GivenSetting {
  std::string key;
  Given value;
};
using GivenSettings = std::vector<GivenSetting>;

/// A value as the user would write it, text in quotes.
std::string described(const Given::Scalar& value);

/// The number that a value is; none where it is something else.
std::optional<double> number_in(const Given::Scalar& value);

}  // namespace springcheck
