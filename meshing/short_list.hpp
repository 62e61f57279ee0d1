#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <compare>
#include <cstdint>
#include <initializer_list>
#include <ranges>

namespace springcheck {

/// A list of up to Capacity values in place, without memory of its own elsewhere.
template <class Value, std::size_t Capacity>
class ShortList {
 public:
  constexpr ShortList() = default;
  constexpr ShortList(std::initializer_list<Value> values) { append(values); }

  template <std::ranges::input_range Range>
  requires(!std::same_as<std::remove_cvref_t<Range>,
                         ShortList>) constexpr explicit ShortList(const Range& values) {
    append(values);
  }

  constexpr void push_back(Value value) {
    assert(size_ < Capacity);
    values_[size_++] = value;
  }

  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr const Value& operator[](std::size_t i) const {
    return values_[i];
  }
  constexpr Value& operator[](std::size_t i) { return values_[i]; }
  [[nodiscard]] constexpr const Value* begin() const { return values_.data(); }
  [[nodiscard]] constexpr const Value* end() const { return values_.data() + size_; }
  constexpr Value* begin() { return values_.data(); }
  constexpr Value* end() { return values_.data() + size_; }

  /// Compares the number of values first, then the values in turn.
  friend constexpr auto operator<=>(const ShortList& a, const ShortList& b) {
    if (const auto order = a.size_ <=> b.size_; order != 0) return order;
    return a.values_ <=> b.values_;  // those beyond the size are all zero
  }
  friend constexpr bool operator==(const ShortList&, const ShortList&) = default;

 private:
  template <class Range>
  constexpr void append(const Range& values) {
    for (const Value& value : values) push_back(value);
  }

  std::array<Value, Capacity> values_{};
  std::uint8_t size_ = 0;
};

}  // namespace springcheck
