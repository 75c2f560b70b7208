"""A part and its dimples as they look: what the ball leaves at rest on each dimple, seen from any direction.

The depth of the part comes from FaceSampler along the line of sight, that of a dimple from the ball around
its centre p + (R - d) n; where balls overlap the deepest counts.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
import numpy as np

TEXTURED, BARE = np.array([0.80, 0.50, 0.30]), np.array([0.62, 0.65, 0.70])


class View:
    """Orthographic, along `direction`, `pixel` mm to the pixel."""

    def __init__(self, shape, direction, pixel, box=None):
        self.plane = core.texture_plane((0, 0, 0), direction, (1, 0, 0))
        faces = [face.exportBrepToString() for face in shape.Faces]
        self.sampler = core.FaceSampler(faces, self.plane, math.radians(89.0))
        low, high = self.sampler.extent() if box is None else np.array(box, float)
        self.low, self.pixel = low - 0.3, pixel
        self.columns, self.rows = (np.ceil((high - low + 0.6) / pixel)).astype(int)
        x = self.low[0] + pixel * (np.arange(self.columns) + 0.5)
        y = self.low[1] + pixel * (np.arange(self.rows) + 0.5)
        self.x, self.y = np.meshgrid(x, y)
        hits = self.sampler.sample(np.column_stack([self.x.ravel(), self.y.ravel()]))
        height = self.seen(hits["positions"])[:, 2]
        height[hits["states"] == core.DimpleState.OFF_FACE] = np.nan
        self.part = height.reshape(self.x.shape)

    def seen(self, points):
        """x and y on the picture and the height towards the eye, of (n, 3) points."""
        axes = np.array([self.plane.x_axis, self.plane.y_axis, -np.asarray(self.plane.direction)])
        return np.asarray(points) @ axes.T

    def dimples(self, plan, stretch=1.0, tolerance=1.5):
        """Height of what the ball leaves, infinite where no visible dimple is. Overlapping dimples are
        drawn up to a little more than where equal neighbours meet, `stretch` times as far."""
        cut = plan.dimples.states == core.DimpleState.CUT
        radius = plan.input.tool.radius
        normals = plan.dimples.normals[cut]
        depth = plan.dimples.depths[cut]
        contact = plan.dimples.positions[cut] - depth[:, None] * normals
        centres = self.seen(contact + radius * normals)
        contact, normals = self.seen(contact), self.seen(normals)
        isolated = plan.input.texture_kind == "Isolated"
        reach = np.sqrt(2.0 * radius * np.maximum(depth, 1e-9))  # chord to the rim
        if not isolated:
            reach[:] = 0.62 * plan.size["diameter"] * stretch
        relief = np.full(self.part.shape, np.inf)
        for p, c, n, r in zip(contact, centres, normals, reach):
            self._one(relief, p, c, n, r, radius, tolerance)
        return relief

    def _one(self, relief, p, c, n, reach, radius, tolerance):
        i, j = ((p[:2] - self.low) / self.pixel).astype(int)
        inside = 0 <= i < self.columns and 0 <= j < self.rows
        if n[2] < 0.1 or not inside or not abs(self.part[j, i] - p[2]) < tolerance:
            return
        k = int(reach / self.pixel) + 2
        rows, columns = slice(max(0, j - k), j + k + 1), slice(max(0, i - k), i + k + 1)
        x, y = self.x[rows, columns], self.y[rows, columns]
        rho2 = (x - c[0]) ** 2 + (y - c[1]) ** 2
        z = c[2] - np.sqrt(np.maximum(radius**2 - rho2, 0.0))
        far = (x - p[0]) ** 2 + (y - p[1]) ** 2 + (z - p[2]) ** 2 > reach**2
        z[far | (rho2 > radius**2)] = np.inf
        relief[rows, columns] = np.minimum(relief[rows, columns], z)

    def picture(self, plans, stretch=1.0, light=(-0.5, 0.45, 0.74)):
        """An image (rows from the bottom, columns, 3) of the part with the textures of `plans`."""
        height, textured = self.part.copy(), np.zeros(self.part.shape, bool)
        for plan in plans:
            relief = self.dimples(plan, stretch)
            here = np.isfinite(relief) & np.isfinite(self.part)
            if plan.input.texture_kind == "Isolated":
                here &= relief < self.part
            height[here] = relief[here]
            textured |= here
        dy, dx = np.gradient(height, self.pixel)
        normal = np.stack([-dx, -dy, np.ones_like(dx)], axis=-1)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        light = np.array(light) / np.linalg.norm(light)
        lit = np.clip(normal @ light, 0.0, 1.0)
        shine = np.clip(normal @ ((light + [0, 0, 1]) / np.linalg.norm(light + [0, 0, 1])), 0, 1)
        colour = np.where(textured[..., None], TEXTURED, BARE)
        image = colour * (0.18 + 0.9 * lit[..., None] ** 1.5) + 0.25 * shine[..., None] ** 40
        image[~np.isfinite(height)] = 1.0
        edge = np.isfinite(height) & ~np.isfinite(lit)
        image[edge] = 0.45
        return np.clip(np.nan_to_num(image, nan=0.45), 0.0, 1.0)

    def show(self, axes, plans, title, stretch=1.0):
        axes.imshow(self.picture(plans, stretch), origin="lower", interpolation="antialiased")
        axes.set_title(title, fontsize=11)
        axes.axis("off")
