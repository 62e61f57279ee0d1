"""Makes the report of a result file: page, figures, files for ParaView."""

import base64
import gc
import gzip
import json
import multiprocessing
import os
import re
import shutil
from pathlib import Path

import bodies
import interruption
import jinja2
import method_style
import paraview
from content import Explorer, Figure, Viewer, figures_of
from markupsafe import Markup
from plotly.offline import get_plotlyjs
from sections import groups_for
from study import read

_HERE = Path(__file__).resolve().parent


def make(file, folder):
    """Writes index.html, figures/ and 3d/ of the result file into the folder, which
    `springcheck report` has put tables/ and data/ in. Files of an earlier report, which
    data/made.txt lists, go; others stay. Returns a sentence that says where things are.
    ValueError or OSError where the file is no result file or the folder cannot be written."""
    method_style.set_defaults()
    study = read(file, folder)
    groups = groups_for(study)
    sections = [section for group in groups.values() for section in group]
    figures = [figure for section in sections for figure in figures_of(section)]
    (folder / "data").mkdir(parents=True, exist_ok=True)
    # Beside their place until all of them are made: an earlier report stays whole till then.
    unfinished = folder / "data" / "unfinished"
    shutil.rmtree(unfinished, ignore_errors=True)  # of one that was killed
    interruption.remove_when_interrupted(unfinished)
    try:
        _make_files(study, groups, figures, unfinished)
        interruption.ignore()
        _replace_earlier(folder, unfinished)
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)
    return f"{folder / 'index.html'}: {len(sections)} sections, {len(figures)} figures"


def _make_files(study, groups, figures, folder):
    figure_folder, three_d = folder / "figures", folder / "3d"
    for part in (figure_folder, three_d):
        part.mkdir(parents=True)
    keys = study.keys_with_fields()
    _in_parallel(
        [(_draw, figure, figure_folder) for figure in figures]
        + [(_write_vtus, study, keys[i : i + 20], three_d) for i in range(0, len(keys), 20)]
    )
    if keys:
        shutil.copyfile(_HERE / "show.py", three_d / "show.py")
    page = folder / "index.html"
    page.write_text(_page(study, groups, figure_folder), encoding="utf-8")


def _replace_earlier(folder, unfinished):
    """Moves the finished files to their places, and removes what an earlier report made
    that this one has not."""
    files = sorted(str(p.relative_to(unfinished)) for p in unfinished.rglob("*") if p.is_file())
    made = folder / "data" / "made.txt"
    earlier = made.read_text(encoding="utf-8").splitlines() if made.exists() else []
    made.write_text("".join(f"{name}\n" for name in {*earlier, *files}), encoding="utf-8")
    for name in files:
        (folder / name).parent.mkdir(exist_ok=True)
        (unfinished / name).replace(folder / name)
    for name in set(earlier) - set(files):
        if name.startswith(("figures/", "3d/")) and ".." not in name.split("/"):
            (folder / name).unlink(missing_ok=True)
    made.write_text("".join(f"{name}\n" for name in files), encoding="utf-8")


_tasks = []  # of _in_parallel, which forks: nothing is pickled


def _in_parallel(tasks):
    """Calls (function, *arguments) of every task, on all cores where they are many."""
    _tasks[:] = tasks
    # What matplotlib loads for its first figure, each worker would load for itself.
    here = range(1 if len(tasks) > 3 else len(tasks))
    for place in here:
        _run_task(place)
    beside = range(len(here), len(tasks))
    if not beside:
        return
    gc.freeze()  # or the workers' collectors would copy all memory
    context = multiprocessing.get_context("fork")
    workers = min(len(os.sched_getaffinity(0)), len(beside))
    with context.Pool(workers, interruption.leave_to_parent, [os.getpid()]) as pool:
        pool.map(_run_task, beside, chunksize=1)


def _run_task(place):
    function, *arguments = _tasks[place]
    function(*arguments)


def _draw(figure, folder):
    # No date: the same input gives the same file. dpi: of the parts that are pixels, fewer
    # in the page's SVG than in the PDF for print.
    drawn = figure.draw(*figure.arguments)
    for form, date, dpi in (("svg", "Date", 140), ("pdf", "CreationDate", 300)):
        path = folder / f"{figure.name}.{form}"
        drawn.savefig(path, bbox_inches="tight", metadata={date: None}, dpi=dpi)
        drawn.set_layout_engine("none")  # the layout stays


def _write_vtus(study, keys, folder):
    for key in keys:
        paraview.write_vtu(study, key, folder)


_SCRIPTS_OF_CASES = ["selection.js", "explorer_plot.js", "explorer.js", "case.js"]


def _scripts(has_explorer, has_views):
    """Their names, each before those that call it."""
    names = ["scrolling.js", "unpack.js", "figures.js"]
    names += ["library.js"] if has_explorer or has_views else []
    names += ["body_traces.js", "views.js"] if has_views else []
    names += ["cases.js"] if has_explorer else []
    return [*names, "tables.js", "navigation.js", "search.js"]


def _packed(content):
    """Bytes as unpack.js unpacks them; the same of the same bytes."""
    return base64.b64encode(gzip.compress(content, mtime=0)).decode("ascii")


def _packed_json(value):
    return _packed(json.dumps(value, separators=(",", ":")).encode())


def _page(study, groups, figure_folder):
    sections = [section for group in groups.values() for section in group]
    explorers = [b.data for section in sections for b in section.blocks if isinstance(b, Explorer)]
    tests = [b.test for section in sections for b in section.blocks if isinstance(b, Viewer)]
    views = bodies.view_data(study, tests) if tests else None
    figures = [block for section in sections for block in section.blocks if isinstance(block, Figure)]
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(_HERE), autoescape=True, trim_blocks=True, lstrip_blocks=True
    )

    environment.policies["json.dumps_kwargs"] = {"sort_keys": False}  # what comes first is shown first

    def kind(block):
        return type(block).__name__

    every = [figure for section in sections for figure in figures_of(section)]
    drawings = {one.name: (figure_folder / f"{one.name}.svg").read_text(encoding="utf-8") for one in every}

    def image(figure):
        content = base64.b64encode(drawings[figure.name].encode()).decode("ascii")
        return f"data:image/svg+xml;base64,{content}"

    def size(figure):
        """Attributes, in pixels: a figure as wide as a page of print has 960."""
        width, height = re.search(
            r'<svg[^>]* width="([0-9.]+)pt" height="([0-9.]+)pt"', drawings[figure.name][:2000]
        ).groups()
        scale = 960 / (72 * method_style.TWO_COLUMNS)
        return Markup('width="{}" height="{}"').format(
            round(scale * float(width)), round(scale * float(height))
        )

    def text(name):
        return Markup((_HERE / name).read_text(encoding="utf-8"))

    return environment.get_template("page.html").render(
        title=f"springcheck: {study.results.path.name}",
        note=study.note,
        groups=groups,
        sections=sections,
        kind=kind,
        image=image,
        size=size,
        text=text,
        figures=_packed_json({figure.name: drawings[figure.name] for figure in figures}) if figures else None,
        plotly=_packed(get_plotlyjs().encode()) if tests or explorers else None,
        explorer=_packed_json(explorers[0]) if explorers else None,
        scripts=_scripts(has_explorer=bool(explorers), has_views=bool(tests)),
        scripts_of_cases=_SCRIPTS_OF_CASES,
        views=views and {**views, "data": _packed(views["data"])},
    )
