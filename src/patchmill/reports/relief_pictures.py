# Pictures of a relief, as a customer would be shown them: shaded relief, depth map, cross-section.
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a machined relief from a height array, rendered without a display.

All functions take `height`, an array of shape (rows, columns): deviation from the base in mm, NaN
where there is no surface; row 0 is the lowest y. `step`: distance of cells in mm, `origin`: the
plane coordinates (x, y) of cell [0, 0] in mm. They return a matplotlib Figure; `save` writes it as
PNG. Raises ValueError for arrays that are not two-dimensional or hold no finite height.
"""

import numpy as np
from matplotlib import colors, ticker
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from patchmill.system import files

MICROMETRES = 1000.0  # per mm
MOST_PIXELS = 1600  # longer sides are thinned out before they are drawn


def shaded_relief(height, step, origin=(0.0, 0.0), title="", light=(135.0, 35.0), exaggeration=1.0):
    """The relief as metal under a lamp. `light`: azimuth and altitude of the lamp in degrees;
    `exaggeration` of heights."""
    height, step = _checked(height, step)
    figure, axes = _figure(height, step, origin, title)
    axes.imshow(_metal(height, step, light, exaggeration), origin="lower",
                extent=_extent(height, step, origin), interpolation="bilinear")
    return figure


def depth_map(height, step, origin=(0.0, 0.0), title="", places=None, planned=None, limits=None):
    """Heights in colours with a scale in micrometres. `places` and `planned`: arrays (n, 2) of
    plane coordinates, drawn as dots and as circles; `limits`: lowest and highest colour in mm."""
    height, step = _checked(height, step)
    figure, axes = _figure(height, step, origin, title, bar=True)
    low, high = limits if limits else (np.nanmin(height), np.nanmax(height))
    image = axes.imshow(height * MICROMETRES, origin="lower", cmap="viridis",
                        extent=_extent(height, step, origin), interpolation="nearest",
                        norm=colors.Normalize(low * MICROMETRES, high * MICROMETRES))
    image.cmap.set_bad("0.85")
    bar = figure.colorbar(image, ax=axes, fraction=0.046, pad=0.03)
    bar.set_label("height over the base, µm")
    if planned is not None and len(planned):
        axes.plot(*np.asarray(planned).T, "o", mfc="none", mec="w", ms=7, mew=0.9, label="planned")
    if places is not None and len(places):
        axes.plot(*np.asarray(places).T, ".", color="tab:red", ms=4, label="found")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="upper right", fontsize=8, framealpha=0.9)
    axes.set_xlim(*_extent(height, step, origin)[:2])
    axes.set_ylim(*_extent(height, step, origin)[2:])
    return figure


def cross_section(height, step, start, end, origin=(0.0, 0.0), title="", levels=()):
    """Heights along the line from `start` to `end` (plane coordinates), with every ridge marked and
    its height written. `levels`: pairs (height in mm, text) drawn as dashed lines, for closed forms."""
    height, step = _checked(height, step)
    along, profile = section(height, step, start, end, origin)
    figure = Figure(figsize=(9.0, 3.4), dpi=150)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.fill_between(along, profile * MICROMETRES, np.nanmin(profile) * MICROMETRES - 8.0,
                      color="0.82", lw=0)
    axes.plot(along, profile * MICROMETRES, color="tab:blue", lw=1.3)
    for level, text in levels:
        axes.axhline(level * MICROMETRES, color="tab:green", lw=0.9, ls="--")
        axes.annotate(text, (along[-1], level * MICROMETRES), xytext=(4, 0), va="center",
                      textcoords="offset points", color="tab:green", fontsize=8,
                      annotation_clip=False)
    tops = ridges(profile)
    axes.plot(along[tops], profile[tops] * MICROMETRES, "v", color="tab:red", ms=4)
    for k in tops[:: max(1, len(tops) // 12)]:
        axes.annotate(f"{profile[k] * MICROMETRES:.1f}", (along[k], profile[k] * MICROMETRES),
                      textcoords="offset points", xytext=(0, 6), ha="center", fontsize=8)
    axes.set_xlabel("along the section, mm")
    axes.set_ylabel("height over the base, µm")
    axes.set_xlim(along[0], along[-1])
    low, high = np.nanmin(profile) * MICROMETRES, np.nanmax(profile) * MICROMETRES
    axes.set_ylim(low - 0.08 * (high - low) - 1.0, high + 0.22 * (high - low) + 1.0)
    if title:
        axes.set_title(title, fontsize=10)
    figure.tight_layout()
    return figure


def section(height, step, start, end, origin=(0.0, 0.0)):
    """Distance along a line and the heights there, in steps of half a cell; bilinear, NaN off the
    grid."""
    height, step = _checked(height, step)
    start, end = np.asarray(start, float), np.asarray(end, float)
    length = np.linalg.norm(end - start)
    if not length > 0.0:
        raise ValueError("a section needs two different points")
    along = np.linspace(0.0, length, 2 + int(2.0 * length / step))
    points = start + along[:, None] / length * (end - start)
    x, y = ((points - np.asarray(origin, float)) / step).T
    rows, columns = height.shape
    i = np.clip(np.floor(x + 1e-9).astype(int), 0, max(columns - 2, 0))
    j = np.clip(np.floor(y + 1e-9).astype(int), 0, max(rows - 2, 0))
    i1, j1 = np.minimum(i + 1, columns - 1), np.minimum(j + 1, rows - 1)
    u, v = np.clip(x - i, 0.0, 1.0), np.clip(y - j, 0.0, 1.0)
    profile = ((height[j, i] * (1 - u) + height[j, i1] * u) * (1 - v)
               + (height[j1, i] * (1 - u) + height[j1, i1] * u) * v)
    off = (x < -0.01) | (y < -0.01) | (x > columns - 0.99) | (y > rows - 0.99)
    profile[off] = np.nan
    return along, profile


def ridges(profile):
    """Indices of the tops of a profile: higher than what is on both sides of their plateau."""
    p = np.asarray(profile, float)
    tops, k = [], 1
    while k < len(p) - 1:
        after = k
        while after + 1 < len(p) and p[after + 1] == p[k]:
            after += 1
        if after + 1 < len(p) and p[k] > p[k - 1] and p[k] > p[after + 1]:
            tops.append((k + after) // 2)
        k = after + 1
    return np.array(tops, dtype=int)


def side_by_side(reliefs, titles, step, origin=(0.0, 0.0), exaggeration=1.0, light=(135.0, 35.0),
                 columns=None):
    """Several shaded reliefs of one grid in a row, or in rows of `columns`."""
    columns = columns or len(reliefs)
    rows = -(-len(reliefs) // columns)
    figure = Figure(figsize=(4.0 * columns, 4.4 * rows), dpi=150)
    FigureCanvasAgg(figure)
    for k, (height, title) in enumerate(zip(reliefs, titles)):
        height, step = _checked(height, step)
        axes = figure.add_subplot(rows, columns, k + 1)
        axes.imshow(_metal(height, step, light, exaggeration), origin="lower",
                    extent=_extent(height, step, origin), interpolation="bilinear")
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("x, mm")
        axes.xaxis.set_major_locator(ticker.MaxNLocator(5))
        if k % columns == 0:
            axes.set_ylabel("y, mm")
    figure.tight_layout()
    return figure


def save(figure, path):
    """Writes a figure as PNG, without the date: the same picture is the same file."""
    with files.replacing(path) as file:
        figure.savefig(file, format="png", bbox_inches="tight", metadata={"Software": None})


def _checked(height, step):
    height = np.asarray(height, float)
    if height.ndim != 2 or not np.isfinite(height).any():
        raise ValueError("height must be an array (rows, columns) with some finite values")
    if not step > 0.0:
        raise ValueError("step must be positive")
    return height, float(step)


def _extent(height, step, origin):
    rows, columns = height.shape
    return (origin[0] - step / 2, origin[0] + (columns - 0.5) * step,
            origin[1] - step / 2, origin[1] + (rows - 0.5) * step)


def _figure(height, step, origin, title, bar=False):
    left, right, low, high = _extent(height, step, origin)
    aspect = np.clip((high - low) / (right - left), 0.2, 3.0)
    width = 7.0
    figure = Figure(figsize=(width + (1.2 if bar else 0.0), 1.0 + width * aspect), dpi=150)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.set_aspect("equal")
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    if title:
        axes.set_title(title, fontsize=10)
    return figure, axes


def _metal(height, step, light, exaggeration):
    """Grey values of a slightly shiny surface: diffuse and specular light, missing cells white."""
    every = max(1, max(height.shape) // MOST_PIXELS)
    height, step = height[::every, ::every], step * every
    dy, dx = np.gradient(height * exaggeration, step)
    normal = np.stack([-dx, -dy, np.ones_like(dx)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    azimuth, altitude = np.radians(light)
    lamp = np.array([np.cos(altitude) * np.cos(azimuth), np.cos(altitude) * np.sin(azimuth),
                     np.sin(altitude)])
    half = lamp + [0.0, 0.0, 1.0]
    half /= np.linalg.norm(half)
    diffuse = np.clip(normal @ lamp, 0.0, 1.0)
    shine = np.clip(normal @ half, 0.0, 1.0) ** 60
    grey = np.clip(0.12 + 0.75 * diffuse + 0.25 * shine, 0.0, 1.0)
    image = np.stack([grey * 0.97, grey * 0.985, grey], axis=-1)
    image[~np.isfinite(grey)] = 1.0
    return image
