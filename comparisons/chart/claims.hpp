#pragma once

#include "comparisons/chart/chart.hpp"
#include "comparisons/formats/table.hpp"

namespace springcheck {

/// What a chart says of a claim. It is undecided where two times cannot be told from each
/// other (is_faster_than), or two errors differ by less than worthwhile_gain or what the
/// truth may be off.
enum class Answer { yes, no, undecided };

template <>
inline constexpr std::array value_names<Answer>{Named{Answer::yes, "yes"},
                                                Named{Answer::no, "no"},
                                                Named{Answer::undecided, "undecided"}};

/// Springs beside the finite elements of the scene's law, of one kind and measure.
struct Claim {
  ChartKind kind;
  ChartMeasure measure;
  std::size_t springs, elements;  // points on the same cells, the largest that both hold
  Answer is_faster;               // the springs, than those elements
  Answer is_as_accurate;
  // The fastest elements of any size, and cells, that cannot be told to be less accurate
  // than the springs; none where all can:
  std::optional<std::size_t> rival{};
  bool were_all_run;  // elements of this kind; none were left out
  // Whether the springs are faster than the rival; without a rival yes, if all were run.
  Answer is_faster_at_equal_accuracy;
};

/// Golec's claims of springs, that they are faster than finite elements and as accurate,
/// put to the foremost springs, but for those that follow another law than the scene's.
/// They stand beside q1-sri elements of the scene's law, in motions beside each of
/// moving_elements on hexahedra, on one thread.
std::vector<Claim> claims(const Chart& chart);

/// The claim in words, with the figures.
std::string claim_text(const Chart& chart, const Claim& claim);

/// The table "chart-claims", with a row for each claim.
Table claims_table(const std::vector<Chart>& charts);

}  // namespace springcheck
