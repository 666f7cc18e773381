# SPDX-License-Identifier: Apache-2.0
"""Runs pytest on files: run_pytest.py FILE... Status 77, which ctest takes as skipped, where a package is missing."""
import importlib.util
import sys

for package in ("pytest", "numpy"):
    if importlib.util.find_spec(package) is None:
        print(f"skipped: python3-{package} is not installed")
        sys.exit(77)

import pytest  # noqa: E402

sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", "--tb=short", *sys.argv[1:]]))
