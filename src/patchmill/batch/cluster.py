"""The same run on the workers of a Dask scheduler, which all see the output folder and the parts.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from typing import Any, Callable, Dict, Iterator, List, Tuple

from patchmill.batch.problem import BatchError
from patchmill.batch.process import Task, make

RETRIES = 5  # of a part whose worker was lost


def on(address: str) -> Callable[[List[Task]], Iterator[Tuple[Task, Dict[str, Any]]]]:
    """A way to make tasks on the workers of the scheduler at `address` (tcp://host:port); yields them as they
    end. A part whose worker is lost is made again by another. Raises BatchError if no scheduler answers.
    """
    try:
        import distributed
    except ImportError as error:
        raise BatchError(
            "--cluster", address, "install Dask distributed (python3-distributed)."
        ) from error

    def each(tasks: List[Task]) -> Iterator[Tuple[Task, Dict[str, Any]]]:
        try:
            client = distributed.Client(address, timeout="10s", set_as_default=False)
        except (OSError, ValueError) as error:
            raise BatchError("--cluster", address, "no scheduler answers there.") from error
        with client:
            futures = client.map(make, tasks, pure=False, retries=RETRIES)
            for future in distributed.as_completed(futures, loop=client.loop):
                yield future.result()

    return each
