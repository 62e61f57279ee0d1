"""speed_test.py, of what the program measures now."""

import sys
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent)]
import speed_test  # noqa: E402
from program import springcheck  # noqa: E402


class MeasuredSpeed(speed_test.Speed):
    @classmethod
    def table(cls, name):
        return springcheck("table", name, "--format", "json", "--threads", speed_test.THREADS).stdout


if __name__ == "__main__":
    unittest.main()
