"""Tests of `zbot launch` with real processes and signals."""

from __future__ import annotations

import re
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.cli.launch.conftest import is_alive, pid_in

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import Program


def test_the_bundled_temperature_system_runs_until_ctrl_c(start: Callable[..., Program]) -> None:
    program = start("zbot", "launch", "temperature")
    program.wait_for("[INFO] [launch]: All log files can be found below ")
    sensor = pid_in(program.wait_for("[INFO] [sensor-1]: process started with pid ["))
    program.wait_for("[INFO] [monitor-2]: process started with pid [")
    program.wait_for("[monitor-2] [")
    program.wait_for(" temperature: ")
    assert program.stop() == 0
    assert "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)" in program.output
    assert f"[INFO] [sensor-1]: process has finished cleanly [pid {sensor}]" in program.output
    assert "Traceback" not in program.output
    assert not is_alive(sensor)


def test_a_launch_file_of_a_package_finds_its_package(
    start: Callable[..., Program], tmp_path: Path
) -> None:
    package = tmp_path / "src" / "my_robot_pkg"
    (package / "my_robot_pkg").mkdir(parents=True)
    (package / "launch").mkdir()
    (package / "my_robot_pkg" / "__init__.py").touch()
    (package / "package.xml").write_text("<package><name>my_robot_pkg</name></package>")
    (package / "setup.py").write_text(
        "from setuptools import setup\n"
        "setup(name='my_robot_pkg', entry_points={'console_scripts': ["
        "'temperature_sensor = my_robot_pkg.sensor:main']})"
    )
    (package / "my_robot_pkg" / "sensor.py").write_text(
        "import zbot\n"
        "def main():\n"
        "    with zbot.init():\n"
        "        node = zbot.Node('unnamed')\n"
        "        print('I am', node.get_fully_qualified_name())\n"
        "        zbot.spin(node)\n"
    )
    (package / "launch" / "temperature_system.launch.py").write_text(
        "from launch import LaunchDescription\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='my_robot_pkg',\n"
        "        executable='temperature_sensor', name='sensor'),\n"
        "        Node(package='my_robot_pkg', executable='temperature_sensor', cwd='/')])\n"
    )
    program = start("zbot", "launch", "my_robot_pkg", "temperature_system.launch.py")
    for line in ("[temperature_sensor-1] I am /sensor", "[temperature_sensor-2] I am /unnamed"):
        program.see(line)
    assert program.stop() == 0


def test_output_is_prefixed_and_not_buffered(launch: Callable[..., Program]) -> None:
    program = launch(
        'python(\'import time, sys; print("out"); print("err", file=sys.stderr); '
        "time.sleep(60)', name='chatty')"
    )
    program.wait_for("[chatty-1] out")
    program.see("[chatty-1] err")  # two pipes have no common order
    assert program.stop(timeout=15) == 0


def test_a_terminal_is_emulated(launch: Callable[..., Program]) -> None:
    program = launch(
        "python('import sys; print(sys.stdout.isatty(), sys.stderr.isatty())', name='tty', "
        "emulate_tty=True), python('import sys; print(sys.stdout.isatty())', name='pipe')"
    )
    assert program.wait() == 0
    assert "[tty-1] True True" in program.output
    assert "[pipe-2] False" in program.output


def test_the_default_output_also_reaches_the_log(
    launch: Callable[..., Program], log_folder: Path
) -> None:
    program = launch(
        "python('print(\"seen\")', name='a'), python('print(\"hidden\")', name='b', output='log'),"
        "python('print(\"own\")', name='c', output='own_log')"
    )
    assert program.wait() == 0
    text = (log_folder / "latest" / "launch.log").read_text()
    assert "[a-1] seen" in text
    assert "[b-2] hidden" in text
    assert "[b-2]" not in program.output.replace("[INFO] [b-2]", "")
    assert (log_folder / "latest" / "c-3-stdout.log").read_text() == "[c-3] own\n"
    assert (log_folder / "latest" / "c-3.log").read_text() == "[c-3] own\n"


def test_ros2_runs_zbot_where_ros2_is_not_installed(launch: Callable[..., Program]) -> None:
    program = launch(
        "ExecuteProcess(cmd=['ros2', 'interface', 'show', 'std_msgs/msg/Empty'], name='a'),"
        "ExecuteProcess(cmd=['ros2 interface show std_msgs/msg/String | head -5'], shell=True),"
        "ExecuteProcess(cmd=[FindExecutable(name='ros2'), ' --version'], shell=True, name='c')"
    )
    assert program.wait(20) == 0
    assert "string data" in program.output
    assert "[c-3] zbot " in program.output


def test_names_parameters_and_scopes_reach_the_nodes(
    launch: Callable[..., Program], tmp_path: Path
) -> None:
    node = tmp_path / "node.py"
    node.write_text(
        "import zbot, sys, os\n"
        "with zbot.init():\n"
        "    node = zbot.Node('given', automatically_declare_parameters_from_overrides=True)\n"
        "    print('name', node.get_fully_qualified_name())\n"
        "    values = {n: node.get_parameter(n).value for n in ('a', 'b', 'c')\n"
        "              if node.has_parameter(n)}\n"
        "    print('values', values, os.environ.get('COLOUR'), sys.argv[1:2])\n"
        "    print('topic', node.resolve_topic_name('in'))\n"
    )
    program = launch(
        f"""
        DeclareLaunchArgument('ns', default_value='one'),
        GroupAction([
            PushRosNamespace(LaunchConfiguration('ns')), PushRosNamespace('two'),
            SetParameter('a', 1), SetRemap('in', 'out'), SetEnvironmentVariable('COLOUR', 'red'),
            ExecuteProcess(cmd=[sys.executable, '-c', ''], name='x'),
            Node(executable=sys.executable, arguments=[{str(node)!r}, 'word'], exec_name='p',
                 name='n', parameters=[{{'b': [1.0, 2.0], 'c': LaunchConfiguration('ns')}}]),
        ]),
        Node(executable=sys.executable, arguments=[{str(node)!r}], exec_name='q', namespace='/z'),
        """,
        "ns:=uno",
    )
    assert program.wait(20) == 0, program.output
    text = program.output
    assert "[p-2] name /uno/two/n" in text
    assert re.search(r"values \{'a': 1, 'b': .*1\.0, 2\.0.*, 'c': 'uno'\} red \['word'\]", text)
    assert "[p-2] topic /uno/two/out" in text
    assert "[q-3] name /z/given" in text
    assert "[q-3] values {} None" in text


def test_a_component_container_is_left_out_with_a_sentence(launch: Callable[..., Program]) -> None:
    program = launch(
        "ComposableNodeContainer(name='c', namespace='', package='rclcpp_components',"
        "executable='component_container', composable_node_descriptions=[]), LogInfo(msg='on')"
    )
    assert program.wait() == 0
    assert "the container 'c' is left out: it is a program that loads C++" in program.output
    assert "[launch.user]: on" in program.output


@pytest.mark.parametrize(
    ("actions", "words", "text"),
    [
        ("Node(package='no_such', executable='x')", [], "16: Package 'no_such' not found"),
        ("Node(package='zbot', executable='talkr')", [], "did you mean 'talker'?"),
        ("ExecuteProcess(cmd=['ls', LaunchConfiguration('x')])", [], "'x' does not exist"),
        ("DeclareLaunchArgument('must')", [], '16: Required launch argument "must" was not'),
        ("DeclareLaunchArgument('c', choices=['a'])", ["c:=b"], "Valid options are: ['a']"),
        ("LogInfo(msg='a'), 5", [], "must be an action, not int"),
        ("IncludeLaunchDescription('/no/such.launch.py')", [], "'/no/such.launch.py' not found"),
        ("IncludeLaunchDescription(__file__)", [], "include each other without end"),
        ("OpaqueFunction(function=lambda context: 1 / 0)", [], "16: ZeroDivisionError"),
        ("GroupAction([LogInfo(msg='a')], condition=IfCondition('maybe'))", [], "not 'maybe'"),
        ("Node(package='zbot', executable='talker', remappings=['a'])", [], "must be a pair"),
        ("Node(package='zbot', executable='talker', output='scren')", [], "must be one of screen"),
    ],
)
def test_a_mistake_is_reported_with_file_and_line(
    launch: Callable[..., Program], actions: str, words: list[str], text: str
) -> None:
    sleeper = "python('import time; time.sleep(600)', name='other'), "
    program = launch(f"{sleeper}\n{actions}", *words)
    assert program.wait() == 1
    (line,) = (line for line in program.lines if line.startswith("[ERROR]"))
    assert "a.launch.py:" in line
    assert text in line
    for started in (line for line in program.lines if "process started" in line):
        assert not is_alive(pid_in(started))


def test_a_prefix_is_put_before_the_selected_executables(launch: Callable[..., Program]) -> None:
    program = launch(
        "python('print(1)', name='one'), python('print(2)', name='two')",
        "--launch-prefix",
        "echo before",
        "--launch-prefix-filter",
        "on",
    )
    assert program.wait() == 0
    assert "[one-1] before " in program.output
    assert "[two-2] 2" in program.output


def test_an_undeclared_argument_is_reported_with_a_hint(launch: Callable[..., Program]) -> None:
    program = launch("DeclareLaunchArgument('speed', default_value='1')", "sped:=2", "free:=3")
    assert program.wait() == 0
    warnings = [line for line in program.lines if line.startswith("[WARNING]")]
    assert warnings == [
        "[WARNING] [launch]: no launch argument 'sped' is declared; did you mean 'speed'?"
    ]


def test_a_wrong_argument_is_reported_too_if_the_right_one_is_missing(
    launch: Callable[..., Program],
) -> None:
    program = launch("DeclareLaunchArgument('speed')", "sped:=2")
    assert program.wait() == 1
    assert "no launch argument 'sped' is declared; did you mean 'speed'?" in program.output
    assert 'Required launch argument "speed" was not provided' in program.output


def test_arguments_of_included_files_are_known(
    launch: Callable[..., Program], tmp_path: Path
) -> None:
    (tmp_path / "b.launch.xml").write_text("<launch><arg name='speed' default='1'/></launch>")
    included = f"IncludeLaunchDescription({str(tmp_path / 'b.launch.xml')!r})"
    program = launch(f"{included}, DeclareLaunchArgument('sped', default_value='1')", "speed:=2")
    assert program.wait() == 0
    assert "is declared" not in program.output


def test_arguments_and_description_are_shown(tmp_path: Path) -> None:
    file = tmp_path / "a.launch.xml"
    file.write_text(
        "<launch><arg name='speed' default='1' description='how fast'/><arg name='must'/>"
        "<group if='$(var must)'><arg name='maybe' default='$(var speed)'/></group></launch>"
    )
    shown = zbot("launch", "-s", str(file))
    assert (shown.code, shown.err) == (0, "")
    assert shown.out == (
        "Arguments (pass arguments as '<name>:=<value>'):\n"
        "\n    'speed':\n        how fast\n        (default: '1')\n"
        "\n    'must':\n        no description given\n"
        "\n    'maybe'*:\n        no description given\n        (default: LaunchConfig('speed'))\n"
        "\n* argument(s) which are only used if specific conditions occur\n"
    )
    printed = zbot("launch", "-p", str(file))
    assert printed.out.splitlines()[:2] == [
        "<launch.LaunchDescription>",
        "    DeclareLaunchArgument('speed', default_value='1', description='how fast')",
    ]
    assert zbot("launch", "-s", "temperature").out.endswith("No arguments.\n")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["temperatur"], "did you mean 'temperature'?"),
        (["zbot", "nothing.launch.py"], "was not found in the share directory of package 'zbot'"),
        (["zbot"], "no launch file of package 'zbot' is given"),
        (["no_such", "a.launch.py"], "package 'no_such' not found"),
        (["no/such.launch.py"], "launch file 'no/such.launch.py' not found"),
        (["robot.launch.py"], "type: zbot launch zbot_nodes robot.launch.py"),
        (["temperature", "a"], "package 'temperature' not found"),
        (["talker_listener", "a:="], "malformed launch argument 'a:='"),
        (["temperature", "--launch-prefix-filter", "a"], "--launch-prefix must be specified"),
    ],
)
def test_a_wrong_command_line_is_refused(words: list[str], text: str) -> None:
    outcome = zbot("launch", *words)
    assert outcome.code == 1
    assert text in outcome.err
    assert outcome.out == ""


def test_a_folder_whose_name_no_package_can_have_does_not_hide_the_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "c"
    folder.mkdir()
    (folder / "setup.py").write_text("from setuptools import setup\nsetup(name='c')\n")
    monkeypatch.chdir(folder)
    outcome = zbot("launch", "no.launch.py")
    assert (outcome.code, outcome.err) == (1, "launch file 'no.launch.py' not found\n")


def test_a_file_that_launches_nothing_is_named(tmp_path: Path) -> None:
    file = tmp_path / "a.launch.py"
    file.write_text(
        "from launch import LaunchDescription\n"
        "def generate_launch_description():\n    return LaunchDescription()\n"
    )
    outcome = zbot("launch", str(file))
    assert outcome.code == 0
    assert f"{file} launches nothing: put its actions into Launch" in outcome.out + outcome.err


def test_arguments_in_one_word_are_named(tmp_path: Path) -> None:
    file = tmp_path / "a.launch.py"
    arguments = "['-c', '', '--ros-args -p speed:=2.0']"
    node = f"Node(executable={sys.executable!r}, arguments={arguments})"
    file.write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        f"def generate_launch_description():\n    return LaunchDescription([{node}])\n"
    )
    outcome = zbot("launch", str(file))
    assert "arguments=['--ros-args', '-p', 'speed:=2.0']" in outcome.out + outcome.err


def test_a_similar_file_is_suggested(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "chat.launch.py").touch()
    monkeypatch.chdir(tmp_path)
    assert zbot("launch", "./chat.launch").err.endswith("did you mean './chat.launch.py'?\n")


def test_words_are_completed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # a checkout in a folder `zbot` is itself a package of this name
    assert "talker_listener" in zbot("complete", "--", "launch", "talker").out.split()
    assert zbot("complete", "--", "launch", "talker_listener", "na").out == "namespace:=\n"
    assert "temperature.launch.py" in zbot("complete", "--", "launch", "zbot", "").out.split()


def test_a_file_whose_suffix_tells_no_format_is_launched(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "src" / "harbour_pkg" / "launch"
    folder.mkdir(parents=True)
    (folder.parent / "package.xml").write_text("<package><name>harbour_pkg</name></package>")
    text = "<launch><log message='ships' level='info'/></launch>"
    (folder / "harbour.launch").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert "it has harbour.launch" in zbot("launch", "harbour_pkg").err
    outcome = zbot("launch", "harbour_pkg", "harbour.launch")
    assert outcome.code == 0, outcome.err
    assert "ships" in outcome.out + outcome.err


def test_python_m_zbot_is_the_command_and_runs_programs(tmp_path: Path) -> None:
    program = tmp_path / "hello.py"
    program.write_text("import launch, sys\nprint(launch.__name__, sys.argv[1:])\n")
    for words, expected in (
        (["--version"], "zbot "),
        ([str(program), "a", "-b"], "launch ['a', '-b']"),
    ):
        done = subprocess.run(
            [sys.executable, "-m", "zbot", *words], capture_output=True, text=True, check=True
        )
        assert done.stdout.startswith(expected)


def test_a_launch_with_a_wrong_domain_says_only_what_is_wrong(
    launch: Callable[..., Program], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_DOMAIN_ID", "300")
    program = launch("Node(package='zbot_nodes', executable='talker')")
    assert program.wait()
    assert "ZBOT_DOMAIN_ID is '300'" in program.output
    assert "Traceback" not in program.output
