"""Parts of the report that need no result file."""

import json
import sys
import types
import unittest
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(Path(__file__).parent), str(REPORTS), str(REPORTS / "springcheck_report")]
import measures  # noqa: E402
import method_style  # noqa: E402
import methods  # noqa: E402
import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402
import sections  # noqa: E402
from bodies import far_apart  # noqa: E402
from case_words import method_name  # noqa: E402
from content import Section, file_name, paragraph, table, table_links  # noqa: E402
from figures import error_parts  # noqa: E402
from figures.cost import pareto_front  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402
from numbers_shown import data, formatted, significant, with_bar  # noqa: E402
from program import springcheck  # noqa: E402
from sections import laws  # noqa: E402
from sections.answers.words import gone_through  # noqa: E402
from surface import edges_in_plane, outside  # noqa: E402


class Numbers(unittest.TestCase):
    def test_significant_digits(self):
        for value, digits, text in [
            (2.86131, 4, "2.861"),
            (9.9996, 4, "10.00"),
            (-0.04725, 2, "-0.047"),
            (58368.2, 4, "58370"),
            (0, 4, "0"),
            (1.2345e-7, 3, "1.23e-07"),
            (1.5e9, 2, "1.5e+09"),
        ]:
            self.assertEqual(significant(value, digits), text)

    def test_values_stop_where_their_bars_begin(self):
        self.assertEqual(with_bar(3.09812, 0.0103), ("3.098", "0.010"))
        self.assertEqual(with_bar(1266.21, 3.2), ("1266", "3"))
        self.assertEqual(with_bar(58368, 260), ("58400", "300"))
        self.assertEqual(with_bar(-0.71372, 0.06), ("-0.71", "0.06"))
        self.assertEqual(with_bar(1.5, 0), ("1.500", "0"))

    def test_no_minus_before_zero(self):
        self.assertEqual(formatted(-1e-9, "{:+.2f}"), "+0.00")
        self.assertEqual(formatted(-0.126, "{:+.2f}"), "-0.13")

    def test_numbers_say_where_they_come_from(self):
        html = data(3.1671, "3.167", "a<b", "volume_error")
        self.assertIn('value="3.1671"', html)
        self.assertIn('data-case="a&lt;b"', html)
        self.assertIn('data-measure="volume_error"', html)
        self.assertTrue(html.endswith(">3.167</data>"))


def split_row(method, reference_law, nu, law_percent, bar, cells="5x5x5"):
    return {
        "scene": "compression",
        "load": "20 %",
        "cells": cells,
        "nu": nu,
        "method": method,
        "reference_law": reference_law,
        "measure": "plate_force",
        "law_percent": law_percent,
        "law_percent_bar": bar,
    }


class FurtherTables(unittest.TestCase):
    def test_a_table_that_no_section_draws_stands_in_its_own_once(self):
        def document(name):
            return {"table": name, "title": f"Of {name}", "columns": [], "rows": [], "notes": []}

        names = {"drawn": "speed", "plain": "speed", "alone": "stability-theory", "not-there": "speed"}
        study = types.SimpleNamespace(
            tables={name: document(name) for name in ("drawn", "plain", "alone", "of-a-chart")},
            vocabulary={"tables": {name: {"section": section} for name, section in names.items()}},
        )
        speed = Section("speed", "Speed", [table_links("drawn")])
        (own,) = sections._further_tables(study, [speed])
        self.assertEqual((own.name, own.title), ("stability-theory", "Stability theory"))
        shown = ["".join(section.blocks) for section in (speed, own)]
        self.assertEqual([text.count("<h3>Of plain</h3>") for text in shown], [1, 0])
        self.assertEqual([text.count("<h3>Of alone</h3>") for text in shown], [0, 1])
        self.assertNotIn("Of drawn", shown[0])
        self.assertNotIn("of-a-chart", "".join(shown))


class LawParts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        measures.learn(json.loads(springcheck("list", "--json").stdout))

    def test_springs_stand_beside_each_other_on_one_mesh(self):
        rows = [
            split_row("mss-cf", "fem-hencky", 0.25, -36, 0.1, cells="10x10x10"),
            split_row("mss-cf", "fem-hencky", 0, -39, 0.1),
            split_row("mss-cf", "fem-hencky", 0.25, -36.3, 0.1),
            split_row("mss-stvk", "fem-stvk", 0.25, -1e-13, 1e-6),
            split_row("mss-stvk", "fem-hencky", 0.25, None, None),
            {**split_row("mss-stvk", "fem-stvk", 0.25, 1, 1), "measure": "volume_change"},
        ]
        (figure,) = laws._law_parts({"rows": rows})
        names, panels = figure.arguments
        self.assertEqual(names, ["mss-cf from fem-hencky", "mss-stvk from fem-stvk"])
        ((title, dots),) = panels
        self.assertEqual(title, "compression 20 %")
        self.assertEqual(dots, [(0, 0, 39, 0.1), (0, 0.25, 36.3, 0.1), (1, 0.25, 1e-13, 1e-6)])
        drawn = error_parts.draw_law_parts(names, panels).axes[0].lines[:3]
        self.assertEqual([line.get_xdata()[0] for line in drawn], [39, 36.3, 1e-3])
        self.assertEqual(drawn[2].get_markerfacecolor(), "white")
        self.assertNotEqual(drawn[1].get_markerfacecolor(), "white")

    def test_one_method_alone_has_no_figure(self):
        self.assertEqual(laws._law_parts({"rows": [split_row("mss-cf", "fem-hencky", 0, -39, 0.1)]}), [])


class Words(unittest.TestCase):
    def test_tests_and_statuses_are_told_in_the_programs_words(self):
        measures.learn(json.loads(springcheck("list", "--json").stdout))
        self.assertEqual(gone_through("bending", "E = 2 MPa"), "Bent by its weight, E = 2 MPa")
        self.assertEqual(gone_through("torsion", "45°"), "Turned by 45°")
        self.assertIsNone(measures.passive("affine"))
        self.assertEqual(measures.description("torsion"),
                         "The upper plate turns about the vertical through its centre.")
        self.assertEqual(measures.said("diverged"), "blew up in time")
        self.assertEqual(measures.said("of tomorrow"), "ended of tomorrow")


class Html(unittest.TestCase):
    def test_texts_are_escaped(self):
        self.assertIn("&lt;script&gt;", paragraph("{}", "<script>"))
        self.assertIn("&lt;b&gt;", table(["<b>"], [["<i>"]], name="t"))
        self.assertNotIn("<i>", table(["h"], [["<i>"]], name="t"))

    def test_long_tables_say_what_they_leave_out(self):
        html = table(["n"], [[str(i)] for i in range(10)], name="t", limit=3)
        self.assertEqual(html.count("<tr>"), 4)
        self.assertIn("first 3 of 10", html)

    def test_long_methods_of_wide_tables_may_take_two_lines(self):
        row = ["fem-hencky:q1-sri", "mss-affine-hencky", "mss-cf", "2026-11-28", "a <b>-c:d"]
        wide = table(["n"] * 13, [row + [""] * 8], name="t")
        for part in ("fem-hencky:</span><wbr><span>q1-sri<", "mss-affine-</span><wbr><span>hencky<", "<td>mss-cf<",
                     "<td>2026-11-28<", "<td>a &lt;b&gt;-c:d<"):
            self.assertIn(part, wide)
        self.assertIn("<td>fem-hencky:q1-sri</td>", table(["n"] * 12, [row + [""] * 7], name="t"))

    def test_file_names_are_plain(self):
        self.assertEqual(file_name("mine/../<é> nu 0.25"), "mine-..-nu-0.25")
        self.assertEqual(file_name("Ω"), "unnamed")


CUBE = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)


class Surfaces(unittest.TestCase):
    def volume(self, mesh):
        """Enclosed by the surface: by the divergence theorem, positive if it faces outward."""
        surface = outside(mesh)
        corners = mesh["nodes"][surface.nodes][surface.triangles()[0]]
        return np.einsum("ti,ti->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6

    def test_two_cubes_have_ten_faces(self):
        nodes = np.concatenate([CUBE, CUBE[4:] + [0, 0, 1]])
        mesh = {"nodes": nodes, "hexahedra": np.array([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]])}
        surface = outside(mesh)
        self.assertEqual(len(surface.faces), 10)
        self.assertEqual(sorted(np.bincount(surface.cells)), [5, 5])
        self.assertEqual(len(surface.edges()), 20)
        self.assertAlmostEqual(self.volume(mesh), 2)

    def test_all_types_of_cells_face_outward(self):
        apex = np.concatenate([CUBE, [[0.5, 0.5, 1.7]]])
        cells = {"hexahedra": [[0, 1, 2, 3, 4, 5, 6, 7]], "pyramids": [[4, 5, 6, 7, 8]]}
        mesh = {"nodes": apex, **{name: np.array(rows) for name, rows in cells.items()}}
        self.assertAlmostEqual(self.volume(mesh), 1 + 0.7 / 3)
        surface = outside(mesh)
        self.assertEqual(len(surface.faces), 9)
        # Fields of cells list pyramids before hexahedra.
        self.assertEqual(list(np.bincount(surface.cells)), [4, 5])
        halves = {"prisms": np.array([[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]])}
        self.assertAlmostEqual(self.volume({"nodes": CUBE, **halves}), 1)
        corner = {"tetrahedra": np.array([[0, 1, 3, 4]])}
        self.assertAlmostEqual(self.volume({"nodes": CUBE, **corner}), 1 / 6)

    def test_edges_in_a_plane(self):
        mesh = {"nodes": CUBE, "hexahedra": np.array([[0, 1, 2, 3, 4, 5, 6, 7]])}
        self.assertEqual(edges_in_plane(mesh, 2, 1, 1e-9).tolist(), [[4, 5], [4, 7], [5, 6], [6, 7]])
        self.assertEqual(len(edges_in_plane(mesh, 2, 0.5, 1e-9)), 0)


# Linear RGB as seen by readers without one kind of cone: Machado, Oliveira and Fernandes
# 2009 (doi 10.1109/TVCG.2009.113), severity 1.
SIGHTS = {
    "full": np.eye(3),
    "protanopia": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deuteranopia": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "tritanopia": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}


def linear_rgb(colour):
    value = np.array(to_rgb(colour))
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def luminance(colour):
    return linear_rgb(colour) @ [0.2126, 0.7152, 0.0722]


def lab(colour, sight):
    """CIE L*a*b* of a colour as a reader sees it, for the white of sRGB."""
    to_xyz = np.array(
        [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
    )
    xyz = to_xyz @ np.clip(SIGHTS[sight] @ linear_rgb(colour), 0, 1) / to_xyz.sum(axis=1)
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        methods.learn(json.loads(springcheck("list", "--json").stdout))

    def test_a_method_has_one_colour(self):
        for name in ("fem-stvk:q2", "fem-stvk:q1-sri", "fem-stvk, else"):
            self.assertEqual(method_style.colour(name), method_style.colour("fem-stvk"))
        self.assertNotEqual(method_style.colour("mine"), method_style.colour("mss-cf"))
        own = [method_style.colour(f"mss-{name}") for name in ("cf", "nfd", "baudet", "affine", "fd")]
        self.assertEqual(len(set(own)), 5)

    def test_every_status_has_a_colour_of_its_own(self):
        statuses = "ok wrinkled inverted indefinite no_equilibrium diverged not_converged refused"
        self.assertEqual(set(method_style.STATUS_COLOURS), set(statuses.split()))
        methods = {method_style.colour(f"mss-{name}") for name in ("cf", "nfd", "baudet", "affine", "fd")}
        colours = set(method_style.STATUS_COLOURS.values())
        self.assertEqual(len(colours), 8)
        self.assertFalse(colours & methods)

    def test_failures_are_told_apart_by_colour_blind_readers(self):
        """Smallest distance in CIE L*a*b*, of which 2.3 is just noticeable; print in grey as
        well for what lies beside each other most often."""
        styles = method_style.FAILURE_STYLES
        names = list(styles)
        for sight in SIGHTS:
            seen = [lab(styles[name][0], sight) for name in names]
            for i, one in enumerate(seen):
                for j in range(i):
                    self.assertGreater(np.linalg.norm(one - seen[j]), 10, (sight, names[i], names[j]))
        light = {name: lab(styles[name][0], "full")[0] for name in names}
        for name in ("wrinkling", "loss of definiteness", "limit point", "inversion", "blow-up"):
            self.assertGreater(light["none"] - light[name], 20, name)
        hatches = [style[1] for style in styles.values()]
        self.assertEqual(len(set(hatches)), len(styles))

    def test_letters_are_readable_on_their_fields(self):
        """Contrast as WCAG 2 defines it; 4.5 is asked of small text. 'none' is a dot."""
        for name, (colour, _, ink) in method_style.FAILURE_STYLES.items():
            if name != "none":
                bright = sorted(luminance(c) for c in (colour, ink))
                self.assertGreater((bright[1] + 0.05) / (bright[0] + 0.05), 4.5, name)

    def test_elements_that_lock_are_hollow(self):
        self.assertEqual(method_style.line("fem-stvk:q1")["markerfacecolor"], "white")
        self.assertEqual(
            method_style.line("fem-stvk:q1-sri")["markerfacecolor"], method_style.colour("fem-stvk"))
        self.assertEqual(method_style.line("fem-explicit-8p")["markerfacecolor"], "white")

    def test_statics_of_what_steps_are_of_its_element(self):
        for name, rest in (
            ("fem-explicit-8p", "fem-stvk:q1"),
            ("fem-explicit-hencky:q1-nodal", "fem-hencky:q1-nodal"),
            ("mss-cf", "mss-cf"),
            ("fem-stvk:q2", "fem-stvk:q2"),
        ):
            self.assertEqual(methods.at_rest(name), rest)

    def test_a_name_holds_the_solver_only_where_it_is_not_the_methods_own(self):
        case = {"element": None, "stiffness-form": None, "diagonal-ratio": None}
        for method, solver, name in (
            ("fem-explicit-1p", "semi-implicit", "fem-explicit-1p"),
            ("fem-explicit-1p", "verlet", "fem-explicit-1p, verlet"),
            ("mss-cf", "semi-implicit", "mss-cf, semi-implicit"),
            ("mss-cf", "static", "mss-cf"),
        ):
            row = pd.Series({**case, "method": method, "solver": solver})
            self.assertEqual(method_name(row), name)

    def test_bodies_drawn_reach_to_both_ends_of_a_sweep(self):
        self.assertEqual(far_apart([-0.5, -0.25, 0, 0.2, 0.4, 0.499], 0.25), [3, 0, 5, 1, 2, 4])
        self.assertEqual(far_apart([0.3, 0.3, 0.3], 0.25), [0, 1, 2])

    def test_pareto_front(self):
        times, errors = np.array([1, 2, 3, 4, 1.0]), np.array([5, 6, 2, 2, 7.0])
        self.assertEqual(pareto_front(times, errors), [0, 2])


if __name__ == "__main__":
    unittest.main()
