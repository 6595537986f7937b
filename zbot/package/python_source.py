"""Source code of other people's Python files, which is read and not run."""

from __future__ import annotations

import ast
import codecs
import io
import re
import tokenize
import warnings
from typing import Final

#: Largest number of dots in one name. Python's parser needs a time that grows with the square of
#: this number: 20 s for a name with 131,000 dots after `import`.
_MAX_DOTS: Final = 1000
_DOTTED: Final = re.compile(r"(?:\.[\s\\]*\w+[\s\\]*)+")
#: The encoding whose decoder needs a time that grows with the square of the length.
_SLOW_ENCODING: Final = "punycode"


def parse_source(source: bytes, file: str = "<unknown>") -> ast.Module:
    """Return the syntax tree of a file. Python's warnings are not shown.

    Raises:
        SyntaxError: The file is not valid Python.
        ValueError: The file cannot be parsed in a short time, or contains null bytes.
        RecursionError: Expressions are nested too deeply. MemoryError has the same reason.
    """
    check_source(source)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the user sees the warnings when the file runs
        return ast.parse(source, file)


def check_source(source: bytes) -> None:
    """Check that Python can parse a file in a short time.

    Raises:
        SyntaxError: The first lines declare an unknown encoding.
        ValueError: Python's parser or decoder would take too long.
    """
    encoding, _ = tokenize.detect_encoding(io.BytesIO(source).readline)
    if codecs.lookup(encoding).name == _SLOW_ENCODING:
        raise ValueError(f"the encoding {encoding} is not supported")
    try:
        text = source.decode(encoding, errors="replace")
    except (LookupError, UnicodeError):  # Python's parser refuses the same encodings
        return
    if any(name[0].count(".") > _MAX_DOTS for name in _DOTTED.finditer(text)):
        raise ValueError(f"a name has more than {_MAX_DOTS} dots")
