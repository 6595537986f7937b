"""CONTRIBUTING.md names rooms and modules that exist."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
PARAGRAPHS = re.findall(r"^- \*\*`(?:.*\n)(?:  .*\n)*", TEXT, flags=re.MULTILINE)
SETUP_PY = "setup.py"  #: of a user's package


def test_every_room_has_a_paragraph() -> None:
    rooms = {path.parent.name for path in ROOT.glob("zbot/*/__init__.py")}
    assert {room for room in rooms if f"`{room}/`" not in TEXT} == set()


def test_the_modules_that_it_names_are_there() -> None:
    named = [
        ({"", *re.findall(r"\*\*`(\w+)/`\*\*", text)}, module)
        for text in PARAGRAPHS
        for module in set(re.findall(r"`([\w/]+(?:\.py|/))`", text)) - {SETUP_PY}
    ]
    missing = [
        module
        for rooms, module in named
        if not any((ROOT / top / room / module).exists() for top in ("zbot", "") for room in rooms)
        and not any(any((ROOT / "zbot" / room).rglob(module)) for room in rooms if room)
    ]
    paths = set(re.findall(r"`((?:zbot|cli|tests)/[\w/]+\.py)`", TEXT))
    assert len(named) > 40
    assert missing + [path for path in paths if not (ROOT / path).exists()] == []
