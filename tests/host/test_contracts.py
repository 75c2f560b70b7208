"""What every function that Python can call does with bad arguments: it refuses them by an InputError that
names property, value and remedy, or, where the type is wrong, by Python's TypeError. It never crashes, hangs,
takes all memory, or raises anything else. What is not a number, or infinite, it does not take at all, but
where TAKES_ANY says so and why; what is plainly bad otherwise, but where TAKEN does. And its docstring says
what it raises.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import faulthandler
import inspect
import os
import pathlib
import re
import resource
import sys
import unittest

import _patchmill as core
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import bound_calls_machine  # noqa: E402, F401: adds its calls to CALLS
from bound_calls import CALLS, FILE  # noqa: E402
from spoilt_values import INF, NAN, NUMBERS, fault_of, not_finite, shown, spoilt  # noqa: E402
from taken_values import TAKEN  # noqa: E402

OPERATORS = ("__init__", "__eq__", "__len__", "__str__", "__getitem__")
# These calls go on to other functions, which refuse what this one takes, or get a thing that was checked.
GO_ON = {"PatchSurface", "PhaseRule", "PacedRule", "MotionModel", "Kinematics", "Kinematics.add_rotary",
         "ProgramForm", "CopyOptions", "MarkWish", "ProjectedSurface.place", "copy_mill",
         "constant_feed_path", "paced_path", "MarkWish.state", "advise", "PartModel.distances"}
# The properties of these are places in a text.
NAME_PLACES = {"read_gcode", "program_lines", "write_program"}
MOST_MEMORY = 8 << 30  # of addresses: FreeCAD itself takes one or two
LONGEST = 60  # s, for one call
# Bad values of these are outcomes: (function, argument) and what becomes of them.
TAKES_ANY = {
    ("ProjectedSurface.sample", "points"): "off the faces",
    ("Mask.at", "places"): "0, or what the image has outside",
    ("SurfaceLattice.places", "points"): "NaN: beyond the lattice's end",
    ("Watch", "progress"): "None: never stops",
    ("axes_at", "points"): "air",
    ("dales", "heights"): "not known",
    ("feed_at", "points"): "air",
    ("kinds_at", "points"): "air",
    ("with_turns", "turns"): "NaN: of a rapid",
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
    ("limit_load", "chip"),
    ("limit_load", "force"),
    ("limit_load", "power"),
    ("limit_load", "acceleration"),
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


class Outcomes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = None
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

    @classmethod
    def call(cls, name, **bad):
        """(the InputError or TypeError that the call ends with, or None; what it did that it must not)."""
        function, good = CALLS[name]
        said = "%s(%s)" % (name, ", ".join("%s=%s" % (k, shown(v)) for k, v in bad.items()))
        faulthandler.dump_traceback_later(LONGEST, exit=True, file=cls.real)
        try:
            function(**dict(good, **bad))
        except core.InputError as error:
            nameless = not (error.property and error.remedy)
            return error.with_traceback(None), said + " names nothing" if nameless else ""
        except TypeError as error:
            return error.with_traceback(None), ""
        except BaseException as error:
            return error, "%s: %s: %s" % (said, type(error).__name__, error)
        finally:
            faulthandler.cancel_dump_traceback_later()
        return None, ""

    def outcome(self, name, **bad):
        """The InputError or TypeError that the call ends with, or None. What else it raises is a fault."""
        error, trouble = self.call(name, **bad)
        self.assertEqual(trouble, "")
        return error

    @classmethod
    def of_spoilt(cls):
        """(name, argument, bad value, error, trouble) of every call with one spoilt argument, made once."""
        if cls.made is None:
            cls.made = [
                (name, argument, bad, *cls.call(name, **{argument: bad}))
                for name, (_, good) in CALLS.items()
                for argument, value in good.items()
                for bad in spoilt(argument, value)
            ]
        return cls.made

    def test_good_arguments_are_taken(self):
        for name in CALLS:
            with self.subTest(name):
                self.assertIsNone(self.outcome(name))

    def test_bad_arguments_are_refused_by_name_or_have_an_outcome(self):
        for name, argument, bad, _, trouble in self.of_spoilt():
            with self.subTest(name, argument=argument, value=shown(bad)):
                self.assertEqual(trouble, "")

    def test_plainly_bad_values_are_refused_but_where_a_table_says_why(self):
        taken, silent = {}, set()
        for _, faults, places in TAKEN:
            for place in places.split(", "):
                taken.setdefault(place, set()).update(faults.split())
        for name, argument, bad, error, _ in self.of_spoilt():
            fault = fault_of(bad) if error is None else None
            if fault:
                function = name.split()[0]
                places = (function + " " + argument, "* " + argument)
                place = next((p for p in places if fault in taken.get(p, ())), None)
                silent.add((place, fault))
                with self.subTest(name, argument=argument, fault=fault, value=shown(bad)):
                    self.assertIsNotNone(place, "refuse it, or say in taken_values.py why not")
        stale = {(p, f) for p, faults in taken.items() for f in faults} - silent
        self.assertEqual(stale, set(), "nothing takes these any more")

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

    def test_docstrings_name_what_is_refused(self):
        """All properties that a spoilt call was seen to name, and none where no call was refused."""
        seen = {}
        for name, _, _, error, _ in self.of_spoilt():
            named = seen.setdefault(name.split()[0], set())
            if isinstance(error, core.InputError):
                named.add(error.property)
        for name, (_, good) in CALLS.items():
            for argument, value in good.items():
                for bad in not_finite(value, [NAN, INF]):
                    error = self.outcome(name, **{argument: bad})
                    if isinstance(error, core.InputError):
                        seen.setdefault(name.split()[0], set()).add(error.property)
        for name, named in seen.items():
            claimed = claims(document(name))
            if name not in GO_ON and name not in NAME_PLACES:
                with self.subTest(name):
                    missing = named - claimed - names_given(name)
                    self.assertEqual((missing, bool(named)), (set(), bool(claimed)))

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
    def test_every_function_says_what_it_raises(self):
        for name, function in functions():
            with self.subTest(name):
                kinds = r"\bRaises (nothing|InputError (naming|for)|IndexError|what)"
                self.assertRegex(document(name), kinds)
        self.assertGreater(len(list(functions())), 150)

    def test_a_docstring_without_it_would_be_found(self):
        said = "Some. Raises InputError naming A, `b` or size of c."
        self.assertEqual(claims(said), {"A", "b", "size of c"})
        self.assertEqual(claims("Some. Raises nothing: they are checked later."), set())
        self.assertEqual(claims("Half a sentence."), set())

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


def functions():
    """(name, function) of all functions and methods of the module."""
    for name, value in vars(core).items():
        if inspect.isclass(value) and value.__name__ == name and not issubclass(value, (int, ValueError)):
            for own, method in vars(value).items():
                method = getattr(method, "__func__", method)
                if callable(method) and (own in OPERATORS or not own.startswith("_")):
                    if not (method.__doc__ or "").startswith("Initialize self"):
                        yield "%s.%s" % (name, own), method
        elif callable(value) and not inspect.isclass(value):
            yield name, value


def document(name):
    """The docstring of a function, a method, or a class with how it is made."""
    found = core
    for part in name.split("."):
        found = getattr(found, part)
    made = found.__init__.__doc__ if inspect.isclass(found) else ""
    return " ".join(("%s %s" % (found.__doc__, made)).split())


def claims(text):
    """What a docstring says that InputErrors name."""
    lists = re.findall(r"Raises InputError naming (.*?)(?:\.|:|$)", text)
    return {n.strip("` ") for some in lists for n in re.split(r", | or ", some)}


def names_given(name):
    """What the call itself says that the property is called."""
    good = next(good for n, (_, good) in CALLS.items() if n.split()[0] == name)
    return {good.get("property", "mesh")} if "`property`" in document(name) else set()


def takes_arguments(function):
    signature = (function.__doc__ or "").split("\n")[0]
    inside = signature[signature.find("(") + 1 : signature.rfind(") ->")]
    return bool(inside.replace("self: _patchmill.", "").partition(",")[2]) or (
        "self" not in inside and ":" in inside
    )


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
