"""How much memory there is for a job, so that what it will take can be refused before it is taken.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import math
import resource

from _patchmill import InputError


def available():
    """Bytes that this process can still take: what the system has free, its control group and its own limit
    allow; infinite if none of them is known."""
    free = _meminfo("MemAvailable") + _meminfo("SwapFree", 0.0)
    with contextlib.suppress(OSError, ValueError):
        with open("/sys/fs/cgroup/memory.max", encoding="ascii") as most:
            limit = most.read().strip()
        with open("/sys/fs/cgroup/memory.current", encoding="ascii") as now:
            free = min(free, math.inf if limit == "max" else float(limit) - float(now.read()))
    own_limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    if own_limit != resource.RLIM_INFINITY:
        with contextlib.suppress(OSError, ValueError):
            with open("/proc/self/statm", encoding="ascii") as own:
                free = min(free, own_limit - float(own.read().split()[0]) * resource.getpagesize())
    return max(0.0, free)


def _meminfo(word, default=math.inf):
    """Bytes of a line of /proc/meminfo."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        with open("/proc/meminfo", encoding="ascii") as lines:
            for line in lines:
                if line.startswith(word + ":"):
                    return 1024.0 * float(line.split()[1])
    return default


def require(needed, name, value, remedy):
    """Raises InputError naming `name` if so many bytes are more than are available; `remedy` says what takes
    less."""
    free = available()
    if needed > free:
        text = "it would take %.3g GB of memory, and %.3g GB are free: %s"
        raise InputError(name, value, text % (needed / 1e9, free / 1e9, remedy))
