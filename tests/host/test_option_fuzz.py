"""Random faces through random options: every texture is planned or refused by name; counts add up, nothing is
NaN, dimples of curved patches lie on the face, and what is cut is where the path goes.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import random
import sys
import unittest

import _patchmill as core
import FreeCAD
import numpy as np
import Part
import patchmill
from patchmill.textures.masks import MaskInput
from patchmill.textures.plan import TextureInput, plan_texture

V = FreeCAD.Vector
COUNT = 100


def random_face(rng):
    """A B-spline, a piece of a sphere, a cone or a cylinder, or a plane with a hole; rotated."""
    kind = rng.randrange(5)
    if kind == 0:
        surface = Part.BSplineSurface()
        n, bump = rng.randrange(4, 9), rng.uniform(0.0, 2.0)
        grid = np.linspace(-8, 8, n)
        surface.interpolate([[V(x, y, rng.uniform(-bump, bump)) for y in grid] for x in grid])
        shape = surface.toShape()
    elif kind == 1:
        shape = Part.makeSphere(rng.uniform(5, 12), V(), V(0, 0, 1), rng.uniform(-20, 50)).Faces[0]
    elif kind == 2:
        shape = Part.makeCone(rng.uniform(6, 12), rng.uniform(0, 5), rng.uniform(4, 15)).Faces[0]
    elif kind == 3:
        shape = Part.makeCylinder(rng.uniform(5, 12), 15, V(), V(1, 0, 0), rng.uniform(60, 360))
        shape = shape.Faces[0]
    else:
        plate = Part.makePlane(16, 16, V(-8, -8, 0))
        shape = plate.cut(Part.makeCylinder(rng.uniform(1, 5), 2, V(0, 0, -1))).Faces[0]
    axis = V(*(rng.uniform(-1, 1) for _ in range(3)))
    shape.rotate(V(0, 0, 0), axis, rng.uniform(0, 40))
    return shape


def random_mask(rng):
    if rng.random() < 0.6:
        return None
    loop = [(rng.uniform(-9, 9), rng.uniform(-9, 9), 0.0) for _ in range(rng.randrange(3, 8))]
    use = rng.choice(["Leave out", "Density", "Depth"])
    return MaskInput(use=use, loops=[tuple(loop)], invert=rng.random() < 0.5, depth_at_black=0.01)


def random_input(rng):
    isolated = rng.random() < 0.5
    return TextureInput(
        breps=[random_face(rng).exportBrepToString()],
        tool=core.BallEndMill(1.0, rng.randrange(1, 5)),
        spindle=core.Spindle(rng.uniform(5, 200), rng.choice(["M3", "M4"])),
        feed=rng.uniform(5, 200),
        safe_height=60.0,
        clearance_height=61.0,
        surface=core.PatchSurface(rng.choice(["Planar", "Pyramid", "Curved"])),
        spacing=rng.uniform(0.4, 1.2),
        texture_kind="Isolated" if isolated else "Overlapping",
        depth=rng.uniform(0.001, 0.02) if isolated else 0.0,
        mapping=rng.choice(["Projected", "On surface"]),
        patch_shape=rng.choice(["Square", "Hexagon", "Triangle"]),
        patch_side=rng.randrange(1, 7),
        patches_x=(patches := rng.choice([0, 0, 2])),
        patches_y=patches,
        helix_order=rng.choice(["Inward", "Outward"]),
        helix_start=rng.choice(["Same corner", "Nearest corner"]),
        auto_direction=rng.random() < 0.3,
        rotation=rng.uniform(0, 360),
        avoid_rubbing=rng.random() < 0.2,
        margin=rng.choice([0.0, 0.5]),
        minimum_dimples=rng.choice([0, 4]),
        mask=random_mask(rng),
        form="Free" if rng.random() < 0.2 else "Lattice",
        free_side=rng.uniform(2, 6),
        cross_feed=rng.uniform(0.3, 0.8),
        feed_per_tooth=rng.uniform(0.3, 0.8),
        extra_turns=5.0,
        decimals=4,
    )


class RandomTextures(unittest.TestCase):
    def test_are_planned_or_refused_by_name(self):
        planned, refused = 0, {}
        for seed in range(COUNT):
            with self.subTest(seed=seed):
                given = random_input(random.Random(seed))
                try:
                    plan = plan_texture(given)
                except patchmill.InputError as error:
                    self.assertTrue(error.remedy)
                    refused[error.property] = refused.get(error.property, 0) + 1
                    continue
                planned += 1
                self.check(plan)
        print("planned %d; refused by property: %s" % (planned, refused))
        self.assertGreater(planned, COUNT // 3)

    def check(self, plan):
        dimples = plan.dimples
        cut = dimples.states == 0
        self.assertEqual(sum(plan.counts.values()), len(dimples))
        self.assertTrue(np.isfinite(dimples.positions[cut]).all())
        self.assertLess(np.abs(np.linalg.norm(dimples.normals[cut], axis=1) - 1.0).max(), 1e-9)
        self.assertTrue(np.isfinite(plan.places()[cut]).all())
        self.assertTrue(np.isfinite(plan.path.tips).all())
        reached = plan.path.dimples[plan.path.dimples >= 0]
        self.assertTrue((reached == np.flatnonzero(cut)).all(), "each once, in order")
        if plan.free is None:
            tips = plan.path.tips[plan.path.dimples >= 0]
            radius, depth = plan.input.tool.radius, dimples.depths[cut][:, None]
            touch = tips + [0, 0, radius] - (radius - depth) * dimples.normals[cut]
            self.assertLess(np.abs(touch - dimples.positions[cut]).max(), 0.51e-4)
        self.assertEqual(len(plan.outlines()) > 0, True)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
