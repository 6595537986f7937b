"""Documentation and examples of a bundle. They are in a checkout of zbot."""

from __future__ import annotations

import shutil
import subprocess
import sys
from importlib.util import find_spec
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

DOCUMENTS, EXAMPLES = "docs", "examples"
_MODULES = ("furo", "myst_parser", "sphinx", "sphinx_copybutton")
_LEFT_OUT = shutil.ignore_patterns(
    "*.py", "__pycache__", "_templates", "generator", ".doctrees", ".buildinfo"
)


def add_documents(checkout: Path | None, folder: Path, tell: Callable[[str], None]) -> None:
    """Put the documentation and the examples of the lessons into a bundle.

    Args:
        checkout: The folder with zbot's source, or `None` if there is none.
        folder: The folder of the bundle.
        tell: Called with a line about what was done.
    """
    for name in (DOCUMENTS, EXAMPLES):
        shutil.rmtree(folder / name, ignore_errors=True)
    if checkout is None:
        tell("documentation: left out, because it is only in a checkout of zbot")
        return
    shutil.copytree(
        checkout / EXAMPLES, folder / EXAMPLES, ignore=shutil.ignore_patterns("__pycache__")
    )
    if all(map(find_spec, _MODULES)):
        tell("documentation: the site is being built")
        if _build_site(checkout, folder / DOCUMENTS):
            return
        tell("documentation: the site cannot be built, so the Markdown files are there")
    else:
        tell('documentation: Markdown files, because the site needs `pip install "zbot[docs]"`')
    shutil.rmtree(folder / DOCUMENTS, ignore_errors=True)
    shutil.copytree(checkout / DOCUMENTS, folder / DOCUMENTS, ignore=_LEFT_OUT)


def _build_site(checkout: Path, site: Path) -> bool:
    """Build the site. Return whether this succeeded."""
    built = subprocess.run(  # noqa: S603 - this Python itself
        [sys.executable, "-m", "sphinx", "-c", "docs", "-E", "-q", ".", str(site)],
        cwd=checkout,
        capture_output=True,
        check=False,
    )
    shutil.rmtree(site / ".doctrees", ignore_errors=True)
    (site / ".buildinfo").unlink(missing_ok=True)
    return built.returncode == 0 and (site / "index.html").is_file()
