#include "comparisons/gates/gate_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "comparisons/gates/measure_column.hpp"
#include "comparisons/gates/sweep_rows.hpp"
#include "comparisons/results/case_rows.hpp"

namespace springcheck::gates {
namespace {

/// A gate and the cases it is judged on.
class Judge {
 public:
  Judge(const Gate& gate, const Columns& cases, const std::string& file)
      : gate_(gate), cases_(cases), file_(file) {}

  Outcome operator()(const StatusAlone&) {
    const std::size_t row = own_row({});
    outcome_.got_text = cell_text(cases_, "status", row);
    std::vector<std::string_view> names;
    for (const Status status : gate_.expect)
      names.push_back(springcheck::name_of(status));
    outcome_.band_text = fmt::format("{}", fmt::join(names, " or "));
    return outcome_;
  }

  Outcome operator()(const Stored& stored) {
    const MeasureColumn column = measure(gate_.measure);
    const auto got = value(column, own_row({&column, 1}));
    compare_about(outcome_, stored.value, stored.width, got);
    return outcome_;
  }

  Outcome operator()(const Range& range) {
    const MeasureColumn column = measure(gate_.measure);
    compare(outcome_, range, value(column, own_row({&column, 1})));
    return outcome_;
  }

  Outcome operator()(const Against& against) {
    const auto [got, other] = own_and_other(against.where, against.measure);
    if (other)
      compare_about(outcome_, *other, against.width, got);
    else
      outcome_.band_text = "null";
    return outcome_;
  }

  Outcome operator()(const Ratio& ratio) {
    const auto [got, other] = own_and_other(ratio.where, ratio.measure);
    if (other && *other == 0) fall_short(outcome_, ratio.measure + " to divide by is 0");
    const bool has_ratio = got && other && *other != 0;
    compare(outcome_, ratio.range,
            has_ratio ? std::optional(*got / *other) : std::nullopt);
    return outcome_;
  }

  Outcome operator()(const Monotonic& monotonic) {
    outcome_.band_text =
        fmt::format("{} along {}", name_of(monotonic.direction), monotonic.along);
    const MeasureColumn column = measure(gate_.measure);
    const auto rows = sweep_rows(cases_, gate_, monotonic.along, 2, column);
    if (!sweep(column, rows)) return outcome_;
    const auto& q = outcome_.values;
    outcome_.got_text = fmt::format("{:.6g} .. {:.6g}", q.front(), q.back());
    const double sign = monotonic.direction == Direction::increasing ? 1 : -1;
    double smallest = sign * (q[1] - q[0]);
    for (std::size_t i = 1; i < q.size(); ++i) {
      const double step = sign * (q[i] - q[i - 1]);
      smallest = std::min(smallest, step);
      if (!(step > 0))
        fall_short(outcome_,
                   fmt::format("{:.9g} at {} = {}, then {:.9g} at {}", q[i - 1],
                               monotonic.along, setting(monotonic.along, rows[i - 1]),
                               q[i], setting(monotonic.along, rows[i])));
    }
    const double change = std::abs(q.back() - q.front());
    if (change > 0) outcome_.margin = smallest / change;
    return outcome_;
  }

  Outcome operator()(const Order& order) {
    outcome_.band_text = "order " + text_of(order.range);
    const MeasureColumn column = measure(gate_.measure);
    const std::vector<std::size_t> rows = finest_grids(cases_, gate_, column);
    if (!sweep(column, rows)) return outcome_;
    const auto observed = order_on(cases_, rows, outcome_.values);
    if (!observed)
      fall_short(outcome_,
                 fmt::format("{:.9g} show no order", fmt::join(outcome_.values, ", ")));
    compare(outcome_, order.range, observed);
    return outcome_;
  }

 private:
  MeasureColumn measure(const std::string& name) const {
    return measure_column(name, cases_, gate_.place);
  }

  std::string setting(const std::string& column, std::size_t row) const {
    return cell_text(cases_, column, row);
  }

  void expect_status(std::size_t row, std::span<const Status> expected,
                     const std::string& whose) {
    const std::string status = cell_text(cases_, "status", row);
    if (std::ranges::count(expected, status_named(status, file_)) > 0) return;
    outcome_.is_status_expected = false;
    const std::string reason = cell_text(cases_, "reason", row);
    fall_short(outcome_, fmt::format("{}status is {}{}", whose, status,
                                     reason.empty() ? "" : " (" + reason + ")"));
  }

  std::size_t own_row(std::span<const MeasureColumn> asked) {
    const std::size_t row = one_row(cases_, gate_.where, asked);
    outcome_.keys.push_back(cell_text(cases_, "key", row));
    expect_status(row, gate_.expect, "");
    return row;
  }

  /// A null value falls short here, whatever it is compared with.
  std::optional<double> value(const MeasureColumn& column, std::size_t row,
                              const std::string& whose = "") {
    const auto value = value_of(column, cases_, row);
    if (!value) fall_short(outcome_, fmt::format("{}{} is null", whose, column.name));
    return value;
  }

  struct Pair {
    std::optional<double> own, other;
  };
  Pair own_and_other(const Selection& where, const std::string& name) {
    const MeasureColumn column = measure(gate_.measure), other_column = measure(name);
    const std::size_t row = own_row({&column, 1}),
                      other = one_row(cases_, where, {&other_column, 1});
    if (other != row) {
      outcome_.keys.push_back(cell_text(cases_, "key", other));
      const Status ok = Status::ok;
      expect_status(other, {&ok, 1}, "the other case's ");
    }
    if (is_time(column) || is_time(other_column)) check_session(row, other);
    return {.own = value(column, row),
            .other = value(other_column, other, "the other case's ")};
  }

  void check_session(std::size_t row, std::size_t other) const {
    const std::string own = cell_text(cases_, "provenance", row);
    if (own.empty() || own != cell_text(cases_, "provenance", other))
      throw NoCase(
          "times of two sessions, which may differ in machine and load; run "
          "both cases in one");
  }

  /// The values of all rows; false, and short, where one is null.
  bool sweep(const MeasureColumn& column, const std::vector<std::size_t>& rows) {
    bool is_whole = true;
    for (const std::size_t row : rows) {
      outcome_.keys.push_back(cell_text(cases_, "key", row));
      const std::string whose = outcome_.keys.back().substr(0, 8) + ": ";
      expect_status(row, gate_.expect, whose);
      const auto one = value(column, row, whose);
      if (one) outcome_.values.push_back(*one);
      is_whole = is_whole && one;
    }
    return is_whole;
  }

  const Gate& gate_;
  const Columns& cases_;
  const std::string& file_;
  Outcome outcome_{};
};

}  // namespace

Outcome check(const Gate& gate, const Columns& cases, const std::string& file) {
  try {
    return std::visit(Judge(gate, cases, file), gate.comparison);
  } catch (const NoCase& error) {
    Outcome outcome{.verdict = Judgement::no_case};
    outcome.explanation = error.what();
    return outcome;
  }
}

}  // namespace springcheck::gates
