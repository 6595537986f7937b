from __future__ import annotations

from pathlib import Path

import pytest

from zbot.interfaces.errors import UnknownPackageError
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.parser import parse
from zbot.interfaces.registry import register_spec
from zbot.interfaces.stubs import main, package_stubs

STUBS = Path(__file__).parents[3] / "zbot" / "compat" / "stubs"


def test_the_stubs_in_the_repository_match_the_definitions() -> None:
    expected = {
        f"{package}/{name}": text
        for package in shipped_packages()
        for name, text in package_stubs(package).items()
    }
    actual = {
        file.relative_to(STUBS).as_posix(): file.read_text(encoding="utf-8")
        for file in STUBS.rglob("*")
        if file.is_file()
    }
    assert actual == expected, "run: python -m zbot.interfaces.stubs zbot/compat/stubs"


def test_a_stub_is_python() -> None:
    register_spec(
        parse(
            "stub_interfaces/action/Do",
            '# A """quoted""" \\ comment\nint32 A=1\nfloat64[] x\n---\nbyte[2] y\n---\nuint8[3] z',
        )
    )
    text = package_stubs("stub_interfaces")["action/__init__.pyi"]
    compile(text, "stub", "exec")
    for line in (
        "    A: Final = 1",
        "    def x(self) -> array[float]: ...",
        "    def x(self, value: Collection[float]) -> None: ...",
        "    def y(self) -> list[bytes]: ...",
        "    def z(self) -> NDArray[numpy.uint8]: ...",
        "    Goal: TypeAlias = Do_Goal",
        "        SendGoalService: TypeAlias = Do_SendGoal",
    ):
        assert line in text.splitlines()


def test_the_command_writes_the_packages_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([str(tmp_path), "std_srvs"]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["std_srvs"]
    assert str(tmp_path / "std_srvs" / "srv" / "__init__.pyi") in capsys.readouterr().out
    with pytest.raises(UnknownPackageError):
        main([str(tmp_path), "std_srv"])


def test_the_command_without_a_folder_prints_its_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 2
    assert "python -m zbot.interfaces.stubs FOLDER" in capsys.readouterr().err
