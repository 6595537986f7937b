from __future__ import annotations

import importlib
import importlib.util
import subprocess
import sys
from importlib import import_module
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import Any

import pytest

from zbot.interfaces import get_interface, install_importer


@pytest.fixture(autouse=True)
def importer(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("importer", "parser"):  # permanently: the modules of a test are removed
        importlib.import_module(f"zbot.interfaces.{name}")
    monkeypatch.setattr(sys, "meta_path", list(sys.meta_path))
    monkeypatch.setattr(sys, "modules", dict(sys.modules))
    install_importer()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return an empty folder that is the current folder and on `sys.path`."""
    source = tmp_path / "src"
    source.mkdir()
    monkeypatch.chdir(source)
    monkeypatch.syspath_prepend(str(source))
    return source


@pytest.mark.parametrize("statement", ["from ant_msgs.msg import Leaf", "import ant_msgs"])
def test_a_missing_package_of_definitions_is_explained(statement: str) -> None:
    with pytest.raises(ModuleNotFoundError) as caught:
        exec(statement)
    assert caught.value.name == "ant_msgs"
    text = str(caught.value)
    assert text.startswith("No module named 'ant_msgs'. To add the package, type `zbot interface ")
    assert "put its .msg files into a folder ant_msgs/msg of your workspace" in text
    assert importlib.util.find_spec("ant_msgs") is None
    with pytest.raises(ModuleNotFoundError, match=r"; did you mean 'sensor_msgs'\? To add"):
        import_module("sensors_msgs")


def test_the_repository_of_a_missing_package_is_named() -> None:
    text = "download https://github.com/PX4/px4_msgs and type `zbot interface add` with its folder"
    with pytest.raises(ModuleNotFoundError, match=text):
        import_module("px4_msgs.msg")


def test_a_type_of_another_version_is_explained() -> None:
    with pytest.raises(
        ImportError, match="your robot's version of control_msgs to `zbot interface"
    ):
        exec("from control_msgs.msg import TypeOfTomorrow")
    with pytest.raises(ImportError, match=r"did you mean 'PidState'\?"):
        exec("from control_msgs.msg import PidStat")
    with pytest.raises(ImportError, match=r"'std_msgs\.msg'$"):
        exec("from std_msgs.msg import TypeOfTomorrow")


def test_a_later_finder_may_have_the_package(monkeypatch: pytest.MonkeyPatch) -> None:
    class Later:
        @staticmethod
        def find_spec(name: str, path: object, target: object = None) -> ModuleSpec | None:
            del path, target
            return ModuleSpec(name, None, is_package=True) if name == "bee_msgs" else None

    monkeypatch.setattr(sys, "meta_path", [*sys.meta_path, Later])
    assert importlib.import_module("bee_msgs").__name__ == "bee_msgs"


@pytest.mark.parametrize(
    ("statement", "name"),
    [
        ("from std_msgs.msg import String as Found", "std_msgs/msg/String"),
        ("import geometry_msgs.msg as m; Found = m.Twist", "geometry_msgs/msg/Twist"),
        ("import std_msgs.msg; Found = std_msgs.msg.String", "std_msgs/msg/String"),
        ("from std_msgs import msg; Found = msg.String", "std_msgs/msg/String"),
        ("from std_msgs.msg._string import String as Found", "std_msgs/msg/String"),
        ("from std_msgs.msg import *; Found = String", "std_msgs/msg/String"),
        ("from std_srvs.srv import SetBool as Found", "std_srvs/srv/SetBool"),
        ("from std_srvs.srv import SetBool_Request as Found", "std_srvs/srv/SetBool_Request"),
        (
            "from std_srvs.srv._trigger import Trigger_Request as Found",
            "std_srvs/srv/Trigger_Request",
        ),
        (
            "from example_interfaces.action import Fibonacci as Found",
            "example_interfaces/action/Fibonacci",
        ),
        (
            "from example_interfaces.action._fibonacci import Fibonacci_SendGoal as Found",
            "example_interfaces/action/Fibonacci_SendGoal",
        ),
        ("from turtlesim.msg import Pose as Found", "turtlesim/msg/Pose"),
        ("from turtlesim_msgs.msg import Pose as Found", "turtlesim_msgs/msg/Pose"),
    ],
)
def test_imports_as_in_ros(statement: str, name: str) -> None:
    names: dict[str, Any] = {}
    exec(statement, names)
    assert names["Found"] is get_interface(name)


def test_star_imports_and_dir_show_the_interfaces() -> None:
    module = importlib.import_module("std_msgs.msg")
    assert {"String", "Float32", "Header"} <= set(dir(module))
    assert "String" in module.__all__
    assert not [name for name in module.__all__ if name.startswith("_")]


@pytest.mark.parametrize(
    ("statement", "message"),
    [
        ("from std_msgs.msg import Strng", "cannot import name 'Strng'.*did you mean 'String'"),
        ("from std_srvs.srv import SetBool_Nothing", "cannot import name 'SetBool_Nothing'"),
        ("import std_msgs.mgs", "'std_msgs.mgs'; did you mean 'std_msgs.msg'"),
        ("from std_msgs.msgs import String", "did you mean 'std_msgs.msg'"),
        ("from std_msgs import messages", "did you mean 'std_msgs.msg'"),
        ("from std_msgs import String", "write from std_msgs.msg import String$"),
        ("import std_msgs.String", "write from std_msgs.msg import String$"),
        ("import std_msgs.msg.String", "String is a class and not a module: write from std_msgs.m"),
        ("from std_msgs.msg.String import String", "write from std_msgs.msg import String$"),
        ("from example_interfaces import AddTwoInts", "write from example_interfaces.srv import A"),
        ("from sensor_msgs.msg import Twist", "write from geometry_msgs.msg import Twist$"),
        ("from std_msgs import Nothing", "'std_msgs.Nothing'; std_msgs has std_msgs.msg$"),
        ("import std_msgs.srv", "has no services, only std_msgs.msg; did you mean 'std_srvs.srv'"),
        ("import geometry_msgs.action", "has no actions, only geometry_msgs.msg$"),
        ("import std_msg.msg", "^No module named 'std_msg'; did you mean 'std_msgs'.$"),
        ("from geometry_msg.msg import Twist", "did you mean 'geometry_msgs'.$"),
        ("from std_srv.srv import SetBool", "did you mean 'std_srvs'.$"),
        ("import std_msgs.msg._nothing", "_nothing"),
        ("import no_such_package_msgs", "no_such_package_msgs"),
    ],
)
def test_a_missing_name_is_an_import_error(statement: str, message: str) -> None:
    with pytest.raises(ImportError, match=message):
        exec(statement, {})


@pytest.mark.parametrize(
    ("statement", "message"),
    [
        ("from named_msgs.msg import my_speed", "rename the file my_speed.msg .*'MySpeed'$"),
        ("from named_msgs.msg import MySpeed", "rename the file my_speed.msg .*'MySpeed'$"),
        ("from named_msgs.srv import Add", "move .*Add.srv into the folder named_msgs/srv$"),
        ("from named_msgs.msg import Pose2", "move .*Pose2.msg into the folder named_msgs/msg$"),
    ],
)
def test_a_file_of_a_wrong_name_or_folder_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, statement: str, message: str
) -> None:
    for name in ("msg/my_speed.msg", "msg/Add.srv", "srv/Sub.srv", "msgs/Pose2.msg"):
        file = tmp_path / "named_msgs" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("---\n" if name.endswith("srv") else "int32 x\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "named_msgs", raising=False)
    with pytest.raises(ImportError, match=message):
        exec(statement, {})


def test_a_missing_attribute_is_an_attribute_error() -> None:
    module = importlib.import_module("std_msgs.msg")
    assert not hasattr(module, "Strng")
    with pytest.raises(AttributeError, match="did you mean 'String'") as caught:
        _ = module.Strng
    assert not caught.value.name  # otherwise, Python suggests the name once more
    package = importlib.import_module("std_msgs")
    assert not hasattr(package, "String")
    with pytest.raises(AttributeError, match=r"write from std_msgs\.msg import String"):
        _ = package.String
    assert importlib.util.find_spec("std_msgs.nothing") is None


def test_installing_twice_changes_nothing() -> None:
    before = list(sys.meta_path)
    install_importer()
    assert sys.meta_path == before


def test_a_real_package_wins(folder: Path) -> None:
    package = folder / "std_msgs" / "msg"
    package.mkdir(parents=True)
    (folder / "std_msgs" / "__init__.py").touch()
    (package / "__init__.py").write_text("String = 'real'", encoding="utf-8")
    for name in [name for name in sys.modules if name.partition(".")[0] == "std_msgs"]:
        del sys.modules[name]
    assert importlib.import_module("std_msgs.msg").String == "real"


def test_a_package_of_definitions_can_be_imported(folder: Path) -> None:
    write_definition(folder / "import_one" / "msg" / "Foo.msg")
    assert importlib.import_module("import_one.msg").Foo(x=1).x == 1


def test_a_python_package_may_have_definitions(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_definition(folder / "import_two" / "msg" / "Foo.msg")
    code = folder / "import_two" / "import_two"
    code.mkdir()
    (code / "__init__.py").write_text("answer = 42", encoding="utf-8")
    monkeypatch.syspath_prepend(str(folder / "import_two"))
    assert importlib.import_module("import_two").answer == 42
    assert importlib.import_module("import_two.msg").Foo(x=1).x == 1


def test_a_module_named_msg_is_left_alone(folder: Path) -> None:
    write_definition(folder / "import_three" / "msg" / "Foo.msg")
    (folder / "import_three" / "__init__.py").touch()
    (folder / "import_three" / "msg" / "__init__.py").write_text("Foo = 1", encoding="utf-8")
    assert importlib.import_module("import_three.msg").Foo == 1


def test_a_broken_definition_is_not_reported_as_a_missing_name(folder: Path) -> None:
    write_definition(folder / "import_four" / "msg" / "Foo.msg", "float x")
    with pytest.raises(ValueError, match=r"Foo\.msg:1: there is no type 'float'"):
        exec("from import_four.msg import Foo", {})


def test_importing_reads_no_definition() -> None:
    # The interfaces alone, as if `zbot/__init__.py` imported nothing else.
    program = (
        "import sys, types; sys.path.insert(0, sys.argv[1]); z = types.ModuleType('zbot');"
        "z.__path__ = [sys.argv[1] + '/zbot']; sys.modules['zbot'] = z;"
        "import zbot.interfaces as i; i.install_importer(); import std_msgs.msg;"
        "print(*[m for m in ('numpy', 'zbot.interfaces.parser', 'difflib') if m in sys.modules])"
    )
    root = Path(__file__).parents[3]
    result = subprocess.run(
        [sys.executable, "-c", program, str(root)],
        capture_output=True,
        text=True,
        check=True,
        timeout=30,
    )
    assert result.stdout.strip() == ""


def write_definition(file: Path, text: str = "int32 x") -> None:
    file.parent.mkdir(parents=True)
    file.write_text(text, encoding="utf-8")


def test_imports_while_definitions_are_loaded_find_no_definition() -> None:
    # `copy` of Python 3.11 tries to import `org`, which only Jython has.
    source = """
import sys, zbot
class Curious:
    def find_spec(self, name, path, target=None):
        if name == "zbot.interfaces.registry":
            try:
                import no_such_module
            except ImportError as error:
                print(error.name)
sys.meta_path.insert(0, Curious())
from std_msgs.msg import String
print(String(data="x").data)
"""
    done = subprocess.run(
        [sys.executable, "-c", source], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["no_such_module", "x"]


def test_the_import_of_a_package_is_enough() -> None:
    program = (
        "import zbot, std_msgs, example_interfaces\n"
        "print(std_msgs.msg.Bool(data=True), example_interfaces.srv.AddTwoInts.Request(a=1).a)\n"
        "print(hasattr(std_msgs, 'srv'), hasattr(std_msgs, 'nothing'))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout == "std_msgs.msg.Bool(data=True) 1\nFalse False\n"
