"""What checks of shank and holder go by, as properties of the operations that are checked.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

POST_GOUGING = (
    "App::PropertyBool",
    "PostGouging",
    "Checks",
    "Post even if the tool gouges or collides, or if that is not known",
    False,
)
CHECK_PROPERTIES = [
    (
        "App::PropertyLength",
        "ToolClearance",
        "Checks",
        "Shank and holder must keep so far away from the model",
        0.1,
    ),
    (
        "App::PropertyLength",
        "StickOut",
        "Checks",
        "How far the tool stands out of its holder; 0: the tool bit's length",
        0.0,
    ),
    (
        "App::PropertyLength",
        "HolderDiameter",
        "Checks",
        "Diameter of the holder, for the collision check; 0: no holder",
        40.0,
    ),
    (
        "App::PropertyLength",
        "HolderLength",
        "Checks",
        "Length of the holder, for the collision check",
        60.0,
    ),
    POST_GOUGING,
]


def gouge_tolerance(besides):
    """The row of GougeTolerance; `besides`: what may lie below the model besides."""
    tip = "Cutting end and flutes may cut so deep below the model, besides %s" % besides
    return ("App::PropertyLength", "GougeTolerance", "Checks", tip, 0.01)
