"""The blocks of code in the pages of docs/ and README.md. As a program, `blocks.py FOLDER` writes the C++
ones for cpp_blocks_test.cpp to include: <page>_<number>.inc, counted from 1, and all.inc, which names them
all; `blocks.py check` fails if a block does not say its language, or a command stands outside of any.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import re
import sys

LANGUAGES = {"python", "cpp", "cmake", "sh", "gcode", "json", "text"}
COMMAND = re.compile(r"    (tools/|cmake |git |python3 |freecadcmd |patchmill |ctest )")
ROOT = pathlib.Path(__file__).resolve().parents[2]


def pages():
    """All pages with code of users, sorted by name."""
    return sorted([*(ROOT / "docs").glob("*.md"), ROOT / "README.md"])


def blocks(text):
    """(language, line of the fence, code) of each fenced block, in its order."""
    found, language = [], None
    for number, line in enumerate(text.split("\n"), 1):
        if not line.lstrip().startswith("```"):
            if language is not None:
                found[-1][2].append(line)
        elif language is None:
            language = line.strip()[3:].strip()
            found.append((language, number, []))
        else:
            language = None
    return [(language, line, "\n".join(code) + "\n") for language, line, code in found]


def of_language(page, language):
    """(line, code) of the page's blocks in one language."""
    return [(line, code) for named, line, code in blocks(page.read_text()) if named == language]


def unmarked(text):
    """The lines at which a block of no known language begins, or a command is only indented."""
    fenced = [line for language, line, _ in blocks(text) if language not in LANGUAGES]
    inside = {n for _, line, code in blocks(text) for n in range(line, line + code.count("\n") + 2)}
    loose = [n for n, line in enumerate(text.split("\n"), 1) if COMMAND.match(line) and n not in inside]
    return sorted(fenced + loose)


def check():
    """Exits with an error if unmarked() finds any, or does not find those that are planted."""
    planted = "```\ncode\n```\n\n    tools/build\n\n```sh\n    tools/test\n```\n"
    found = ["%s:%d" % (page, line) for page in pages() for line in unmarked(page.read_text())]
    if unmarked(planted) != [1, 5] or found:
        sys.exit("blocks of no known language: " + ", ".join(found))


def main():
    if sys.argv[1] == "check":
        return check()
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    names = []
    for page in pages():
        for number, (line, code) in enumerate(of_language(page, "cpp"), 1):
            name = "%s_%d.inc" % (page.stem, number)
            (folder / name).write_text('#line %d "%s"\n%s' % (line + 1, page, code))
            names.append(name)
    (folder / "all.inc").write_text("".join('"%s",\n' % name for name in names))


if __name__ == "__main__":
    main()
