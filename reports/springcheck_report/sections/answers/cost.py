"""What an accuracy costs: springs against finite elements."""

from content import Answer, Figure
from figures import nearness
from markupsafe import Markup
from numbers_shown import significant
from sections.answers.words import SIZE, bold, case_number
from sections.chart import load_of
from sections.chart_figures import answer_of, fewest_threads, point_of

_LEVEL = 1  # percent off the converged solution


def cost_of_accuracy(study):
    """Of every chart whose scene's own law has a front of equilibria; the first one's is drawn."""
    fronts = [(chart, front) for chart in study.charts for front in chart["fronts"] if _is_main(chart, front)]
    if not fronts:
        return None
    parts = [
        Markup("{} ({}): {}").format(load_of(study, chart), chart["law"], _fastest(chart)) for chart, _ in fronts
    ]
    sentence = Markup(
        "Within {} % of the force or torque to which the law named converges, by models of any law: {}."
    ).format(_LEVEL, Markup("; ").join(parts))
    return Answer("What does an accuracy cost?", _figure(study, *fronts[0]), sentence, "chart")


def _is_main(chart, front):
    own = (front["kind"], front["law"], front["measure"]) == ("equilibrium", chart["law"], "force")
    return own and bool(front["points"])


def _figure(study, chart, front):
    law, threads, answer = chart["law"], fewest_threads(chart), answer_of(chart)[0]
    caption = (
        f"Error of the {answer} from what {law} converges to, against the time of an equilibrium: "
        f"{load_of(study, chart)}{', a quick chart' if chart['quick'] else ''}. No model is both faster and nearer "
        "than those on the Pareto front, which are named; they have a point for every mesh, the finer the slower, "
        f"grey are all others. Curves are of {'one thread' if threads == 1 else f'{threads} threads'}, the front of "
        f"all numbers of threads. The dotted line is at {_LEVEL} %. Measured on {chart['machine']}."
    )
    points = [_with_force_alone(p, law) for p in _usable(chart) if p["threads"] == threads]
    on_front = [_with_force_alone(chart["points"][place], law) for place in front["points"]]
    told = [100 * error for error in front["errors_told"]]
    arguments = (SIZE, "time of an equilibrium [s]", f"{answer}, error [%]", points, on_front, told, [_LEVEL])
    return Figure("answer_cost", caption, nearness.draw, arguments)


def _usable(chart):
    """Points of equilibria whose error is known."""
    return [
        p
        for p in chart["points"]
        if p["kind"] == "equilibrium"
        and p["status"] == "ok"
        and p["median"] is not None
        and p["errors"].get(chart["law"], {}).get("force")
    ]


def _with_force_alone(point, law):
    found = point_of(point, law)
    found.errors = {"force": found.errors["force"]}
    return found


def _fastest(chart):
    """"springs 18 ms (mss-affine-stvk, 6 cells across), finite elements 5.0 ms (...)"."""
    bar = max((truth["bars"]["force"] or 0 for truth in chart["truths"] if truth["law"] == chart["law"]), default=0)
    if 100 * bar > _LEVEL:  # no error is less than what the converged solution may be off itself
        return Markup("it is known to {} % only").format(significant(100 * bar, 2))
    near = [p for p in _usable(chart) if 100 * p["errors"][chart["law"]]["force"] <= _LEVEL]
    several = len({p["threads"] for p in chart["points"]}) > 1
    parts = []
    for family in ("springs", "finite elements"):
        own = [p for p in near if p["family"] == family]
        if not own:
            parts.append(Markup("no {} here").format(family))
            continue
        best = min(own, key=lambda p: p["median"])
        threads = f", {best['threads']:.0f} threads" if several else ""
        time = case_number(1000 * best["median"], best["case"])
        text = Markup("{} {} ms ({}, {} cells across{})")
        parts.append(text.format(family, time, bold(best["model"]), f"{best['across']:.0f}", threads))
    return Markup(", ").join(parts)
