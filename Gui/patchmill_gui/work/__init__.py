"""Work in the background of a panel: threads, progress, cancelling.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
