"""First page of a bundle. People read it in a browser, and pip finds the wheels on it."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING
from urllib.parse import quote

from zbot.classroom.bundle.documents import DOCUMENTS, EXAMPLES
from zbot.classroom.bundle.manifest import WHEELS

if TYPE_CHECKING:
    from collections.abc import Mapping

FILE = "index.html"
_STARTS = (f"{DOCUMENTS}/index.html", f"{DOCUMENTS}/index.md")

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>zbot {version}</title>
<style>body {{ font-family: sans-serif; margin: 2em auto; max-width: 50em; padding: 0 1em }}</style>
</head>
<body>
<h1>zbot {version}</h1>
<h2>Install from this folder</h2>
<p>Open a terminal in the folder of this page, and type:</p>
<table>
<tr><td>Linux, macOS</td><td><code>bash install.sh</code></td></tr>
<tr><td>PowerShell</td><td><code>.\\install.ps1</code>, or <code>.\\install.cmd</code></td></tr>
<tr><td>cmd</td><td><code>install.cmd</code></td></tr>
</table>
<p>If this page comes from your teacher's machine, type the line that the teacher shows.</p>
{links}
<h2>Files for pip</h2>
<ul>
{wheels}
</ul>
</body>
</html>
"""


def first_page(version: str, files: Mapping[str, str]) -> str:
    """Return the page.

    Args:
        version: The version of zbot.
        files: The SHA-256 of each file of the bundle, by its path.
    """
    wheels = [
        f'<li><a href="{quote(name)}#sha256={digest}">{escape(name.rpartition("/")[2])}</a></li>'
        for name, digest in files.items()
        if name.startswith(f"{WHEELS}/")
    ]
    start = next((page for page in _STARTS if page in files), None)
    links = f'<p><a href="{start}">Documentation</a></p>\n' if start else ""
    programs = [name for name in files if name.startswith(f"{EXAMPLES}/") and name.endswith(".py")]
    if programs:
        items = "\n".join(
            f'<li><a href="{quote(name)}">{escape(name.rpartition("/")[2])}</a></li>'
            for name in programs
        )
        links += f"<h2>Programs of the lessons</h2>\n<ul>\n{items}\n</ul>"
    return _PAGE.format(version=escape(version), links=links, wheels="\n".join(wheels))
