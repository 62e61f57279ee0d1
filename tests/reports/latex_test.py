"""Tables of a report compile into a document, where TeX is installed."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

DOCUMENT = r"""\documentclass{article}
\usepackage{booktabs}
\usepackage{adjustbox}
\usepackage{rotating}
\begin{document}
%s
\end{document}
"""


@unittest.skipUnless(shutil.which("latexmk") and shutil.which("kpsewhich"), "latexmk is not installed")
class Latex(unittest.TestCase):
    def test_all_tables_of_a_report_compile(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        program = os.environ["SPRINGCHECK"]
        field = folder / "mine.csv"
        ticks = [i * 0.025 for i in range(3)]
        rows = [f"{x},{y},{z},0,0,{-0.05 * z}" for z in ticks for y in ticks for x in ticks]
        field.write_text("x,y,z,ux,uy,uz\n" + "\n".join(rows) + "\n")
        for arguments in (
            "run shearing --method mss-cf,mss-nfd,fem-hencky --nu 0.25 --deformation 5%",
            "run compression --method mss-nfd --nu 0 --deformation 20%",
        ):
            subprocess.run([program, *arguments.split(), "--out", folder / "r.h5"],
                           check=False, stdout=subprocess.DEVNULL)
        subprocess.run(
            [program, "measure", "compression", "--cells", "2,2,2", "--displacements", field,
             "--label", r"50% of_é & \x {} Ω $ # ^ ~ <b>", "--out", folder / "r.h5"],
            check=True, stdout=subprocess.DEVNULL)
        subprocess.run([program, "report", folder / "r.h5", "--out", folder / "report"],
                       check=True, stdout=subprocess.DEVNULL)
        tables = sorted((folder / "report" / "tables").glob("*.tex"))
        self.assertEqual([path.stem for path in tables], ["5.1", "5.3", "5.5", "cases"])
        inputs = "\n".join(rf"\input{{report/tables/{path.name}}}" for path in tables)
        (folder / "all.tex").write_text(DOCUMENT % inputs)
        made = subprocess.run(
            ["latexmk", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "all.tex"],
            cwd=folder, capture_output=True, text=True, errors="replace", check=False)
        self.assertEqual(made.returncode, 0, made.stdout[-3000:])
        self.assertGreater((folder / "all.pdf").stat().st_size, 20000)
        self.assertNotIn("Overfull \\hbox", (folder / "all.log").read_text(errors="replace"))


if __name__ == "__main__":
    unittest.main()
