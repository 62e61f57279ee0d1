"""The real program, which SPRINGCHECK names, for tests, and what it makes."""

import os
import re
import subprocess
import unittest

# Of tests that are left out unless all of a file is asked for.
slow = unittest.skipUnless("SPRINGCHECK_SLOW_TESTS" in os.environ, "slow")


def springcheck(*arguments, check=True):
    ended = subprocess.run(
        [os.environ["SPRINGCHECK"], *map(str, arguments)], capture_output=True, text=True, check=False
    )
    if check and ended.returncode != 0:
        raise AssertionError(f"springcheck {arguments}: {ended.stderr}")
    return ended


def same_figures(made, case):
    """Of each row of a table of cases, whether it has the other case's figures, to the bit: all but times
    and what depends on a reference."""
    columns = [name for name in made.columns if name in case.index and made[name].dtype.kind == "f"]
    columns = [name for name in columns if not re.search("wall_s|deviation|reference|provenance|difference", name)]
    figures = case[columns].astype(float)
    return ((made[columns] == figures) | (made[columns].isna() & figures.isna())).all(axis=1)


def same_files(test, one, other):
    """Checks that the other folder has every file of the one, to the byte: but for the times
    that are in the result file, nothing depends on when a report is made, and only the way
    from 3d/cases.xdmf to the result file on where."""
    for path in sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file()):
        if path.name == "cases.xdmf" and one.parent != other.parent:
            continue
        test.assertEqual((one / path).read_bytes(), (other / path).read_bytes(), path)
