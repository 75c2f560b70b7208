"""Benchmarks of two builds in turns, the least time of each: BEFORE AFTER PROGRAM [FILTER [ROUNDS]], such as

    /usr/bin/python3 tests/bench/compare.py ../before/build build texture_bench .

Both builds have been made with -DPATCHMILL_BENCH=ON. Other work on the machine only adds to times, so that
the least of several rounds counts. Of each name that both have: before, after, and the change.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import pathlib
import subprocess
import sys


def times(build, program, only, seconds):
    """{benchmark: CPU time, or real time where it measures that} of one run [ns]."""
    command = [str(pathlib.Path(build, "tests", "bench", program)), "--benchmark_format=json"]
    command += ["--benchmark_filter=" + only, "--benchmark_min_time=%g" % seconds]
    text = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    scale = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    found = {}
    for each in json.loads(text)["benchmarks"]:
        clock = "real_time" if "real_time" in each["name"] else "cpu_time"
        found[each["name"]] = each[clock] * scale[each["time_unit"]]
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
