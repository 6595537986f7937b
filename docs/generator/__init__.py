"""Writers of the pages that are made from the code."""

from pathlib import Path

from docs.generator import api, commands

REFERENCE = Path(__file__).parents[1] / "reference"


def write_commands() -> None:
    """Write the page of the commands."""
    (REFERENCE / "commands.md").write_text(commands.page(), encoding="utf-8")


def write_api() -> None:
    """Write the pages of the Python names. Git ignores them, and each build writes them."""
    folder = REFERENCE / "api"
    folder.mkdir(exist_ok=True)
    for package in api.PACKAGES:
        (folder / f"{package}.md").write_text(api.page(package), encoding="utf-8")
