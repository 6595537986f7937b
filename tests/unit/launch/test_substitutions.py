from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from zbot.errors import ZbotError
from zbot.launch import LaunchContext
from zbot.launch.condition import (
    IfCondition,
    LaunchConfigurationEquals,
    LaunchConfigurationNotEquals,
    UnlessCondition,
)
from zbot.launch.errors import (
    ConditionError,
    EntityTypeError,
    SubstitutionError,
    SubstitutionSyntaxError,
)
from zbot.launch.frontend.substitution_text import parse
from zbot.launch.frontend.tags import words
from zbot.launch.substitution import normalize, perform
from zbot.launch.substitutions import (
    AnonName,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    FileContent,
    FindExecutable,
    FindPackageShare,
    IfElseSubstitution,
    LaunchConfiguration,
    LocalSubstitution,
    NotEqualsSubstitution,
    PathJoinSubstitution,
    PythonExpression,
    StringJoinSubstitution,
    TextSubstitution,
    ThisLaunchFileDir,
)


@pytest.fixture
def context() -> LaunchContext:
    made = LaunchContext()
    made.launch_configurations.update({"robot": "r2", "yes": "true", "no": "0", "n": "3"})
    made.environment["SIZE"] = "7"
    return made


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("plain", "plain"),
        ("", ""),
        ("a $ b $5", "a $ b $5"),
        ("$(var robot)_arm", "r2_arm"),
        ("$(var missing fallback)", "fallback"),
        ("$(env SIZE)", "7"),
        ("$(env NOWHERE none)", "none"),
        ("$(optenv NOWHERE)", ""),
        ('$(var $(eval \'"ro" + "bot"\'))', "r2"),
        (r"\$(var robot)", "$(var robot)"),
        (r"a \"quoted\" word", 'a "quoted" word'),
        ("it's", "it's"),
        ("$(eval '1 + $(var n)')", "4"),
        ('$(eval "$(var n) > 2")', "True"),
        ("$(eval 2 * 3)", "6"),
        ("$(eval 'floor(2.7)')", "2"),
        (r"$(eval '\'$(var robot)\' == \'r2\'')", "True"),
        ("$(not $(var yes))", "false"),
        ("$(and $(var yes) $(not $(var no)))", "true"),
        ("$(or false $(var no))", "false"),
        ("$(all true 1 on)", "true"),
        ("$(any false 0)", "false"),
        ("$(equals $(var n) 3.0)", "true"),
        ("$(not-equals a b)", "true"),
        ("$(if $(var yes) one two)", "one"),
        ("$(if false one)", ""),
        ("$(command 'echo hi there')", "hi there\n"),
    ],
)
def test_substitutions_are_replaced(context: LaunchContext, text: str, expected: str) -> None:
    assert perform(context, parse(text)) == expected


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("$(var", "'$(var' is not closed"),
        ("$(va x)", "did you mean '$(var ...)'?"),
        ("$( )", "a name must follow"),
        ("$(var 'x)", "the quote ' is not closed"),
        ("$(env)", "takes 1 to 2 arguments, not 0"),
        ("$(not a b)", "takes 1 arguments, not 2"),
    ],
)
def test_a_text_that_breaks_the_grammar_is_refused(text: str, reason: str) -> None:
    with pytest.raises(SubstitutionSyntaxError, match=r".*") as caught:
        parse(text)
    assert reason in str(caught.value)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("ls -l  /tmp", ["ls", "-l", "/tmp"]),
        ("sh -c 'echo $(var robot) now'", ["sh", "-c", "echo r2 now"]),
        ("run --name=$(var robot)_x $(var n)", ["run", "--name=r2_x", "3"]),
        ("a '' b", ["a", "", "b"]),
        ("", []),
    ],
)
def test_a_command_line_is_split_into_words(
    context: LaunchContext, text: str, expected: list[str]
) -> None:
    assert [perform(context, word) for word in words(parse(text))] == expected


def test_the_slash_joins_paths(context: LaunchContext) -> None:
    path = LaunchConfiguration("robot") / "config" / [LaunchConfiguration("n"), ".yaml"]
    assert perform(context, path) == str(Path("r2", "config", "3.yaml"))
    joined = PathJoinSubstitution(["a", "b"]) / "c"
    assert perform(context, joined) == str(Path("a", "b", "c"))


def test_an_unset_configuration_is_an_error_with_a_hint(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionError, match="'robt' does not exist") as caught:
        perform(context, LaunchConfiguration("robt"))
    assert caught.value.hint == "did you mean 'robot'?"
    with pytest.raises(SubstitutionError) as caught:
        perform(context, LaunchConfiguration("robot_ip"))
    assert caught.value.hint.startswith("give it a value: robot_ip:=VALUE, or declare it above: ")


def test_a_default_may_be_a_substitution_or_a_number(context: LaunchContext) -> None:
    default = LaunchConfiguration("missing", default=LaunchConfiguration("robot"))
    assert perform(context, default) == "r2"
    assert perform(context, LaunchConfiguration("missing", default=5)) == "5"


def test_an_unset_environment_variable_is_an_error(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionError, match="'NOWHERE' does not exist") as caught:
        perform(context, EnvironmentVariable("NOWHERE"))
    assert caught.value.hint.startswith("set the environment variable first: type `")


def test_a_failed_expression_is_an_error_with_its_reason(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionError, match=r"cannot evaluate `1/0`: ZeroDivisionError"):
        perform(context, PythonExpression(["1/", "0"]))
    assert perform(context, PythonExpression("os.path.sep", ["os"])) == os.sep


def test_a_failed_command_is_an_error_with_its_reason(context: LaunchContext) -> None:
    failing = [sys.executable, " -c 'import sys; sys.exit(3)'"]
    with pytest.raises(SubstitutionError, match="failed with 3"):
        perform(context, Command(failing))
    with pytest.raises(SubstitutionError, match="cannot run command 'no-such-program'"):
        perform(context, Command("no-such-program"))
    with pytest.raises(SubstitutionError, match=r"failed with 1: ValueError: no$"):
        perform(context, Command([sys.executable, """ -c 'raise ValueError("no")'"""]))
    noisy = [sys.executable, " -c 'import sys; print(1, file=sys.stderr)'"]
    with pytest.raises(SubstitutionError, match="printed to stderr: 1"):
        perform(context, Command(noisy))
    assert perform(context, Command(noisy, on_stderr="ignore")) == ""
    assert perform(context, Command(noisy, on_stderr="capture")) == "1\n"


def test_executables_are_found_and_ros2_runs_zbot(context: LaunchContext) -> None:
    context.environment["PATH"] = os.environ["PATH"]
    assert Path(perform(context, FindExecutable(name="sh"))).is_file()
    assert Path(perform(context, FindExecutable(name="ros2"))).is_file()
    with pytest.raises(SubstitutionError, match="'no-such-program' not found on the PATH"):
        perform(context, FindExecutable(name="no-such-program"))


def test_a_missing_package_is_an_error(context: LaunchContext) -> None:
    with pytest.raises(ZbotError, match="'no_such_package' not found"):
        perform(context, FindPackageShare("no_such_package"))


def test_a_package_is_found_while_a_launch_file_is_read() -> None:
    found = FindPackageShare(package="demo_nodes_cpp").find("demo_nodes_cpp")
    assert Path(found, "launch", "topics", "talker_listener_launch.py").is_file()


def test_the_content_of_a_file_is_a_text(context: LaunchContext, tmp_path: Path) -> None:
    (tmp_path / "a.urdf").write_text("<robot/>", encoding="utf-8")
    assert perform(context, FileContent([str(tmp_path), "/a.urdf"])) == "<robot/>"
    with pytest.raises(SubstitutionError, match="cannot read"):
        perform(context, FileContent(str(tmp_path / "missing")))


def test_local_variables_are_those_of_the_current_event(context: LaunchContext) -> None:
    context.extend_locals({"event": TextSubstitution(text="hello")})
    assert perform(context, LocalSubstitution("event.text")) == "hello"
    context.pop_locals()
    with pytest.raises(SubstitutionError, match=r"'event\.text' is not known here"):
        perform(context, LocalSubstitution("event.text"))
    with pytest.raises(SubstitutionError, match="outside of a launch file"):
        perform(context, ThisLaunchFileDir())


def test_an_anonymous_name_is_made_once(context: LaunchContext) -> None:
    first = perform(context, AnonName("node"))
    assert first.startswith("node_")
    assert perform(context, AnonName("node")) == first
    assert perform(LaunchContext(), AnonName("node")) != first


def test_choices_and_comparisons_are_evaluated(context: LaunchContext) -> None:
    assert perform(context, IfElseSubstitution(LaunchConfiguration("yes"), "a", "b")) == "a"
    assert perform(context, EqualsSubstitution(LaunchConfiguration("yes"), "1")) == "true"
    assert perform(context, NotEqualsSubstitution("a", "a")) == "false"
    assert perform(context, StringJoinSubstitution(["a", "b"], "-")) == "a-b"


def test_conditions_are_evaluated(context: LaunchContext) -> None:
    assert IfCondition(LaunchConfiguration("yes")).evaluate(context)
    assert UnlessCondition(LaunchConfiguration("no")).evaluate(context)
    assert LaunchConfigurationEquals("robot", "r2").evaluate(context)
    assert LaunchConfigurationNotEquals("robot", "bb8").evaluate(context)
    assert LaunchConfigurationEquals("missing", None).evaluate(context)
    with pytest.raises(ConditionError, match="not 'r2'"):
        IfCondition(LaunchConfiguration("robot")).evaluate(context)


def test_a_value_that_is_not_a_text_is_refused() -> None:
    with pytest.raises(EntityTypeError, match="not int: 5"):
        normalize(5)  # type: ignore[arg-type]


def test_a_substitution_in_an_f_string_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert f"bot_{LaunchConfiguration('robot')}".startswith("bot_<")
    assert capsys.readouterr().out == (
        "[WARNING] [launch]: LaunchConfiguration is in an f-string, before it has its value: write "
        "a list in place of the f-string, ['text', LaunchConfiguration(...)]\n"
    )


def test_a_comparison_with_a_text_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    robot = LaunchConfiguration("robot")
    assert robot != "r2"
    assert capsys.readouterr().out == (
        "[WARNING] [launch]: LaunchConfiguration('robot') is compared with 'r2' before it has its "
        "value, so they always differ: write condition=IfCondition(EqualsSubstitution("
        "LaunchConfiguration('robot'), 'r2')) in the action\n"
    )
    assert robot == robot  # noqa: PLR0124 - it is the same object
    assert robot != LaunchConfiguration("robot")
    assert {robot: 1}[robot] == 1
    assert capsys.readouterr().out == ""
