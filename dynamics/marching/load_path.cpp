#include "dynamics/marching/load_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace springcheck::dynamics {
namespace {

/// A place on a path: a piece, and the part of it that has passed.
struct Place {
  std::size_t piece;
  LoadPoint from, to;
  double part;
};

Place place_on(const LoadPath& path, double time) {
  assert(!path.empty());
  const auto next = std::ranges::lower_bound(path, time, {}, &LoadPoint::time);
  const auto piece =
      static_cast<std::size_t>(std::min(next, path.end() - 1) - path.begin());
  const LoadPoint from =
      piece == 0 ? LoadPoint{.time = 0, .fraction = 0} : path[piece - 1];
  const LoadPoint to = path[piece];
  return {.piece = piece,
          .from = from,
          .to = to,
          .part = (time - from.time) / (to.time - from.time)};
}

}  // namespace

LoadPath ramp(double duration) {
  return {{.time = duration, .fraction = 1}};
}

LoadPath oscillation(double angular_frequency, double cycles) {
  constexpr double pieces_per_cycle = 64;
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(cycles * pieces_per_cycle - 1e-9)));
  LoadPath path;
  for (int piece = 1; piece <= pieces; ++piece) {
    const double angle = 2 * std::numbers::pi * cycles * piece / pieces;
    const double half_cycles = 2 * cycles * piece / pieces;
    const bool passes_zero = half_cycles == std::round(half_cycles);
    path.push_back({.time = angle / angular_frequency,
                    .fraction = passes_zero ? 0 : std::sin(angle)});
  }
  return path;
}

LoadPath turning_points(const LoadPath& path) {
  LoadPath turns;
  const auto direction = [&](std::size_t piece) {
    const double before = piece == 0 ? 0 : path[piece - 1].fraction;
    return (path[piece].fraction > before) - (path[piece].fraction < before);
  };
  for (std::size_t i = 0; i < path.size(); ++i)
    if (i + 1 == path.size() || direction(i) != direction(i + 1))
      turns.push_back(path[i]);
  return turns;
}

double load_fraction(const LoadPath& path, double time) {
  const Place place = place_on(path, time);
  return place.from.fraction + place.part * (place.to.fraction - place.from.fraction);
}

double pieces_passed(const LoadPath& path, double time) {
  const Place place = place_on(path, time);
  return static_cast<double>(place.piece) + place.part;
}

}  // namespace springcheck::dynamics
