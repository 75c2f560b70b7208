"""What a macro says in a few lines: a job over a part, faces by what they are, a texture on them.

The functions are called through `patchmill` itself (see patchmill.job, patchmill.texture, patchmill.faces).

SPDX-License-Identifier: LGPL-2.1-or-later
"""
