"""The output folder of a run: where a part's files are made, and how they appear there, whole.

    OUT/index.html, index.json
    OUT/parts/NAME/            program.ngc, result.json and what else the recipe keeps
    OUT/.work/                 what is being made

A part's folder is made in .work and moved to parts when all of it is there; result.json in it is the ledger's
entry: content hashes of part and recipe, and the version. Links in the output folder are refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import errno
import fcntl
import json
import os
import shutil
import tempfile
from typing import Any, Dict, Optional

from _patchmill import InputError

from patchmill.batch.problem import BatchError
from patchmill.system import files

OLD = ".old"  # in .work: parts that are being replaced


class OutputFolder:
    """An output folder, made if it is not there, that one run at a time holds. Use it with `with`. Raises
    BatchError if it cannot be written to, is held by another run, or has links in it."""

    def __init__(self, path: str) -> None:
        self.path = os.path.abspath(path)
        self._lock: Optional[int] = None

    def __enter__(self) -> "OutputFolder":
        try:
            os.makedirs(self.path, exist_ok=True)
            for name in ("parts", ".work"):
                self._own_folder(name)
            self._hold()
        except OSError as error:
            raise self._refused(error) from error
        self._put_back()
        work = os.path.join(self.path, ".work")
        for name in os.listdir(work):  # of runs that were ended
            shutil.rmtree(os.path.join(work, name), ignore_errors=True)
        return self

    def _put_back(self) -> None:
        """Parts whose old folder was taken away, and then no new one came in its place."""
        old = os.path.join(self.path, ".work", OLD)
        for name in os.listdir(old) if os.path.isdir(old) else ():
            if not os.path.lexists(os.path.join(self.path, "parts", name)):
                os.rename(os.path.join(old, name), os.path.join(self.path, "parts", name))

    def __exit__(self, *ended: Any) -> None:
        self._put_back()
        shutil.rmtree(os.path.join(self.path, ".work"), ignore_errors=True)
        if self._lock is not None:
            os.close(self._lock)
        try:
            os.unlink(os.path.join(self.path, ".lock"))
        except FileNotFoundError:
            pass

    def _own_folder(self, name: str) -> None:
        path = os.path.join(self.path, name)
        self._refuse_link(path)
        os.makedirs(path, exist_ok=True)

    @staticmethod
    def _refuse_link(path: str) -> None:
        if os.path.islink(path):
            raise BatchError("output folder", path, "it is a link: take it away.")

    def _hold(self) -> None:
        name = os.path.join(self.path, ".lock")
        self._refuse_link(name)
        self._lock = os.open(name, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC, 0o644)
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in (errno.EAGAIN, errno.EACCES):
                remedy = "another run writes into it: wait, or give another folder."
                raise BatchError("output folder", self.path, remedy) from error
            raise

    def part_folder(self, name: str) -> str:
        """Where the files of a part are, or will be. Raises BatchError if it is a link."""
        path = os.path.join(self.path, "parts", name)
        self._refuse_link(path)
        return path

    def working_folder(self, name: str) -> str:
        """A new folder for a part that is being made. Raises BatchError if there can be none."""
        try:
            return tempfile.mkdtemp(prefix=name[:40] + "-", dir=os.path.join(self.path, ".work"))
        except OSError as error:
            raise self._refused(error) from error

    def known(self, name: str, key: str) -> Optional[Dict[str, Any]]:
        """The result of a part that was finished under the same `key` and whose files are all there, or
        None."""
        folder = self.part_folder(name)
        try:
            result: Dict[str, Any] = json.loads(files.read_text(os.path.join(folder, "result.json")))
        except (InputError, ValueError):
            return None
        there = all(os.path.isfile(os.path.join(folder, f)) for f in result.get("files", []))
        return result if result.get("key") == key and there else None

    def keep(self, name: str, working: str, result: Dict[str, Any]) -> None:
        """Moves a finished part's folder to its place, with result.json in it. Raises BatchError if it cannot
        be: what was there before is there again."""
        folder = self.part_folder(name)
        aside = os.path.join(self.path, ".work", OLD, name)
        try:
            files.write(os.path.join(working, "result.json"), json.dumps(result, indent=1, sort_keys=True))
            if os.path.lexists(folder):
                os.makedirs(os.path.dirname(aside), exist_ok=True)
                shutil.rmtree(aside, ignore_errors=True)
                os.rename(folder, aside)
            os.rename(working, folder)
        except InputError as error:
            raise BatchError("output folder", folder, error.remedy) from error
        except OSError as error:
            raise self._refused(error) from error

    def write(self, name: str, text: str) -> None:
        """Writes a file of the run whole. Raises BatchError if it cannot be."""
        path = os.path.join(self.path, name)
        self._refuse_link(path)
        try:
            files.write(path, text)
        except InputError as error:
            raise BatchError("output folder", path, error.remedy) from error

    def _refused(self, error: OSError) -> BatchError:
        return BatchError("output folder", self.path, "%s." % (error.strerror or error))
