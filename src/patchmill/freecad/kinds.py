"""What a document object is to PatchMill, asked without importing the classes of operations: a proxy says it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

TEXTURE, COPY_MILLING, DCM = "texture", "copy milling", "dynamic contour milling"


def kind_of(obj):
    """The KIND of a document object's proxy; '' if it is none of ours."""
    return getattr(getattr(obj, "Proxy", None), "KIND", "")
