"""Rows and boxes of a form: properties, choices, machines, advice; icons and the words of summaries.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
