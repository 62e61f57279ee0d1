#include "tissue/strain_history.hpp"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <string>

#include "meshing/basics/input_error.hpp"
#include "tissue/checks.hpp"

namespace springcheck::tissue {
namespace {

/// D = gamma(t) - gamma(t') over the ages s = t - t' of a piece, D = change + slope s.
struct Piece {
  double youngest, oldest;  // [s]
  double change, slope;     // [-], [1/s]
};

/// int m(s) h(slope s) ds from 0 to `oldest`.
double newest_piece(const BipowerLaw& law, double slope, double oldest) {
  const double n = law.linear_index, p = law.hardening_index;
  const double D = slope * oldest;
  return n * linear_relaxation_modulus(law, oldest) * D *
         (1 / (1 - n) +
          std::pow(std::abs(D / law.linear_limit), p) / ((p + 1) * (p + 1 - n)));
}

/// int m(s) h(D(s)) ds where D keeps its sign; over ln s, m ds = n G0 d(ln s).
double older_piece(const BipowerLaw& law, const Piece& piece) {
  // integrate() is not const in Boost 1.74.
  thread_local boost::math::quadrature::tanh_sinh<double> quadrature;
  const double n = law.linear_index,
               G_youngest = linear_relaxation_modulus(law, piece.youngest);
  const auto integrand = [&](double log_ratio) {
    const double s = piece.youngest * std::exp(log_ratio);
    return n * G_youngest * std::exp(-n * log_ratio) *
           hardened_strain(law, piece.change + piece.slope * s);
  };
  constexpr double tolerance = 1e-10;
  return quadrature.integrate(integrand, 0., std::log(piece.oldest / piece.youngest),
                              tolerance);
}

double cut_at_change_of_sign(const BipowerLaw& law, const Piece& piece) {
  const double root = -piece.change / piece.slope;
  const bool is_inside = root > piece.youngest && root < piece.oldest;  // none: inf, NaN
  if (!is_inside) return older_piece(law, piece);
  return older_piece(law, {piece.youngest, root, piece.change, piece.slope}) +
         older_piece(law, {root, piece.oldest, piece.change, piece.slope});
}

}  // namespace

void check(const StrainHistory& history) {
  const auto refuse = [](const std::string& expected, const std::string& got) {
    throw InputError("tissue", "strain history", expected, got);
  };
  const auto& [times, strains] = history;
  if (times.empty()) refuse("at least one time", "none");
  if (times.size() != strains.size())
    refuse(std::to_string(times.size()) + " strains, one at each time",
           std::to_string(strains.size()));
  for (const auto* numbers : {&times, &strains})
    if (!std::all_of(numbers->begin(), numbers->end(),
                     [](double value) { return std::isfinite(value); }))
      refuse("finite times and strains", "others");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      refuse("increasing times",
             std::to_string(times[i]) + " after " + std::to_string(times[i - 1]));
}

double strain_at(const StrainHistory& history, double time) {
  const auto& [times, strains] = history;
  if (time < times.front()) return 0;
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  if (next == times.end()) return strains.back();
  const auto i = static_cast<std::size_t>(next - times.begin());
  const double part = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return std::lerp(strains[i - 1], strains[i], part);
}

double stress(const BipowerLaw& law, const StrainHistory& history, double time) {
  check(law);
  check(history);
  const auto& [times, strains] = history;
  if (time < times.front() || (time == times.front() && strains.front() == 0)) return 0;
  check_positive("time after the jump of the strain [s]", time - times.front());

  const double now = strain_at(history, time);
  double sum =
      linear_relaxation_modulus(law, time - times.front()) * hardened_strain(law, now);
  for (std::size_t i = 0; i < times.size() && times[i] < time; ++i) {
    const bool is_newest = i + 1 == times.size() || times[i + 1] >= time;
    const double oldest = time - times[i];
    if (is_newest) {
      sum += newest_piece(law, (now - strains[i]) / oldest, oldest);
    } else {
      const double slope = (strains[i + 1] - strains[i]) / (times[i + 1] - times[i]);
      const double youngest = time - times[i + 1];
      sum += cut_at_change_of_sign(
          law, {youngest, oldest, now - strains[i + 1] - slope * youngest, slope});
    }
  }
  return sum;
}

double stress(const MaxwellModel& model, const StrainHistory& history, double time) {
  check(model);
  check(history);
  const double first = history.strains.front(), now = strain_at(history, time);
  std::vector<BranchStrain> branches(model.branches.size(), {first, first * first});
  double rate = 0;
  const auto advance = [&](double duration) {
    for (std::size_t i = 0; i < branches.size(); ++i) {
      const double tau = model.branches[i].relaxation_time, step = rate * tau;
      const double left = std::exp(-duration / tau), gone = -std::expm1(-duration / tau);
      auto& [mean, mean_square] = branches[i];
      mean_square = 2 * step * step * gone +
                    (mean_square + 2 * rate * (mean - step) * duration) * left;
      mean = step * gone + mean * left;
    }
  };
  for (std::size_t i = 0; i < history.times.size() && history.times[i] < time; ++i) {
    const bool is_held = i + 1 == history.times.size();
    const double end = is_held ? time : std::min(time, history.times[i + 1]);
    rate = is_held ? 0
                   : (history.strains[i + 1] - history.strains[i]) /
                         (history.times[i + 1] - history.times[i]);
    advance(end - history.times[i]);
  }
  double sum = model.viscosity * rate;
  const auto add = [&](const BranchModuli& moduli, const BranchStrain& strain) {
    sum += strain.mean * branch_stiffness(moduli, strain.mean_square, model.linear_limit,
                                          model.hardening_index);
  };
  add(model.elastic, {now, now * now});
  for (std::size_t i = 0; i < branches.size(); ++i)
    add(model.branches[i].moduli, branches[i]);
  return sum;
}

}  // namespace springcheck::tissue
