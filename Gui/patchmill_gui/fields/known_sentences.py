"""Sentences of the core and of operations that users meet most, marked for translation: what an InputError
says and proposes. {} stands for a number, which a translation keeps in its place.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from FreeCAD import Qt
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.properties.property_table import label_of

SENTENCES = (
    QT_TRANSLATE_NOOP("PatchMill", "give a finite number."),
    QT_TRANSLATE_NOOP("PatchMill", "give a value greater than zero."),
    QT_TRANSLATE_NOOP("PatchMill", "give a finite value greater than zero."),
    QT_TRANSLATE_NOOP("PatchMill", "give a value from {} to {} mm."),
    QT_TRANSLATE_NOOP("PatchMill", "give a value from {} to {} degrees."),
    QT_TRANSLATE_NOOP("PatchMill", "give more than zero."),
    QT_TRANSLATE_NOOP("PatchMill", "give zero or a positive length."),
    QT_TRANSLATE_NOOP("PatchMill", "give a whole number greater than zero: posts write S so."),
    QT_TRANSLATE_NOOP("PatchMill", "give the tool controller a feed."),
    QT_TRANSLATE_NOOP("PatchMill", "give the operation a tool controller with a tool."),
    QT_TRANSLATE_NOOP("PatchMill", "{} mm from the nearest dimple"),
    QT_TRANSLATE_NOOP(
        "PatchMill",
        "a ball of radius {} mm leaves untouched material between the dimples: choose a smaller spacing "
        "or a larger ball.",
    ),
    QT_TRANSLATE_NOOP("PatchMill", "choose a larger ball or a smaller spacing."),
    QT_TRANSLATE_NOOP(
        "PatchMill",
        "in dimples {} mm deep the tip of the ball would rub: incline the tool by more than {}°, or choose "
        "shallower dimples.",
    ),
    QT_TRANSLATE_NOOP(
        "PatchMill",
        "in dimples {} mm deep the tip of the ball would rub under a tilt of {} degrees, and the faces have "
        "{} at most: incline the part or choose shallower dimples.",
    ),
    QT_TRANSLATE_NOOP(
        "PatchMill",
        "on a paced path every flute passes in turn: allow any flute, or use the constant-feed strategy.",
    ),
    QT_TRANSLATE_NOOP("PatchMill", "select a face of a solid or surface."),
    QT_TRANSLATE_NOOP("PatchMill", "select at least one face of the job's model."),
    QT_TRANSLATE_NOOP("PatchMill", "it is gone: choose the faces again."),
    QT_TRANSLATE_NOOP("PatchMill", "give the job a stock."),
    QT_TRANSLATE_NOOP("PatchMill", "give the job a model."),
    QT_TRANSLATE_NOOP("PatchMill", "it belongs to no job: make it in one."),
    QT_TRANSLATE_NOOP("PatchMill", "choose a texture operation."),
    QT_TRANSLATE_NOOP("PatchMill", "repair the operation first."),
    QT_TRANSLATE_NOOP(
        "PatchMill", "copy milling takes a ball, bull nose, tapered or conical end mill: choose one."
    ),
    QT_TRANSLATE_NOOP(
        "PatchMill", "choose a ball, bull nose, flat, tapered ball or conical end mill."
    ),
    QT_TRANSLATE_NOOP("PatchMill", "give no more than the tool's cutting edge, {} mm."),
    QT_TRANSLATE_NOOP(
        "PatchMill", "give no more than AxialDepth, {} mm: the last pass takes it all at once."
    ),
    QT_TRANSLATE_NOOP("PatchMill", "rapids would go through the stock: give more than its top, {} mm."),
    QT_TRANSLATE_NOOP(
        "PatchMill", "there is nothing to cut on them, or the ball does not reach them from above."
    ),
    QT_TRANSLATE_NOOP("PatchMill", "with undercuts choose the whole model."),
    QT_TRANSLATE_NOOP("PatchMill", "tool axes other than Z need a machine file with rotary axes."),
    QT_TRANSLATE_NOOP(
        "PatchMill", "name a machine file: without one nobody knows what it can follow."
    ),
    QT_TRANSLATE_NOOP("PatchMill", "give a picture or closed curves, or choose None."),
    QT_TRANSLATE_NOOP("PatchMill", "it has an open curve: close it."),
    QT_TRANSLATE_NOOP("PatchMill", "put it over the faces."),
    QT_TRANSLATE_NOOP("PatchMill", "the job has no active operation."),
    QT_TRANSLATE_NOOP("PatchMill", "choose a post-processor for the job."),
    QT_TRANSLATE_NOOP("PatchMill", "name a file in a folder that can be written to."),
    QT_TRANSLATE_NOOP("PatchMill", "give the name of a file."),
)
_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.]\d)")


def translated(sentence):
    """`sentence` in the language of FreeCAD's interface, where it is a known one; else as it is."""
    numbers = _NUMBER.findall(sentence)
    known = _NUMBER.sub("{}", sentence)
    if known not in SENTENCES:
        return sentence
    return Qt.translate("PatchMill", known).format(*numbers)


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
