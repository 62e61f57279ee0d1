"""The real program, which SPRINGCHECK names, for tests."""

import os
import subprocess


def springcheck(*arguments, check=True):
    ended = subprocess.run(
        [os.environ["SPRINGCHECK"], *map(str, arguments)], capture_output=True, text=True, check=False
    )
    if check and ended.returncode != 0:
        raise AssertionError(f"springcheck {arguments}: {ended.stderr}")
    return ended
