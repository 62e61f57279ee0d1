"""The page's stability atlas and theory of stability, from what the real program writes, in
Chromium."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from html import unescape
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import browser  # noqa: E402
import numpy as np  # noqa: E402
import page_text  # noqa: E402
import springcheck_results  # noqa: E402
import study as study_module  # noqa: E402
from content import Figure  # noqa: E402
from method_style import FAILURE_STYLES  # noqa: E402
from program import springcheck  # noqa: E402
from sections.atlas import atlas  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402

MAPS = {
    "atlas_compression_deformation_nu": "compression --cells 3,3,3 --method mss-cf,mss-nfd,mss-stvk,mss-hencky,fem-stvk "
    "--over deformation=5%:50%:4 --over nu=0:0.4:3",
    "atlas_compression_dt-ratio_damping": "compression --cells 3,3,3 --method mss-cf,fem-explicit-1p "
    "--solver verlet --duration 1 --deformation 1% --over dt-ratio=0.8:1.2:3 --over damping=0:0.2:2",
    "atlas_shearing_nu_cell-type": "shearing --cells 2,2,2 --method mss-cf,mss-affine "
    "--over nu=0.1,0.25 --over cell-type=hexahedron,tetrahedron",
}
TABLES = ("regions", "four-springs", "lattice-stability")


def page_in(folder):
    return (folder / "index.html").read_text(encoding="utf-8")


def maps_in_letters(section):
    """{method: letters from top to bottom} of every map, in the page's order."""
    found = []
    for details in re.findall(r"<details>.*?</details>", section, re.DOTALL):
        own = {}
        for method, text in re.findall(r'<pre data-method="([^"]*)">(.*?)</pre>', details, re.DOTALL):
            lines = unescape(text).strip("\n").split("\n")[1:]
            own[method] = [line.strip().split("  ", 1)[1].split(" ") for line in lines]
        found.append(own)
    return found


class Page(unittest.TestCase):
    @classmethod
    def table(cls, name):
        """As `springcheck table NAME --format json` writes it; the longest once did so."""
        recorded = Path(__file__).parent / "recorded" / f"{name}.json"
        if recorded.exists():
            return recorded.read_text(encoding="utf-8")
        return springcheck("table", name, "--format", "json").stdout

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        (cls.folder / "tables").mkdir()
        for name in TABLES:
            (cls.folder / "tables" / f"{name}.json").write_text(cls.table(name), encoding="utf-8")
        cls.file = cls.folder / "atlas.h5"
        cls.printed = {}  # points and limits as the command prints them
        for name, options in MAPS.items():
            command = f"stability {options} --format json --out"
            cls.printed[name] = json.loads(springcheck(*command.split(), cls.file).stdout)
        springcheck("report", cls.file, "--out", cls.folder)
        cls.section = page_text.section(page_in(cls.folder), "atlas")
        cls.study = study_module.read(cls.file, cls.folder)
        cls.figures = {b.name: b for b in atlas(cls.study).blocks if isinstance(b, Figure)}

    def test_every_map_has_a_figure_and_a_caption(self):
        self.assertEqual(sorted(page_text.figures(self.section)), sorted(MAPS))
        for name, figure in self.figures.items():
            self.assertRegex(figure.caption, r"^How methods fail in \w+: .+\.")
            self.assertGreater((self.folder / "figures" / f"{name}.pdf").stat().st_size, 5_000)
        self.assertIn("stepped by verlet", self.figures["atlas_compression_dt-ratio_damping"].caption)
        self.assertIn("3×3×3 hexahedra", self.figures["atlas_compression_deformation_nu"].caption)

    def test_quick_maps_name_the_command_for_more(self):
        commands = [unescape(text) for text in re.findall(r"<code>(springcheck stability .*?)</code>", self.section)]
        self.assertEqual(
            commands[0],
            "springcheck stability compression --method mss-cf,mss-nfd,mss-stvk,mss-hencky,fem-stvk:q1-sri --cells 3,3,3 "
            f"--over deformation,nu --out {self.file.name}",
        )
        self.assertIn("of 4 × 3 fields", self.section)
        self.assertIn("adds one of 12 × 12.", self.section)

    def test_the_summary_counts_limits_of_paths_too(self):
        exported = springcheck("export", self.file, "--out", self.folder / "all.csv").stdout
        count = re.search(r"(\d+) cases", exported)[1]
        self.assertIn(f"<li>{count} cases: ", page_text.section(page_in(self.folder), "summary"))

    def test_letters_are_those_that_the_command_prints(self):
        """In the page's text, and of the fields in the figure."""
        letters = {kind["name"]: kind["letter"] for kind in self.study.atlas["failures"]}
        self.assertEqual(set(letters), set(FAILURE_STYLES))
        seen = set()
        for name, in_page in zip(self.figures, maps_in_letters(self.section)):
            points = self.printed[name][0]["rows"]
            *_, panels, _ = self.figures[name].arguments
            self.assertEqual(list(in_page), [panel.title for panel in panels])
            first, second = (c["key"] for c in self.printed[name][0]["columns"][1:3])
            for panel in panels:
                own = [row for row in points if row["method"] == panel.title]
                across = list(dict.fromkeys(row[second] for row in own))
                for i, value in enumerate(dict.fromkeys(row[first] for row in own)):
                    failures = [row["failure"] for row in own if row[first] == value]
                    self.assertEqual(len(failures), len(across))
                    self.assertEqual(panel.failures[i], failures)
                    self.assertEqual(in_page[panel.title][-1 - i], [letters[f] for f in failures])
                    seen |= set(failures)
        self.assertLessEqual({"none", "limit point", "blow-up", "not covered"}, seen)

    def test_limits_are_those_that_the_command_prints(self):
        """Exactly: in the table and on the curve."""
        for name in MAPS:
            limits = self.printed[name][1]["rows"]
            if name.endswith("cell-type"):
                self.assertEqual(len(limits), 4)
            rows = page_text.rows(self.section, f"limits-{name}")
            self.assertEqual(len(rows), len(limits))
            html = self.section[self.section.index(f'id="table-limits-{name}"') :]
            numbers = iter(page_text.numbers(html))
            for cells, limit in zip(rows, limits):
                self.assertEqual((cells[0], cells[4]), (limit["method"], limit["failure"]))
                for cell, bound in zip(cells[2:4], ("holds", "fails")):
                    if limit[bound] is None:
                        self.assertEqual(cell, "none")
                    else:
                        self.assertEqual(float(next(numbers)["value"]), limit[bound])
                if limit["wavelength"] is not None:
                    self.assertEqual(float(next(numbers)["value"]), limit["wavelength"])
            *_, panels, _ = self.figures[name].arguments
            for panel in panels:
                own = [row for row in limits if row["method"] == panel.title]
                drawn = [r["holds"] for r in own if None not in (r["holds"], r["fails"])]
                y = [] if panel.limit is None else panel.limit.y[np.isfinite(panel.limit.y)].tolist()
                self.assertEqual(y, drawn)

    def test_theory_is_the_tables(self):
        _, _, panels, _ = self.figures["atlas_compression_deformation_nu"].arguments
        theory = {panel.title: panel.theory for panel in panels}
        document = json.loads((self.folder / "tables" / "lattice-stability.json").read_text())
        rows = [r for r in document["rows"] if r["method"] == "mss-cf" and r["diagonal_ratio"] == 1]
        rows = [r for r in rows if r["compression_strain"] is not None]
        (lattice,) = theory["mss-cf"]
        self.assertEqual(lattice.x.tolist(), [r["nu"] for r in rows])
        np.testing.assert_allclose(lattice.y, [r["compression_strain"] for r in rows], rtol=1e-12)
        # A fixed A is that of all its rows.
        rows = [r for r in document["rows"] if r["method"] == "mss-hencky"]
        (lattice,) = theory["mss-hencky"]
        np.testing.assert_allclose(lattice.y, [r["compression_strain"] for r in rows], rtol=1e-12)
        # Springs have the bar of the law that they follow.
        bar, lattice = theory["mss-stvk"]
        np.testing.assert_allclose(bar.y, 42.2650, rtol=1e-5)  # 100 (1 - 1/sqrt(3))
        self.assertTrue((lattice.y < bar.y[0]).all())
        (bar,) = next(lines for method, lines in theory.items() if method.startswith("fem-stvk"))
        np.testing.assert_allclose(bar.y, 42.2650, rtol=1e-5)  # 100 (1 - 1/sqrt(3))
        caption = self.figures["atlas_compression_deformation_nu"].caption
        self.assertIn("table lattice-stability", caption)
        self.assertIn("1/√3", caption)
        _, _, panels, _ = self.figures["atlas_compression_dt-ratio_damping"].arguments
        for panel in panels:
            self.assertEqual(set(panel.theory[0].y), {1})

    def test_small_systems_have_figures_beside_their_tables(self):
        section = page_text.section(page_in(self.folder), "stability-theory")
        self.assertEqual(page_text.figures(section), ["regions_plane", "regions_damping", "four_springs"])
        for name in TABLES:
            document = json.loads((self.folder / "tables" / f"{name}.json").read_text())
            self.assertEqual(len(page_text.rows(section, name)), min(len(document["rows"]), 100))

    def test_the_browser_draws_it_without_complaint(self):
        driver = browser.chromium(webgl=False)
        self.addCleanup(driver.quit)
        driver.get((self.folder / "index.html").as_uri())
        images = driver.find_elements(By.CSS_SELECTOR, "#atlas figure img, #stability-theory figure img")
        self.assertEqual(len(images), len(MAPS) + 3)
        for image in images:
            browser.show(driver, image)
            self.assertGreater(browser.drawn_share(browser.pixels(image)), 0.05, image.get_attribute("alt"))
        width = driver.execute_script("return document.documentElement.scrollWidth")
        self.assertLessEqual(width, 1300)
        self.assertEqual(driver.get_log("browser"), [])


class Interrupted(unittest.TestCase):
    def test_what_is_there_is_drawn(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        file = folder / "half.h5"
        command = "stability compression --cells 6,6,6 --method mss-cf --jobs 1 --over deformation=2%:20%:6 "
        command = f"{command} --over nu=0:0.45:5 --out {file}"
        running = subprocess.Popen([os.environ["SPRINGCHECK"], *command.split()], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        while running.poll() is None:
            if file.exists() and len(springcheck_results.read(file).cases) >= 4:
                running.kill()
                running.wait()
            time.sleep(0.02)
        springcheck("report", file, "--out", folder)
        study = study_module.read(file, folder)
        (one,) = study.atlas["maps"]
        done = [point for point in one["points"] if point["failure"]]
        self.assertTrue(4 <= len(done) < 30, len(done))
        self.assertLessEqual({point["case"] for point in done}, set(study.cases.index))
        section = page_text.section(page_in(folder), "atlas")
        self.assertIn(f"Interrupted: {len(done)} of 30 simulations", section)
        (figure,) = (b for b in atlas(study).blocks if isinstance(b, Figure))
        (panel,) = figure.arguments[2]
        self.assertEqual(sum(f is not None for row in panel.failures for f in row), len(done))
        self.assertIsNone(panel.limit)
        self.assertNotIn('id="table-limits-', section)


if __name__ == "__main__":
    unittest.main()
