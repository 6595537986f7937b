"""What a path may be given as."""

import os

FilePath = str | bytes | os.PathLike[str] | os.PathLike[bytes]

__all__ = ["FilePath"]
