#!/usr/bin/env python3
"""Figures of a second program: what this project's tests compare the first with.

    figures.py write [TOPIC ...]   computes them and writes figures/TOPIC.csv
    figures.py check [TOPIC ...]   computes them and compares them with the files
    figures.py check --quick       those that take seconds

Exit status 1 where a figure is not that of its file.
"""

import csv
import sys
import time
from pathlib import Path

import hypoelastic
import laws
import stability
import statics
import theory

FOLDER = Path(__file__).parent / "figures"
FIGURE = "case", "quantity", "value"
ELEMENTS = "test", "amount", "law", "element", "nu", "quantity", "value"
# Columns, what computes the rows, how much a figure may move from one machine to another
# (relative: linear solvers round otherwise, searches stop a step apart), whether quick.
TOPICS = {
    "plates": (FIGURE, statics.plates, 1e-7, False),
    "elements": (ELEMENTS, statics.trilinear, 1e-7, False),
    "quadratic_and_nodal": (ELEMENTS, statics.quadratic_and_nodal, 1e-7, False),
    "bending": (FIGURE, statics.bending, 1e-7, False),
    "small_strain": (FIGURE, statics.small_strain, 1e-7, True),
    "strain_measures": (FIGURE, statics.strain_measures, 1e-7, False),
    "hypoelastic": (FIGURE, hypoelastic.steps, 1e-6, False),
    "bars": (FIGURE, laws.bars, 1e-8, True),
    "turns": (FIGURE, laws.turns, 1e-8, True),
    "off_hencky": (FIGURE, laws.off_hencky, 1e-8, True),
    "paths": (FIGURE, stability.paths, 1e-3, False),
    "waves": (FIGURE, stability.waves, 1e-5, False),
    "steps": (FIGURE, stability.steps, 1e-7, True),
    "motion": (FIGURE, stability.motion, 1e-6, False),
    "elastica": (FIGURE, theory.elastica, 1e-8, True),
    "volumes": (FIGURE, theory.volumes, 1e-6, True),
    "thesis_springs": (FIGURE, theory.thesis_springs, 1e-9, True),
    "branches": (("rate", "strain", "stress"), theory.branches_at_rate, 1e-7, True),
    "tissue_at_rate": (("organ", "rate", "strain", "linear", "hardening"),
                       theory.tissue_at_rate, 1e-9, True),
    "tissue_held": (("organ", "strain", "rate", "held", "stress"), theory.tissue_held, 1e-9,
                    True),
    "tissue_oscillating": (("organ", "frequency", "storage", "loss"),
                           theory.tissue_oscillating, 1e-7, True),
    "tissue_between_discs": (("organ", "radius", "rate", "strain", "torque"),
                             theory.tissue_between_discs, 1e-9, True),
}


def text(value):
    return f"{value:.12g}" if isinstance(value, float) else str(value)


def computed(topic):
    columns, rows, _, _ = TOPICS[topic]
    return [list(columns)] + [[text(value) for value in row] for row in rows()]


def is_near(found, stored, tolerance):
    if found == stored:
        return True
    try:
        return abs(float(found) - float(stored)) <= tolerance * abs(float(stored))
    except ValueError:
        return False


def differences(topic):
    with open(FOLDER / f"{topic}.csv", newline="") as file:
        stored = list(csv.reader(file))
    found = computed(topic)
    if len(found) != len(stored):
        yield f"{topic}.csv: {len(stored)} rows, computed {len(found)}"
    for line, (row, expected) in enumerate(zip(found, stored), 1):
        if not all(map(lambda a, b: is_near(a, b, TOPICS[topic][2]), row, expected)):
            yield f"{topic}.csv:{line}: {','.join(expected)}, computed {','.join(row)}"


def main(arguments):
    if not arguments or arguments[0] not in ("write", "check"):
        sys.exit(__doc__)
    quick = "--quick" in arguments
    topics = [a for a in arguments[1:] if a != "--quick"] or [
        name for name, (*_, is_quick) in TOPICS.items() if is_quick or not quick]
    wrong = []
    for topic in topics:
        if topic not in TOPICS:
            sys.exit(f"figures.py: expected one of {', '.join(TOPICS)}, got '{topic}'")
        begin = time.time()
        if arguments[0] == "check":
            wrong += differences(topic)
        else:
            found = computed(topic)
            with open(FOLDER / f"{topic}.csv", "w", newline="") as file:
                csv.writer(file, lineterminator="\n").writerows(found)
        print(f"{topic}: {time.time() - begin:.1f} s", flush=True)
    for line in wrong:
        print(line)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
