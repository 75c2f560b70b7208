"""Tells load from fault. On a busy machine LinuxCNC's task fills the motion queue too slowly, and the planner
brakes: the phase is lost, and nobody's program is to blame.

A check that fails is run again, slower. If both runs moved alike, it was the program: a failure. If they did
not, the first one is unknown; the slower one counts. Where no two runs agree, the check is unknown, which is
no pass: unittest says skipped, and main() ends with the status that ctest shows as "Skipped".

SPDX-License-Identifier: LGPL-2.1-or-later
"""
import contextlib
import contextvars
import functools
import sys
import unittest

import numpy

SKIPPED = 77  # SKIP_RETURN_CODE of tests/controller/CMakeLists.txt
SLOWER = (1.0, 3.0, 10.0)  # of the attempts at a check
SAMPLES = 2000  # along the path
ALIKE, APART = 0.1, 0.02  # of the greatest speed that speeds may differ by; share of samples that may by more


class Unknown(RuntimeError):
    """A run that says nothing about its program: it never began, did not end, or was not fast enough."""


class Attempt:
    """One attempt at a check: how much slower than usual its runs go, and their logs."""

    def __init__(self, slower):
        self.slower, self.logs = slower, []


_CURRENT = contextvars.ContextVar('attempt', default=None)


def slower():
    """How much slower than usual a run is to go now."""
    attempt = _CURRENT.get()
    return attempt.slower if attempt else 1.0


def note(log):
    """Keeps a run's log for the comparison."""
    if _CURRENT.get():
        _CURRENT.get().logs.append(log)


@contextlib.contextmanager
def attempting(attempt):
    token = _CURRENT.set(attempt)
    try:
        yield attempt
    finally:
        _CURRENT.reset(token)


def speed_along(log):
    """Speed at evenly spaced distances along the way of the tool, mm/s. Standing still has no length: how
    long the spindle was waited for makes no difference."""
    step = numpy.linalg.norm(numpy.diff(log.tip, axis=0), axis=1)
    moving = step > 1e-9
    if moving.sum() < 2:
        return numpy.zeros(SAMPLES)
    along = numpy.cumsum(step[moving])
    speed = (step / numpy.diff(log.time))[moving]
    return numpy.interp(numpy.linspace(0.0, along[-1], SAMPLES), along, speed)


def alike(one, other):
    """Whether two runs of a program moved alike."""
    a, b = speed_along(one), speed_along(other)
    greatest = max(a.max(), b.max())
    return bool(numpy.mean(abs(a - b) > ALIKE * greatest) <= APART)


def all_alike(one, other):
    """Whether two attempts made the same runs. Without any log there is nothing that load could have
    changed."""
    return len(one) == len(other) and all(alike(a, b) for a, b in zip(one, other))


def told_from_load(check):
    """A check of a test case that is run again as above. Not to be put around `subTest`, which keeps failures
    to itself."""

    @functools.wraps(check)
    def checked(*arguments, **options):
        before, reason = None, ''
        for factor in SLOWER:
            with attempting(Attempt(factor)) as attempt:
                try:
                    return check(*arguments, **options)
                except Unknown as unknown:
                    reason, before = str(unknown), None
                except AssertionError as failure:
                    if before is not None and all_alike(before, attempt.logs):
                        raise
                    reason, before = str(failure), attempt.logs
                    if not attempt.logs:
                        raise
        said = 'unknown, for no two runs moved alike; the last said: %s' % reason.strip().splitlines()[0]
        print('%s: %s' % (check.__qualname__, said))
        raise unittest.SkipTest(said)

    return checked


def main(**options):
    """unittest.main with an exit status that keeps unknown apart from passed."""
    result = unittest.main(exit=False, **options).result
    if not result.wasSuccessful() or not result.testsRun:
        sys.exit(1)
    sys.exit(SKIPPED if result.skipped else 0)
