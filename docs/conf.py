"""Settings of the documentation's site, for Sphinx.

The source is the whole checkout and not only this folder. So the same relative links work on the
site and on a code host, also those to the examples and the measurements.
"""

import re
from pathlib import Path
from typing import TYPE_CHECKING

from docs.generator import write_api
from zbot.version import __version__

if TYPE_CHECKING:
    from sphinx.application import Sphinx

project = "zbot"
author = "the authors of zbot"
version = release = __version__

extensions = ["myst_parser", "sphinx_copybutton"]
root_doc = "docs/index"
include_patterns = [
    "docs/**/*.md",
    "docs/*.md",
    "examples/README.md",
    "benchmarks/*.md",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
]
exclude_patterns = [".*", "build", "dist", "tests", "zbot", "cli", "nodes", "launch", "**/.venv*"]
templates_path = ["_templates"]

myst_enable_extensions = ["deflist"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "zbot"
html_permalinks_icon = "#"
html_show_sphinx = False
# The site's address opens the first page, which is in a folder.
html_additional_pages = {"index": "first_page.html"}

# The button copies commands without the prompt and without the output.
copybutton_prompt_text = r"\w*\$ "
copybutton_prompt_is_regexp = True

_DOCS = Path(__file__).parent


def list_guides(_app: object, name: str, content: list[str]) -> None:
    """Replace `*` in the first page's list of guides by the pages that no page lists yet.

    So a new page needs no line there. Sphinx's own patterns would list the other pages again.
    """
    if name != root_doc:
        return
    lists = [content[0], *(path.read_text("utf-8") for path in _DOCS.glob("*/index.md"))]
    listed = set(re.findall(r"^(?:\.\./)?([\w-]+)$", "\n".join(lists), re.MULTILINE))
    others = sorted({path.stem for path in _DOCS.glob("*.md")} - listed - {"index"})
    content[0] = content[0].replace("\n*\n", "\n" + "".join(f"{other}\n" for other in others))


def setup(app: "Sphinx") -> None:
    """Let Sphinx call `list_guides`, and write the pages of the Python names."""
    app.connect("source-read", list_guides)
    write_api()
