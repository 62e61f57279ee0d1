"""Makes page, figures and 3D files of a result file.

    python3 reports/springcheck_report FILE.h5 DIR

`springcheck report` writes DIR/tables and DIR/data first and then runs this.
"""

import importlib.util
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


def missing_packages():
    """Debian packages that are needed and not there."""
    return [package for name, package in PACKAGES.items() if importlib.util.find_spec(name) is None]


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
    import interruption

    interruption.watch()
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))  # springcheck_results
    try:
        import report

        print(report.make(Path(arguments[0]), Path(arguments[1])))
    except (OSError, ValueError) as error:
        print(f"springcheck: {arguments[0]}: the report failed: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
