"""Quantities as text and back: in one unit of the user's system for each kind of quantity, however small the
value, with as many digits as it needs, and with either decimal sign.

FreeCAD's own text changes its unit with the value, so that a plain number typed after "50 µm" would be taken
for micrometres; and it takes the point of a user whose language writes a comma for a separator of thousands.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import re

import FreeCAD
from PySide import QtCore

DIGITS = 4  # that are shown at least of a value, where it has them
# value at which a kind's unit is taken from the user's system, and the unit if that gives none
KINDS = {"mm": (25.0, "mm"), "deg": (10.0, "deg"), "mm/s": (10.0, "mm/s"), "": (1.0, "")}
_BARE = re.compile(r"^[-+]?[0-9]*\.?[0-9]*(?:[eE][-+]?[0-9]+)?$")
_NUMBER = re.compile(r"[0-9]+(?:[.,][0-9]+)*|[.,][0-9]+")


def user_unit(kind):
    """(text, how many of `kind` it is): the user's unit for quantities of `kind`, one of KINDS."""
    if not kind:
        return "", 1.0
    value, fallback = KINDS[kind]
    _, factor, unit = FreeCAD.Units.Quantity("%r %s" % (value, kind)).getUserPreferred()
    try:
        FreeCAD.Units.Quantity("1 " + unit)
    except (ValueError, ArithmeticError):  # schemes that write several units in one text
        unit, factor = fallback, 1.0
    return unit, factor


def text_of(value, kind):
    """`value` [kind] with its unit in the user's system."""
    unit, factor = user_unit(kind)
    shown = value / factor
    number = plain(shown, decimals_of(shown))
    return "%s %s" % (number, unit) if unit else number


def of_micrometre():
    """(unit, how many µm it is, decimals) in which the user says small lengths."""
    unit, factor = user_unit("mm")
    return ("µm", 1.0, 2) if unit.endswith("m") else (unit, 1e3 * factor, 6)


def of_micrometres(low, high):
    """(unit, low, high, decimals) of a range of heights [µm], in the user's system."""
    unit, factor = user_unit("mm")
    if unit.endswith("m"):
        return "µm", low, high, 0
    per_micrometre = 1e-3 / factor
    return unit, low * per_micrometre, high * per_micrometre, decimals_of(per_micrometre * (high - low))


def decimals_of(shown):
    """Digits behind the decimal sign that a number needs: the user's own, more where it is small."""
    own = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("Decimals", 2)
    if not math.isfinite(shown) or shown == 0.0:
        return own
    return max(own, min(9, DIGITS - 1 - math.floor(math.log10(abs(shown)))))


def plain(number, decimals):
    """A number without groups and zeros behind the user's own decimals, in the user's decimal sign."""
    own = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("Decimals", 2)
    text = "%.*f" % (decimals, number)
    while decimals > own and text.endswith("0"):
        text, decimals = text[:-1], decimals - 1
    return text.rstrip(".").replace(".", decimal_point())


def decimal_point():
    """Of the user's language."""
    point = QtCore.QLocale().decimalPoint()
    return point if isinstance(point, str) else chr(point)


def with_points(text):
    """`text` with the decimal sign of each number in it a point. Of two kinds of sign in a number the last is
    the decimal one, and so is one that is there once."""

    def pointed(found):
        number = found.group(0)
        signs = [c for c in number if c in ".,"]
        if len(signs) < 2:
            return number.replace(",", ".")
        if len(set(signs)) == 1:
            return number.replace(signs[0], "")  # groups of a whole number
        head, _, tail = number.rpartition(signs[-1])
        return re.sub("[.,]", "", head) + "." + tail

    return _NUMBER.sub(pointed, text)


def value_of(text, kind):
    """The value [kind] that a user typed, or None if it cannot be read as such a quantity: a number counts in
    user_unit(kind), another unit may be given, sums and the like are worked out."""
    text = with_points(text.strip())
    if not text:
        return None
    unit, factor = user_unit(kind)
    if _BARE.match(text):
        try:
            return float(text) * factor
        except ValueError:
            return None
    try:
        quantity = FreeCAD.Units.Quantity(text)
    except (ValueError, ArithmeticError):
        return None
    if str(quantity.Unit) == str(FreeCAD.Units.Unit()):
        return _finite(quantity.Value * factor)
    if not kind or quantity.Unit != FreeCAD.Units.Quantity("1 " + kind).Unit:
        return None
    return _finite(quantity.getValueAs(kind).Value)


def _finite(value):
    return value if math.isfinite(value) else None
