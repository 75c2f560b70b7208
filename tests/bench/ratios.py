"""Reads Google Benchmark's console output on stdin, repeats it, and prints every rate as a ratio to the first
benchmark of the program that has a rate of the same name: that one is the peer, or the limit.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
import sys

SCALE = {"": 1.0, "k": 1e3, "M": 1e6, "G": 1e9, "T": 1e12}
RATE = re.compile(r"(items_per_second|[a-z]+/s)=([0-9.]+)([kMGT]?)(?:/s)?(?=\s|$)")


def rates_of(line):
    """{name of the rate: value per second} of one line."""
    return {name: float(value) * SCALE[unit] for name, value, unit in RATE.findall(line)}


def said(ratio):
    """A ratio as it is read best: so many times, or a share."""
    return "%.1f times" % ratio if ratio >= 2.0 else "%.0f %% of" % (100.0 * ratio)


def main(lines):
    first = {}
    found = []
    for line in lines:
        print(line, end="")
        for rate, value in rates_of(line).items():
            name = line.split()[0]
            if rate in first:
                found.append((name, rate, value))
            else:
                first[rate] = (name, value)
    for name, rate, value in found:
        peer, limit = first[rate]
        suffix = "" if rate == "items_per_second" else " in " + rate
        print("%s: %s %s%s" % (name, said(value / limit), peer, suffix))


if __name__ == "__main__":
    main(sys.stdin)
