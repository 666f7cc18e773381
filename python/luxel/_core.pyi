# SPDX-License-Identifier: Apache-2.0
# The extension is private: the package around it has the types.
from typing import Any

version: str

def __getattr__(name: str) -> Any: ...
