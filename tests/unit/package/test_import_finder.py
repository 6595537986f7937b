"""Tests of the order in which zbot's sources of modules are asked."""

from __future__ import annotations

import importlib
import importlib.util
import subprocess
import sys
from importlib.machinery import ModuleSpec
from typing import TYPE_CHECKING

import pytest

from zbot.package import import_finder

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path
    from types import ModuleType

    from zbot.package.import_finder import Source


@pytest.fixture(autouse=True)
def finders(monkeypatch: pytest.MonkeyPatch) -> None:
    """Give the test finders without sources."""
    known = [
        finder for finder in sys.meta_path if not isinstance(finder, import_finder.ImportFinder)
    ]
    monkeypatch.setattr(sys, "meta_path", known)
    monkeypatch.setattr(import_finder, "_first", import_finder.ImportFinder())
    monkeypatch.setattr(import_finder, "_last", import_finder.ImportFinder())


def source(name: str, asked: list[str] | None = None) -> Source:
    """Return a source that has every module whose name begins with `from_any`."""

    def find(
        fullname: str, path: Sequence[str] | None, target: ModuleType | None
    ) -> ModuleSpec | None:
        del path, target
        if not fullname.startswith("from_any"):
            return None
        if asked is not None:
            asked.append(name)
            return None
        return ModuleSpec(fullname, None, origin=name, is_package=True)

    return find


def origin(name: str) -> str | None:
    spec = importlib.util.find_spec(name)
    return None if spec is None else spec.origin


def test_the_first_source_of_the_order_wins_whoever_was_added_first() -> None:
    for name in reversed(import_finder.ORDER):
        if name != import_finder.PYTHON:
            import_finder.add(name, source(name))
            assert origin("from_any") == name


def test_every_source_is_asked_in_the_order() -> None:
    asked: list[str] = []
    names = [name for name in import_finder.ORDER if name != import_finder.PYTHON]
    for name in sorted(names):
        import_finder.add(name, source(name, asked))
    assert origin("from_any") is None
    assert asked == names


def test_pythons_own_finders_are_asked_between_the_sources(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "from_any_file.py").touch()
    monkeypatch.syspath_prepend(str(tmp_path))
    import_finder.add("packages of interfaces", source("last"))
    assert origin("from_any_file") == str(tmp_path / "from_any_file.py")
    import_finder.add("workspace", source("first"))
    assert origin("from_any_file") == "first"


def test_an_error_is_explained_only_to_an_import_statement() -> None:
    def explanation(fullname: str, path: Sequence[str] | None) -> ImportError | None:
        return ImportError(f"{fullname} in {path}") if fullname == "no_such_one" else None

    for _ in range(2):
        import_finder.explain(explanation)
    with pytest.raises(ImportError, match="no_such_one in None"):
        importlib.import_module("no_such_one")
    assert origin("no_such_one") is None
    with pytest.raises(ModuleNotFoundError, match="No module named 'no_such_other'"):
        importlib.import_module("no_such_other")
    import_finder.stop_explaining(explanation)
    with pytest.raises(ModuleNotFoundError, match="No module named 'no_such_one'"):
        importlib.import_module("no_such_one")


def test_nothing_is_explained_if_a_later_finder_has_the_module() -> None:
    import_finder.explain(lambda fullname, _: ImportError(fullname))
    later = import_finder.ImportFinder()
    later.sources["any"] = source("later")
    sys.meta_path.append(later)
    assert importlib.import_module("from_any_later").__name__ == "from_any_later"


def test_only_modules_with_code_are_installed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "only_a_folder").mkdir()
    (tmp_path / "with_code.py").touch()
    assert import_finder.is_installed("with_code", among=[str(tmp_path)])
    assert not import_finder.is_installed("with_code")
    monkeypatch.syspath_prepend(str(tmp_path))
    assert import_finder.is_installed("with_code")
    assert not import_finder.is_installed("only_a_folder")
    import_finder.add("workspace", source("ours"))
    assert not import_finder.is_installed("from_any")


def test_zbot_has_two_finders_and_adds_each_once() -> None:
    source = (
        "import sys, zbot.compat, zbot.interfaces, zbot.package.python_finder as finder\n"
        "zbot.interfaces.install_importer(); zbot.compat.install_names(); finder.install()\n"
        "print([type(one).__name__ for one in sys.meta_path].count('ImportFinder'))\n"
        "first = sys.meta_path[0]\n"
        "print(type(first).__name__, list(first.sources))"
    )
    command = [sys.executable, "-c", source]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.stdout == ("2\nImportFinder [\"ROS 2's names\", 'interfaces', 'workspace']\n"), (
        result.stderr
    )
