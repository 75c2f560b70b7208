"""One part of a recipe, inside FreeCADCmd: from its file to the program and what else the recipe keeps.

Run by patchmill.batch.process with the name of a request (JSON); writes result.json into the request's
folder last, so that a folder without one is not finished.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import sys
from typing import Any, Dict, List

import FreeCAD
import patchmill
from patchmill import InputError
from patchmill.batch import recipe
from patchmill.macros import jobs

PROGRAM, DOCUMENT, PICTURE = "program.ngc", "part.FCStd", "dimples.png"


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
    textures = [_figures(*row) for row in zip(operations, plans, posted)]
    if "simulation" in outputs:
        for op, one, figures in zip(operations, posted, textures):
            figures["simulation"] = _simulated(op, one.path)
    _draw(outputs, posted, plans, program, folder)
    return {
        "status": "done",
        "program_sha256": recipe.digest_of(program),
        "program_seconds": round(sum(t["seconds"] for t in textures), 3),
        "dimples": sum(t["dimples"] for t in textures),
        "textures": textures,
        "files": sorted(f for f in os.listdir(folder) if not f.startswith(".") and f != "request.json"),
    }


def _texture(job: Any, number: int, one: Dict[str, Any], request: Dict[str, Any]) -> Any:
    values = dict(one.get("properties", {}))
    if values.get("MaskImage"):
        values["MaskImage"] = recipe.inside(request["recipe_folder"], values["MaskImage"], "MaskImage")
    name = one.get("name", "Texture%d" % (number + 1))
    return jobs.texture(job, one["faces"], one["texture"], name, **values)


def _figures(op: Any, plan: Any, posted: Any) -> Dict[str, Any]:
    """What the index tells of one texture: lengths in mm, times in seconds, angles in degrees."""
    verdict = plan.pacing.verdict
    degrees = 180.0 / 3.141592653589793
    return {
        "name": op.Label,
        "faces": sorted(name for _, names in op.Base for name in names),
        "dimples": int(plan.counts["cut"]),
        "left_out": {k: int(n) for k, n in plan.counts.items() if n and k != "cut"},
        "seconds": round(float(posted.path.statistics()["timed_seconds"]), 3),
        "verdict": verdict.sentence if verdict else "Unknown: no machine is named.",
        "phase_error_max_degrees": round(float(posted.errors["largest"]) * degrees, 4),
        "phase_error_rms_degrees": round(float(posted.errors["rms"]) * degrees, 4),
        "check": posted.check.outcome if posted.check else "unknown",
        "check_sentence": posted.check.sentence if posted.check else "Unknown: not checked.",
    }


def _simulated(op: Any, path: Any) -> Dict[str, Any]:
    return {key: value for key, value in patchmill.simulate(op, path=path).rows()}


def _draw(outputs: List[str], posted: Any, plans: Any, program: str, folder: str) -> None:
    if "report" in outputs:
        patchmill.write_report(posted[0], plans[0], program, folder)
    elif "picture" in outputs:
        from patchmill.reports import pictures

        pictures.draw_dimples(plans[0], os.path.join(folder, PICTURE))


def main(name: str) -> int:
    """Runs the request of that name; 0 if there is a result, whatever it says."""
    with open(name, encoding="utf-8") as file:
        request = json.load(file)
    result = run(request)
    for document in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(document)
    target = os.path.join(request["folder"], ".answer.json")
    with open(target, "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1, sort_keys=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
