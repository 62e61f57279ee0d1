"""The page for everyone: contrast, colours that the colour-blind tell apart, both schemes, and what
axe-core, which npm brings, finds. SPRINGCHECK names the program."""

import itertools
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import browser  # noqa: E402
import method_style  # noqa: E402
import numpy as np  # noqa: E402
from browser import PageTest  # noqa: E402
from figures import curves  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402
from program import springcheck  # noqa: E402

AXE = "axe-core@4.10.2"

# What those see who lack a cone, on linear RGB: Machado, Oliveira and Fernandes 2009, severity 1.
SIGHTS = {
    "all cones": np.eye(3),
    "no long cones": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    "no middle cones": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]),
    "no short cones": np.array([[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]),
}
# CIE 1976 differences; 2.3 is just noticed side by side, lines a millimetre wide need several times as much.
LEAST_DIFFERENCE = 12


def linear(colour):
    values = np.array(to_rgb(colour))
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def luminance(colour):
    return float(linear(colour) @ [0.2126, 0.7152, 0.0722])


def contrast(one, other):
    """WCAG 2.1: (L1 + 0.05)/(L2 + 0.05)."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def lab(colour, sight):
    """CIE L*a*b* under D65."""
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    xyz = to_xyz @ np.clip(SIGHTS[sight] @ linear(colour), 0, 1) / [0.9505, 1, 1.089]
    x, y, z = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def difference(one, other):
    """The smallest over all sights."""
    return min(float(np.linalg.norm(lab(one, sight) - lab(other, sight))) for sight in SIGHTS)


class Colours(unittest.TestCase):
    def test_white_on_black_and_red_beside_green(self):
        self.assertAlmostEqual(contrast("white", "black"), 21, 9)
        self.assertGreater(difference("#0072B2", "#D55E00"), 60)  # of a palette for the colour-blind
        # As bright as each other: apart for all cones, hardly for two.
        self.assertLess(difference("#A06000", "#6A7400"), 12)

    def test_text_of_the_page_is_legible_in_both_schemes_and_in_print(self):
        style = (REPORTS / "springcheck_report" / "page.css").read_text(encoding="utf-8")
        schemes = [dict(re.findall(r"--([\w-]+): (#\w+)", block)) for block in re.findall(r":root \{([^}]*)\}", style)]
        light, dark, paper = schemes
        levels = ["good", *(f"level-{i}" for i in range(1, 5))]
        pairs = [("ink", ground) for ground in ("paper", "shade", "bad", "failed", *levels)]
        pairs += [(text, ground) for text in ("pale", "accent") for ground in ("paper", "shade", "good", "bad")]
        pairs += [("failure", "failed"), ("plate-ink", "plate")]
        for scheme in (light, light | dark, light | paper):
            for text, ground in pairs:
                self.assertGreater(contrast(scheme[text], scheme[ground]), 4.5, (text, ground, scheme))

    def test_methods_of_one_mark_are_told_apart_by_all(self):
        methods = json.loads(springcheck("list", "methods", "--json").stdout)["methods"]
        self.assertGreater(len(methods), 20)
        for one, other in itertools.combinations(methods.items(), 2):
            if one[1]["mark"] == other[1]["mark"]:
                apart = difference(one[1]["colour"], other[1]["colour"])
                self.assertGreater(apart, LEAST_DIFFERENCE, (one[0], other[0]))

    def test_rings_are_told_by_their_shapes(self):
        statuses = ["wrinkled", "indefinite", "inverted", "refused"]
        curve = curves.Curve("mss-cf", np.arange(5.0), np.ones(5), ["ok", *statuses])
        drawn = curves.draw([curves.Panel("", "", "", [curve])])
        rings = [line for line in drawn.axes[0].lines if len(line.get_xdata()) == 1]
        self.assertEqual([line.get_xdata()[0] for line in rings], [1, 2, 3, 4])
        self.assertEqual(len({line.get_marker() for line in rings}), 4)
        self.assertEqual({line.get_markeredgecolor() for line in rings}, {"#222222"})
        self.assertLessEqual(set(statuses), {text.get_text() for text in drawn.legends[0].texts})

    def test_kinds_of_failure_have_hatches_of_their_own(self):
        hatches = [hatch for _, hatch, _ in method_style.FAILURE_STYLES.values()]
        self.assertEqual(len(hatches), len(set(hatches)))
        for name, (ground, _, ink) in method_style.FAILURE_STYLES.items():
            self.assertGreater(contrast(ink, ground), 3.5, name)  # letters in bold, large on the page


def axe_source(folder):
    """The text of axe-core, None where npm cannot bring it."""
    if not shutil.which("npm"):
        return None
    packed = subprocess.run(["npm", "pack", AXE, "--silent"], cwd=folder, capture_output=True, text=True, check=False)
    if packed.returncode:
        return None
    archive = folder / packed.stdout.split()[-1]
    shutil.unpack_archive(archive, folder / "axe", "gztar")
    return (folder / "axe" / "package" / "axe.min.js").read_text(encoding="utf-8")


class Everyone(PageTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        file = cls.folder / "all.h5"
        for run in (
            "compression --deformation 5% --method mss-cf,mss-nfd,fem-hencky --nu 0.25",
            "compression --deformation 5% --method mss-cf,fem-hencky --nu 0.4",
            "compression --deformation 20% --method mss-nfd,mss-cf --nu 0",
            "torsion --cells 3,3,3 --method mss-cf,fem-stvk --nu 0.3",
            "shearing --cells 3,3,3 --method mss-cf --solver verlet --damping 0.1 --duration 0.2 --history 20",
        ):
            springcheck("run", *run.split(), "--out", file, check=False)  # some do not end well
        springcheck("report", file, "--out", cls.folder / "report")
        cls.browser = browser.chromium(webgl=False)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.set_script_timeout(120)

    def tearDown(self):
        self.set_scheme("light")
        self.check_console()

    def open(self, scheme="light", width=1300):
        self.set_size(width, 900)
        self.set_scheme(scheme)
        self.browser.get((self.folder / "report" / "index.html").as_uri())
        self.wait_for(lambda: not self.script("return document.querySelector('.explorer').hidden"), "no explorer")

    def set_scheme(self, scheme):
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})

    def unfold(self):
        self.script("for (const one of document.querySelectorAll('main > section')) one.style.contentVisibility = 'visible';"
                    "for (const one of document.querySelectorAll('details')) one.open = true")

    def test_axe_finds_nothing_serious(self):
        source = axe_source(self.folder)
        if source is None:
            self.skipTest("npm does not bring axe-core here")
        for scheme, width in (("light", 1300), ("dark", 1300), ("light", 390)):
            self.open(scheme, width)
            self.unfold()
            self.script(source)
            found = self.browser.execute_async_script(
                "const done = arguments[arguments.length - 1];"
                "axe.run(document, {resultTypes: ['violations']}).then(({violations, passes}) => done([passes.length,"
                " violations.map(({id, impact, nodes}) => [impact, id, nodes.length, nodes[0].html.slice(0, 200)])]))")
            self.assertGreater(found[0], 20)  # rules that were met
            self.assertEqual(found[1], [], (scheme, width))

    def test_the_dark_scheme_has_white_plates_below_pictures(self):
        for scheme, is_dark in (("light", False), ("dark", True)):
            self.open(scheme)
            ground, plate = (self.script("return getComputedStyle(document.querySelector(arguments[0])).backgroundColor", one)
                             for one in ("body", "figure img"))
            values = [int(value) / 255 for value in re.findall(r"\d+", ground)[:3]]
            self.assertEqual(luminance(values) < 0.05, is_dark)
            self.assertEqual(plate, "rgb(255, 255, 255)")

    def test_print_has_pictures_that_were_not_looked_at(self):
        self.open()
        unseen = "return [...document.querySelectorAll('main img')].filter((one) => !one.naturalWidth).length"
        self.assertGreater(self.script(unseen), 0)
        self.browser.execute_cdp_cmd("Page.printToPDF", {})
        self.assertEqual(self.script(unseen), 0)

    def test_pictures_say_what_they_show(self):
        self.open()
        texts = self.script("return [...document.querySelectorAll('main img')].map((one) => one.alt)")
        self.assertGreater(len(texts), 4)
        self.assertEqual(len(texts), len(set(texts)))
        self.assertGreater(min(len(text) for text in texts), 40)

    def test_no_words_are_cut_and_nothing_is_told_to_mice_alone(self):
        self.open()
        self.unfold()
        cut = self.script("return [...document.querySelectorAll('main td, main th')].filter((one) =>"
                          " one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent)")
        self.assertEqual(cut, [])
        self.assertEqual(self.every("main [title]"), [])

    def test_the_first_table_leads_to_its_largest_differences(self):
        self.open()
        link = self.one("#table-summary-small td a")
        self.assertRegex(link.get_attribute("aria-label"), r"up to .* %, in compression")
        key = link.get_attribute("href").rpartition("=")[2]
        self.script("arguments[0].click()", link)
        self.wait_for(lambda: self.one("#case").is_displayed(), "no case")
        self.assertIn(key, self.one("#case").text)


if __name__ == "__main__":
    unittest.main()
