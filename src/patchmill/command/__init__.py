"""The command `patchmill`: recipes, programs and indexes from a terminal or from CI.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
