#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/cases/convergence_grids.hpp"
#include "comparisons/cases/grids.hpp"
#include "comparisons/results/stored_chart.hpp"
#include "comparisons/settings/scene_file.hpp"

namespace springcheck {

/// A model, and what it changes.
struct ChartModel {
  Model model;
  GivenSettings changes;  // of the scene's settings
  ChartKind kind;
};

/// Every model that a chart compares, as the methods' entries have them
/// (Method::charted); for a kidney those on its own two kinds of cells.
const std::vector<ChartModel>& chart_models(BodyShape shape = BodyShape::block);

/// The models that a chart compares.
enum class ChartModels {
  all,
  foremost  // of methods that people want to see first (Method::foremost), on hexahedra,
            // by the linear solver that is chosen by size
};

bool is_foremost(const Model& model);

/// The chosen models, in the order of chart_models.
std::vector<ChartModel> chosen_models(ChartModels which, BodyShape shape);

/// The entry of that model in chart_models. Throws std::logic_error where there is none.
const ChartModel& chart_model(const Model& model, BodyShape shape);

/// Whether a chart chooses the setting for its models. What a scene file says of it is
/// not for a chart: models get the step, precision and constants that they have by
/// default.
bool is_chosen_by_charts(std::string_view key);

/// Laws of which a chart has a truth each, as methods; fem-cauchy-born's is the lattice
/// of mss-cf.
const std::vector<std::string>& truth_laws();

/// The law of that name, or "" of none. Throws InputError for another.
std::string truth_law_named(const std::string& name);

/// The options for models of a kind: those of motion are for the ones that move.
GivenSettings options_for(ChartKind kind, GivenSettings options);

/// The scene's body, a block or a kidney, which can be cut as finely as wanted. Throws
/// InputError for another.
Body chart_body(const std::string& scene, const GivenSettings& options);

/// Whether all meshes of the body have its corners, edges and faces, so that a grid can
/// refine them: a block's.
bool is_nested(const Body& body);

/// Cells along the extents of a body with so many across its shortest one, as near to
/// cubes as counts allow.
Cells cells_across(const std::array<double, 3>& size, int across);

/// The scene's case of a model on so many cells across: the scene without
/// what charts choose, the options, the model's changes. Throws InputError for options
/// that the model's method does not take, and as chart_body.
CaseSettings model_case(const std::string& scene, const GivenSettings& options,
                        const ChartModel& model, int across);

/// Elements of a truth's grids, and of those by which their limit is checked.
inline constexpr std::string_view truth_element = "q2", check_element = "q1-sri";

/// The grids that a law's truth is told from.
struct TruthGrids {
  ThreeCases grids, check;
};

/// Grids of q2, from coarse to fine, whose limit is the truth of a law. For a block they
/// are those of convergence_grids from `across` cells on: 4, or 2 where the finest of 16
/// would have more than 10^5 nodes, as beams have. They are solved directly: multigrid
/// takes several times as long where a beam bends (fem-stvk on 8 x 8 x 48 cells, beside
/// other work on two cores: 80 s, and stopped after 300). For a kidney, whose meshes are
/// not nested and whose surface they follow ever closer, they are 4, 6 and 8 across in
/// proportion to `across`, solved directly too: multigrid takes four times as long on
/// such cells.
///
/// They are checked by q1-sri on twice as many cells along each axis, which for a block
/// have the same nodes.
TruthGrids truth_grids(const std::string& scene, const GivenSettings& options,
                       const std::string& law, const std::optional<int>& across);

}  // namespace springcheck
