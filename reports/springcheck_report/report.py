"""Makes the report of a result file: page, figures, files for ParaView."""

import base64
import multiprocessing
import os
import shutil
from pathlib import Path

import bodies
import jinja2
import method_style
import paraview
from content import Figure, Viewer
from markupsafe import Markup
from plotly.offline import get_plotlyjs
from sections import SECTIONS, empty_file
from study import read

_HERE = Path(__file__).resolve().parent


def make(file, folder):
    """Writes index.html, figures/ and 3d/ of the result file into the folder, which
    `springcheck report` has put tables/ and data/ in. Files of an earlier report, which
    data/made.txt lists, go; others stay. Returns a sentence that says where things are. ValueError or OSError, with the path,
    where the file is no result file or the folder cannot be written."""
    method_style.set_defaults()
    study = read(file, folder)
    makers = [empty_file] if study.cases.empty else SECTIONS
    sections = [section for section in (maker(study) for maker in makers) if section]
    figures = [block for section in sections for block in section.blocks if isinstance(block, Figure)]
    figure_folder, three_d = folder / "figures", folder / "3d"
    for part in (figure_folder, three_d, folder / "data"):
        part.mkdir(parents=True, exist_ok=True)
    _replace_earlier(folder, [*_figure_files(figures), *_three_d_files(study)])
    keys = study.keys_with_fields()
    _in_parallel(
        [(_draw, figure, figure_folder) for figure in figures]
        + [(_write_vtus, study, keys[i : i + 20], three_d) for i in range(0, len(keys), 20)]
    )
    shutil.copyfile(_HERE / "show.py", three_d / "show.py")
    page = _page(study, sections, figure_folder)
    unfinished = folder / "index.html.unfinished"
    unfinished.write_text(page, encoding="utf-8")
    unfinished.replace(folder / "index.html")
    return f"{folder / 'index.html'}: {len(sections)} sections, {len(figures)} figures"


def _figure_files(figures):
    return [f"figures/{figure.name}.{form}" for figure in figures for form in ("svg", "pdf")]


def _three_d_files(study):
    names = [paraview.vtu_name(study, key) for key in study.keys_with_fields()]
    return [f"3d/{name}" for name in [*names, "show.py", "cases.xdmf"]]


def _replace_earlier(folder, files):
    """Removes what an earlier report made there, and notes what this one will."""
    made = folder / "data" / "made.txt"
    if made.exists():
        for name in made.read_text(encoding="utf-8").splitlines():
            if name.startswith(("figures/", "3d/")) and ".." not in name.split("/"):
                (folder / name).unlink(missing_ok=True)
    made.write_text("".join(f"{name}\n" for name in files), encoding="utf-8")


_tasks = []  # of _in_parallel, which forks: nothing is pickled


def _in_parallel(tasks):
    """Calls (function, *arguments) of every task, on all cores."""
    _tasks[:] = tasks
    context = multiprocessing.get_context("fork")
    with context.Pool(min(len(os.sched_getaffinity(0)), max(len(tasks), 1))) as pool:
        pool.map(_run_task, range(len(tasks)), chunksize=1)


def _run_task(place):
    function, *arguments = _tasks[place]
    function(*arguments)


def _draw(figure, folder):
    drawn = figure.draw(*figure.arguments)
    stem = folder / figure.name
    # No date: the same input gives the same file.
    # dpi: of the parts that are pixels, fewer in the page's SVG than in the PDF for print.
    drawn.savefig(f"{stem}.svg", bbox_inches="tight", metadata={"Date": None}, dpi=140)
    drawn.savefig(f"{stem}.pdf", bbox_inches="tight", metadata={"CreationDate": None}, dpi=300)


def _write_vtus(study, keys, folder):
    for key in keys:
        paraview.write_vtu(study, key, folder)


def _page(study, sections, figure_folder):
    tests = [b.test for section in sections for b in section.blocks if isinstance(b, Viewer)]
    views, left_out = bodies.view_data(study, tests) if tests else (None, 0)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(_HERE), autoescape=True, trim_blocks=True, lstrip_blocks=True
    )

    def kind(block):
        return type(block).__name__

    def image(figure):
        content = (figure_folder / f"{figure.name}.svg").read_bytes()
        return f"data:image/svg+xml;base64,{base64.b64encode(content).decode('ascii')}"

    def text(name):
        return Markup((_HERE / name).read_text(encoding="utf-8"))

    return environment.get_template("page.html").render(
        title=f"springcheck: {study.results.path.name}",
        sections=sections,
        kind=kind,
        image=image,
        text=text,
        plotly=Markup(get_plotlyjs()) if tests else None,
        views=views,
        left_out=left_out,
    )
