#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace springcheck {

/// How far apart two texts are: 2 for each letter that is lost, added or swapped with its
/// neighbour, 3 for each that is another (the Damerau-Levenshtein distance, each letter
/// edited once at most, with weights: fingers lose and swap more than they exchange).
std::size_t edit_distance(std::string_view one, std::string_view other);

/// The candidate that was most likely meant, capitals or not: the nearest, if it is near for a text of
/// that length, or the only one that begins so. Empty where none is.
std::string_view nearest(std::string_view text,
                         const std::vector<std::string_view>& candidates);

/// A text for messages, of a long one its beginning.
std::string clipped(std::string_view text);

/// Throws InputError: "place: unknown key 'yuong', did you mean 'young'? expected one of
/// ...". `what` says what it is, "key".
[[noreturn]] void refuse_name(std::string_view place, std::string_view what,
                              std::string_view text,
                              const std::vector<std::string_view>& candidates);

}  // namespace springcheck
