"""Sentences of the core and of operations in the user's units. They give lengths in mm and speeds in mm/s or
mm/min, some of them with all digits of a number that was computed.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.known_sentences import translated_error

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"
_UNITS = {  # unit in a sentence: (kind of unit_text, how many of it)
    "mm": ("mm", 1.0),
    "µm": ("mm", 1e-3),
    "mm/s": ("mm/s", 1.0),
    "mm/min": ("mm/s", 1.0 / 60.0),
}
# numbers that share a unit, such as "from 0.1 to 10 mm" or "4 x 8 mm"; not areas, no part of a longer number
_QUANTITY = re.compile(
    r"(?<![\w.,])(?P<all>%s(?:(?: to | and | x | × |, )%s)*) (?P<unit>mm/min|mm/s|mm|µm)(?![\w²³/^])"
    % (_NUMBER, _NUMBER)
)
_METRIC = re.compile(r"[µmc]?m(?:/|$)")
_LONG = 6  # digits: with more of them a number was computed, not typed


def in_user_units(sentence):
    """`sentence` with its lengths and speeds in the user's units. In metric ones they stay as they are
    written, but for numbers of more than 6 digits."""
    return _QUANTITY.sub(_in_user_units, sentence)


def error_text(error):
    """What an exception says, in the user's language and units."""
    return in_user_units(translated_error(error))


def _in_user_units(found):
    kind, factor = _UNITS[found["unit"]]
    unit, _ = unit_text.user_unit(kind)
    if _METRIC.match(unit):
        return re.sub(_NUMBER, _shortened, found["all"]) + " " + found["unit"]
    one = re.compile(_NUMBER)
    texts = [unit_text.text_of(float(number) * factor, kind) for number in one.findall(found["all"])]
    between = one.split(found["all"])[1:-1]
    parts = [text.rsplit(" ", 1)[0] for text in texts[:-1]] + texts[-1:]  # the unit once, at the end
    return "".join(part + link for part, link in zip(parts, [*between, ""]))


def _shortened(found):
    number = found.group(0)
    if len(re.sub(r"e.*|\D", "", number).strip("0")) <= _LONG:
        return number
    return "%.4g" % float(number)
