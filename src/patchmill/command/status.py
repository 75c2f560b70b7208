"""Exit statuses of the command; 0 is: all is well.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

FAILED = 1  # something has no program, is not as it should be, or came out otherwise
WRONG_CALL = 2  # nothing was done: a wrong call, or a recipe, folder or document that cannot be used
