"""Deformed bodies side by side (figures 5.9, 5.10, 5.12, 5.14, 5.15 of the thesis)."""

from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from method_style import TWO_COLUMNS
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

_LIGHT = np.array([0.3, -0.5, 0.81])  # from the viewer's upper left, of length 1


@dataclass
class Panel:
    """corners: faces x 4 x 3 deformed corners [m], values: one per face; of a place without
    a body None, and the title says why."""

    title: str
    corners: np.ndarray | None
    values: np.ndarray | None


def draw(rows, colour_label, unit_scale=1.0, full_width=TWO_COLUMNS):
    """rows: lists of Panel, one column per method. All panels share scale, view and colours;
    values are shown times `unit_scale`. full_width: inches of all columns, which are not as
    wide where they are few."""
    columns = max(len(row) for row in rows)
    panels = [panel for row in rows for panel in row if panel.corners is not None]
    everything = np.concatenate([panel.corners.reshape(-1, 3) for panel in panels])
    low, high = everything.min(axis=0), everything.max(axis=0)
    largest = max(panel.values.max() for panel in panels) * unit_scale
    scale = matplotlib.colors.Normalize(0, largest or 1.0)
    colours = matplotlib.colormaps["viridis"]
    width = min(full_width / columns, 2.4)
    # mplot3d knows no constrained layout.
    figure = Figure((max(width * columns, 2.4) + 0.7, width * len(rows) + 0.3), layout="none")
    right = 1 - 0.75 / figure.get_figwidth()
    grid = figure.add_gridspec(
        len(rows), columns, left=0.01, right=right, bottom=0.01, top=0.9, wspace=0, hspace=0.3
    )
    for i, row in enumerate(rows):
        for j, panel in enumerate(row):
            if panel.corners is None:
                axes = figure.add_subplot(grid[i, j])
                axes.set_axis_off()
                axes.text(0.5, 0.5, panel.title, ha="center", va="center", color="#777777", fontsize=7)
                continue
            axes = figure.add_subplot(grid[i, j], projection="3d")
            collection = Poly3DCollection(
                panel.corners,
                facecolors=_shaded(colours(scale(panel.values * unit_scale)), panel.corners),
                edgecolors=(0, 0, 0, 0.35),
                linewidths=0.2,
            )
            collection.set_rasterized(True)  # hundreds of faces each
            axes.add_collection3d(collection)
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            # mplot3d shows the body's diagonal always as long: beams fill the panel then,
            # cubes do not.
            size = high - low
            zoom = np.clip(0.75 * np.linalg.norm(size) / size.max(), 0.95, 1.2)
            axes.set_box_aspect(size, zoom=zoom)
            axes.view_init(elev=18, azim=-62)
            axes.set_axis_off()
            axes.set_title(panel.title, fontsize=7, y=1.05)
    bar = figure.add_axes([right + 0.012, 0.2, 0.018, 0.6])
    mappable = matplotlib.cm.ScalarMappable(scale, colours)
    figure.colorbar(mappable, cax=bar, label=colour_label)
    return figure


def _shaded(colours, corners):
    """Colours darkened by the angle between the faces and the light."""
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-300
    light = 0.62 + 0.38 * np.clip(normals @ _LIGHT, 0, 1)
    return np.column_stack([colours[:, :3] * light[:, None], colours[:, 3]])
