"""The 3D views of bodies, in a real browser. SPRINGCHECK names the program."""

import contextlib
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import bodies  # noqa: E402
import browser  # noqa: E402
import h5py  # noqa: E402
import numpy as np  # noqa: E402
import springcheck_results  # noqa: E402
import study as study_module  # noqa: E402
from browser import PageTest  # noqa: E402
from program import springcheck  # noqa: E402
from strains import equivalent_strains  # noqa: E402
from surface import outside  # noqa: E402

SINGLE = 1e-6  # the page has numbers of four bytes


def turned(factors):
    """Cube of 2 x 2 x 2 hexahedra that is stretched along its axes, then turned, then moved."""
    places = np.stack(np.meshgrid(*[np.arange(3.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    corner = [0, 9, 12, 3, 1, 10, 13, 4]
    cells = np.array([[c + shift for c in corner] for shift in (0, 1, 3, 4, 9, 10, 12, 13)])
    turn, _ = np.linalg.qr(np.arange(9.0).reshape(3, 3) ** 2 + np.eye(3))
    mesh = {"nodes": places, "hexahedra": cells}
    return mesh, (places * factors) @ turn.T + [5, -2, 1] - places


class Strains(unittest.TestCase):
    def test_a_stretch_at_constant_volume_is_its_own_logarithm(self):
        for stretch in (0.5, 1.0, 1.3):
            mesh, moved = turned([stretch, stretch**-0.5, stretch**-0.5])
            np.testing.assert_allclose(equivalent_strains(mesh, moved), abs(np.log(stretch)), atol=1e-12)

    def test_size_alone_is_none(self):
        np.testing.assert_allclose(equivalent_strains(*turned([1.2, 1.2, 1.2])), 0, atol=1e-12)

    def test_shearing(self):
        """By gamma: stretches l and 1/l with l - 1/l = gamma, so ln l = asinh(gamma/2) and the
        strain 2/sqrt(3) of it."""
        mesh, _ = turned([1, 1, 1])
        moved = np.zeros_like(mesh["nodes"])
        moved[:, 0] = 0.4 * mesh["nodes"][:, 2]
        np.testing.assert_allclose(equivalent_strains(mesh, moved), 2 / 3**0.5 * np.arcsinh(0.2), atol=1e-12)

    def test_a_cell_without_volume_has_a_number(self):
        mesh, _ = turned([1, 1, 1])
        self.assertTrue(np.isfinite(equivalent_strains(mesh, -mesh["nodes"] * [0, 0, 1])).all())

    def test_all_types_in_the_order_of_fields(self):
        """One cell of each type, all stretched, each by another amount."""
        parts = {
            "tetrahedra": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
            "pyramids": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]],
            "prisms": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]],
        }
        nodes, mesh, moved = [], {}, []
        for i, (name, corners) in enumerate(parts.items()):
            mesh[name] = np.array([np.arange(len(corners)) + len(nodes)])
            nodes += corners
            stretch = 1 + i / 10
            moved += [np.array(corner) * (np.array([stretch, stretch**-0.5, stretch**-0.5]) - 1) for corner in corners]
        strains = equivalent_strains({"hexahedra": np.empty((0, 8), int), "nodes": np.array(nodes, float), **mesh},
                                     np.array(moved))
        np.testing.assert_allclose(strains, np.log([1, 1.1, 1.2]), atol=1e-12)


class Views(PageTest):
    MOTION = "--solver semi-implicit --damping 0.1 --duration 0.2 --history 10"

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "bodies.h5"
        common = "run torsion --deformation 30deg --cells 3,3,3 --nu 0.3"
        for rest in ("--method mss-cf,mss-nfd,fem-hencky", f"--method mss-cf,fem-explicit-stvk {cls.MOTION}"):
            springcheck(*common.split(), *rest.split(), "--out", cls.file)
        springcheck("run", "compression", "--method", "mss-cf", "--cells", "2,2,2", "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder / "report")
        cls.results = springcheck_results.read(cls.file)
        cls.browser = browser.chromium()
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.get((cls.folder / "report" / "index.html").as_uri())

    def tearDown(self):
        self.check_console()

    def setUp(self):
        self.viewer = self.drawn("torsion")
        self.choose(1, "mss-cf")
        self.choose(2, "fem-hencky:q1-sri")
        self.choose(3, "displacement")

    def drawn(self, test):
        viewer = self.one(f".viewer[data-test={test}]")
        browser.show(self.browser, viewer)
        self.wait_for(lambda: self.script("return arguments[0].querySelector('.plot').dataset.drawn", viewer), "no plot")
        return viewer

    def choose(self, place, text):
        """Of the place-th menu what is called so."""
        self.script(
            "const menu = arguments[0].querySelectorAll('select')[arguments[1]];"
            "const found = [...menu.options].find((one) => one.text === arguments[2] || one.value === arguments[2]);"
            "menu.value = found.value; menu.dispatchEvent(new Event('change'))", self.viewer, place, text)

    def traces(self, kind="mesh3d"):
        """What is drawn: scene, coordinates [cm] (3 x nodes) and values of each surface."""
        return self.script(
            "return arguments[0].querySelector('.plot').data.filter((one) => one.type === arguments[1]).map((one) =>"
            "({scene: one.scene, place: [one.x, one.y, one.z].map((all) => Array.from(all)), axis: one.coloraxis,"
            " values: one.intensity && Array.from(one.intensity)}))", self.viewer, kind)

    def slide(self, place):
        self.script("const slider = arguments[0].querySelector('input'); slider.value = arguments[1];"
                    "slider.dispatchEvent(new Event('input'))", self.viewer, place)

    def axis(self, name):
        return self.script("return arguments[0].querySelector('.plot').layout[arguments[1]]", self.viewer, name)

    def key(self, method, **others):
        cases = self.results.cases
        cases = cases[(cases.test == "torsion") & (cases.method == method)]
        for name, value in others.items():
            cases = cases[cases[name] == value]
        return cases.index[0]

    def on_surface(self, key):
        """The surface of a case's mesh, its displacements, the volume change and strain of its faces' cells."""
        mesh, fields = self.results.mesh(key), self.results.fields(key)
        surface = outside(mesh)
        strain = equivalent_strains(mesh, fields["displacement"])
        return surface, fields["displacement"][surface.nodes], fields["cell_volume_ratio"][surface.cells] - 1, strain[surface.cells]

    def of_triangles(self, surface, values):
        _, faces = surface.triangles()
        return values[faces]

    def test_colours_are_values_of_the_file_on_one_scale(self):
        springs, elements = self.key("mss-cf", solver="static"), self.key("fem-hencky")
        surface, ours, our_volume, our_strain = self.on_surface(springs)
        _, theirs, their_volume, their_strain = self.on_surface(elements)
        nodes = self.results.mesh(springs)["nodes"][surface.nodes]
        distance = 1e3 * np.linalg.norm(ours - theirs, axis=1)
        expected = {
            "displacement": [1e3 * np.linalg.norm(u, axis=1) for u in (ours, theirs)] + [distance],
            "deviation": [distance, 0 * distance, distance],
        }
        for name, (a, b) in {"strain": (our_strain, their_strain), "volume": (our_volume, their_volume)}.items():
            expected[name] = [100 * self.of_triangles(surface, values) for values in (a, b, a - b)]
        for name, values in expected.items():
            self.choose(3, name)
            first, second, third, below = self.traces()
            self.assertEqual([one["scene"] for one in (first, second, third, below)],
                             ["scene", "scene2", "scene3", "scene3"])
            self.assertEqual((first["axis"], second["axis"]), ("coloraxis", "coloraxis"))
            most = max(np.abs(one).max() for one in values[:2])
            for trace, own in zip((first, second, third), values):
                np.testing.assert_allclose(trace["values"], own, atol=5 * SINGLE * most, err_msg=name)
            self.assertAlmostEqual(self.axis("coloraxis")["cmax"], most, delta=SINGLE * most)
            for trace, moved in ((first, ours), (second, theirs), (third, ours)):
                np.testing.assert_allclose(np.transpose(trace["place"]), 100 * (nodes + moved), atol=1e-5)
            # The reference below hides what is behind it, and is hidden where it is inside.
            self.assertIsNone(below["values"])
            off = np.linalg.norm(np.transpose(below["place"]) - 100 * (nodes + theirs), axis=1)
            size = np.ptp(100 * (nodes + theirs), axis=0).max()
            np.testing.assert_allclose(off, 0.008 * size, rtol=1e-3)
            centre = 100 * (nodes + theirs).mean(axis=0)
            inside = np.linalg.norm(np.transpose(below["place"]) - centre, axis=1)
            outside_ = np.linalg.norm(100 * (nodes + theirs) - centre, axis=1)
            self.assertGreater((inside < outside_).mean(), 0.9)

    def test_the_slider_goes_through_the_history(self):
        way, slider = (self.viewer.find_element("css selector", one) for one in (".way", ".way input"))
        self.assertFalse(way.is_displayed())  # a body at rest has no way
        key = self.key("mss-cf", solver="semi-implicit")
        self.choose(1, "mss-cf, semi-implicit")
        self.assertTrue(way.is_displayed())
        frames, history = self.results.frames(key), self.results.history(key)
        self.assertEqual([frame.sample for frame in frames], list(range(len(history))))
        self.assertEqual(slider.get_attribute("max"), str(len(frames) - 1))
        self.assertEqual(slider.get_attribute("value"), slider.get_attribute("max"))
        surface, at_end, _, _ = self.on_surface(key)
        np.testing.assert_allclose(frames[-1].displacement[surface.nodes], at_end, rtol=0, atol=1e-15)
        nodes = self.results.mesh(key)["nodes"][surface.nodes]
        scales = []
        for place in (0, 4, len(frames) - 1):
            self.slide(place)
            moved = frames[place].displacement[surface.nodes]
            np.testing.assert_allclose(np.transpose(self.traces()[0]["place"]), 100 * (nodes + moved), atol=1e-5)
            said = way.find_element("css selector", "output").text
            sample = history.iloc[place]
            told = float(re.match(r"t = (\S+) s, ", said)[1])
            self.assertAlmostEqual(told, sample.time, delta=5e-3 * sample.time)
            self.assertTrue(said.endswith("fem-hencky:q1-sri as it ends"), said)
            scales.append((self.axis("coloraxis")["cmax"], self.axis("scene")["zaxis"]["range"]))
        self.assertEqual(scales[0], scales[1])
        self.assertEqual(scales[0], scales[2])
        self.choose(3, "volume")
        ratio = frames[-1].cell_volume_ratio[surface.cells] - 1
        np.testing.assert_allclose(self.traces()[0]["values"], 100 * self.of_triangles(surface, ratio), atol=1e-5)

    def test_a_method_and_a_reference_that_both_move(self):
        """At each moment of the one the other as it was then, and the end beside the end."""
        self.choose(2, "fem-explicit-stvk:q1-sri")
        self.choose(1, "mss-cf, semi-implicit")
        ours, theirs = (self.key(name, solver="semi-implicit") for name in ("mss-cf", "fem-explicit-stvk"))
        slider, output = (self.viewer.find_element("css selector", one) for one in (".way input", ".way output"))
        nodes = self.results.mesh(ours)["nodes"]
        surface = outside(self.results.mesh(ours))
        last = len(self.results.frames(ours)) - 1
        self.assertEqual(slider.get_attribute("max"), str(last))
        for place in (3, last):
            self.slide(place)
            first, second, *_ = self.traces()
            for key, trace in ((ours, first), (theirs, second)):
                moved = (nodes + self.results.frames(key)[place].displacement)[surface.nodes]
                np.testing.assert_allclose(np.transpose(trace["place"]), 100 * moved, atol=1e-5)
            self.assertNotIn("as it ends", output.text)
        self.choose(1, "mss-cf")  # the reference alone moves
        self.slide(3)
        self.assertTrue(output.text.endswith("mss-cf as it ends"), output.text)
        sample = self.results.history(theirs).iloc[3]
        self.assertIn(f"{100 * sample.load_fraction:.3g} % of the load", output.text)

    def test_a_body_alone_deviates_from_nothing(self):
        self.viewer = self.drawn("compression")
        self.choose(3, "volume")
        self.assertEqual(len(self.traces()), 1)
        options = self.viewer.find_elements("css selector", "select:nth-of-type(1)")[3].find_elements("tag name", "option")
        self.assertEqual([one.is_enabled() for one in options], [True, False, True, True])


class Room(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "bodies.h5"
        both = "--method mss-cf,fem-hencky"
        for rest in (both, f"{both} --deformation 2%", f"{both} --reference fem-hooke", f"--method mss-cf {Views.MOTION}",
                     f"--method mss-cf {Views.MOTION} --reference fem-hooke"):
            springcheck("run", "shearing", "--cells", "3,3,3", "--nu", "0.3", *rest.split(), "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder / "report")

    def data(self, file=None, **budgets):
        """What the page would get, with other budgets."""
        study = study_module.read(file or self.file, self.folder / "report")
        with contextlib.ExitStack() as stack:
            for name, value in budgets.items():
                stack.enter_context(mock.patch.object(bodies, name, value))
            return bodies.view_data(study, ["shearing"])

    def test_what_finds_no_room_is_counted(self):
        whole = self.data()
        shown = whole["header"]["tests"]["shearing"]
        self.assertEqual((whole["left_out"], whole["without_way"]), (0, 0))
        self.assertEqual(sum(len(body["frames"]) > 0 for group in shown for body in group["bodies"]), 1)
        none = self.data(_BUDGET=100)
        self.assertEqual((none["left_out"], none["data"]), (len(shown), b""))
        at_rest = self.data(_BUDGET_OF_FRAMES=100)
        self.assertEqual((at_rest["left_out"], at_rest["without_way"]), (0, 1))
        self.assertLess(len(at_rest["data"]), len(whole["data"]))

    def test_the_same_simulation_is_there_once_and_found_by_all_its_keys(self):
        cases = springcheck_results.read(self.file).cases
        shown = self.data()["header"]["tests"]["shearing"]
        keys = [key for group in shown for body in group["bodies"] for key in body["cases"]]
        self.assertEqual(sorted(keys), sorted(cases.index))
        names = [[body["name"] for body in group["bodies"]] for group in shown]
        self.assertTrue(all(len(own) == len(set(own)) for own in names), names)

    def test_bodies_without_fields_do_not_hide_those_with(self):
        """Of the same simulation, whichever the file has first; nor ends those with a way."""
        cases = springcheck_results.read(self.file).cases
        again = cases[cases.duplicated(["method", "deformation", "solver"], keep=False)]
        self.assertEqual(sorted(set(again.solver)), ["semi-implicit", "static"])
        for keep in ("first", "last"):
            other = self.folder / "other.h5"
            shutil.copy(self.file, other)
            with h5py.File(other, "r+") as file:
                for key in again.index[again.duplicated(["method", "deformation", "solver"], keep=keep)]:
                    if again.solver[key] == "static":
                        del file["fields"][key]
                    else:
                        del file["fields"][key]["frame_sample"]
            bodies_shown = [body for group in self.data(other)["header"]["tests"]["shearing"] for body in group["bodies"]]
            self.assertEqual(sorted(key for body in bodies_shown for key in body["cases"]), sorted(cases.index), keep)
            self.assertEqual(sum(len(body["frames"]) > 0 for body in bodies_shown), 1, keep)

    def test_moments_that_nobody_could_look_at_are_left_out(self):
        other = self.folder / "flown.h5"
        shutil.copy(self.file, other)
        with h5py.File(other, "r+") as file:
            for moved in (group for group in file["fields"].values() if "frame_sample" in group):
                nodes = len(moved["displacement"])
                moved["frame_displacement"][nodes] = np.nan
                moved["frame_displacement"][2 * nodes] = 1e200
        counts = [sum(len(body["frames"]) for group in self.data(one)["header"]["tests"]["shearing"] for body in group["bodies"])
                  for one in (self.file, other)]
        self.assertEqual(counts[0] - counts[1], 2)


if __name__ == "__main__":
    unittest.main()
