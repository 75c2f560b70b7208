"""Gives the C++ symbols of a set of ELF files names of their own, so that no other copy of the same libraries
in the process can take their place, whoever loads it and however: `_ZN6gp_PntC1Ev` becomes `_YN6gp_PntC1Ev`.

A name keeps its length, so that it is changed where it stands. Its hash changes, and with it its place: the
loader finds a symbol through a table of hashes (.gnu.hash), to which the order of the symbols belongs, and
that is made anew: U. Drepper, How To Write Shared Libraries, 2011, section 1.5; relocations and versions
follow the symbols.
ELF-64, little-endian.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import struct

SYMBOLS, RELOCATIONS, HASHES, VERSIONS = 11, 4, 0x6FFFFFF6, 0x6FFFFFFF  # kinds of sections
ENTRY, RELOCATION = 24, 24  # bytes


class Elf:
    """An ELF file's bytes, and where in them the parts are that name symbols."""

    def __init__(self, data):
        self.data = data
        if data[:6] != b"\x7fELF\x02\x01":
            raise ValueError("no little-endian ELF-64 file")
        (table,) = struct.unpack_from("<Q", data, 40)
        size, count = struct.unpack_from("<HH", data, 58)
        self.sections = []
        for number in range(count):
            _, kind, _, _, offset, length, link = struct.unpack_from("<IIQQQQI", data, table + number * size)
            self.sections.append((kind, offset, length, link))
        self.number = next(n for n, s in enumerate(self.sections) if s[0] == SYMBOLS)
        _, self.symbols, length, strings = self.sections[self.number]
        self.count = length // ENTRY
        self.strings = self.sections[strings][1]

    def part(self, kind):
        """Offset of the one section of a kind."""
        return next(s[1] for s in self.sections if s[0] == kind)

    def name_at(self, number):
        """Offset of a symbol's name."""
        return self.strings + struct.unpack_from("<I", self.data, self.symbols + number * ENTRY)[0]

    def name(self, number):
        at = self.name_at(number)
        return bytes(self.data[at : self.data.index(0, at)])

    def defined(self, number):
        return struct.unpack_from("<H", self.data, self.symbols + number * ENTRY + 6)[0] != 0


def own(name):
    """The new name of a symbol."""
    return b"_Y" + name[2:]


def defined_names(file):
    """The C++ names that a file defines for others."""
    with open(file, "rb") as stream:
        elf = Elf(bytearray(stream.read()))
    return {elf.name(n) for n in range(elf.count) if elf.defined(n) and elf.name(n).startswith(b"_Z")}


def rename(file, names):
    """Renames those of a file's symbols that are in `names`, defined there or asked for; returns how many."""
    with open(file, "rb") as stream:
        elf = Elf(bytearray(stream.read()))
    before = [elf.name(n) for n in range(elf.count)]
    wanted = [own(name) if name in names else name for name in before]
    for number, name in enumerate(wanted):
        at = elf.name_at(number)
        elf.data[at : at + len(name)] = name
    # a name may be the end of another, and stand in the file once
    if [elf.name(n) for n in range(elf.count)] != wanted:
        raise SystemExit("%s: names of symbols share their bytes" % file)
    _sort(elf, wanted)
    with open(file, "wb") as stream:
        stream.write(elf.data)
    return sum(a != b for a, b in zip(before, wanted))


def hashed(name):
    value = 5381
    for byte in name:
        value = (33 * value + byte) & 0xFFFFFFFF
    return value


def _sort(elf, names):
    """Puts the symbols into the order of their new hashes, and writes the table of hashes."""
    table = elf.part(HASHES)
    buckets, first, words, shift = struct.unpack_from("<IIII", elf.data, table)
    hashes = {n: hashed(names[n]) for n in range(first, elf.count)}
    order = list(range(first)) + sorted(hashes, key=lambda n: hashes[n] % buckets)
    _move(elf, order)
    bloom, heads, chain = [0] * words, [0] * buckets, [0] * (elf.count - first)
    for place in range(first, elf.count):
        value = hashes[order[place]]
        bloom[value // 64 % words] |= 1 << value % 64 | 1 << (value >> shift) % 64
        bucket = value % buckets
        heads[bucket] = heads[bucket] or place
        last = place + 1 == elf.count or hashes[order[place + 1]] % buckets != bucket
        chain[place - first] = value & ~1 | last
    at = table + 16
    struct.pack_into("<%dQ" % words, elf.data, at, *bloom)
    struct.pack_into("<%dI" % buckets, elf.data, at + 8 * words, *heads)
    struct.pack_into("<%dI" % len(chain), elf.data, at + 8 * words + 4 * buckets, *chain)


def _move(elf, order):
    """The symbols in a new order, {new place: old place}, with their versions and whatever refers to them."""
    for offset, size in ((elf.symbols, ENTRY), (elf.part(VERSIONS), 2)):
        old = bytes(elf.data[offset : offset + size * elf.count])
        new = b"".join(old[size * n : size * n + size] for n in order)
        elf.data[offset : offset + len(new)] = new
    place = {old: new for new, old in enumerate(order)}
    for kind, offset, length, link in elf.sections:
        if kind != RELOCATIONS or link != elf.number:
            continue
        for at in range(offset + 8, offset + length, RELOCATION):
            kind_of, symbol = struct.unpack_from("<II", elf.data, at)
            struct.pack_into("<II", elf.data, at, kind_of, place[symbol])
