"""Two indexes held against each other: which parts came out otherwise than before.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
from typing import Any, Dict, List

from patchmill.batch.problem import BatchError
from patchmill.batch.recipe import text_of

MOST_BYTES = 1 << 30
WATCHED = (
    ("status", "result"),
    ("dimples", "dimples"),
    ("program_seconds", "time"),
    ("program_sha256", "program"),
)


def load(filename: str) -> Dict[str, Any]:
    """The data of an index.json. Raises BatchError if it is none."""
    text = text_of(filename, "--compare", MOST_BYTES)
    try:
        index = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise BatchError("--compare", filename, "it is no index.json: %s." % error) from error
    parts = index.get("parts") if isinstance(index, dict) else None
    if not isinstance(parts, list) or not all(isinstance(p, dict) and "name" in p for p in parts):
        raise BatchError("--compare", filename, "it is no index.json of a run.")
    return dict(index)


def changes(old: Dict[str, Any], new: Dict[str, Any]) -> List[str]:
    """A sentence for each part that is new, gone, or has another result, number of dimples, time or
    program."""
    before = {part["name"]: part for part in old["parts"]}
    after = {part["name"]: part for part in new["parts"]}
    found = ["%s: is gone" % name for name in sorted(set(before) - set(after))]
    found += ["%s: is new" % name for name in sorted(set(after) - set(before))]
    for name in sorted(set(before) & set(after)):
        differing = [_change(word, before[name], after[name], key) for key, word in WATCHED]
        sentence = ", ".join(text for text in differing if text)
        if sentence:
            found.append("%s: %s" % (name, sentence))
    return found


def _change(word: str, before: Dict[str, Any], after: Dict[str, Any], key: str) -> str:
    a, b = before.get(key), after.get(key)
    if a == b:
        return ""
    if key == "program_sha256":
        return "another program"
    reason = ": " + after["reason"] if key == "status" and after.get("reason") else ""
    return "%s %s before, %s now%s" % (word, a, b, reason)
