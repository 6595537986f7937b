from __future__ import annotations

import socket
from typing import TYPE_CHECKING

import pytest

from zbot.errors.installation import pip_install

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program

WITHOUT_EXTRA = """
import importlib.util, sys
find = importlib.util.find_spec
importlib.util.find_spec = lambda name, *rest: None if name == "nicegui" else find(name, *rest)
from zbot_cli.main import main
sys.argv = ["zbot", "web"]
main()
"""
NOT_IMPORTED = """
import sys
EXTRA = "nicegui", "fastapi", "starlette", "uvicorn", "psutil", "PIL", "ifaddr"
import zbot, zbot.compat, zbot_cli.main
import zbot_cli.commands.web, zbot_cli.commands.plot, zbot_cli.commands.graph
import zbot.observer.system, zbot.web.server.server, zbot.observer.curve, zbot.web.forms.form
print("imported:", sorted({*EXTRA} & sys.modules.keys()))
"""


def test_a_missing_extra_is_reported_with_the_remedy(start: Callable[..., Program]) -> None:
    program = start(source=WITHOUT_EXTRA)
    assert program.wait(30) == 1
    assert program.lines == [f"the page needs nicegui: install it with {pip_install('zbot[web]')}"]


def test_only_the_running_page_imports_the_extra(start: Callable[..., Program]) -> None:
    program = start(source=NOT_IMPORTED)
    program.wait_for("imported: []")


def test_unknown_panel_is_refused_with_the_nearest_name(start: Callable[..., Program]) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    program = start("zbot", "web", "topcis", "--no-browser")
    assert program.wait(30) == 1
    assert program.lines == ["there is no panel 'topcis'", "", "hint: did you mean 'topics'?"]


def test_host_of_another_machine_is_refused(start: Callable[..., Program]) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    program = start("zbot", "web", "--no-browser", "--host", "192.0.2.1")
    assert program.wait(30) == 1
    assert program.lines[0].startswith("cannot listen on 192.0.2.1:8080: ")


def test_taken_port_is_replaced_by_the_next_port(start: Callable[..., Program]) -> None:
    pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
    with socket.socket() as holder:
        holder.bind(("127.0.0.1", 0))
        holder.listen()
        port = holder.getsockname()[1]
        program = start("zbot", "web", "--no-browser", "--port", str(port))
        line = program.wait_for("zbot web: ", 30)
        assert port < int(line.rstrip("/").rpartition(":")[2]) <= port + 100
        assert program.stop(timeout=15) == 130
