"""The xu2016 recipe as a module, for tests; and a small, quick version of its job.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Resources" / "recipes" / "xu2016"
STEP = str(FOLDER / "block.step")
sys.path.insert(0, str(FOLDER))

import make_part  # noqa: E402
import run  # noqa: E402

__all__ = ["ROOT", "STEP", "make_part", "run", "small_job"]


def small_job(decimals=3, direction="Forward", name="small"):
    """Document, job and operation of 2 x 2 patches of 6 x 6 dimples, not yet recomputed."""
    document, part = run.make_document(STEP, name)
    job, operation = run.make_job(part, decimals, direction)
    operation.PatchSide = 6
    operation.PatchesX = operation.PatchesY = 2
    operation.AutoOrigin = False
    operation.Origin = (-15, -10, 0)
    return document, job, operation
