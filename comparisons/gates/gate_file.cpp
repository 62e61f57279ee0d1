#include "comparisons/gates/gate_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "comparisons/gates/gate_table.hpp"
#include "comparisons/settings/setting_values.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck::gates {
namespace {

/// Keys that say what is compared; at_least and at_most belong together.
constexpr std::array<const char*, 6> kinds{"equals",         "against",       "monotonic",
                                           "order_at_least", "order_between", "at_least"};

/// The kind of comparison, and that there is one only.
std::string kind_of(const GateTable& gate) {
  std::string kind;
  for (std::string key : kinds) {
    if (key == "at_least" && !gate.has(key)) key = "at_most";
    if (!gate.has(key)) continue;
    if (!kind.empty())
      gate.refuse(key, "one kind of band", fmt::format("{} and {}", kind, key));
    kind = key;
  }
  if (gate.has("ratio_to")) {
    if (kind != "at_least" && kind != "at_most")
      gate.refuse("ratio_to", "at_least or at_most with it",
                  kind.empty() ? "neither" : kind);
    return "ratio_to";
  }
  return kind;
}

/// Keys that mean something with some kinds of band only.
void check_applicable(const GateTable& gate, const std::string& kind) {
  const auto only_with = [&](const char* key, const std::set<std::string>& wanted) {
    if (gate.has(key) && !wanted.contains(kind))
      gate.refuse(key, fmt::format("{} with it", fmt::join(wanted, " or ")),
                  kind.empty() ? "no band" : kind);
  };
  only_with("absolute", {"equals", "against"});
  only_with("relative", {"equals", "against"});
  only_with("along", {"monotonic", "order_at_least", "order_between"});
}

Width width_of(const GateTable& gate, const std::string& kind) {
  Width width;
  if (gate.has("absolute")) width.absolute = gate.value("absolute").positive_number();
  if (gate.has("relative")) width.relative = gate.value("relative").positive_number();
  if (!gate.has("absolute") && !gate.has("relative"))
    gate.refuse(kind, "a width with it: absolute, relative or both", "none");
  return width;
}

Stored stored_of(const GateTable& gate) {
  const auto source = gate.source("equals");
  const Stored stored{.value = gate.value("equals").finite_number(),
                      .width = width_of(gate, "equals"),
                      .line = source.begin.line,
                      .column = source.begin.column};
  if (!(half_width(stored.width, stored.value) > 0))
    gate.refuse("equals", "an absolute width about 0", "a relative one");
  return stored;
}

Range range_of(const GateTable& gate) {
  Range range;
  if (gate.has("at_least")) range.low = gate.value("at_least").finite_number();
  if (gate.has("at_most")) range.high = gate.value("at_most").finite_number();
  if (range.low && range.high && !(*range.low < *range.high))
    gate.refuse("at_most", fmt::format("more than at_least = {}", *range.low),
                fmt::to_string(*range.high));
  return range;
}

Order order_of(const GateTable& gate) {
  if (gate.along() != "cells")
    gate.refuse("along", "'cells' for an order of convergence", "'" + gate.along() + "'");
  if (gate.has("order_at_least"))
    return {.range = {.low = gate.value("order_at_least").positive_number()}};
  const auto [low, high] = gate.value("order_between").numbers<2>();
  if (!(0 < low && low < high))
    gate.value("order_between").refuse("two positive numbers, the smaller one first");
  return {.range = {.low = low, .high = high}};
}

Comparison comparison_of(const GateTable& gate, const Gate& own) {
  const std::string kind = kind_of(gate);
  check_applicable(gate, kind);
  if (kind.empty()) {
    const bool is_judged = own.measure.empty() && gate.has("expect");
    if (!is_judged && gate.text_or("measure", "") != "status")
      gate.refuse("", "a measure with a band, or a status to expect", "neither");
    return StatusAlone{};
  }
  if (own.measure.empty())
    gate.refuse(kind, "the name of a measure with it",
                gate.has("measure") ? "'status'" : "none");
  if (kind == "equals") return stored_of(gate);
  if (kind == "against") {
    const OtherCase other = gate.other_case("against", own);
    return Against{
        .where = other.where, .measure = other.measure, .width = width_of(gate, kind)};
  }
  if (kind == "ratio_to") {
    const OtherCase other = gate.other_case("ratio_to", own);
    return Ratio{.where = other.where, .measure = other.measure, .range = range_of(gate)};
  }
  if (kind == "monotonic")
    return Monotonic{.direction = named<Direction>(gate.value("monotonic")),
                     .along = gate.along()};
  if (kind == "order_at_least" || kind == "order_between") return order_of(gate);
  return range_of(gate);
}

Gate gate_of(const GateTable& table, const Selection& common, bool all_fixed) {
  table.check_keys();
  Gate gate{.name = table.line("name"),
            .reason = table.line("reason"),
            .place = table.place(),
            .where = narrowed(common, table.selection("where")),
            .measure = table.text_or("measure", ""),
            .expect = {Status::ok},
            .blessing = Blessing::allowed};
  if (gate.where.empty()) table.refuse("where", "settings that select a case", "none");
  if (gate.measure == "status") gate.measure.clear();
  if (table.has("expect")) gate.expect = statuses_of(table.value("expect"));
  if (table.has("fixed") ? table.value("fixed").truth() : all_fixed)
    gate.blessing = Blessing::fixed;
  gate.comparison = comparison_of(table, gate);
  return gate;
}

}  // namespace

std::vector<Gate> parse_gates(std::string_view text, const std::string& file) {
  const toml::table table = parse_toml(text, file);
  const GateFileTable all(table, file);
  std::vector<Gate> gates;
  std::set<std::string> names;
  for (const GateTable& one : all.gates()) {
    gates.push_back(gate_of(one, all.common(), all.is_fixed()));
    if (!names.insert(gates.back().name).second)
      one.refuse("name", "a name of its own", "'" + gates.back().name + "' again");
  }
  return gates;
}

}  // namespace springcheck::gates
