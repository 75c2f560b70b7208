"""Sentences of the core and of operations in the language of FreeCAD's interface: what an InputError says and
proposes. Resources/translations/sentences.txt lists them, one a line, as tools/translations finds them in the
sources; {} stands for what is put in, which a translation keeps.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import os
import re

from FreeCAD import Qt
from patchmill.install import core_loader
from patchmill.properties.property_table import label_of

FILE = os.path.join(core_loader.module_root(), "Resources", "translations", "sentences.txt")


@functools.lru_cache(maxsize=None)
def _known():
    """[(pattern, sentence)]; those that leave least open come first."""
    with open(FILE, encoding="utf-8") as file:
        sentences = file.read().splitlines()
    sentences.sort(key=lambda sentence: len(sentence.replace("{}", "")), reverse=True)
    return [(re.compile(re.escape(s).replace(r"\{\}", "(.+?)"), re.DOTALL), s) for s in sentences]


def translated(sentence):
    """`sentence` in the language of FreeCAD's interface, where it is a known one; else as it is."""
    for pattern, known in _known():
        found = pattern.fullmatch(sentence)
        if found:
            return Qt.translate("PatchMill", known).format(*found.groups())
    return sentence


def translated_error(error):
    """What an exception says; of an InputError the property as its row names it, value and remedy in that
    language."""
    if not hasattr(error, "remedy"):
        return str(error)
    said = str(error).replace(error.remedy, translated(error.remedy))
    said = said.replace(str(error.value), translated(str(error.value)), 1)
    known = label_of(error.property)
    label = Qt.translate("PatchMill", known)
    return said if label == known else said.replace(error.property, label, 1)
