"""One part of a recipe, inside FreeCADCmd: from its file to the program and what else the recipe keeps.

Run by patchmill.batch.process with the name of a request (JSON); writes result.json into the request's
folder last, so that a folder without one is not finished.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
from typing import Any, Dict, List

import patchmill
from patchmill import InputError
from patchmill.batch import answer, recipe
from patchmill.macros import jobs, outcome

PROGRAM, DOCUMENT, PICTURE = "program.ngc", "part.FCStd", "picture-%d.png"


def run(request: Dict[str, Any]) -> Dict[str, Any]:
    """The result of one part: a dict as Resources/schemas/index.schema.json says under parts. `request`:
    file, data (of the recipe), folder (to write into) and recipe_folder. An InputError is a result, too.
    """
    try:
        return _mill(request)
    except InputError as error:
        return _failed("refused", str(error), error.property)


def _failed(status: str, sentence: str, where: str = "") -> Dict[str, Any]:
    return {"status": status, "reason": sentence, "property": where}


def _mill(request: Dict[str, Any]) -> Dict[str, Any]:
    data, folder = request["data"], request["folder"]
    job = jobs.job(
        request["file"], data.get("tool"), data.get("machine"), data.get("offset"), data.get("post")
    )
    operations = [_texture(job, number, one, request) for number, one in enumerate(data["operations"])]
    plans = [patchmill.recompute(op) for op in operations]
    program = os.path.join(folder, PROGRAM)
    posted = patchmill.post(job, program)
    outputs = data.get("outputs", [])
    if "document" in outputs:
        job.Document.saveAs(os.path.join(folder, DOCUMENT))
    textures = [outcome.figures(one) for one in posted]
    if "simulation" in outputs:
        for one, figures in zip(posted, textures):
            figures["simulation"] = _simulated(one.operation, one.path)
    _draw(outputs, posted, plans, program, folder)
    return {
        "status": "done",
        "program_sha256": recipe.digest_of(program),
        "program_seconds": round(sum(t["seconds"] for t in textures), 3),
        "dimples": sum(t["dimples"] for t in textures),
        "textures": textures,
        "files": _files(folder),
    }


def _texture(job: Any, number: int, one: Dict[str, Any], request: Dict[str, Any]) -> Any:
    values = dict(one.get("properties", {}))
    if values.get("MaskImage"):
        values["MaskImage"] = recipe.inside(request["recipe_folder"], values["MaskImage"], "MaskImage")
    name = one.get("name", "Texture%d" % (number + 1))
    return jobs.texture(job, one["faces"], one["texture"], name, **values)


def _simulated(op: Any, path: Any) -> Dict[str, Any]:
    return {key: value for key, value in patchmill.simulate(op, path=path).rows()}


def _draw(outputs: List[str], posted: Any, plans: Any, program: str, folder: str) -> None:
    """The pictures that the index shows, one for each texture, and reports."""
    if "report" in outputs:
        outcome.report(posted, program, folder)
    if "report" in outputs or "picture" in outputs:
        from patchmill.reports import pictures

        for number, plan in enumerate(plans):
            pictures.draw_dimples(plan, os.path.join(folder, PICTURE % (number + 1)))


def _files(folder: str) -> List[str]:
    """Names of what was made, also in folders of it."""
    found = []
    for place, _, names in os.walk(folder):
        found += [os.path.relpath(os.path.join(place, name), folder) for name in names]
    return sorted(f for f in found if not f.startswith(".") and f not in ("request.json", "log.txt"))


def main(name: str) -> int:
    """Runs the request of that name; 0 if there is a result, whatever it says."""
    return answer.leave(name, run)
