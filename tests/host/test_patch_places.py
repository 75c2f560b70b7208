"""Where the one patch is looked at that stands for all of a face whose tilts are alike.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest
from types import SimpleNamespace

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import FreeCAD  # noqa: E402
import numpy as np  # noqa: E402
import one_click  # noqa: E402
import other_parts  # noqa: E402
import quality_parts  # noqa: E402
from patchmill.advice import assessment, orientation  # noqa: E402


def alone(shape, name):
    """A flat face of a part as the face of a solid of its own, 4 mm thick, and its name there."""
    face = shape.getElement(name)
    normal = face.normalAt(*(0.5 * (face.ParameterRange[k] + face.ParameterRange[k + 1]) for k in (0, 2)))
    solid = face.extrude(-4.0 * normal)
    same = [k for k, f in enumerate(solid.Faces, 1) if f.CenterOfMass.isEqual(face.CenterOfMass, 1e-6)]
    return solid, "Face%d" % same[0]


SEEN = SimpleNamespace(quality=1.0, alignment={"state": ""})


class Places(unittest.TestCase):
    def test_the_patch_of_a_plane_lies_in_its_middle_however_its_normals_are_rounded(self):
        operation = one_click.texture(quality_parts.plate(25.0, 8.0, 4.5).toNurbs(), "Face6", "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        given = operation.Proxy.texture_input(operation)
        middle = np.mean([v.Point for v in operation.Base[0][0].Shape.Face6.Vertexes], axis=0)
        look = assessment.with_simulation(lambda *_, **__: SEEN)  # the place alone matters
        apart = []
        for seed in range(6):
            axis, angle = (np.sin(seed), np.cos(seed), 0.0), 1e-6 * seed
            turned = orientation.turned(given, axis, angle)
            (patch,) = look(turned).patches
            apart.append(np.linalg.norm(np.array(patch.position) - middle))
        self.assertLess(max(apart), given.spacing)
        self.assertLess(np.ptp(apart), 1e-3)

    def test_a_remedy_for_a_small_narrow_plane_makes_it_good_in_the_document_as_well(self):
        """Of 96 dimples on a plane that is a spline: an order by tilt is one of rounding
        errors, and a patch a spacing further was worth 0.93 where the remedy had found 1.00. Without the
        part's flanges, which would be in the tool's way."""
        operation = one_click.texture(*alone(*other_parts.PARTS["coil"]()), "linuxcnc-mill")
        self.addCleanup(FreeCAD.closeDocument, operation.Document.Name)
        self.assertEqual(one_click.fix(operation), "incline")
        self.assertEqual(one_click.state_of(operation)[0], "good")


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(0 if outcome.wasSuccessful() else 1)
