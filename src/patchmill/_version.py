"""The version of the Python files, of which the compiled core must be too. CMakeLists.txt and package.xml say
the same (tests/host/test_install.py).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

__version__ = "0.2.0"
