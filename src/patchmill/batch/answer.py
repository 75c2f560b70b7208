"""How a process inside FreeCADCmd reads its request and leaves its answer (see patchmill.batch.process).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
from typing import Any, Callable, Dict

import FreeCAD


def leave(name: str, answer: Callable[[Dict[str, Any]], Dict[str, Any]]) -> int:
    """Answers the request of that name (JSON). The answer is written last: a folder without one is not
    finished. 0 if there is an answer, whatever it says."""
    with open(name, encoding="utf-8") as file:
        request = json.load(file)
    result = answer(request)
    for document in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(document)
    target = os.path.join(request["folder"], ".answer.json")
    with open(target, "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1, sort_keys=True)
    return 0
