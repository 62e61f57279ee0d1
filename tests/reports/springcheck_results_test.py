"""Reads what the real program writes: SPRINGCHECK names it."""

import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from hashlib import sha256
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "reports"))
import numpy as np  # noqa: E402
import springcheck_results as results  # noqa: E402


class Reading(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.file = self.folder / "run.h5"
        run = "run traction --method mss-cf,fem-hooke --cells 2,2,2 --nu 0.25 --out"
        subprocess.run(
            [os.environ["SPRINGCHECK"], *run.split(), self.file],
            check=True,
            stdout=subprocess.DEVNULL,
        )

    def test_cases_have_settings_and_measures(self):
        cases = results.read(self.file).cases
        self.assertEqual(sorted(cases.method), ["fem-hooke", "mss-cf"])
        hooke = cases[cases.method == "fem-hooke"].iloc[0]
        # A bar of E = 10 kPa under 1 kPa: 10 %, free sides thinner by nu of that.
        self.assertAlmostEqual(hooke["face_displacement.z"], 0.1 * 0.05, 12)
        self.assertEqual(hooke.nu, 0.25)
        self.assertEqual(hooke.status, "ok")
        self.assertIsNone(hooke["stiffness-form"])  # springs' own
        self.assertTrue(cases["volume_error"].notna().all())

    def test_fields_and_meshes_go_together(self):
        read = results.read(self.file)
        key = read.cases.index[read.cases.method == "fem-hooke"][0]
        fields, mesh = read.fields(key), read.mesh(key)
        self.assertEqual(mesh["nodes"].shape, (27, 3))
        self.assertEqual(mesh["hexahedra"].shape, (8, 8))
        faces = {"bottom", "top", "x_min", "x_max", "y_min", "y_max"}
        self.assertEqual(set(mesh["regions"]), faces)
        stretched = 0.1 * mesh["nodes"][:, 2]
        self.assertLess(abs(fields["displacement"][:, 2] - stretched).max(), 1e-12)
        self.assertEqual(fields["cell_volume_ratio"].shape, (8,))
        with self.assertRaises(KeyError):
            read.fields("none")

    def test_mixed_meshes_list_their_cells_by_type(self):
        """Their volumes, in the order of the types, add up to the deformed body's."""
        file = self.folder / "mixed.h5"
        run = "run compression --method mss-affine --cells 3,3,3 --cell-type mixed --out"
        subprocess.run(
            [os.environ["SPRINGCHECK"], *run.split(), file], check=True, stdout=subprocess.DEVNULL
        )
        read = results.read(file)
        key = read.cases.index[0]
        mesh = read.mesh(key)
        widths = {"tetrahedra": 4, "pyramids": 5, "prisms": 6, "hexahedra": 8}
        counts = {name: len(mesh[name]) for name in widths}
        for name, width in widths.items():
            self.assertEqual(mesh[name].shape[1], width)
        ratios = read.fields(key)["cell_volume_ratio"]
        self.assertEqual(len(ratios), sum(counts.values()))
        corner = mesh["nodes"][mesh["hexahedra"]]
        cube = 0.05**3 / 27
        self.assertTrue(
            np.allclose(np.prod(corner[:, 6] - corner[:, 0], axis=1), cube, rtol=1e-12)
        )
        share = {"tetrahedra": 1 / 12, "pyramids": 1 / 6, "prisms": 1 / 2, "hexahedra": 1}
        volumes = np.concatenate([np.full(counts[n], cube * share[n]) for n in widths])
        change = (ratios * volumes).sum() / volumes.sum() - 1
        self.assertAlmostEqual(volumes.sum(), 0.05**3, 15)
        self.assertAlmostEqual(change, read.cases.volume_change.iloc[0], 12)

    def test_a_history_has_the_columns_of_the_json(self):
        file = self.folder / "motion.h5"
        run = "run compression --method mss-cf --cells 2,2,2 --solver verlet --duration 0.1 --history 5"
        ended = subprocess.run(
            [os.environ["SPRINGCHECK"], *run.split(), "--json", "--out", file],
            check=True, capture_output=True, text=True,
        )
        (result,) = json.loads(ended.stdout)["results"]
        read = results.read(file)
        history = read.history(result["key"])
        # What compression does not have is null there.
        known = history.astype(object).where(history.notna(), None)
        self.assertEqual(known.to_dict("list"), result["history"])
        frames = read.frames(result["key"])
        self.assertEqual([frame.sample for frame in frames], list(range(len(history))))
        volumes = [frame.cell_volume_ratio.mean() - 1 for frame in frames]
        np.testing.assert_allclose(volumes, history.volume_change, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(frames[-1].displacement, read.fields(result["key"])["displacement"])
        self.assertIsNone(results.read(self.file).history(results.read(self.file).cases.index[0]))

    def test_provenance_is_of_the_writing(self):
        read = results.read(self.file)
        written = read.provenance.loc[read.cases.provenance.iloc[0]]
        self.assertTrue(written.commit)
        self.assertEqual(len(read.provenance), 1)

    def test_other_files_are_refused_by_name(self):
        text = self.folder / "notes.h5"
        text.write_text("notes")
        with self.assertRaisesRegex(ValueError, "notes.h5: expected a readable springcheck result"):
            results.read(text)
        with self.assertRaises(FileNotFoundError):
            results.read(self.folder / "none.h5")

    def test_a_whole_journal_counts_and_a_cut_one_does_not(self):
        """As a writer that was killed while it changed the file leaves it."""
        whole = self.file.read_bytes()
        old = b"\0" * 4096
        page = struct.pack("<Q", 0) + sha256(old).hexdigest().encode() + whole[:4096]
        body = b"springcheck journal 1\n".ljust(32, b"\0")
        body += struct.pack("<QQ", len(whole), 1) + page
        journal = body + sha256(body).hexdigest().encode()
        self.file.write_bytes(old + whole[4096:])
        Path(f"{self.file}-journal").write_bytes(journal)
        self.assertEqual(len(results.read(self.file).cases), 2)
        self.file.write_bytes(b"x" * 4096 + whole[4096:])
        with self.assertRaisesRegex(ValueError, "of other content"):
            results.read(self.file)
        Path(f"{self.file}-journal").write_bytes(journal[:-1])
        with self.assertRaises(ValueError):
            results.read(self.file)


if __name__ == "__main__":
    unittest.main()
