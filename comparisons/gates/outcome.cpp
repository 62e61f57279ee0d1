#include "comparisons/gates/outcome.hpp"
#include "meshing/loads/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace springcheck::gates {
namespace {

/// A number with so many digits that two of the scale's can be seen.
std::string shown(double value, double scale) {
  const double ratio = std::abs(value) / scale;
  const int digits =
      std::isfinite(ratio) && ratio > 1 ? static_cast<int>(std::log10(ratio)) + 3 : 6;
  return fmt::format("{:.{}g}", value, std::clamp(digits, 6, 17));
}

/// Distance to the nearest edge in the units of Outcome::margin, where those exist.
std::optional<double> margin_in(const Range& band, double got) {
  const auto over = [](double distance, double unit) {
    return unit > 0 ? std::optional(distance / unit) : std::nullopt;
  };
  if (band.low && band.high)
    return over(std::min(got - *band.low, *band.high - got),
                (*band.high - *band.low) / 2);
  if (band.low) return over(got - *band.low, std::abs(*band.low));
  return over(*band.high - got, std::abs(*band.high));
}

bool contains(const Range& band, double got) {
  return (!band.low || got >= *band.low) && (!band.high || got <= *band.high);
}

}  // namespace

std::string text_of(const Range& band) {
  if (band.low && band.high)
    return fmt::format("{:.6g} .. {:.6g}", *band.low, *band.high);
  return band.low ? fmt::format(">= {:.6g}", *band.low)
                  : fmt::format("<= {:.6g}", *band.high);
}

void fall_short(Outcome& outcome, const std::string& why) {
  outcome.verdict = Judgement::falls_short;
  add_reason(outcome.explanation, why);
}

void compare(Outcome& outcome, const Range& band, const std::optional<double>& got) {
  outcome.band = band;
  if (outcome.band_text == "-") outcome.band_text = text_of(band);
  outcome.got = got;
  if (!got) {
    outcome.got_text = "null";
    return;
  }
  const double scale = band.low && band.high ? (*band.high - *band.low) / 2 : 0;
  outcome.got_text = shown(*got, scale);
  outcome.margin = margin_in(band, *got);
  if (!contains(band, *got)) fall_short(outcome, "outside the band");
}

void compare_about(Outcome& outcome, double middle, const Width& width,
                   const std::optional<double>& got) {
  const double half = half_width(width, middle);
  outcome.band_text = fmt::format("{} +- {:.3g}", shown(middle, half), half);
  compare(outcome, {.low = middle - half, .high = middle + half}, got);
}

}  // namespace springcheck::gates
