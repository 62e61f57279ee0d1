#include "comparisons/gates/bless.hpp"

#include <utf8.h>

#include <algorithm>
#include <stdexcept>

#include "comparisons/gates/gate_file.hpp"

namespace springcheck::gates {
namespace {

/// The offset in the text of a line and column, both from 1. Columns count code points.
std::size_t offset_of(std::string_view text, std::size_t line, std::size_t column) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (; line > 1; --line) at = text.find('\n', at) + 1;
  const auto* place = text.data() + at;
  utf8::advance(place, column - 1, text.data() + text.size());
  return static_cast<std::size_t>(place - text.data());
}

std::size_t end_of_number(std::string_view text, std::size_t begin) {
  constexpr std::string_view letters = "0123456789+-._abcdefABCDEFxoinf";
  return std::min(text.find_first_not_of(letters, begin), text.size());
}

const Stored& stored_of(const Gate& gate) {
  return std::get<Stored>(gate.comparison);
}

}  // namespace

std::vector<Blessed> to_bless(const std::vector<Gate>& gates,
                              const std::vector<Outcome>& outcomes) {
  std::vector<Blessed> values;
  for (std::size_t i = 0; i < gates.size(); ++i) {
    const auto* stored = std::get_if<Stored>(&gates[i].comparison);
    const auto& got = outcomes[i].got;
    if (stored == nullptr || gates[i].blessing == Blessing::fixed || !got ||
        outcomes[i].verdict != Judgement::falls_short || !outcomes[i].is_status_expected)
      continue;
    if (half_width(stored->width, *got) > 0)
      values.push_back({.gate = i, .old_value = stored->value, .new_value = *got});
  }
  return values;
}

std::string with_blessed(std::string_view text, const std::string& file,
                         const std::vector<Gate>& gates,
                         const std::vector<Blessed>& values) {
  std::vector<std::pair<std::size_t, std::string>> edits;
  for (const Blessed& value : values) {
    const Stored& stored = stored_of(gates[value.gate]);
    edits.emplace_back(offset_of(text, stored.line, stored.column),
                       described(value.new_value));
  }
  std::ranges::sort(edits, std::greater{});  // from the end, so that places stay
  std::string blessed(text);
  for (const auto& [begin, number] : edits)
    blessed.replace(begin, end_of_number(text, begin) - begin, number);

  const std::vector<Gate> read = parse_gates(blessed, file);
  for (const Blessed& value : values)
    if (read.size() != gates.size() ||
        stored_of(read[value.gate]).value != value.new_value)
      throw std::runtime_error(file + ": the stored value of gate '" +
                               gates[value.gate].name + "' could not be replaced");
  return blessed;
}

}  // namespace springcheck::gates
