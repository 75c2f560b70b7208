"""Benchmarks of two builds in turns, the least time of each: BEFORE AFTER PROGRAM [FILTER [ROUNDS]], such as

    /usr/bin/python3 tests/bench/compare.py ../before/build build texture_bench .

Both builds have been made with -DPATCHMILL_BENCH=ON. Other work on the machine only adds to times, so that
the least of several rounds counts. Of each name that both have: before, after, and the change.

The C library is told to keep what it once had, and each benchmark is repeated: what a virtual machine's host
takes to supply memory (up to a second for a gigabyte, the more the larger the pages) is not the program's.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import pathlib
import subprocess
import sys

KEEP = {
    "MALLOC_MMAP_THRESHOLD_": str(8 << 30),
    "MALLOC_TRIM_THRESHOLD_": str(16 << 30),
    "MALLOC_TOP_PAD_": str(1 << 30),
}


def times(build, program, only, seconds):
    """{benchmark: least CPU time, or real time where it measures that, of one run's repetitions [ns]}."""
    command = [str(pathlib.Path(build, "tests", "bench", program)), "--benchmark_format=json"]
    command += ["--benchmark_filter=" + only, "--benchmark_min_time=%g" % seconds]
    command += ["--benchmark_repetitions=3"]
    text = subprocess.run(
        command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env={**os.environ, **KEEP}
    ).stdout
    scale = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    found = {}
    for each in json.loads(text)["benchmarks"]:
        if each["run_type"] != "iteration":
            continue  # a mean of them
        name = each["name"]
        took = each["real_time" if "real_time" in name else "cpu_time"] * scale[each["time_unit"]]
        found[name] = min(took, found.get(name, took))
    return found


def main(before, after, program, only=".", rounds="3"):
    least = {before: {}, after: {}}
    for _ in range(int(rounds)):
        for build in (before, after):
            for name, took in times(build, program, only, 0.3).items():
                least[build][name] = min(took, least[build].get(name, took))
    for name in sorted(set(least[before]) & set(least[after])):
        old, new = least[before][name], least[after][name]
        print("%-50s %12.4g ms %12.4g ms %+6.1f %%" % (name, old / 1e6, new / 1e6, 100.0 * (new / old - 1.0)))


main(*sys.argv[1:])
