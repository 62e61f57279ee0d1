"""The 3D views of bodies, in a real browser. SPRINGCHECK names the program."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import browser  # noqa: E402
import numpy as np  # noqa: E402
import springcheck_results  # noqa: E402
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
        for rest in ("--method mss-cf,mss-nfd,fem-hencky", f"--method mss-cf {cls.MOTION}"):
            springcheck(*common.split(), *rest.split(), "--out", cls.file)
        springcheck("run", "compression", "--method", "mss-cf", "--cells", "2,2,2", "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder / "report")
        cls.results = springcheck_results.read(cls.file)
        cls.browser = browser.chromium()
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.get((cls.folder / "report" / "index.html").as_uri())

    def tearDown(self):
        errors = [entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(errors, [])

    def setUp(self):
        self.viewer = self.drawn("torsion")
        self.choose(1, "mss-cf")
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
            self.script("arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input'))", slider, place)
            moved = frames[place].displacement[surface.nodes]
            np.testing.assert_allclose(np.transpose(self.traces()[0]["place"]), 100 * (nodes + moved), atol=1e-5)
            said = way.find_element("css selector", "output").text
            sample = history.iloc[place]
            self.assertIn(f"t = {sample.time:.3g} s"[:7], said)
            self.assertIn("fem-hencky:q1-sri as it ends", said)
            scales.append((self.axis("coloraxis")["cmax"], self.axis("scene")["zaxis"]["range"]))
        self.assertEqual(scales[0], scales[1])
        self.assertEqual(scales[0], scales[2])
        self.choose(3, "volume")
        ratio = frames[-1].cell_volume_ratio[surface.cells] - 1
        np.testing.assert_allclose(self.traces()[0]["values"], 100 * self.of_triangles(surface, ratio), atol=1e-5)

    def test_a_body_alone_deviates_from_nothing(self):
        self.viewer = self.drawn("compression")
        self.choose(3, "volume")
        self.assertEqual(len(self.traces()), 1)
        options = self.viewer.find_elements("css selector", "select:nth-of-type(1)")[3].find_elements("tag name", "option")
        self.assertEqual([one.is_enabled() for one in options], [True, False, True, True])


if __name__ == "__main__":
    unittest.main()
