"""Type of arguments that are paths."""

import os

FilePath = str | bytes | os.PathLike[str] | os.PathLike[bytes]

__all__ = ["FilePath"]
