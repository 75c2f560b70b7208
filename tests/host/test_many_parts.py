"""Two faces each of many parts that others made: nothing crashes or takes a minute of the processor, dimples
of lattices on the surface keep apart, and what is refused is refused by name with a remedy.

The parts are those of Debian packages occt-misc and freecad-common, 40 of them. PATCHMILL_PARTS names folders
with more (STEP, BREP, IGES), parted by colons: tools/fuzz takes all of theirs, and each is told when it is
done.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import pathlib
import random
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import _patchmill as core  # noqa: E402
import patchmill  # noqa: E402
from test_real_parts import IDF, OCCT, facing_up, interesting_face, read  # noqa: E402

from patchmill.texture_plan import TextureInput, plan_texture  # noqa: E402

MORE = os.environ.get("PATCHMILL_PARTS", "")
KINDS = {".step", ".stp", ".brep", ".rle", ".igs", ".iges"}
COUNT, MOST_FACES, SLOW = 40, 4000, 60.0


def parts():
    """Files, in an order that is the same each time; few of the packages', all of the folders named."""
    folders = [pathlib.Path(f) for f in MORE.split(":") if f] or [OCCT, IDF]
    files = [f for folder in folders for f in folder.rglob("*") if f.suffix.lower() in KINDS]
    files.sort()
    return files if MORE else [f for f in files if f.stat().st_size < 300000][:COUNT]


def two_faces(shape, rng):
    """The one that asks most of a texture, and any other of some size."""
    faces = shape.Faces
    if not faces or len(faces) > MOST_FACES:
        return []
    first = interesting_face(shape) or max(faces, key=lambda f: f.Area)
    large = sorted(faces, key=lambda f: -f.Area)[:12]
    others = [f for f in large if not f.isSame(first)]
    return [first] + ([rng.choice(others)] if others else [])


def texture_of(face, rng):
    """A texture of some hundred dimples with a tool to match."""
    spacing = math.sqrt(face.Area / rng.uniform(100.0, 800.0))
    height = face.BoundBox.ZMax + 100.0 * spacing + 1.0
    return TextureInput(
        breps=[face.exportBrepToString()],
        tool=core.BallEndMill(2.0 * spacing, 2),
        spindle=core.Spindle(1000 / 60, "M3"),
        feed=30.0 * spacing,
        safe_height=height,
        clearance_height=height + 1.0,
        spacing=spacing,
        mapping=rng.choice(["Projected", "On surface", "On surface"]),
        patch_shape=rng.choice(["Square", "Hexagon", "Triangle"]),
        patch_side=rng.randrange(2, 6),
        auto_direction=rng.random() < 0.5,
        minimum_tilt=0.01,
        decimals=6,
    )


class ManyParts(unittest.TestCase):
    def test_two_faces_of_each(self):
        done, refused, slowest, dimples = 0, {}, 0.0, 0
        for path in parts():
            rng = random.Random(path.name)
            with self.subTest(path.name):
                for face in two_faces(read(path), rng):
                    began = time.process_time()
                    late = []

                    def go_on(share):
                        if time.process_time() - began > SLOW:
                            late.append(share)
                        return not late

                    try:
                        plan = plan_texture(texture_of(facing_up(face), rng), go_on)
                    except patchmill.InputError as error:
                        self.assertTrue(error.remedy)
                        refused.setdefault(error.property, []).append("%s: %s" % (path.name, error))
                        continue
                    slowest = max(slowest, time.process_time() - began)
                    self.assertFalse(late, "over %g s" % SLOW)
                    done += 1
                    dimples += self.check(plan)
                if MORE:
                    print("%s: %d textures so far" % (path.name, done), flush=True)
        print("%d textures, %d dimples, slowest %.1f s" % (done, dimples, slowest))
        for name, lines in sorted(refused.items()):
            print("refused for %s: %d" % (name, len(lines)), *lines[: 400 if MORE else 2], sep="\n   ")
        self.assertGreater(done, 20)

    def check(self, plan):
        cut = plan.dimples.states == 0
        self.assertEqual(sum(plan.counts.values()), len(plan.dimples))
        if plan.laid is not None and cut.sum() > 1:
            nearest = core.nearest_distances(plan.dimples).min() / plan.input.spacing
            self.assertGreaterEqual(nearest, 0.9 * (1.0 - 1e-9))
        return int(cut.sum())


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
