"""LinuxCNC's two table-rotary-tilting machines: their geometry, their part of machine.ini, and where the
tool tip is in the frame of the work, from the joints, by the formulas of xyzac-trt-kins(9) and
xyzbc-trt-kins(9) written anew.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
import numpy

POINT = (4.0, -3.0, 0.0)  # x-, y-, z-rot-point, mm
OFFSET = 5.0              # y-offset of xyzac, x-offset of xyzbc, mm
OFFSET_Z = -40.0          # mm
SUBROUTINE = """o<%dremap> sub
M68 E3 Q%d
M66 E0 L0
o<%dremap> endsub
"""


def sections(kinematics):
    """Entries of machine.ini beside those of three axes; `kinematics` is 'xyzac' or 'xyzbc'."""
    return {
        'KINS': {'KINEMATICS': kinematics + '-trt-kins sparm=identityfirst', 'JOINTS': 5},
        'TABLE': {'PINS': kinematics + '-trt-kins',
                  'OFFSET_PIN': ('y' if kinematics == 'xyzac' else 'x') + '-offset',
                  'OFFSET': OFFSET, 'OFFSET_Z': OFFSET_Z, 'POINT_X': POINT[0],
                  'POINT_Y': POINT[1], 'POINT_Z': POINT[2]},
    }


REMAPS = ['SUBROUTINE_PATH = ./subroutines', 'REMAP = M428 modalgroup=10 ngc=428remap',
          'REMAP = M429 modalgroup=10 ngc=429remap']


def write_subroutines(folder):
    """M428 switches TCP on, M429 off."""
    (folder / 'subroutines').mkdir()
    for code, kind in ((428, 1), (429, 0)):
        text = SUBROUTINE % (code, kind, code)
        (folder / 'subroutines' / ('%dremap.ngc' % code)).write_text(text, encoding='ascii')


def rotation(axis, angle):
    """(n, 3, 3) rotations by `angle` [rad] about coordinate axis 0, 1 or 2."""
    cosine, sine = numpy.cos(angle), numpy.sin(angle)
    matrix = numpy.zeros(angle.shape + (3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix[..., axis, axis] = 1
    matrix[..., i, i] = matrix[..., j, j] = cosine
    matrix[..., i, j], matrix[..., j, i] = -sine, sine
    return matrix


def work_to_housing(kinematics, rotary):
    """(n, 3, 3) rotations R_wm; `rotary` is (n, 2) degrees of A or B, and C."""
    tilt, c = numpy.radians(rotary[:, 0]), numpy.radians(rotary[:, 1])
    return rotation(0 if kinematics == 'xyzac' else 1, tilt) @ rotation(2, c)


def tip_in_work(kinematics, linear, rotary):
    """(n, 3) tool tip in the work frame [mm] from joints: (n, 3) mm and degrees: (n, 2), or of xyza (n, 1)
    about the machine's X."""
    if kinematics == 'xyza':
        return numpy.einsum('nij,nj->ni', rotation(0, -numpy.radians(rotary[:, 0])), linear)
    tilt, c = numpy.radians(rotary[:, 0]), numpy.radians(rotary[:, 1])
    point = numpy.array(POINT)
    side = numpy.array([0.0, OFFSET, OFFSET_Z] if kinematics == 'xyzac' else [OFFSET, 0.0, OFFSET_Z])
    turn = rotation(0 if kinematics == 'xyzac' else 1, -tilt)
    on_c = numpy.einsum('nij,nj->ni', turn, linear - point - side) + side
    return numpy.einsum('nij,nj->ni', rotation(2, -c), on_c) + point
