"""What every function that Python can call does with bad arguments: it refuses them by an InputError that
names property, value and remedy, or, where the type is wrong, by Python's TypeError. It never crashes, hangs,
takes all memory, or raises anything else; and what is not a number, or infinite, it does not take at all, but
where TAKES_ANY says so and why.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import faulthandler
import inspect
import math
import os
import pathlib
import resource
import sys
import unittest

import _patchmill as core
import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import bound_calls_machine  # noqa: E402, F401: adds its calls to CALLS
import bound_things as things  # noqa: E402
from bound_calls import CALLS, FILE  # noqa: E402

MOST_MEMORY = 8 << 30  # of addresses: FreeCAD itself takes one or two
LONGEST = 60  # s, for one call
NAN, INF = math.nan, math.inf
NUMBERS = [NAN, INF, -INF, -1.0, 0.0, 1e300, -1e300, 1e-300, 1e9, 1e-9]
COUNTS = [-1, 0, 1, 7, 300, 10**6, 2**31 - 1, -(2**31)]
WORDS = ["", "nonsense", "a\0b", "x" * 10000]
OTHERS = {  # another one of the same kind, which does not belong to the other arguments
    "dimples": things.other_dimples,
    "grid": things.other_grid,
    "feed": core.steady_feed(things.other_grid, 5.0, 10.0),
    "posture": core.steady_posture(things.other_grid, things.part),
    "materials": core.materials_of(things.other_grid, []),
    "path": things.copy_path,
    "postures": core.plan_postures(
        things.machine, things.other_dimples, core.tool_axes(things.other_dimples, "Normal", lead=0.2), 3
    ),
    "machine": things.bare_machine(),
    "part": core.Solid.box((100, 100, 100), (101, 101, 101)),
    "section": core.read_gcode(things.PROGRAM.replace(" A1", ""), things.tool)[0],
    "options": core.CopyOptions(**dict(things.COPY, mode="Contour")),
}

# Bad values of these are outcomes: (function, argument) and what becomes of them.
TAKES_ANY = {
    ("FaceSampler.sample", "points"): "off the faces",
    ("Mask.at", "places"): "0, or what the image has outside",
    ("SurfaceLattice.places", "points"): "NaN: beyond the lattice's end",
    ("axes_at", "points"): "air",
    ("feed_at", "points"): "air",
    ("kinds_at", "points"): "air",
    ("materials_at", "points"): "-1",
    ("PartModel.distances", "points"): "NaN: not known",
    ("Solid.signed_distances", "points"): "NaN: not known",
    ("make_path", "turns"): "NaN: nobody knows",
    ("outline_display", "outlines"): "rows of NaN interrupt a polyline",
    ("grid_display", "points"): "holes",
    ("grid_display", "values"): "holes",
    ("slice_display", "centres"): "not shown",
    ("slice_display", "values"): "the last colour",
    ("arrow_display", "places"): "not shown",
    ("arrow_display", "vectors"): "not shown",
    ("arrow_display", "values"): "the last colour",
    ("scale_colour", "share"): "the nearest end of the scale",
}
# Infinite is a value of these: no limit, or no depth to which a material reaches.
TAKES_INFINITE = {
    ("MotionModel", "jerk"),
    ("apply_dcm", "axis_rate"),
    ("apply_dcm", "acceleration"),
    ("Kinematics", "lowest"),
    ("Kinematics", "highest"),
    ("Kinematics.add_rotary", "lowest"),
    ("Kinematics.add_rotary", "highest"),
    ("Kinematics.add_rotary", "rate"),
    ("Kinematics.add_rotary", "acceleration"),
    ("materials_of", "bodies"),
    ("voxelise", "memory_limit"),
    ("simulate_texture", "memory_limit"),
}


def is_vector(value):
    return isinstance(value, (tuple, list)) and value and all(type(x) in (int, float) for x in value)


def spoilt_array(array):
    yield np.zeros((0,) + array.shape[1:], array.dtype)
    yield array[:1]
    yield np.concatenate([array, array])
    yield np.zeros((2, 2, 2, 7), array.dtype)
    if array.dtype.kind == "i":
        for number in (-1, 10**6, 2**31 - 1):
            yield np.full_like(array, number)
    if array.dtype.kind == "f":
        for number in (0.0, 1e30, -1e30):
            yield np.full_like(array, number)


def spoilt(name, value):
    """Bad values for a good one, all but those that are not finite."""
    if isinstance(value, bool):
        return
    if isinstance(value, float):
        yield from (n for n in NUMBERS if math.isfinite(n))
    elif isinstance(value, int):
        yield from COUNTS
    elif isinstance(value, str):
        yield from WORDS
    elif isinstance(value, np.ndarray):
        yield from spoilt_array(value)
    elif is_vector(value):
        yield from (type(value)([n] * len(value)) for n in (0.0, 1e300, 1e-300, 1e8, -1e8))
        yield from (value[:-1], value * 2, [-1] * len(value), [300] * len(value))
    elif isinstance(value, list):
        yield []
        if isinstance(value[0], str):
            yield from ([word] for word in WORDS)
        if isinstance(value[0], np.ndarray):
            yield from ([array] for array in spoilt_array(value[0]))
        if isinstance(value[0], tuple):
            yield from ([t] for t in spoilt_tuples(value[0], (-1.0, 0.0, 1e300, 1e-300)))
    if name in OTHERS:
        yield OTHERS[name]
    if not isinstance(value, (float, int, str, np.ndarray, tuple, list)):
        yield from (None, 1.0, "nonsense")


def spoilt_tuples(entry, numbers):
    for i, item in enumerate(entry):
        if isinstance(item, float):
            yield from (entry[:i] + (n,) + entry[i + 1:] for n in numbers)


def not_finite(value, numbers):
    """Values in the place of a good one that have one of these numbers in them."""
    if isinstance(value, float):
        yield from numbers
    elif isinstance(value, np.ndarray) and value.dtype.kind == "f":
        for number in numbers:
            one = value.copy()
            one.flat[0] = number
            yield from (one, np.full_like(value, number))
    elif is_vector(value) and isinstance(value[-1], float):
        yield from (value[:-1] + type(value)([n]) for n in numbers)
        yield from (type(value)([n] * len(value)) for n in numbers)
    elif isinstance(value, list) and isinstance(value[0], np.ndarray):
        yield from ([array] for array in not_finite(value[0], numbers))
    elif isinstance(value, list) and isinstance(value[0], tuple):
        yield from ([entry] for entry in spoilt_tuples(value[0], numbers))


def shown(value):
    text = repr(value.ravel()[:4]) + str(value.shape) if isinstance(value, np.ndarray) else repr(value)
    return text[:80]


class Outcomes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.limit = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, cls.limit[1]))
        cls.folder = os.getcwd()
        os.chdir(os.path.dirname(FILE))  # some words are names of files
        cls.real = os.dup(2)  # OpenCASCADE talks about bad BREP texts
        quiet = os.open(os.devnull, os.O_WRONLY)
        os.dup2(quiet, 2)
        os.close(quiet)

    @classmethod
    def tearDownClass(cls):
        os.dup2(cls.real, 2)
        os.chdir(cls.folder)
        resource.setrlimit(resource.RLIMIT_AS, cls.limit)

    def outcome(self, name, **bad):
        """The InputError or TypeError that the call ends with, or None. What else it raises is a fault."""
        function, good = CALLS[name]
        said = "%s(%s)" % (name, ", ".join("%s=%s" % (k, shown(v)) for k, v in bad.items()))
        faulthandler.dump_traceback_later(LONGEST, exit=True, file=self.real)
        try:
            function(**dict(good, **bad))
        except core.InputError as error:
            self.assertTrue(error.property and error.remedy, said)
            return error
        except TypeError as error:
            return error
        except BaseException as error:
            self.fail("%s: %s: %s" % (said, type(error).__name__, error))
        finally:
            faulthandler.cancel_dump_traceback_later()
        return None

    def test_good_arguments_are_taken(self):
        for name in CALLS:
            with self.subTest(name):
                self.assertIsNone(self.outcome(name))

    def test_bad_arguments_are_refused_by_name_or_have_an_outcome(self):
        for name, (_, good) in CALLS.items():
            for argument, value in good.items():
                for bad in spoilt(argument, value):
                    with self.subTest(name, argument=argument, value=shown(bad)):
                        self.outcome(name, **{argument: bad})

    def test_what_is_not_finite_is_refused(self):
        for name, (_, good) in CALLS.items():
            for argument, value in good.items():
                place = (name.split()[0], argument)
                numbers = [NAN] if place in TAKES_INFINITE else [NAN, INF, -INF]
                for bad in not_finite(value, numbers):
                    with self.subTest(name, argument=argument, value=shown(bad)):
                        refused = self.outcome(name, **{argument: bad})
                        if place not in TAKES_ANY:
                            self.assertIsInstance(refused, core.InputError)

    @settings(max_examples=400, derandomize=True, database=None, deadline=None,
              suppress_health_check=list(HealthCheck))
    @given(st.data())
    def test_two_bad_arguments_at_once(self, data):
        name = data.draw(st.sampled_from(sorted(n for n, (_, good) in CALLS.items() if len(good) > 1)))
        good = CALLS[name][1]
        chosen = data.draw(st.lists(st.sampled_from(sorted(good)), min_size=2, max_size=2, unique=True))
        bad = {}
        for argument in chosen:
            value = good[argument]
            if isinstance(value, float):
                bad[argument] = data.draw(st.floats())
            else:
                choices = [*spoilt(argument, value), *not_finite(value, NUMBERS)]
                if choices:
                    bad[argument] = choices[data.draw(st.integers(0, len(choices) - 1))]
        self.outcome(name, **bad)


class Complete(unittest.TestCase):
    def test_every_function_with_arguments_is_called_here(self):
        called = {name.split()[0] for name in CALLS}
        missing = []
        for name, value in vars(core).items():
            if inspect.isclass(value) and value.__name__ == name:  # not a class's former name
                methods = [m for m in vars(value) if not m.startswith("__") and callable(getattr(value, m))]
                missing += ["%s.%s" % (name, m) for m in methods if takes_arguments(getattr(value, m))]
            elif callable(value) and takes_arguments(value):
                missing.append(name)
        missing = set(missing) - called
        self.assertEqual(missing, set(), "add a good call of it to bound_calls.py")


def takes_arguments(function):
    signature = (function.__doc__ or "").split("\n")[0]
    inside = signature[signature.find("(") + 1 : signature.rfind(") ->")]
    return bool(inside.replace("self: _patchmill.", "").partition(",")[2]) or (
        "self" not in inside and ":" in inside
    )


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
