#include "comparisons/names/suggestion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utf8.h>

#include <algorithm>

#include "meshing/basics/input_error.hpp"

namespace springcheck {

std::size_t edit_distance(std::string_view one, std::string_view other) {
  constexpr std::size_t edit = 2, other_letter = 3;
  // distance[i][j]: of the first i letters of one and the first j of the other
  std::vector distance(one.size() + 1, std::vector<std::size_t>(other.size() + 1));
  for (std::size_t j = 1; j <= other.size(); ++j) distance[0][j] = j * edit;
  for (std::size_t i = 1; i <= one.size(); ++i) {
    distance[i][0] = i * edit;
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const bool same = one[i - 1] == other[j - 1];
      distance[i][j] = std::min({distance[i - 1][j] + edit, distance[i][j - 1] + edit,
                                 distance[i - 1][j - 1] + (same ? 0 : other_letter)});
      if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1])
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + edit);
    }
  }
  return distance[one.size()][other.size()];
}

namespace {

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

}  // namespace

std::string_view nearest(std::string_view text,
                         const std::vector<std::string_view>& candidates) {
  constexpr std::size_t longest = 64;  // a name; what is longer is none
  if (text.empty() || text.size() > longest) return {};
  std::string_view best;
  // An edit for every three letters, one at least:
  std::size_t least = 2 + 2 * std::max<std::size_t>(1, text.size() / 3);
  for (const std::string_view candidate : candidates)
    if (const std::size_t edits =
            edit_distance(in_small_letters(text), in_small_letters(candidate));
        edits < least && candidate.find(' ') == candidate.npos) {
      least = edits;
      best = candidate;
    }
  if (!best.empty() || text.size() < 3) return best;
  const auto begins = [&](std::string_view name) { return name.starts_with(text); };
  const auto found = std::ranges::find_if(candidates, begins);
  return std::ranges::count_if(candidates, begins) == 1 ? *found : std::string_view{};
}

std::string clipped(std::string_view text) {
  constexpr std::ptrdiff_t longest = 200;
  std::string sound = utf8::replace_invalid(text);
  const auto characters = utf8::distance(sound.begin(), sound.end());
  if (characters <= longest) return sound;
  auto end = sound.begin();
  utf8::advance(end, longest, sound.end());
  return fmt::format("{}... ({} characters)", std::string(sound.begin(), end),
                     characters);
}

void refuse_name(std::string_view place, std::string_view what, std::string_view text,
                 const std::vector<std::string_view>& candidates) {
  const std::string_view meant = nearest(text, candidates);
  throw InputError(
      fmt::format("{}: unknown {} '{}'{} expected one of {}", place, what, clipped(text),
                  meant.empty() ? "," : fmt::format(", did you mean '{}'?", meant),
                  fmt::join(candidates, ", ")));
}

}  // namespace springcheck
