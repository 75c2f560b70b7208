"""What a wheel needs of ELF files: the libraries that one names, the newest symbol version of the C library
that it asks for, and the binding of its unique symbols.

A symbol that is bound as GNU unique is one for the whole process, whatever the scope that a library was
loaded in.
Two versions of OpenCASCADE would share such ones; bound as weak, each keeps its own. ELF-64, little-endian.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
import struct
import subprocess

UNIQUE, WEAK = 10, 2
DYNAMIC_SYMBOLS = 11  # SHT_DYNSYM
SYMBOL_BYTES = 24


def needed(file):
    """Names of the libraries that an ELF file asks for itself."""
    text = subprocess.run(["readelf", "-d", file], capture_output=True, text=True, check=True).stdout
    return re.findall(r"\(NEEDED\)\s+Shared library: \[(.*)\]", text)


def search_path(file):
    """Where an ELF file wants its libraries to be looked for first; '' if it does not say."""
    text = subprocess.run(["readelf", "-d", file], capture_output=True, text=True, check=True).stdout
    return "".join(re.findall(r"\((?:RPATH|RUNPATH)\)\s+Library \w+: \[(.*)\]", text))


def found_libraries(file):
    """{name: path} of all the libraries that the loader would take for a file, directly or not."""
    text = subprocess.run(["ldd", file], capture_output=True, text=True, check=True).stdout
    missing = re.findall(r"(\S+) => not found", text)
    if missing:
        raise SystemExit("%s needs %s, which is missing" % (file, ", ".join(missing)))
    return dict(re.findall(r"(\S+) => (\S+) \(0x", text))


def newest_glibc(files):
    """The newest GLIBC_x.y that any of the files asks for, a tuple of two numbers."""
    newest = (2, 0)
    for file in files:
        text = subprocess.run(["objdump", "-T", file], capture_output=True, text=True, check=True).stdout
        for major, minor in re.findall(r"\(?GLIBC_(\d+)\.(\d+)", text):
            newest = max(newest, (int(major), int(minor)))
    return newest


def dynamic_symbols(data):
    """(offset of the entry, binding, whether it is defined) of each dynamic symbol of an ELF file's bytes."""
    if data[:6] != b"\x7fELF\x02\x01":
        raise ValueError("no little-endian ELF-64 file")
    (table,) = struct.unpack_from("<Q", data, 40)
    size, count = struct.unpack_from("<HH", data, 58)
    for number in range(count):
        _, kind, _, _, offset, length = struct.unpack_from("<IIQQQQ", data, table + number * size)
        if kind != DYNAMIC_SYMBOLS:
            continue
        for entry in range(offset, offset + length, SYMBOL_BYTES):
            (section,) = struct.unpack_from("<H", data, entry + 6)
            yield entry, data[entry + 4] >> 4, section != 0


def make_unique_weak(file):
    """Binds the unique symbols of a file as weak; returns how many there were."""
    with open(file, "rb") as stream:
        data = bytearray(stream.read())
    changed = 0
    for entry, binding, _ in list(dynamic_symbols(data)):
        if binding == UNIQUE:
            data[entry + 4] = WEAK << 4 | data[entry + 4] & 15
            changed += 1
    with open(file, "wb") as stream:
        stream.write(data)
    return changed
