"""Makes page, figures and 3D files of a result file.

    python3 reports/springcheck_report FILE.h5 DIR

`springcheck report` writes DIR/tables and DIR/data first and then runs this.
"""

import importlib.util
import signal
import sys
from pathlib import Path

# Import name and Debian package of what the report is made with.
PACKAGES = {
    "h5py": "python3-h5py",
    "numpy": "python3-numpy",
    "pandas": "python3-pandas",
    "matplotlib": "python3-matplotlib",
    "plotly": "python3-plotly",
    "jinja2": "python3-jinja2",
    "meshio": "python3-meshio",
}

_ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def missing_packages():
    """Debian packages that are needed and not there."""
    return [package for name, package in PACKAGES.items() if importlib.util.find_spec(name) is None]


def _interrupt(number, frame):
    """It cleans up undisturbed, then ends: a terminal and the program may both ask for it."""
    for other in _ENDING:
        signal.signal(other, signal.SIG_IGN)
    raise KeyboardInterrupt


def main(arguments):
    if len(arguments) != 2:
        print("usage: python3 springcheck_report FILE.h5 DIR", file=sys.stderr)
        return 2
    missing = missing_packages()
    if missing:
        names = " ".join(missing)
        print(
            f"springcheck: the report needs {names}; install with: sudo apt-get install {names}",
            file=sys.stderr,
        )
        return 1
    for number in _ENDING:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _interrupt)
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))  # springcheck_results
    try:
        import report

        print(report.make(Path(arguments[0]), Path(arguments[1])))
    except (OSError, ValueError) as error:
        print(f"springcheck: {arguments[0]}: the report failed: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("springcheck: interrupted; an earlier report is as it was", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
