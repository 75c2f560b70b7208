"""A logo in dimples: a picture as mask, dark pixels are left out.

    patchmill macro logo.py PART PICTURE OUT

The picture is stretched over the texture's faces; a PNG of some hundred pixels will do.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys

import patchmill

TOOL = {"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413}


def main(part, picture, out):
    os.makedirs(out, exist_ok=True)
    job = patchmill.job(part, tool=TOOL)
    op = patchmill.texture(
        job,
        "largest free-form",
        Spacing=0.5,
        PatchSide=14,
        MaskUse="Leave out",
        MaskImage=os.path.abspath(picture),
    )
    plan = patchmill.recompute(op)
    program = os.path.join(out, "logo.ngc")
    posted = patchmill.post(job, program)
    patchmill.report(posted, program, out)
    for reason, count in sorted(plan.counts.items()):
        if count:
            print("%-10s %d" % (reason, count))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
