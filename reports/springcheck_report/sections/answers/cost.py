"""What an accuracy costs: springs against finite elements."""

from content import Answer, Figure
from figures import nearness
from markupsafe import Markup
from numbers_shown import significant
from sections.answers.words import SIZE, bold, case_number
from sections.chart import answer_of, fewest_threads, load_of, point_of

_LEVELS = [5, 1]  # percent off the converged solution


def cost_of_accuracy(study):
    """Of the first chart whose scene's own law has a front of equilibria."""
    for chart in study.charts:
        for front in chart["fronts"]:
            if (front["kind"], front["law"], front["measure"]) == ("equilibrium", chart["law"], "force"):
                found = _answer(study, chart, front)
                if found:
                    return found
    return None


def _answer(study, chart, front):
    law, threads = chart["law"], fewest_threads(chart)
    rows = [p for p in chart["points"] if _is_usable(p, law)]
    fastest = [words for words in (_fastest(rows, law, level) for level in _LEVELS) if words]
    on_front = [chart["points"][place] for place in front["points"]]
    if not fastest or not on_front:
        return None
    answer = answer_of(chart)[0]
    caption = (
        f"Error of the {answer} from what {law} converges to, against the time of an equilibrium: "
        f"{load_of(study, chart)}. Methods on the Pareto front are named; each has a point for every mesh, grey are "
        f"all others. {'One thread' if threads == 1 else f'{threads} threads'}; measured on {chart['machine']}."
    )
    sentence = Markup("{}: within {}.").format(_capital(load_of(study, chart)), Markup("; within ").join(fastest))
    told = [100 * error for error in front["errors_told"]]
    points = [_with_force_alone(p, law) for p in rows if p["threads"] == threads]
    arguments = (SIZE, "time of an equilibrium [s]", f"{answer}, error [%]", points)
    arguments += ([_with_force_alone(p, law) for p in on_front], told, _LEVELS)
    figure = Figure("answer_cost", caption, nearness.draw, arguments)
    return Answer("What does an accuracy cost?", figure, sentence, "chart")


def _is_usable(point, law):
    known = point["errors"].get(law, {}).get("force")
    return point["kind"] == "equilibrium" and point["status"] == "ok" and point["median"] is not None and bool(known)


def _with_force_alone(point, law):
    found = point_of(point, law)
    found.errors = {"force": found.errors["force"]}
    return found


def _fastest(rows, law, level):
    """"5 %, springs take 3.1 ms (mss-stvk, 4 cells across), ..."; nothing where none comes so near."""
    near = [p for p in rows if 100 * p["errors"][law]["force"] <= level]
    parts = []
    for family in ("springs", "finite elements"):
        own = [p for p in near if p["family"] == family]
        if not own:
            parts.append(Markup("no {} here").format(family))
            continue
        best = min(own, key=lambda p: p["median"])
        parts.append(
            Markup("{} take {} ms ({} on {} cells across)").format(
                family, case_number(1000 * best["median"], best["case"]), bold(best["model"]), f"{best['across']:.0f}"
            )
        )
    return Markup("{} %, ").format(significant(level, 1)) + Markup(", ").join(parts) if near else None


def _capital(text):
    return text[:1].upper() + text[1:]
