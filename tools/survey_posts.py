"""Posts a few moves with every post-processor of the FreeCAD that runs this, and prints a table of what
became of the words that textures need (docs/posts.md). Needs no compiled module:

    freecadcmd -c "exec(open('tools/survey_posts.py').read())" </dev/null

in the project's root; elsewhere SURVEY_SCRIPT names this file and SURVEY_SOURCE the folder src/patchmill.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import subprocess
import sys
import types

SCRIPT = os.environ.get("SURVEY_SCRIPT", os.path.join(os.getcwd(), "tools", "survey_posts.py"))
SOURCE = os.environ.get("SURVEY_SOURCE", os.path.join(os.getcwd(), "src", "patchmill"))


def main():
    import FreeCAD

    package = types.ModuleType("patchmill")  # the package without what its __init__ wants: the compiled core
    package.__path__ = [SOURCE]
    sys.modules["patchmill"] = package
    from patchmill.freecad import host, post_probe as probe

    folders = [os.path.dirname(host.PathUtils.__file__)]
    folders.append(os.path.join(os.path.dirname(folders[0]), "Path", "Post", "scripts"))
    folders.append(os.path.join(folders[0], "post"))
    posts = set()
    for folder in folders:
        if os.path.isdir(folder):
            posts.update(f[: -len("_post.py")] for f in os.listdir(folder) if f.endswith("_post.py"))
    only = os.environ.get("SURVEY_ONLY")
    if only:
        return print(row(only, probe.probe(host, only)))
    print("## FreeCAD %s\n" % ".".join(FreeCAD.Version()[:3]))
    print("| post | C | C-371.5 | K | F under G93 | C with --inches | decimals | TCP words |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |", flush=True)
    for post in sorted(posts):
        print(in_a_process_of_its_own(post), flush=True)


def row(post, survey):
    cells = survey.as_row()[:-1]
    if survey.fault:
        cells = ["fails: %s" % survey.fault.replace("|", "/")] + [""] * 6
    return "| %s | %s |" % (post, " | ".join(cells))


def in_a_process_of_its_own(post):
    """The row of one post: a post that fails would leave its state to the next one."""
    command = "exec(open(%r).read())" % SCRIPT
    done = subprocess.run(
        [os.environ.get("FREECADCMD", "freecadcmd"), "-c", command],
        env=dict(os.environ, SURVEY_ONLY=post),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
    )
    rows = [line for line in done.stdout.splitlines() if "| %s |" % post in line]
    if not rows:
        return "| %s | fails: no answer | | | | | | |" % post
    return rows[-1][rows[-1].index("| %s |" % post) :]


main()
