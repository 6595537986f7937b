"""Tests of launch files with programs that cannot run in zbot: they are named and left out."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

from tests.cli.conftest import write_package
from tests.cli.launch.conftest import launcher
from zbot.package import PackageNotFoundError, package_share
from zbot.package.ament_index import get_package_share_directory
from zbot.package.bundled_nodes import BUNDLED_NODES
from zbot.package.finder import COMPAT_PACKAGES
from zbot.package.unavailable import _BY_PACKAGE, _BY_PROGRAM, _PACKAGES
from zbot.package.zbot_command import find_on_path

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.cli.conftest import Command
    from tests.conftest import Program, Start

    Launch = Callable[..., Program]

_IMPORTS = """
import os, sys
from ament_index_python.packages import *
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackagePrefix, FindPackageShare
gazebo = Node(package="stage_ros2", executable="spawn_entity.py", name="spawn")
done = ExecuteProcess(cmd=[sys.executable, "-c", "print('still here')"])
def generate_launch_description():
    return LaunchDescription([
"""
VIEWER = (
    "Node(package='mapviz', executable='mapviz', arguments=['-d', FindPackageShare('nowhere')])"
)
SENTENCE = (
    "[WARNING] [launch]: mapviz is left out: it is a 3D viewer in C++, which does not run here; "
    "`zbot web` shows topics, images, plots and the graph, and `zbot foxglove` serves 3D viewers"
)
WORLD = "PathJoinSubstitution([FindPackageShare('stage_ros2'), 'launch', 'gz_sim.launch.py'])"
INCLUDE = f"IncludeLaunchDescription({WORLD}, launch_arguments={{'gz_args': '-r'}}.items())"


@pytest.fixture
def launch(tmp_path: Path, start: Start) -> Launch:
    """Return a function that launches the given arguments of a LaunchDescription."""
    return launcher(_IMPORTS, tmp_path, start)


def test_a_known_program_is_named_once_and_the_launch_goes_on(launch: Launch) -> None:
    program = launch(f"{VIEWER}, {VIEWER}, done")
    assert program.wait() == 0
    assert program.output.count(SENTENCE) == 1
    assert "still here" in program.output
    assert "nodes with the name" not in program.output


def test_strict_fails_at_the_first_one(launch: Launch) -> None:
    program = launch(f"{VIEWER}, done", "--strict")
    assert program.wait() == 1
    assert "a.launch.py:16: mapviz does not run here: it is a 3D viewer" in program.output
    assert "still here" not in program.output


def test_a_launch_file_of_a_known_package_is_left_out(launch: Launch) -> None:
    program = launch(f"{INCLUDE}, done")
    assert program.wait() == 0
    assert "stage_ros2 is left out: it is a simulator in C++" in program.output
    assert "still here" in program.output


def test_a_launch_file_of_a_package_with_known_messages_is_left_out(launch: Launch) -> None:
    file = (
        "PathJoinSubstitution([FindPackageShare('robot_localization'), 'launch', 'ekf.launch.py'])"
    )
    program = launch(f"IncludeLaunchDescription({file}), done")
    assert program.wait(20) == 0
    assert "robot_localization is left out" in program.output
    assert "still here" in program.output


def test_a_launch_file_that_a_copy_of_a_package_lacks_is_left_out(launch: Launch) -> None:
    folder = "FindPackageShare('nav2_bringup'), 'launch'"
    absent = f"PathJoinSubstitution([{folder}, 'tb3_simulation_launch.py'])"
    typo = f"PathJoinSubstitution([{folder}, 'bringup_lanch.py'])"
    program = launch(f"IncludeLaunchDescription({absent}), IncludeLaunchDescription({typo})")
    assert program.wait() == 1
    assert "launch/tb3_simulation_launch.py of nav2_bringup is left out" in program.output
    assert "bringup_lanch.py' not found (did you mean 'bringup_launch.py'?)" in program.output


def test_a_known_command_is_left_out(launch: Launch) -> None:
    if find_on_path("webots", {}) is not None:
        pytest.skip("this machine has Webots")
    program = launch("ExecuteProcess(cmd=['webots', '-s', 'world']), done")
    assert program.wait() == 0
    assert "webots is left out: it is a simulator in C++" in program.output
    assert "still here" in program.output


def test_what_waits_for_the_end_of_a_short_program_goes_on(launch: Launch) -> None:
    waiting = "RegisterEventHandler(OnProcessExit(target_action=gazebo, on_exit=[done]))"
    program = launch(f"{waiting}, gazebo")
    assert program.wait() == 0
    assert "stage_ros2 is left out" in program.output
    assert "still here" in program.output


def test_what_waits_for_the_end_of_a_viewer_does_not_run(launch: Launch) -> None:
    viewer = "viewer := Node(package='mapviz', executable='mapviz', on_exit=Shutdown())"
    waiting = "RegisterEventHandler(OnProcessExit(target_action=viewer, on_exit=[done]))"
    program = launch(f"{viewer}, {waiting}")
    assert program.wait() == 0
    assert "still here" not in program.output


def test_a_managed_node_that_cannot_run_is_left_out(launch: Launch) -> None:
    driver = "package='urg_node', executable='urg_node', name='urg', namespace='', autostart=True"
    program = launch(f"LifecycleNode({driver}), done")
    assert program.wait() == 0
    assert "urg_node is left out: it is a compiled driver of a laser scanner" in program.output


def test_a_cpp_program_of_the_workspace_is_left_out(
    launch: Launch, workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write_package(workspace, "my_robot")
    (folder / "setup.py").unlink()
    (folder / "CMakeLists.txt").write_text(
        "project(my_robot)\nadd_executable(drive drive.cpp)\n"
        "install(TARGETS drive DESTINATION lib/${PROJECT_NAME})\n"
    )
    monkeypatch.setenv("ZBOT_WORKSPACE", str(workspace))
    program = launch("Node(package='my_robot', executable='drive'), done")
    assert program.wait() == 0
    assert "drive of package my_robot is left out: it is a C++ program" in program.output
    assert "still here" in program.output


def test_strict_fails_for_components_too(launch: Launch) -> None:
    components = "[ComposableNode(package='a', plugin='a::B')]"
    container = f"name='box', composable_node_descriptions={components}"
    options = f"ComposableNodeContainer(namespace='', package='c', executable='d', {container})"
    program = launch(f"{options}, done", "--strict")
    assert program.wait() == 1
    assert "the container 'box' of a::B does not run here: it is a program that" in program.output
    assert "still here" not in program.output


def test_a_typo_still_ends_the_launch(launch: Launch) -> None:
    program = launch("Node(package='rviz3', executable='rviz3'), done")
    assert program.wait() == 1
    assert "Package 'rviz3' not found" in program.output


SHARES = [
    "get_package_share_directory('stage_ros2')",
    "get_package_share_directory('stage_ros2', print_warning=True)",
    "str(get_package_share_path('stage_ros2'))",
    "os.path.join(get_package_prefix('stage_ros2'), 'share', 'stage_ros2')",
    "FindPackageShare('stage_ros2')",
    "FindPackageShare('stage_ros2').find('stage_ros2')",
    "PathJoinSubstitution([FindPackagePrefix('stage_ros2'), 'share', 'stage_ros2'])",
]


@pytest.mark.parametrize("share", SHARES)
def test_the_folder_of_a_known_package_does_not_end_the_launch(launch: Launch, share: str) -> None:
    path = f"PathJoinSubstitution([{share}, 'launch', 'gz_sim.launch.py'])"
    program = launch(
        f"IncludeLaunchDescription({path}), SetEnvironmentVariable('GZ', {share}),"
        f"LogInfo(msg='logged', condition=LaunchConfigurationEquals('a', {share})), done"
    )
    assert program.wait() == 0
    assert program.output.count("stage_ros2 is left out: it is a simulator in C++") == 1
    line = "a.launch.py:16: this line is left out, because it needs launch/gz_sim.launch.py of "
    assert f"{line}stage_ros2" in program.output
    assert "still here" in program.output
    assert "Share directory for" not in program.output


def test_an_xml_file_may_use_the_folder_of_a_known_package(
    tmp_path: Path, start: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    file = tmp_path / "a.launch.xml"
    file.write_text(
        "<launch><include file='$(find-pkg-share stage_ros2)/launch/gz_sim.launch.py'/>"
        "<executable cmd='echo $(find-pkg-prefix stage_ros2)' output='screen'/></launch>"
    )
    program = start("zbot", "launch", str(file))
    assert program.wait() == 0
    assert program.output.count("stage_ros2 is left out") == 1
    assert f"[echo-1] {sys.prefix}" in program.output


def test_strict_fails_at_the_folder_of_a_known_package(launch: Launch) -> None:
    program = launch("LogInfo(msg=get_package_share_directory('stage_ros2')), done", "--strict")
    assert program.wait() == 1
    assert "a.launch.py:16: stage_ros2 does not run here: it is a simulator" in program.output


def test_what_needs_a_file_of_a_known_package_is_left_out(launch: Launch) -> None:
    urdf = "Command(['cat ', FindPackageShare('ur_description'), '/urdf/ur.urdf.xacro'])"
    state = "package='robot_state_publisher', executable='robot_state_publisher'"
    node = f"Node({state}, parameters=[{{'robot_description': {urdf}}}])"
    program = launch(f"{node}, done")
    assert program.wait() == 0
    assert "ur_description is left out: it is a package of a robot, which is not here" in (
        program.output
    )
    assert "16: this line is left out, because it needs urdf/ur.urdf.xacro of ur_description" in (
        program.output
    )
    assert "still here" in program.output


def test_a_description_that_uses_a_known_package_is_left_out(
    launch: Launch, tmp_path: Path
) -> None:
    pytest.importorskip("xacro")
    include = '<xacro:include filename="$(find ur_description)/urdf/ur_macro.xacro"/>'
    robot = f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">{include}</robot>'
    (tmp_path / "a.xacro").write_text(robot)
    urdf = f"Command(['xacro ', {str(tmp_path / 'a.xacro')!r}])"
    state = "package='robot_state_publisher', executable='robot_state_publisher'"
    program = launch(f"Node({state}, parameters=[{{'robot_description': {urdf}}}]), done")
    assert program.wait() == 0
    assert "because it needs a file of ur_description" in program.output
    assert "still here" in program.output


NEEDS = {
    "opened": ("open(share('ur_description') + '/x.yaml')", "x.yaml of ur_description"),
    "imported": (
        "sys.path.append(share('ur_description') + '/launch'); import ur_launch",
        "launch/ur_launch.py of ur_description",
    ),
    "module": ("import clearpath_config.parser", "the module clearpath_config of clearpath_config"),
    "exit": (
        "try: open(share('ur_description') + '/x.urdf')\n    except OSError: sys.exit(2)",
        "x.urdf of ur_description",
    ),
}


@pytest.mark.parametrize("name", NEEDS)
@pytest.mark.parametrize("is_function", [False, True])
def test_a_file_or_function_that_needs_a_file_of_a_known_package_is_left_out(
    launch: Launch, tmp_path: Path, name: str, is_function: bool
) -> None:
    code, file = NEEDS[name]
    text = "import sys\nfrom ament_index_python import get_package_share_directory as share\n"
    if is_function:
        (tmp_path / "helper.py").write_text(f"{text}def fail(context):\n    {code}\n")
        path = f"sys.path.insert(0, {str(tmp_path)!r})"
        program = launch(f"{path} or OpaqueFunction(function=__import__('helper').fail), done")
    else:
        inner = tmp_path / "inner.launch.py"
        inner.write_text(f"{text}def generate_launch_description():\n    {code}\n")
        program = launch(f"IncludeLaunchDescription({str(inner)!r}), done")
    assert program.wait() == 0
    assert f"16: this line is left out, because it needs {file}" in program.output
    assert "still here" in program.output


def test_a_file_that_calls_exit_is_an_error_with_a_line(launch: Launch) -> None:
    program = launch("OpaqueFunction(function=lambda context: sys.exit('set ROBOT')), done")
    assert program.wait() == 1
    assert "a.launch.py:16: SystemExit: set ROBOT" in program.output


def test_a_file_that_cannot_be_read_without_a_known_package_is_an_error(launch: Launch) -> None:
    program = launch("LogInfo(msg=open(get_package_share_directory('ur_description') + '/a'))")
    assert program.wait() == 1
    assert "a.launch.py:16: ur_description is not here: it is a package of a robot" in (
        program.output
    )


@pytest.mark.parametrize(
    ("package", "hint"),
    [("nav2_bringp", "nav2_bringup"), ("demo_nodes_pi", "demo_nodes_py"), ("my_own_robot", "")],
)
def test_the_folder_of_an_unknown_package_ends_the_launch(
    launch: Launch, package: str, hint: str
) -> None:
    program = launch(f"LogInfo(msg=get_package_share_directory({package!r})), done")
    assert program.wait() == 1
    assert f"16: package '{package}' not found" in program.output
    assert (f"did you mean '{hint}'?" in program.output) is bool(hint)
    assert "still here" not in program.output


@pytest.mark.parametrize("words", [[], ["speed:=2"], ["other:=2"]])
def test_an_included_file_without_its_module_is_left_out_with_and_without_arguments(
    launch: Launch, tmp_path: Path, words: list[str]
) -> None:
    (tmp_path / "arm.launch.py").write_text("import clearpath_config.common\n", encoding="utf-8")
    included = f"IncludeLaunchDescription({str(tmp_path / 'arm.launch.py')!r})"
    program = launch(f"DeclareLaunchArgument('speed', default_value='1'), {included}, done", *words)
    assert program.wait() == 0
    assert "this line is left out, because it needs the module clearpath_config" in program.output
    assert "still here" in program.output


def test_the_arguments_are_shown_without_those_of_a_file_that_cannot_be_read(
    launch: Launch, tmp_path: Path
) -> None:
    (tmp_path / "arm.launch.py").write_text("import clearpath_config.common\n", encoding="utf-8")
    included = f"IncludeLaunchDescription({str(tmp_path / 'arm.launch.py')!r})"
    program = launch(f"{included}, DeclareLaunchArgument('speed')", "-s")
    assert program.wait() == 0
    assert "a.launch.py:16: the arguments of the included file are not shown: " in program.output
    assert "'speed':" in program.output


def test_a_file_of_which_only_the_template_exists_is_left_out(
    launch: Launch, tmp_path: Path
) -> None:
    template = tmp_path / "arm.launch.py.in"
    template.write_text("@SPEED@", encoding="utf-8")
    included = f"IncludeLaunchDescription({str(tmp_path / 'arm.launch.py')!r})"
    program = launch(f"{included}, done")
    assert program.wait() == 0
    assert f"arm.launch.py is left out: it is made from the template {template}" in program.output
    assert "a.launch.py:16: this line is left out, because it needs arm.launch" in program.output
    assert "still here" in program.output


def test_the_template_of_a_launch_file_is_not_launched(
    zbot_command: Command, workspace: Path
) -> None:
    folder = write_package(workspace, "my_robot")
    (folder / "launch").mkdir()
    (folder / "launch" / "arm.launch.py.in").write_text("@SPEED@", encoding="utf-8")
    for name in ("arm.launch.py", "arm.launch.py.in"):
        for words in (["my_robot", name], [str(folder / "launch" / name)]):
            outcome = zbot_command("launch", *words)
            assert outcome.code == 1
            assert "arm.launch.py does not exist here: CMake makes it from" in outcome.err


def test_the_arguments_of_a_file_that_names_a_known_package_are_shown(launch: Launch) -> None:
    share = "get_package_share_directory('stage_ros2')"
    program = launch(f"DeclareLaunchArgument('world', default_value={share})", "--show-args")
    assert program.wait() == 0
    assert "'world':" in program.output


def test_a_program_gets_an_error_for_a_known_package() -> None:
    with pytest.raises(PackageNotFoundError, match="'stage_ros2' not found"):
        get_package_share_directory("stage_ros2")


COMPONENTS = (
    "ComposableNode(package='composition', plugin='composition::Talker', name='teller',"
    " namespace='/here', remappings=[('chatter', 'words')]),"
    "ComposableNode(package='depth_image_proc', plugin='depth_image_proc::CropNode'),"
    "ComposableNode(package='p', plugin='p::Off', condition=IfCondition('false'))"
)


LOADED = f"composable_node_descriptions=[{COMPONENTS}]"
CONTAINER = (
    "name='box', namespace='', package='rclcpp_components', executable='component_container'"
)


@pytest.mark.parametrize(
    "action",
    [
        f"ComposableNodeContainer({CONTAINER}, {LOADED})",
        f"LoadComposableNodes({LOADED}, target_container='box')",
        f"LoadComposableNodes({LOADED}, target_container=ComposableNodeContainer({CONTAINER}))",
    ],
)
def test_a_component_that_zbot_has_runs_as_a_program(launch: Launch, action: str) -> None:
    program = launch(action)
    program.wait_for("Publishing")
    assert "[talker-1]" in program.output
    assert "[here.teller]" in program.output
    sentence = "the container 'box' of depth_image_proc::CropNode is left out: it is a program that"
    assert program.output.count(sentence) == 1
    assert "p::Off" not in program.output
    assert program.stop() == 0


def test_a_container_that_is_a_node_is_left_out(launch: Launch) -> None:
    program = launch("Node(package='rclcpp_components', executable='component_container'), done")
    assert program.wait() == 0
    assert "rclcpp_components is left out: it is a program that loads C++" in program.output
    assert "still here" in program.output


NO_PROGRAMS = {
    "missing": ("cmd=['nosuch']", "executable 'nosuch' not found on the PATH"),
    "empty": ("cmd=['', 'a']", "executable '' not found on the PATH"),
    "prefix": ("cmd=['echo', 'a'], prefix='noterm -e'", "executable 'noterm' not found"),
    "words": ("cmd=['echo a']", "a shell splits the command line into words"),
    "folder": ("cmd=['ls'], cwd='/no/such'", "the working directory '/no/such' of 'ls' does not"),
    "shell folder": ("cmd=['ls'], cwd='/no/such', shell=True", "cannot start 'ls'"),
    "mode": ("cmd=['./plain'], cwd=HERE", "'./plain' is not executable (type: chmod +x"),
    "shebang": ("cmd=['./bang'], cwd=HERE", "its first line, #!/no/such/python, does not exist"),
    "format": ("cmd=['./none'], cwd=HERE", "its first line does not begin with #!"),
}


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no modes and first lines")
@pytest.mark.parametrize("name", NO_PROGRAMS)
def test_a_program_that_cannot_start_is_an_error_and_the_launch_goes_on(
    launch: Launch, tmp_path: Path, name: str
) -> None:
    for file, text in {"plain": "", "bang": "#!/no/such/python\n", "none": "x = 1\n"}.items():
        (tmp_path / file).write_text(text)
        (tmp_path / file).chmod(0o644 if file == "plain" else 0o755)
    options, sentence = NO_PROGRAMS[name]
    options = options.replace("HERE", repr(str(tmp_path)))
    action = f"e := ExecuteProcess({options}, on_exit=Shutdown(), respawn=True)"
    waiting = "RegisterEventHandler(OnProcessExit(target_action=e, on_exit=LogInfo(msg='ended')))"
    program = launch(f"{action}, {waiting}, TimerAction(period=0.5, actions=[done])")
    assert program.wait() == 1
    assert sentence in program.output
    assert program.output.count("the launch goes on without it") == 1
    assert "a.launch.py:16: " in program.output
    assert "still here" in program.output
    assert "ended" not in program.output


def test_a_program_that_cannot_start_ends_a_strict_launch(launch: Launch) -> None:
    program = launch(
        "ExecuteProcess(cmd=['nosuch']), TimerAction(period=9.0, actions=[done])", "--strict"
    )
    assert program.wait() == 1
    assert "a.launch.py:16: executable 'nosuch' not found on the PATH" in program.output
    assert "still here" not in program.output


@pytest.mark.usefixtures("workspace")
def test_run_says_the_same_sentence(zbot_command: Command) -> None:
    result = zbot_command("run", "mapviz", "mapviz")
    assert (result.code, result.out) == (1, "")
    assert "mapviz does not run here: it is a 3D viewer in C++; `zbot web` shows" in result.err


def test_rviz2_needs_the_extra(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("zbot.package.unavailable.find_spec", lambda _: None)
    result = zbot_command("run", "rviz2", "rviz2")
    assert (result.code, result.out) == (1, "")
    assert (
        'rviz2 does not run here: it is a 3D viewer in C++; after `pip install "zbot[view]"`'
        in (result.err)
    )
    assert find_on_path("rviz2", {"PATH": str(tmp_path)}) is None


def test_the_table_names_each_package_once_and_no_package_of_zbot() -> None:
    names = [name for _, text in _PACKAGES for name in text.split()]
    assert len(names) == len(set(names))
    assert not set(names) & {*BUNDLED_NODES, *(path.name for path in COMPAT_PACKAGES.iterdir())}
    for kind in {*_BY_PACKAGE.values(), *_BY_PROGRAM.values()}:
        assert not kind.what.endswith(".")
        assert not kind.instead.endswith(".")
    with pytest.raises(PackageNotFoundError):
        package_share("mapviz")
