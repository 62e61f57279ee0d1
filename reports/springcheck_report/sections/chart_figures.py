"""Speed against accuracy in figures: errors of every model over its times."""

import measures
from content import Figure
from figures import work_precision
from numbers_shown import revision_text

_KINDS = {
    "equilibrium": ("time of the solution [s]", "Equilibria", "time of a static solution"),
    "motion": (
        "real per simulated time [s/s]",
        "Motions",
        "real time per simulated time, by explicit steps of 0.9 of the method's own stability limit",
    ),
}
_GROUPS = [
    "Explicit steps,\ndouble precision",
    "Explicit steps,\nsingle precision",
    "Springs on hexahedra",
    "Finite elements of this\nlaw on hexahedra",
    "Finite elements of other\nlaws on hexahedra",
    "Tetrahedra and prisms",
]
_PARTS = ["method", "family", "element", "cell_type", "linear_solver", "precision"]


def figures_against(one, laws, name, heading):
    """One of each kind against the truths of these laws: times of the two kinds are never
    compared."""
    truths = [truth for truth in one["truths"] if truth["law"] in laws]
    figures = [_figure(one, truths, kind, name, heading) for kind in _KINDS]
    return [figure for figure in figures if figure]


def _figure(one, truths, kind, name, heading):
    blocks = [block for block in (_block(one, truth, kind) for truth in truths) if block]
    if not blocks:
        return None
    time_label, states, times = _KINDS[kind]
    is_own = truths[0]["law"] == one["law"]
    caption = _caption(one, is_own, f"{states} in {heading}: {times}.")
    name = f"{name}_{kind}" if is_own else f"{name}_{kind}_other-laws"
    return Figure(name, caption, work_precision.draw, (time_label, blocks))


def _block(one, truth, kind):
    law, threads = truth["law"], fewest_threads(one)
    points = [point_of(p, law) for p in one["points"] if p["kind"] == kind and _is_timed(p)]
    points = [point for point in points if point.threads == threads]
    if not points:
        return None
    measures = []
    for front in one["fronts"]:
        if (front["kind"], front["law"]) == (kind, law):
            on_it = [point_of(one["points"][place], law) for place in front["points"]]
            told = [100 * error for error in front["errors_told"]]
            bar = truth["bars"][front["measure"]]
            title = _measure_title(one, front["measure"])
            measures.append(work_precision.Measure(front["measure"], title, on_it, told, bar and 100 * bar))
    title = f"Pareto front against\nconverged {law}"
    groups = _groups(points, law) if law == one["law"] else [_closest(points, law, kind)]
    return work_precision.Block(title, points, measures, [group for group in groups if group.models])


def _caption(one, is_own, words):
    threads = fewest_threads(one)
    on = "one thread" if threads == 1 else f"{threads} threads"
    law = f"{one['law']}, the scene's own law" if is_own else "other laws, one after the other"
    return (
        f"{words} Errors against what {law} converges to. Times are medians on {on}, bars their quartiles; "
        "larger markers are finer meshes, pale ones all models. The front counts all numbers of threads: its "
        "points have the cells across beside them and, in brackets, the threads if more than one. In the "
        "shaded band the converged solution itself is unsure, of deviations on the mesh where it is most so; the front "
        "counts what it may be off on each mesh; where all errors are far "
        "above it, its height is written alone. Crosses above the line are simulations that failed, at the "
        f"time they took. Errors below an axis stand on it. Measured on {one['machine']}"
        + (
            f", with the numerics of {revision_text(other)}, not this program's."
            if (other := one["other_revision"])
            else "."
        )
    )


def _is_timed(point):
    """Whether it was run on so many threads: it may have been over the budget on these and
    not on others."""
    return point["median"] is not None


def fewest_threads(one):
    return min(point["threads"] for point in one["points"])


def point_of(point, law):
    errors = point["errors"].get(law, {})
    return work_precision.Point(
        model=work_precision.Model(point["model"], **{part: point[part] for part in _PARTS}),
        across=point["across"],
        threads=point["threads"],
        status=point["status"],
        time=point["median"],
        lower=point["lower_quartile"],
        upper=point["upper_quartile"],
        errors={name: error if error is None else 100 * error for name, error in errors.items()},
    )


def answer_of(one):
    """Label and unit of what it is about."""
    return measures.label(one["answer"]), measures.unit(one["answer"])


def _measure_title(one, measure):
    names = {"force": answer_of(one)[0], "volume": "volume", "deviation": "deviation of the nodes"}
    return names[measure].capitalize()


def _groups(points, law):
    """Rows of the figure by kind of model, in the order of _GROUPS."""
    models = {title: [] for title in _GROUPS}
    for model in _models_of(points):
        models[_group(model, law)].append(model)
    return [work_precision.Group(title, own) for title, own in models.items()]


def _models_of(points):
    return list(dict.fromkeys(point.model for point in points))


def _group(model, law):
    if model.precision == "double":
        return "Explicit steps,\ndouble precision"
    if model.precision:
        return "Explicit steps,\nsingle precision"
    if model.cell_type != "hexahedron":
        return "Tetrahedra and prisms"
    if model.family == "springs":
        return "Springs on hexahedra"
    if model.method == law:
        return "Finite elements of this\nlaw on hexahedra"
    return "Finite elements of other\nlaws on hexahedra"


def _closest(points, law, kind):
    """The row of another law: its own elements and the springs."""
    if kind == "motion":
        own = [model for model in _models_of(points) if model.precision == "double"]
        return work_precision.Group("Explicit steps,\ndouble precision", own)
    models = [model for model in _models_of(points) if model.cell_type == "hexahedron"]
    own = [model for model in models if model.family == "springs" or model.method == law]
    return work_precision.Group(f"Springs and {law}\non hexahedra", own)
