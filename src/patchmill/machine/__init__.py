"""Machines of the machine files: read, checked by their schema, and as the rows of a form.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
