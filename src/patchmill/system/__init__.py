"""What PatchMill does with the operating system.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
