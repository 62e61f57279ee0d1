"""Figures of speed against accuracy, on made-up points."""

import json
import sys
import unittest
from dataclasses import replace
from pathlib import Path

REPORTS = Path(__file__).parents[2] / "reports"
sys.path[:0] = [str(REPORTS), str(REPORTS / "springcheck_report")]
import methods  # noqa: E402
import numpy as np  # noqa: E402
from figures import work_precision  # noqa: E402
from program import springcheck  # noqa: E402


def springs(method, **parts):
    return work_precision.Model(method, method, "springs", **parts)


class WorkPrecision(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        methods.learn(json.loads(springcheck("list", "--json").stdout))

    def test_ticks_are_few_and_inside(self):
        for low, high, fewest, expected in [
            (0.0004, 0.3, 2, [0.001, 0.01, 0.1]),
            (0.2, 60, 3, [0.3, 1, 3, 10, 30]),
            (0.4, 2.5, 3, [0.5, 1, 2]),
            (2.1, 4.9, 3, [3, 4]),
            (1e-7, 1e3, 3, [1e-7, 1e-4, 0.1, 100]),
        ]:
            np.testing.assert_allclose(work_precision.ticks(low, high, fewest), expected)

    def test_texts_cover_neither_each_other_nor_points(self):
        places = [(20, 60), (24, 58), (30, 40), (33, 40), (60, 20)]
        texts = ["4", "10 (2)", "16 (2)", "4", "6"]
        boxes = [
            (x + dx, y + dy, 2 * len(text) + 1, 3)
            for (x, y), (dx, dy), text in zip(places, work_precision.text_offsets(places, texts), texts)
        ]
        for i, (x, y, width, height) in enumerate(boxes):
            self.assertGreater(x - width, 0)
            for px, py in places:
                self.assertFalse(abs(x - px) < width and abs(y - py) < height)
            for other in boxes[:i]:
                self.assertFalse(abs(x - other[0]) < width + other[2] and abs(y - other[1]) < 2 * height)

    def test_variants_of_a_method_share_its_colour_and_not_its_marker(self):
        affine, lattice = springs("mss-affine"), springs("mss-cf", precision="double")
        elements = work_precision.Model("fem-stvk:q1-sri", "fem-stvk", "finite elements", "q1-sri")
        for usual, changes in [
            (affine, {"cell_type": "tetrahedron"}),
            (replace(affine, cell_type="tetrahedron"), {"cell_type": "prism"}),
            (lattice, {"precision": "float"}),
            (elements, {"linear_solver": "direct"}),
            (elements, {"element": "q2"}),
        ]:
            one, other = work_precision.style(usual), work_precision.style(replace(usual, **changes))
            self.assertEqual(one["color"], other["color"])
            keys = ("marker", "fillstyle", "markerfacecolor")
            self.assertNotEqual(*([look.get(key) for key in keys] for look in (one, other)))

    def test_a_failed_point_is_a_cross_of_its_models_colour_at_its_time(self):
        """And the line to the next finer mesh does not pass over it."""
        points = [
            work_precision.Point(springs("mss-cf"), 2 + i, 1, status, 10.0**i, 10.0**i, 10.0**i, {"force": 5.0})
            for i, status in enumerate(["ok", "inverted", "ok"])
        ]
        block = work_precision.Block(
            "t", points, [work_precision.Measure("force", "Force", points[:1], [0.5], 0.5)],
            [work_precision.Group("g", [springs("mss-cf")])])
        row = work_precision.draw("time [s]", [block]).axes[2]  # after the front and its legend
        colour = work_precision.style(springs("mss-cf"))["color"]
        own = [line for line in row.lines if line.get_color() == colour]
        crosses = [line for line in own if line.get_marker() == "x"]
        self.assertEqual([list(line.get_xdata()) for line in crosses], [[10.0]])
        self.assertTrue(5 < crosses[0].get_ydata()[0] < row.get_ylim()[1])
        (curve,) = (line for line in own if len(line.get_xdata()) == 3)
        self.assertEqual(np.isnan(curve.get_ydata()).tolist(), [False, True, False])
        self.assertIn("inverted", {text.get_text() for text in row.texts})

    def test_errors_below_the_bar_leave_the_others_room(self):
        errors = [{"force": 1e-9}, {"force": 2.0}, {"force": 8.0}]
        points = [work_precision.Point(springs("mss-cf"), 2 + i, 1, "ok", 1, 1, 1, e) for i, e in enumerate(errors)]
        block = work_precision.Block(
            "t", points, [work_precision.Measure("force", "Force", points[:1], [0.5], 0.5)],
            [work_precision.Group("g", [springs("mss-cf")])])
        figure = work_precision.draw("time [s]", [block])
        low, high = figure.axes[0].get_ylim()
        self.assertTrue(0.01 < low < 0.5 and high > 8, (low, high))


if __name__ == "__main__":
    unittest.main()
