"""In which order the dimples of a ball are milled: runs along neighbours, from the rim up.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import numpy as np


def runs(points, pairs, up):
    """(order, run): numbers of all unit vectors in milling order, and the number of the run each is in, from
    0. A run goes from neighbour to neighbour (`pairs`: (m, 2) numbers); the next one is of those left that
    are reached from fewest others, then the lowest along `up`. A run begins at the lowest that is left."""
    around: list = [[] for _ in points]
    for i, j in pairs.tolist():
        around[i].append(j)
        around[j].append(i)
    heights = np.round(points @ up, 9)
    left = set(range(len(points)))
    order, run, number, at = [], [], -1, None
    while left:
        ways: list = [] if at is None else [j for j in around[at] if j in left]
        if ways:
            at = min(ways, key=lambda j: (sum(k in left for k in around[j]), heights[j], j))
        else:
            number, at = number + 1, min(left, key=lambda j: (heights[j], j))
        left.remove(at)
        order.append(at)
        run.append(number)
    return np.array(order, dtype=int), np.array(run, dtype=int)
