"""Packs a compiled core and the libraries that it needs into a wheel that any FreeCAD of that Python can
load.

    pack.py CORE.so VERSION cp313 FOLDER

The libraries, OpenCASCADE among them, become copies under names that nobody else has, found beside the core;
only those that every Linux has are taken from the system. The copies do not share symbols with the host's
(elf.py, and patchmill.install.core_loader, which loads them). Needs patchelf, readelf, objdump, ldd.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import base64
import glob
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import elf  # noqa: E402
import symbols  # noqa: E402

NAME, FOLDER = "patchmill_core", "patchmill_core.libs"
# Of the system, or of the host: the C and C++ libraries, of which there can be one in a process
OF_THE_SYSTEM = r"(lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+)\.so\.\d+|ld-linux.*|linux-vdso.*)$"
STAMP = (1980, 1, 1, 0, 0, 0)  # the same bytes for the same input
METADATA = """Metadata-Version: 2.1
Name: patchmill-core
Version: %s
Summary: Compiled core of PatchMill, a FreeCAD workbench that mills regular dimple textures
License: LGPL-2.1-or-later
License-File: LICENSE
Requires-Python: ==%s.*
"""
WHEEL = """Wheel-Version: 1.0
Generator: patchmill packaging/wheel/pack.py
Root-Is-Purelib: false
Tag: %s
"""


def own_name(library, file):
    """The name of a library's copy: no other package has it, and another build of the library has another
    one."""
    with open(file, "rb") as stream:
        digest = hashlib.sha256(stream.read()).hexdigest()[:8]
    stem, rest = library.split(".so", 1)
    return "%s-patchmill-%s.so%s" % (stem, digest, rest)


def bundle(core, folder):
    """Copies a core and its libraries into `folder`; returns the library files of the system's package
    manager that were copied."""
    found = {n: p for n, p in elf.found_libraries(core).items() if not re.match(OF_THE_SYSTEM, n)}
    names = {library: own_name(library, path) for library, path in found.items()}
    libraries = os.path.join(folder, FOLDER)
    os.makedirs(libraries)
    copies = [(core, os.path.join(folder, os.path.basename(core)), "$ORIGIN/" + FOLDER)]
    copies += [(path, os.path.join(libraries, names[n]), "$ORIGIN") for n, path in found.items()]
    for source, copy, _ in copies:
        shutil.copyfile(source, copy)
        os.chmod(copy, 0o755)
        subprocess.run(["strip", "--strip-unneeded", copy], check=True)
    defined = set().union(*(symbols.defined_names(copy) for _, copy, _ in copies))
    for source, copy, path in copies:
        symbols.rename(copy, defined)
        edits = [["--force-rpath", "--set-rpath", path]]
        edits += [["--replace-needed", n, names[n]] for n in elf.needed(source) if n in names]
        if source is not core:
            edits.append(["--set-soname", os.path.basename(copy)])
        for edit in edits:  # patchelf 0.14 mixes up the texts of several at once
            subprocess.run(["patchelf", *edit, copy], check=True)
        elf.make_unique_weak(copy)
        require_own(copy, set(names.values()), path)
    return sorted(os.path.realpath(path) for path in found.values())


def require_own(file, names, path):
    """Ends with the reason if a file of the wheel would take a library from where it is not to."""
    foreign = [n for n in elf.needed(file) if n not in names and not re.match(OF_THE_SYSTEM, n)]
    if foreign or elf.search_path(file) != path:
        raise SystemExit("%s: %s, looked for in %s" % (file, ", ".join(foreign), elf.search_path(file)))


def add_licences(sources, folder):
    """The licences of the libraries that are copied, where Debian keeps them."""
    os.makedirs(folder)
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
    shutil.copyfile(os.path.join(root, "LICENSE"), os.path.join(folder, "LICENSE"))
    for file in sources:
        owner = subprocess.run(["dpkg-query", "-S", file], capture_output=True, text=True).stdout
        package = owner.split(":", 1)[0]
        licence = os.path.join("/usr/share/doc", package, "copyright")
        if not package or not os.path.isfile(licence):
            raise SystemExit("%s comes without a licence that could be packed with it" % file)
        shutil.copyfile(licence, os.path.join(folder, package + ".txt"))


def pack(core, version, python, out):
    """The wheel's file name."""
    with tempfile.TemporaryDirectory() as folder:
        sources = bundle(core, folder)
        files = glob.glob(os.path.join(folder, "*.so")) + glob.glob(os.path.join(folder, FOLDER, "*"))
        machine = "manylinux_%d_%d_%s" % (*elf.newest_glibc(files), platform.machine())
        tag = "%s-%s-%s" % (python, python, machine)
        about = os.path.join(folder, "%s-%s.dist-info" % (NAME, version))
        add_licences(sources, os.path.join(about, "licenses"))
        for name, text in (
            ("METADATA", METADATA % (version, re.sub(r"cp(\d)(\d+)", r"\1.\2", python))),
            ("WHEEL", WHEEL % tag),
        ):
            with open(os.path.join(about, name), "w", encoding="utf-8") as file:
                file.write(text)
        os.makedirs(out, exist_ok=True)
        wheel = os.path.join(out, "%s-%s-%s.whl" % (NAME, version, tag))
        zip_with_record(folder, wheel, os.path.join(os.path.basename(about), "RECORD"))
    return wheel


def zip_with_record(folder, wheel, record):
    """A zip file of a folder, with the list of its files and their hashes."""
    names = sorted(
        os.path.relpath(os.path.join(at, name), folder) for at, _, files in os.walk(folder) for name in files
    )
    rows = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in names:
            with open(os.path.join(folder, name), "rb") as file:
                data = file.read()
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode("ascii")
            rows.append("%s,sha256=%s,%d" % (name, digest, len(data)))
            archive.writestr(_entry(name, 0o755 if ".so" in name else 0o644), data)
        archive.writestr(_entry(record, 0o644), "\n".join([*rows, record + ",,", ""]))


def _entry(name, mode):
    entry = zipfile.ZipInfo(name, STAMP)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = (0o100000 | mode) << 16
    return entry


if __name__ == "__main__":
    print(pack(*sys.argv[1:]))
