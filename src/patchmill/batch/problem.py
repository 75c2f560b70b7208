"""What is wrong with a recipe, an output folder or a call, in one sentence.

SPDX-License-Identifier: LGPL-2.1-or-later
"""


class BatchError(Exception):
    """A call, recipe or folder that cannot be used: `where` (a file, an option or a position in the recipe),
    `value` and `remedy`."""

    def __init__(self, where: str, value: object, remedy: str) -> None:
        sentence = "%s: %s: %s" % (where, value, remedy)
        # half a character, as JSON can name it, cannot be shown
        super().__init__(sentence.encode("utf-8", "backslashreplace").decode())
        self.where, self.value, self.remedy = where, value, remedy
