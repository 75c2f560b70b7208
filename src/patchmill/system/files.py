"""Files that are there whole: the old one or the new one, whatever happens between. Every file that PatchMill
writes is written here.

    with files.replacing("texture.ngc", "filename") as file:      # binary, to write to
        file.write(b"M2")

It is written without a name, or under one that nobody can foresee, in the folder where it is to be; synced;
given the mode and owner of what it replaces; then put in its place. A name that is a symbolic link goes on
being one: the file is written where it points. What a writer left that was killed in the last moment, between
having a name and being in its place, is removed by the next one in that folder.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import os
import re
import secrets
import stat
import time

from _patchmill import InputError

try:
    import fcntl
except ImportError:  # Windows, where no leftover can be told from a file that is being written
    fcntl = None

FOREIGN = re.compile(r"\.patchmill-[0-9a-f]{24}")
OLD = 60.0  # seconds: a younger one may be about to be locked by who writes it


def name_of(filename, name="filename"):
    """A file's name as text, of a str, bytes or os.PathLike. Raises InputError naming `name`."""
    try:
        return os.fsdecode(filename)
    except TypeError as error:
        raise InputError(name, repr(filename), "give the name of a file.") from error


def require_place(filename, name="filename"):
    """The path at which a file of that name is to be written, links followed. Raises InputError naming `name`
    if it cannot be: no name, no folder, a read-only file, a device, a pipe."""
    asked = name_of(filename, name)
    try:
        path = os.path.realpath(asked)
        there = os.path.lexists(path) and os.stat(path)
        folder = os.path.dirname(path)
        good = asked and os.path.isdir(folder) and os.access(folder, os.W_OK)
    except (OSError, ValueError) as error:
        remedy = "there can be no such file (%s): give another name." % error
        raise InputError(name, repr(asked), remedy) from error
    if not good or os.path.isdir(path) or len(os.fsencode(os.path.basename(path))) > 255:
        raise InputError(name, repr(asked), "name a file in a folder that can be written to.")
    if there and not stat.S_ISREG(there.st_mode):
        raise InputError(name, repr(asked), "it is a device or a pipe, not a file: name another one.")
    if there and not (there.st_mode & 0o222 and os.access(path, os.W_OK)):
        raise InputError(name, repr(asked), "the file is read-only: name another one.")
    return path


@contextlib.contextmanager
def replacing(filename, name="filename"):
    """A binary file whose content takes the place of `filename` when the block ends without an error; else
    nothing is changed and nothing left. Raises InputError naming `name` if it cannot be written."""
    try:
        path = require_place(filename, name)
        _remove_leftovers(os.path.dirname(path))
        file = _unnamed(os.path.dirname(path))
        try:
            with file:
                _lock(file.fileno())
                yield file
                file.flush()
                _like(file.fileno(), path)
                os.fsync(file.fileno())
                _put(file, path)
        finally:
            if isinstance(file.name, str):
                with contextlib.suppress(FileNotFoundError):
                    os.unlink(file.name)
        _sync_folder(os.path.dirname(path))
    except OSError as error:
        remedy = "it cannot be written (%s): give another file." % (error.strerror or error)
        raise InputError(name, repr(name_of(filename, name)), remedy) from error


def write(filename, content, name="filename"):
    """Writes text, as UTF-8, or bytes. As replacing()."""
    with replacing(filename, name) as file:
        file.write(content.encode("utf-8") if isinstance(content, str) else content)


def read_text(filename, name="filename", most=1 << 30, other=None):
    """The text of a file, of at most so many bytes, without a byte order mark; what is no UTF-8 is of the
    encoding `other`, if given. Raises InputError naming `name` if it cannot be read, or is a device or a
    pipe, which might never end."""
    content = read_bytes(filename, name, most)
    if b"\0" in content:
        remedy = "byte %d is zero, as in UTF-16 and in what is no text: save the file as plain text."
        raise InputError(name, repr(name_of(filename, name)), remedy % content.index(0))
    try:
        return _decoded(content, other)
    except UnicodeDecodeError as error:
        remedy = "byte %d is no UTF-8: save the file as UTF-8." % error.start
        raise InputError(name, repr(name_of(filename, name)), remedy) from error


def read_bytes(filename, name="filename", most=1 << 30):
    """What a file of at most so many bytes holds. Raises InputError naming `name` if it cannot be read, or is
    a device or pipe, which might never end."""
    asked = name_of(filename, name)
    with opened(asked, name) as file:
        content = file.read(most + 1)
    if len(content) > most:
        raise InputError(name, repr(asked), "it has more than %d bytes: give a smaller file." % most)
    return content


@contextlib.contextmanager
def opened(filename, name="filename"):
    """A binary file to read from. Raises InputError naming `name` if it cannot be read, or is a device or
    pipe, which might never end."""
    asked = name_of(filename, name)
    remedy = "it is a device or a pipe, not a file: give another one."
    try:
        with _readable(asked, name) as file:
            if stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                yield file
                return
    except OSError as error:
        remedy = "it cannot be read (%s): give another file." % (error.strerror or error)
    raise InputError(name, repr(asked), remedy)


def _readable(asked, name):
    try:
        return open(asked, "rb", opener=_at_once)
    except ValueError as error:
        raise InputError(name, repr(asked), "there can be no such file: give another name.") from error


def _at_once(path, flags):
    """Opens without waiting for whoever writes into a pipe."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _decoded(content, other):
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        if other is None:
            raise
        return content.decode(other)


def _unnamed(folder):
    """An open file in `folder` that has no name; where file systems cannot, one that nobody can foresee."""
    if hasattr(os, "O_TMPFILE") and os.path.isdir("/proc/self/fd"):
        with contextlib.suppress(OSError):
            return open(os.open(folder, os.O_TMPFILE | os.O_RDWR | os.O_CLOEXEC, 0o600), "w+b")
    return open(_foreign_name(folder), "x+b", opener=lambda path, flags: os.open(path, flags, 0o600))


def _foreign_name(folder):
    return os.path.join(folder, ".patchmill-%s" % secrets.token_hex(12))


def _lock(descriptor):
    """Marks a file as being written. False if somebody writes it, or if that cannot be known here."""
    if fcntl is None:
        return False
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


def _remove_leftovers(folder):
    """Files of writers that were killed: nobody holds them. A folder that cannot be listed keeps them."""
    names: list[str] = []
    if fcntl is not None:
        with contextlib.suppress(OSError):
            names = os.listdir(folder)
    for name in names:
        if not FOREIGN.fullmatch(name):
            continue
        path = os.path.join(folder, name)
        with contextlib.suppress(OSError):
            descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
            try:
                found = os.fstat(descriptor)
                old = time.time() - found.st_mtime > OLD
                if stat.S_ISREG(found.st_mode) and old and _lock(descriptor):
                    os.unlink(path)
            finally:
                os.close(descriptor)


def _like(descriptor, path):
    """Mode and owner of the file that is replaced; of a new one as the user's mask has it."""
    try:
        before = os.stat(path)
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        os.fchmod(descriptor, 0o666 & ~mask)
        return
    with contextlib.suppress(PermissionError):  # only root gives files away
        os.fchown(descriptor, before.st_uid, before.st_gid)
    os.fchmod(descriptor, stat.S_IMODE(before.st_mode) & 0o777)


def _put(file, path):
    """Puts the file in its place at once."""
    if isinstance(file.name, str):
        os.replace(file.name, path)
        return
    beside = _foreign_name(os.path.dirname(path))
    root = os.open("/", os.O_RDONLY)  # with a folder given, Python follows the link to the open file
    try:
        os.link("/proc/self/fd/%d" % file.fileno(), beside, src_dir_fd=root, follow_symlinks=True)
        os.replace(beside, path)
    finally:
        os.close(root)
        with contextlib.suppress(FileNotFoundError):
            os.unlink(beside)


def _sync_folder(folder):
    """So that the name lasts, too; where folders cannot be synced, it is done later."""
    with contextlib.suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
