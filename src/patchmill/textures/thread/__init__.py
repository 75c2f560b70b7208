"""Cylinders that are milled all the way round along one thread, while a rotary table turns them under the
tool (docs/thread.md).

SPDX-License-Identifier: LGPL-2.1-or-later
"""
