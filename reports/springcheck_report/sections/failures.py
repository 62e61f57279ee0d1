"""Where methods fail."""

import measures
import numpy as np
from case_words import case_text, is_variant
from content import Figure, Section, bullets, paragraph, table
from figures import statuses
from markupsafe import Markup
from numbers_shown import significant

_MOST_ROWS = 300


def failing_sentences(study):
    """What goes wrong with each spring method, in words; one sentence if nothing does. Told are cases at rest
    with the usual settings, others are counted; where a method has none of these that it covers, all are told."""
    cases = study.distinct[study.distinct.kind != "finite elements"]
    items = []
    for method, with_any in cases.groupby("method"):
        is_usual = ~with_any["name"].map(is_variant)
        covers_any = (is_usual & (with_any.status != "refused")).any()
        of_method = with_any[is_usual] if covers_any else with_any
        bad = of_method[~of_method.status.isin(["ok", "refused"])]
        covered = of_method[of_method.status != "refused"]
        parts = []
        for status, of_status in bad.groupby("status", sort=False):
            first = of_status.loc[of_status.strain.fillna(np.inf).idxmin()]
            tests = ", ".join(dict.fromkeys(of_status.test))
            parts.append(
                f"{measures.said(status)} in {len(of_status)} of {len(covered)} cases ({tests}; "
                f"mildest: {case_text(first)})"
            )
        others = with_any.drop(of_method.index)
        others = others[others.status != "refused"]
        if failed := int((others.status != "ok").sum()):
            parts.append(f"with other settings or in motion fails in {failed} of {len(others)} cases")
        if parts:
            items.append(Markup("<b>{}</b> {}.").format(method, "; ".join(parts)))
    if not items:
        return ["In none of these cases." if (cases.status != "refused").any() else "None was run."]
    return items


def failures(study):
    """A map by method and test, every case that is not ok with its reason, and what else is
    to be known of others."""
    bad = study.distinct[study.distinct.status != "ok"]
    section = Section("failures", "Where methods fail")
    if not bad.empty:
        _show_failed(section, study, bad)
    section.blocks += _remarks(study)
    return section if section.blocks else None


def _show_failed(section, study, bad):
    section.blocks.append(
        paragraph(
            "A failed simulation is a result. Wrinkled, inverted and indefinite states are "
            "equilibria, but not those of a smooth elastic body: their figures say that the method "
            "failed, and little more. Where there is no equilibrium, the table says how much of "
            "the load was carried."
        )
    )
    cases = study.distinct
    tests = list(dict.fromkeys(cases.test))[:8]
    methods = sorted(set(cases.method))[:24]
    shares = [
        [
            cases[(cases.method == method) & (cases.test == test)]
            .status.value_counts()
            .to_dict()
            for test in tests
        ]
        for method in methods
    ]
    caption = (
        "How cases ended, by method and test: the bars are shares of statuses, the numbers count "
        "usable ones among all."
    )
    section.blocks.append(Figure("statuses", caption, statuses.draw, (methods, tests, shares)))
    section.blocks += _maps(study)
    section.blocks.append(_table(bad))


def _remarks(study):
    """Cases that ended well and of which something is to be known nevertheless."""
    cases = study.distinct
    is_remarkable = (cases["flags"].fillna("") != "") | (cases["reason"].fillna("") != "")
    cases = cases[(cases.status == "ok") & is_remarkable]
    if cases.empty:
        return []
    rows = [
        [case["name"], case_text(case), case["flags"] or "", case.reason or "", (key[:8], "key")]
        for key, case in cases.sort_values(["test", "method", "nu", "deformation"]).iterrows()
    ]
    text = (
        "These cases reached an equilibrium, with a remark. Flagged as extrapolated: strains or their "
        "rates leave the range to which the law of a tissue was fitted."
    )
    headings = ["method", "case", "flag", "remark", "case's key"]
    return [paragraph(text), table(headings, rows, name="remarks", limit=_MOST_ROWS)]


def _maps(study):
    """Status by Poisson's ratio and deformation, for each method and test whose cases fill
    a grid of the two; maps of `springcheck stability` have a section of their own."""
    figures = []
    in_atlas = {point["case"] for one in study.atlas.get("maps", []) for point in one["points"]}
    others = study.cases[~study.cases.index.isin(in_atlas)]
    for (test, method), cases in others.groupby(["test", "method"]):
        if (cases.status == "ok").all() or (cases.kind == "finite elements").all():
            continue
        most = cases["cell-type"].mode()  # none of users' meshes
        cases = cases[cases["cell-type"] == most[0]] if len(most) else cases
        nus, loads = sorted(set(cases.nu)), sorted(set(cases.deformation.dropna()))
        if len(nus) < 3 or len(loads) < 3:
            continue
        filled = cases.dropna(subset="deformation").drop_duplicates(["nu", "deformation"])
        if len(filled) < 0.7 * len(nus) * len(loads):
            continue
        names = [cases[cases.deformation == load].iloc[0].load for load in loads]
        shares = [
            [
                cases[(cases.nu == nu) & (cases.deformation == load)].status.value_counts().to_dict()
                for load in loads
            ]
            for nu in nus
        ]
        caption = f"{method} in {test}: how cases ended, by Poisson's ratio and deformation."
        rows = [f"nu {nu:g}" for nu in nus]
        figures.append(
            Figure(f"stability_{method}_{test}", caption, statuses.draw, (rows, names, shares))
        )
    return figures[:8]


def _table(bad):
    bad = bad.sort_values(["test", "method", "nu", "deformation"])
    refused = bad[bad.status == "refused"]
    rows = []
    for key, case in bad[bad.status != "refused"].iterrows():
        reached = ""
        if case.load_fraction < 1:
            reached = f"{significant(100 * case.load_fraction, 3)} % of the load"
        reason = case.reason or ""
        rows.append(
            [case["name"], case_text(case), (case.status.replace("_", " "), "failed"), reached]
            + [reason, (key[:8], "key")]
        )
    blocks = Markup("")
    if rows:
        headings = ["method", "case", "status", "reached", "why", "case's key"]
        blocks += table(headings, rows, name="failures", limit=_MOST_ROWS)
    if len(refused):
        counts = refused.groupby(["method", "reason"]).size()
        items = [f"{method}: {count} refused ({reason})" for (method, reason), count in counts.items()]
        short = items[:12] + ([f"and {len(items) - 12} further reasons"] if len(items) > 12 else [])
        blocks += bullets(short)
    return blocks
