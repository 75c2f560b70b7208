"""Reads Google Benchmark's console output on stdin, repeats it, and prints every rate as a ratio to the
program's first benchmark, which is the peer.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
import sys

SCALE = {"": 1.0, "k": 1e3, "M": 1e6, "G": 1e9}

rates = []
for line in sys.stdin:
    print(line, end="")
    found = re.search(r"items_per_second=([0-9.]+)([kMG]?)/s", line)
    if found:
        rates.append((line.split()[0], float(found.group(1)) * SCALE[found.group(2)]))
for name, rate in rates[1:]:
    print("%s: %.1f times %s" % (name, rate / rates[0][1], rates[0][0]))
