"""The text of a LinuxCNC configuration: the .ini file with the files that it includes, and what its HAL files
say of pins. Nothing is run: what a .tcl file or a component works out is not known here.

    found = read("mill.ini")
    found.text("TRAJ", "LINEAR_UNITS"), found.pin("xyzac-trt-kins.y-offset"), found.unread

Format: LinuxCNC's manual, *INI Configuration* and *HAL Basics*.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import re
from dataclasses import dataclass, field

from _patchmill import InputError

from patchmill.system import files

MOST_INCLUDED = 20  # files within files
SECTION = re.compile(r"\[\s*(\w+)\s*\]")
ENTRY = re.compile(r"(\w+)\s*=\s*(.*)")
OF_INI = re.compile(r"\[(\w+)\]\(?(\w+)\)?")  # in a HAL file, the value of an entry
LIBRARY = "LIB:"


@dataclass
class Configuration:
    """`entries`: (section, name) -> texts, in the order of the file. `nets`: name of a signal -> its pins;
    `values`: pin or signal -> text. `unread`: HAL files that are not there or are programs."""

    filename: str
    entries: dict
    nets: dict = field(default_factory=dict)
    values: dict = field(default_factory=dict)
    unread: list = field(default_factory=list)

    def texts(self, section, name):
        """All that an entry says, for it may be there several times."""
        return self.entries.get((section, name), [])

    def text(self, section, name, default=""):
        """What an entry says the last time."""
        return self.texts(section, name)[-1] if self.texts(section, name) else default

    def number(self, section, name):
        """An entry as a number, None where it is not given. Raises InputError naming it."""
        text = self.text(section, name)
        return None if text == "" else self._number("[%s]%s" % (section, name), text)

    def pin(self, name):
        """The number that a pin is set to, itself or through its signal; None where no file says it. Raises
        InputError naming the pin."""
        text = self.values.get(name)
        for signal, pins in self.nets.items():
            if name in pins:
                text = self.values.get(signal, text)
        return None if text is None else self._number(name, text)

    def signal_of(self, pin):
        """Whether a pin is joined to another one."""
        return any(pin in pins and len(pins) > 1 for pins in self.nets.values())

    def _number(self, name, text):
        try:
            return float(text)
        except ValueError as error:
            raise InputError("%s in %s" % (name, self.filename), text, "give a number.") from error


def read(filename):
    """Configuration of an .ini file and of the HAL files beside it. Raises InputError naming filename where
    it cannot be read or is no such file."""
    entries: dict = {}
    _read_entries(filename, entries, [""])
    if ("KINS", "KINEMATICS") not in entries and ("TRAJ", "COORDINATES") not in entries:
        raise InputError("filename", filename, "it is no LinuxCNC configuration: it says nothing of axes.")
    found = Configuration(filename, entries)
    folder = os.path.dirname(os.path.abspath(filename))
    for name in found.texts("HAL", "HALFILE") + found.texts("HAL", "POSTGUI_HALFILE"):
        _read_hal(found, folder, name.split()[0] if name.split() else "")
    for command in found.texts("HAL", "HALCMD"):
        _command(found, command)
    return found


def _lines(text):
    """Lines without comments, empty ones left out; a backslash at the end goes on in the next."""
    for line in text.replace("\\\n", " ").splitlines():
        line = line.strip()
        if line.startswith("#INCLUDE") or (line and line[0] not in "#;"):
            yield line


def _read_entries(filename, entries, section, depth=0):
    """`section`: a list with the name of the one that is being read, for an included file goes on in it."""
    if depth > MOST_INCLUDED:
        raise InputError("filename", filename, "it includes itself.")
    for line in _lines(files.read_text(filename, "filename")):
        if line.startswith("#INCLUDE"):
            inner = os.path.join(os.path.dirname(os.path.abspath(filename)), line.split(None, 1)[-1])
            _read_entries(inner, entries, section, depth + 1)
        elif found := SECTION.match(line):
            section[0] = found.group(1)
        elif found := ENTRY.match(line):
            entries.setdefault((section[0], found.group(1)), []).append(found.group(2).strip())


def _read_hal(found, folder, name):
    path = os.path.join(folder, name)
    if name.startswith(LIBRARY) or not name.endswith(".hal") or not os.path.isfile(path):
        found.unread.append(name)
        return
    for line in _lines(files.read_text(path, "filename")):
        _command(found, line)


def _command(found, line):
    """Takes what a HAL command says of pins; others are left alone."""
    line = OF_INI.sub(lambda entry: found.text(entry.group(1), entry.group(2), entry.group(0)), line)
    words = [word for word in line.partition("#")[0].split() if word not in ("=>", "<=", "<=>")]
    if len(words) >= 3 and words[0] in ("setp", "sets"):
        found.values[words[1]] = words[2]
    elif len(words) >= 3 and words[0] == "net":
        found.nets.setdefault(words[1], []).extend(words[2:])
