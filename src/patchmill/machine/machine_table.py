"""A machine file as rows of text, for forms: what may be said where, in which unit, and what is said now.

    rows(data) -> [Row]              all that MACHINE of schema.py knows, in its order
    with_text(data, place, text)     the data with one row said otherwise

What cannot be read as the row's kind is kept as it was written: schema.checked then refuses it by its
place, in the words that a file with that mistake would get.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
from dataclasses import dataclass

from patchmill.machine.schema import MACHINE, NUMBER, List, Numbers, Record, Value

HIDDEN = ("format", "version")
ONE = {"rotary_axes": "rotary axis"}
UNITS = {
    ("mm",): "mm",
    ("s",): "s",
    ("mm", "s"): "mm/s",
    ("mm", "s2"): "mm/s²",
    ("mm", "s3"): "mm/s³",
    ("deg", "s"): "°/s",
    ("deg", "s2"): "°/s²",
    ("degrees",): "°",
}


@dataclass
class Row:
    """One thing that a file may say. `place`: the words and list numbers that lead to it, as in
    schema.Place; `words`: what it may be, if that is one of some; a `heading` has rows below it
    and no text. An empty text: not said, or none."""

    place: tuple
    label: str
    unit: str = ""
    text: str = ""
    words: tuple = ()
    heading: bool = False


def rows(data):
    """Rows of the data of a machine file that fits the schema, in the schema's order; each heading before its
    rows."""
    return list(_rows(MACHINE, data, (), ""))


def with_text(data, place, text):
    """A copy of a machine file's data in which the row at `place` says `text`; an empty text takes out what
    need not be said."""
    return _said(MACHINE, data, place, text.strip())


def _said(item, data, place, text):
    word, rest = place[0], place[1:]
    if isinstance(item, List):
        number = int(word)
        return data[:number] + [_said(item.item, data[number], rest, text)] + data[number + 1:]
    made, inner = dict(data), _words(item)[word]
    if rest:
        made[word] = _said(inner, data.get(word, {}), rest, text)
    else:
        made[word] = _value(inner, text)
    silent = made[word] == {} if rest else not text and (word in item.optional or word not in data)
    if silent:
        del made[word]
    return made


def _words(record):
    return dict(record.required, **record.optional)


def _rows(record, data, place, unit):
    for word, item in _words(record).items():
        here = place + (word,)
        value = data.get(word)
        if word in HIDDEN:
            continue
        if isinstance(item, Record):
            label, inner = _named(word)
            yield Row(here, label, inner, heading=True)
            yield from _rows(item, value or {}, here, inner)
        elif isinstance(item, List) and isinstance(item.item, Record):
            for number, part in enumerate(value or []):
                yield Row(here + (str(number),), "%s %s" % (ONE[word], part["letter"]), heading=True)
                yield from _rows(item.item, part, here + (str(number),), "")
        else:
            label, own = _named(word)
            choices = _choices(item, word in record.optional)
            yield Row(here, label, own or unit, _text(item, value), choices)


def _named(word):
    """'velocity_mm_s' -> ('velocity', 'mm/s')"""
    parts = word.split("_")
    for count in (2, 1):
        unit = UNITS.get(tuple(parts[-count:]))
        if unit and len(parts) > count:
            return _spelt(parts[:-count]), unit
    return _spelt(parts), ""


def _spelt(parts):
    return " ".join("TCP" if part == "tcp" else part for part in parts)


def _choices(item, optional):
    if isinstance(item, Value) and item.types == (bool,):
        words: tuple = ("yes", "no")
    else:
        words = tuple(getattr(item, "words", None) or ())
    return ("",) + words if words and optional else words


def _text(item, value):
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(item, Numbers) and isinstance(value, list):
        return ", ".join(json.dumps(v) for v in value)
    if isinstance(item, List) and isinstance(value, list):
        return "\n".join(str(v) for v in value)
    return value if isinstance(value, str) else json.dumps(value)


def _value(item, text):
    text = text.strip()
    if isinstance(item, List):
        return [line.strip() for line in text.splitlines() if line.strip()]
    if isinstance(item, Numbers):
        return _read("[%s]" % text.strip("[] "), text) if text else None
    if item.types == (bool,):
        return {"yes": True, "no": False}.get(text, text)
    if item.types == (str,):
        return text
    if not text and type(None) in item.types:
        return None
    number = _read(text, text)
    return number if isinstance(number, NUMBER) else text


def _read(text, otherwise):
    try:
        return json.loads(text)
    except ValueError:
        return otherwise
