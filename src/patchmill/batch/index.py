"""The index of a run: index.json with a published schema, and index.html, one file with its pictures in it.

Two runs of the same parts, recipe and version give the same index.json but for the values under `run`.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import base64
import glob
import html
import json
import os
from typing import Any, Dict, Iterator, List, Tuple

import patchmill
from patchmill.batch.outputs import OutputFolder
from patchmill.batch.recipe import Recipe

HIDDEN = ("key", "files")

_STYLE = """
body { font: 15px/1.5 sans-serif; color: #222; max-width: 72em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; width: 100% } th { text-align: left; color: #555; font-weight: normal }
th, td { padding: .3em 1em .3em 0; border-bottom: 1px solid #ddd; vertical-align: top }
img { max-width: 22em; max-height: 12em } .done { color: #1a6b1a } .failed { color: #a31515 }
"""


Results = Dict[str, Dict[str, Any]]  # by the part's name


def failed(results: Results) -> List[str]:
    """Names of the parts that have no program."""
    return [name for name, result in results.items() if result["status"] != "done"]


def data(recipe: Recipe, results: Results) -> Dict[str, Any]:
    """What index.json holds (Resources/schemas/index.schema.json). Lengths in mm, times in seconds, angles in
    degrees."""
    parts = [
        dict({k: v for k, v in result.items() if k not in HIDDEN}, name=name)
        for name, result in results.items()
    ]
    return {
        "index": 1,
        "patchmill": patchmill.__version__,
        "recipe": recipe.data.get("name", ""),
        "recipe_sha256": recipe.digest,
        "parts": parts,
        "done": len(parts) - len(failed(results)),
        "failed": failed(results),
    }


def write(recipe: Recipe, results: Results, out: OutputFolder) -> None:
    """Writes index.json and index.html into the output folder."""
    index = data(recipe, results)
    out.write("index.json", json.dumps(index, indent=1, sort_keys=True) + "\n")
    out.write("index.html", _page(index, out))


def without_times(index: Dict[str, Any]) -> Dict[str, Any]:
    """An index without what differs from run to run."""
    parts = [{k: v for k, v in part.items() if k != "run"} for part in index["parts"]]
    return dict(index, parts=parts)


def _page(index: Dict[str, Any], out: OutputFolder) -> str:
    title = html.escape(index["recipe"] or "PatchMill")
    rows = "\n".join(_row(part, out) for part in index["parts"])
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>%s</title>'
        "<style>%s</style></head><body><h1>%s</h1><p>%d of %d parts have a program. PatchMill %s.</p>"
        "<table><tr><th>Part</th><th>Picture</th><th>Result</th></tr>\n%s</table></body></html>\n"
        % (
            title,
            _STYLE,
            title,
            index["done"],
            len(index["parts"]),
            html.escape(index["patchmill"]),
            rows,
        )
    )


def _row(part: Dict[str, Any], out: OutputFolder) -> str:
    done = part["status"] == "done"
    facts = "".join("<div>%s: %s</div>" % (html.escape(k), html.escape(v)) for k, v in _facts(part))
    return '<tr><td>%s<br><span class="%s">%s</span></td><td>%s</td><td>%s</td></tr>' % (
        html.escape(part["name"]),
        "done" if done else "failed",
        html.escape(part["status"]),
        _picture(part["name"], out),
        facts,
    )


def _facts(part: Dict[str, Any]) -> Iterator[Tuple[str, str]]:
    if part["status"] != "done":
        yield "Reason", part["reason"]
        return
    yield "Dimples", "{:,}".format(part["dimples"])
    yield "Time", "%d min %02d s" % divmod(round(part["program_seconds"]), 60)
    for texture in part["textures"]:
        if texture["left_out"]:
            left = ", ".join("%s: %d" % item for item in sorted(texture["left_out"].items()))
            yield "%s, left out" % texture["name"], left
        yield "%s, machine" % texture["name"], texture["verdict"]
        yield (
            "%s, phase error" % texture["name"],
            "largest %(phase_error_max_degrees).3f°, rms %(phase_error_rms_degrees).3f°" % texture,
        )
        yield "%s, gouge and collision" % texture["name"], texture["check_sentence"]


def _picture(name: str, out: OutputFolder) -> str:
    """The pictures of a part's textures, in the page itself."""
    names = glob.glob(os.path.join(glob.escape(out.part_folder(name)), "picture-*.png"))
    found = []
    for file in sorted(names, key=lambda n: (len(n), n)):
        with open(file, "rb") as picture:
            text = base64.b64encode(picture.read()).decode("ascii")
        found.append('<img alt="dimples" src="data:image/png;base64,%s">' % text)
    return "".join(found)
