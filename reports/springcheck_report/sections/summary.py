"""The first screen: what this is, answers in pictures, how well springs agree, where they fail."""

from operator import itemgetter

import measures
import methods
import pandas as pd
from case_words import case_text, is_variant
from content import Section, bullets, columns, measured_number, paragraph, table
from markupsafe import Markup
from numbers_shown import formatted, significant
from sections.answers import answers
from sections.failures import failing_sentences
from sections.thesis_tables import relative_size

# From half a percent on, below which volumes do not change; 5 % and 0.05 rad are small.
_LEAST, _SMALL = 0.005, 0.051
_MOST_NAMES = 4  # of methods in the first sentence


def summary(study):
    """Of a file without cases but of limits of paths what it is, and no more."""
    section = Section("summary", "Summary")
    if study.cases.empty:
        section.blocks += [_what(study.limits), _made_by(study)]
        return section
    section.blocks += [_what(study.cases), _made_by(study), *answers(study), _agreement(study), _findings(study)]
    return section


_SOLVERS = {"springs": "mass-spring systems", "finite elements": "finite elements", "measured": "other programs"}


def _what(cases):
    solvers = []
    for kind, words in _SOLVERS.items():
        names = sorted(set(cases[cases.kind == kind].method))
        if names:
            solvers.append(f"{words} ({', '.join(names)})" if len(names) <= _MOST_NAMES else f"{len(names)} {words}")
    return paragraph(
        "Do springs deform like the elastic body that they stand for? A mass-spring system replaces "
        "the body by springs (methods whose names begin with mss); finite elements solve the equations of "
        "elasticity (fem, with the law, and the element behind the colon). Here are {} in {}: how far they are apart "
        "in the force on the plate that holds the deformed body, in its volume and in the place of its points.",
        " and ".join(solvers),
        ", ".join(sorted(set(cases.test), key=_place_of_test)),
    )


def _place_of_test(test):
    answered = list(measures.answers())
    return answered.index(test) if test in answered else len(answered), test


def _made_by(study):
    """The newest session that computed cases, and how many there are."""
    count = len(study.cases) + len(study.limits)
    simulations = len(study.distinct) + len(study.limits)
    text = f"{count} {'case' if count == 1 else 'cases'}"
    if simulations < count:
        text += f" of {simulations} simulations"
    sessions = study.results.provenance
    if sessions.empty:
        return paragraph('<span class="note">{}: {}.</span>', study.results.path.name, text)
    last = sessions.sort_values("date").iloc[-1]
    return paragraph(
        '<span class="note">Made by springcheck {} (commit {}) from {}: {}, the newest of {} on {}. '
        '<a href="#provenance">Where they come from</a>.</span>',
        last.get("springcheck", "of an unknown version"),
        last.get("commit", "unknown"),
        study.results.path.name,
        text,
        str(last["date"])[:10],
        last.get("cpu", "an unknown machine"),
    )


def _agreement(study):
    """Two tables by method and test, for small and large deformation."""
    cases = study.distinct[study.distinct.kind != "finite elements"]
    cases = cases[~cases["name"].map(is_variant) & (cases.status != "refused")]
    if cases.empty:
        return paragraph(
            "No springs were computed here that finite elements could be compared with."
        )
    parts = []
    for name, title, chosen in (
        ("small", "Small deformation, ½ to 5 %", cases.strain.between(_LEAST, _SMALL)),
        ("large", "Large deformation, beyond 5 %", cases.strain > _SMALL),
    ):
        if chosen.any():
            parts += [Markup("<h3>{}</h3>").format(title), _matrix(study, cases[chosen], name)]
    if not parts:
        return paragraph("All deformations here are below ½ %: see the tests.")
    how_to_read = paragraph(
        "For each test: how far the force (torque, tip deflection) is from that of finite elements on the same "
        "mesh and problem, the median of usable cases; below it the largest, which leads to its case, and how many of "
        "the cases are usable, which are equilibria, stable and without wrinkles. It is red where most are not. <b>Not judged</b>: no "
        "finite elements solved the same problem on hexahedra without locking. <b>Volume</b>: the largest "
        "difference, in points, which are hundredths of the body's volume. <b>Points</b>: the median deviation of "
        "the body's points from each case's own reference, over the largest displacement."
    )
    note = Markup(
        '<p class="note">Methods with their usual settings. Judges are finite elements on hexahedra that do not '
        "lock{}: {}, of the law that springs follow where they follow one, else the first of these that was "
        "computed. At large deformation the law of other springs is none of finite elements, which is part of the "
        "difference.</p>"
    )
    unjudged = cases.counterpart.notna() & ~cases.is_judged
    more = (
        f" (none for {unjudged.sum()} cases on other cells, where linear finite elements are too "
        "stiff to judge by: see the tests)"
        if unjudged.any()
        else ""
    )
    judges = study.cases.loc[sorted(set(cases[cases.is_judged].counterpart)), "name"]
    named = ", ".join(sorted(set(judges), key=_by_usefulness))
    heading = Markup("<h3>How near springs are, test by test</h3>")
    return Markup("").join([heading, how_to_read, *parts, *([note.format(more, named)] if named else [])])


def _matrix(study, cases, name):
    tests = [test for test in measures.answers() if (cases.test == test).any()]
    rows = []
    for method in sorted(set(cases["name"]), key=_by_usefulness):
        of_method = cases[cases["name"] == method]
        words = study.theory.get("methods", {}).get(method, "")
        row = [Markup('<b>{}</b> <span class="note">{}</span>').format(method, words)]
        row += [_force(study, of_method[of_method.test == test]) for test in tests]
        usable = of_method[(of_method.status == "ok")]
        volumes = 100 * usable[usable.is_judged].volume_difference.abs().dropna()
        deviations = 100 * usable.deviation_l2_relative.dropna()
        row.append(f"{_short(volumes.max())} points" if len(volumes) else _NOT_JUDGED)
        row.append(f"{_short(deviations.median())} %" if len(deviations) else _NOT_JUDGED)
        rows.append(row)
    return table(["springs", *tests, "volume", "points"], rows, name=f"summary-{name}", classes="summary")


_NOT_JUDGED = ("not judged", "none")


def _by_usefulness(name):
    return methods.place(name.split(":")[0]), name


def _force(study, cases):
    """"1.6 %", below it "up to 4 %" and "12 of 14"; failed where most cases are not usable."""
    if cases.empty:
        return ("not run", "none")
    usable = cases[cases.status == "ok"]
    count = f"{len(usable)} of {len(cases)}"
    sizes = 100 * usable[usable.is_judged].answer_difference.abs().dropna()
    style = "failed" if 2 * len(usable) < len(cases) else ""
    if sizes.empty:
        return Markup('{} <span class="note">{}</span>').format("not judged" if len(usable) else "fails", count), style
    worst = sizes.idxmax()
    largest = Markup('<a href="#case={}" aria-label="up to {} %, in {}">up to {} %</a>').format(
        worst, _short(sizes.max()), case_text(study.cases.loc[worst]), _short(sizes.max())
    )
    return (
        Markup('{} % <span class="note">{}</span> <span class="note">{}</span>').format(
            _short(sizes.median()), largest if len(sizes) > 1 else "", count
        ),
        style,
    )


def _short(value):
    return "0" if value < 0.005 else significant(value, 2)


def _findings(study):
    agreement = [*against_print(study), *_worst_cell(study), *_counts(study)]
    return columns(
        [Markup("<h3>What agrees, what does not</h3>"), bullets(agreement)],
        [Markup("<h3>Where springs fail</h3>"), bullets(failing_sentences(study))],
    )


def against_print(study):
    """How many of the thesis's figures are met, by method, and the furthest of each unit. One that has no
    figure of ours, since nothing usable came out, is not met."""
    items = []
    for method, law in (
        (methods.of_thesis(), ""),
        (f"{methods.reference_law()}:q1-sri", " (of three laws the nearest to the thesis's FEM column)"),
    ):
        judged, without = [], 0
        for document in study.tables.values():
            if "quantity" not in document or document["table"] in ("deviation", "bending"):
                continue
            for row in document["rows"]:
                if row["method"] != method or not row["printed_text"]:
                    continue
                if row["difference"] is None:
                    without += 1
                else:
                    judged.append((relative_size(document, row), document, row))
        if not judged and not without:
            continue
        near = sum(size <= 0.1 for size, _, _ in judged)
        by_unit = {}
        for entry in judged:
            by_unit.setdefault(entry[1]["unit"], []).append(entry)
        worst = [_printed_and_ours(*max(entries, key=itemgetter(0))[1:]) for entries in by_unit.values()]
        items.append(
            Markup(
                "<b>{}</b>{} meets {} of {} figures that Golec's thesis of 2018 prints, to 0.2 points "
                "of volume change or 1 % of force and torque{}.{} Deviations and drops of a tip are not "
                "counted here."
            ).format(
                method,
                law,
                near,
                len(judged) + without,
                f" (of {without} nothing usable came out)" if without else "",
                f" Furthest: {'; '.join(worst)}." if worst else "",
            )
        )
    return items


def _printed_and_ours(document, row):
    """"table 5.1, nu 0, deformation 5 %: printed 5.61, ours 4.841, in %"."""
    labels = ", ".join(f"{label} {row[label]}" for label in document["labels"] if label != "method")
    ours = formatted(row["ours"], document["format"])
    return f"table {document['table']}, {labels}: printed {row['printed_text']}, ours {ours}, in {document['unit']}"


def _worst_cell(study):
    """The cell whose volume is furthest from the rest state, of usable springs."""
    cases = study.cases[(study.cases.kind == "springs") & (study.cases.status == "ok")]
    if cases.cell_volume_ratio_min.isna().all():
        return []
    key = cases.cell_volume_ratio_min.idxmin()
    case = cases.loc[key]
    number = measured_number(
        study, key, "cell_volume_ratio_min", significant(case.cell_volume_ratio_min, 3)
    )
    text = Markup("Worst cell of a usable state: pressed to {} of its volume ({}, {}").format(
        number, case["name"], case_text(case)
    )
    if case.counterpart is not None:
        theirs = study.cases.loc[case.counterpart]
        ratio = significant(theirs.cell_volume_ratio_min, 3)
        text += Markup("; smallest of {} on the same mesh: {}").format(
            theirs["name"],
            measured_number(study, case.counterpart, "cell_volume_ratio_min", ratio),
        )
    return [text + ")."]


def _counts(study):
    counts = pd.concat([table.status for table in (study.cases, study.limits) if not table.empty]).value_counts()
    parts = [f"{count} {status.replace('_', ' ')}" for status, count in counts.items()]
    text = Markup("{} {}: {}").format(
        counts.sum(), "case" if counts.sum() == 1 else "cases", ", ".join(parts)
    )
    if not set(counts.index) <= {"ok", "refused"}:
        text += Markup('; <a href="#failures">where and why</a>')
    return [text + "."]
