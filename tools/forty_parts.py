"""tools/forty_parts.py kill | speed [-j N]: forty parts of Debian's packages in one run.

kill: a run that is left alone, and one that is killed with SIGKILL at ten random moments and resumed each
time: the indexes are the same but for times, three parts are named as they should be, the exit status is 1.
speed: parts per minute of `patchmill run` beside a loop that starts FreeCADCmd for each part by hand, and how
much longer a part takes; FreeCAD's own start apart.

The parts are files of occt-misc and freecad-common, which tools/install-deps installs; one file is cut off in
the middle, one face is too large for the memory of a part, one takes too long.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import glob
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MODULE = os.path.join(ROOT, "build", "Mod", "PatchMill")
sys.path.insert(0, MODULE)

from patchmill.batch import index  # noqa: E402

OCCT = "/usr/share/opencascade/data"
IDF = "/usr/share/freecad/Mod/Idf/Idflibs"
PATTERNS = (OCCT + "/occ/*.brep", OCCT + "/step/*.step", OCCT + "/iges/*.iges", IDF + "/*.stp")
# no face, or too near the limits
UNSUITED = "edge Bottom CrankArm Room terrain MODERN_Table_1 MODERN_Cooker_1 shell1 Top Pump_TopCover".split()
TOO = {"large": 1500.0, "long": 140.0}  # side of a square [mm]
PARTS, KILLS = 40, 10
SECONDS, MEMORY_MIB = 20, 1500
THREE = {"broken": "refused", "large": "memory", "long": "time"}
RECIPE = {
    "recipe": 1,
    "name": "forty",
    "parts": ["parts"],
    "tool": {"diameter": 1.0, "flutes": 2, "speed": 1000, "feed": 434.413},
    "machine": "table-table-ac",  # most of the parts are flat: their tops are milled with the tool inclined
    "operations": [
        {
            "texture": "Curved",
            "faces": {"normal": [0, 0, 1], "within": 30},
            "properties": {
                "Spacing": 0.4,
                "PatchSide": 4,
                "FixedAxis": [0.25, 0.1, 1],
                "PostUnheld": True,
                "PostGouging": True,
            },
        }
    ],
    "outputs": ["picture"],
    "limits": {"seconds": SECONDS, "memory_mib": MEMORY_MIB},
}


def _stem(file):
    return os.path.splitext(os.path.basename(file))[0]


def prepare(folder):
    """Copies the parts into a folder, writes the recipe beside them, returns its name."""
    parts = os.path.join(folder, "parts")
    os.mkdir(parts)
    found = sorted(f for p in PATTERNS for f in glob.glob(p) if _stem(f) not in UNSUITED)
    for file in found[: PARTS - len(THREE)]:
        shutil.copy(file, parts)
    if len(os.listdir(parts)) != PARTS - len(THREE):
        sys.exit("only %d parts: run tools/install-deps" % len(found))
    with open(os.path.join(OCCT, "step", "screw.step"), "rb") as file:
        whole = file.read()
    with open(os.path.join(parts, "broken.step"), "wb") as file:
        file.write(whole[: len(whole) // 2])
    for name, side in TOO.items():
        file = os.path.join(parts, name + ".brep")
        macro = "import Part; Part.makeBox(%g, %g, 5).exportBrep(%r)" % (side, side, file)
        subprocess.run(["freecadcmd", "-c", macro], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    recipe = os.path.join(folder, "forty.json")
    with open(recipe, "w", encoding="utf-8") as file:
        json.dump(RECIPE, file)
    return recipe


def start(recipe, out, jobs, *words):
    """The command as a process."""
    arguments = [sys.executable, "-m", "patchmill", "run", recipe, "-o", out, "-j", str(jobs), *words]
    return subprocess.Popen(
        arguments, env=dict(os.environ, PYTHONPATH=MODULE), stdout=subprocess.DEVNULL
    )


def finished(recipe, out, jobs, *words):
    """(exit status, index) of a run that is left alone."""
    status = start(recipe, out, jobs, *words).wait()
    with open(os.path.join(out, "index.json"), encoding="utf-8") as file:
        return status, json.load(file)


def kill(folder, jobs):
    """See above; returns the exit status."""
    recipe = prepare(folder)
    begin = time.monotonic()
    status, whole = finished(recipe, os.path.join(folder, "whole"), jobs)
    seconds = time.monotonic() - begin
    killed = os.path.join(folder, "killed")
    chance = random.Random(4)
    for number in range(KILLS):
        process = start(recipe, killed, jobs, "--resume")
        time.sleep(chance.uniform(0.0, 1.5 * seconds / KILLS))
        process.send_signal(signal.SIGKILL)
        process.wait()
        there = os.path.join(killed, "parts")
        done = len(os.listdir(there)) if os.path.isdir(there) else 0
        print("killed %d times, %d parts are finished" % (number + 1, done), flush=True)
    again, resumed = finished(recipe, killed, jobs, "--resume")
    same = index.without_times(whole) == index.without_times(resumed)
    said = {p["name"]: p["status"] for p in whole["parts"]}
    three = {name: said.get(name) for name in THREE}
    print("%d parts, %.0f s; exit status %d, resumed %d" % (len(said), seconds, status, again))
    print("index the same but for times: %s" % ("yes" if same else "NO"))
    print("the three: %s" % three)
    for part in whole["parts"]:
        print("  %-26s %-8s %s" % (part["name"], part["status"], part.get("reason", part.get("dimples"))))
    return int(not (same and three == THREE and (status, again) == (1, 1)))


def by_hand(recipe, out):
    """Seconds of a loop over the parts that starts FreeCADCmd for each, with a macro of a few lines."""
    os.makedirs(out)
    op = RECIPE["operations"][0]
    given = RECIPE["tool"], RECIPE["machine"], op["faces"], op["properties"]
    begin = time.monotonic()
    folder = os.path.join(os.path.dirname(recipe), "parts")
    for name in sorted(os.listdir(folder)):
        if os.path.splitext(name)[0] in THREE:
            continue
        program = os.path.join(out, name + ".ngc")
        macro = (
            "import patchmill; job = patchmill.job(%r, tool=%r, machine=%r); "
            "op = patchmill.texture(job, %r, **%r); patchmill.recompute(op); patchmill.post(job, %r)"
            % (os.path.join(folder, name), *given, program)
        )
        command = ["freecadcmd", "-c", macro, "-M", MODULE]
        silent = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        subprocess.run(command, timeout=SECONDS, **silent)
    return time.monotonic() - begin


def starts(count):
    """Mean seconds of FreeCADCmd that does nothing."""
    begin = time.monotonic()
    for _ in range(count):
        command = ["freecadcmd", "-c", "import Part, Path", "-M", MODULE]
        subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    return (time.monotonic() - begin) / count


def speed(folder, jobs):
    """See above; the three that have no program are left out of both. Returns the exit status: 1 if one way
    made other programs than the other."""
    recipe = prepare(folder)
    for name in THREE:
        os.unlink(glob.glob(os.path.join(folder, "parts", name + ".*"))[0])
    with open(recipe, "w", encoding="utf-8") as file:
        json.dump(dict(RECIPE, outputs=[]), file)
    count = PARTS - len(THREE)
    rows = []
    for said, run in (
        ("patchmill run -j 1", lambda: finished(recipe, os.path.join(folder, "one"), 1)),
        ("FreeCADCmd by hand", lambda: by_hand(recipe, os.path.join(folder, "hand"))),
        ("patchmill run -j %d" % jobs, lambda: finished(recipe, os.path.join(folder, "more"), jobs)),
    ):
        begin = time.monotonic()
        run()
        rows.append((said, time.monotonic() - begin))
        print("%-20s %6.1f s, %5.1f parts a minute" % (*rows[-1], 60.0 * count / rows[-1][1]), flush=True)
    made = [len(glob.glob(os.path.join(folder, n))) for n in ("one/parts/*/*.ngc", "hand/*.ngc")]
    print("programs: %d by patchmill run, %d by hand" % tuple(made))
    print("overhead of patchmill run: %.2f s a part" % ((rows[0][1] - rows[1][1]) / count))
    print("FreeCAD's own start: %.2f s a part" % starts(5))
    return int(made[0] != made[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=("kill", "speed"))
    parser.add_argument("-j", "--jobs", type=int, default=2)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="forty-") as folder:
        return {"kill": kill, "speed": speed}[options.what](folder, options.jobs)


if __name__ == "__main__":
    sys.exit(main())
