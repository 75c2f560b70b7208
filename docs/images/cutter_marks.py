# Makes the pictures of docs/cutter-marks.md. Usage:
#   /usr/bin/python3 docs/images/cutter_marks.py BUILD
# where BUILD is a build directory of the core.
# SPDX-License-Identifier: LGPL-2.1-or-later
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "src/patchmill/reports"))  # the compiled part of the package is not needed

import relief_pictures as pictures  # noqa: E402


def read(path):
    with open(path, "rb") as file:
        _, rows, columns, step, x, y = file.readline().split()
        height = np.frombuffer(file.read(), np.float32).reshape(int(rows), int(columns))
    return height.astype(float), float(step), (float(x), float(y))


def simulate(build, folder):
    program = folder / "cutter_marks"
    includes = [f"-I{ROOT / 'src/core'}", f"-I{ROOT / 'tests/core'}", "-isystem", "/usr/include/eigen3"]
    libraries = [str(build / "src/core/libpatchmill_core.a"), "-ltbb", "-lfmt"]
    subprocess.run(["c++", "-std=c++17", "-O2", *includes, str(HERE / "cutter_marks.cpp"),
                    "-o", str(program), *libraries], check=True)
    subprocess.run([str(program), str(folder)], check=True)


def main(build):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        simulate(build, folder)
        names = ["square", "staggered", "drifting"]
        reliefs = [read(folder / f"{n}.relief") for n in names]
        _, step, origin = reliefs[0]
        pictures.save(pictures.side_by_side([r[0] for r in reliefs], names, step, origin, 1.5),
                      HERE / "cutter-marks-arrays.png")
        square = reliefs[0][0]
        pictures.save(pictures.depth_map(square, step, origin, "square array, R 1, f 0.5, p 0.5"),
                      HERE / "cutter-marks-depth.png")
        experiment, fine, corner = read(folder / "experiment.relief")
        pictures.save(pictures.depth_map(experiment, fine, corner, "Xu & Sasahara's path"),
                      HERE / "cutter-marks-xu2016.png")
        runout = read(folder / "runout.relief")[0]
        pictures.save(pictures.cross_section(runout, step, (0.2, 2.0), (5.3, 2.0), origin,
                                             "one flute 5 µm short: two depths along a row",
                                             [(0.0, "flute 0"), (0.005, "flute 1")]),
                      HERE / "cutter-marks-section.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
