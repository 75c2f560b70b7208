"""Bad values in the place of good arguments of _patchmill's functions, for test_contracts.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
import bound_things as things
import numpy as np

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


def fault_of(value):
    """What is wrong with a bad value, in a word, where it is plainly bad; None where it may as well be good:
    a tiny number, another thing of the same kind, an array of another shape."""
    if value is None:
        return "none"
    if isinstance(value, (str, list, np.ndarray)) and len(value) == 0:
        return "empty"
    if isinstance(value, str):
        return "word"
    if is_vector(value):
        value = value[0] if len(set(value)) == 1 else 1.0
    if isinstance(value, (float, int)) and not isinstance(value, bool):
        if abs(value) >= (1e300 if isinstance(value, float) else 2**31 - 1):
            return "huge"
        return "negative" if value < 0 else "zero" if value == 0 else None
    return None
