"""Verbs of `zbot class`: start a classroom, list and check its students, and stop it."""

from __future__ import annotations

import os
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import typer

from zbot.transport.config import HUB_PORT
from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import AsJson, new_app, print_json

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.classroom.bundle.service import Served
    from zbot.classroom.teacher.class_check import Verdict
    from zbot.classroom.teacher.invitation import Invitation
    from zbot_cli.commands.class_.robot import RobotSpec

app = new_app("Start and manage a class")


@app.callback()
def options() -> None:
    """Start and manage a class."""


@app.command("start")
def start(
    name: Annotated[str | None, typer.Argument(help="Name of the class")] = None,
    pin: Annotated[
        bool, typer.Option("--pin", help="Make a PIN, which students must enter")
    ] = False,
    new_pin: Annotated[
        bool, typer.Option("--new-pin", help="Give an open class another PIN")
    ] = False,
    port: Annotated[
        int | None, typer.Option("--port", min=1, max=65535, help="TCP port; 7447 by default")
    ] = None,
    students: Annotated[
        Path | None, typer.Option("--students", help="File with NUMBER,NAME in each line")
    ] = None,
    keystore: Annotated[
        Path | None, typer.Option("--keystore", help="Folder of this machine's certificate")
    ] = None,
    robot: Annotated[
        list[str] | None,
        typer.Option(
            "--robot",
            help="Robot of ROS 2, e.g. dds, or NAME=dds:DOMAIN for /class/NAME",
        ),
    ] = None,
    rate: Annotated[
        list[str] | None,
        typer.Option("--rate", help="Maximum messages per second of a topic: '/camera/*=5'"),
    ] = None,
    bundle: Annotated[
        Path | None,
        typer.Option("--bundle", help="Folder of `class bundle`, from which students install"),
    ] = None,
    sensors: Annotated[
        bool | None,
        typer.Option(
            "--sensors/--no-sensors",
            help="Whether the live page may publish cameras and other sensors of browsers",
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Start a class, or show its join code."""
    from zbot.classroom.join_request import clean_name  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher import opening  # noqa: PLC0415 - as above
    from zbot.classroom.teacher.invitation import invitation_to  # noqa: PLC0415 - as above
    from zbot.classroom.teacher.roster import load_roster  # noqa: PLC0415 - as above
    from zbot_cli.domain.client import print_programs_outside  # noqa: PLC0415 - as above

    robots = _robots(robot or [])
    if bundle:
        from zbot.classroom.bundle import manifest  # noqa: PLC0415 - few classes have a bundle

        manifest.load(bundle).check(bundle)
    opened, record = opening.start(
        opening.ClassOptions(
            name=clean_name(name) if name else None,
            port=port,
            with_pin=pin,
            pin=os.environ.get("ZBOT_PIN", "").strip() if pin or new_pin else "",
            new_pin=new_pin,
            expected=load_roster(students) if students else None,
            keystore=keystore,
            sensors=sensors,
        )
    )
    invitation = invitation_to(opened, record)
    for class_robot in robots:
        robot_module().start(class_robot, rate or [])
    served = _served(bundle, invitation.host)
    if as_json:
        print_json({**invitation.document(), **({"bundle": served.document()} if served else {})})
    else:
        print(
            "\n".join([*(_bundle_module().lines(served) if served else []), _join_text(invitation)])
        )
    if not record.has_sensors and not as_json:
        print("The live page publishes no sensors of browsers in this class")
    for class_robot in robots:
        if not as_json:
            robot_name = class_robot.name
            print(f"The robot is in /class/{robot_name}/. `zbot class give NUMBER {robot_name}`")
    print_programs_outside()


@app.command("bundle")
def make_bundle(
    out: Annotated[Path, typer.Option("--out", help="Folder, e.g. on a USB stick")],
    systems: Annotated[
        str, typer.Option("--systems", help="Systems, or e.g. linux-x86_64 for one processor")
    ] = "windows,macos,linux",
    python: Annotated[
        str, typer.Option("--python", help="Versions: 3.11..3.14, or a list with commas")
    ] = "3.11..3.14",
    extras: Annotated[str, typer.Option("--extras", help="Extras of zbot")] = "web,bag,view,sim",
    wheel: Annotated[
        Path | None, typer.Option("--wheel", help="zbot's own wheel; default: it is built")
    ] = None,
    check_only: Annotated[
        bool, typer.Option("--check", help="Only check the files of a folder that was made")
    ] = False,
) -> None:
    """Make a folder for installing without the internet.

    The same line continues after an interruption, and replaces damaged files.
    """
    module = _bundle_module()
    if check_only:
        module.check(out)
    else:
        module.make(out, systems, python, extras, wheel)


def _bundle_module() -> Any:
    """Return the module for bundles. It is imported late, because few classes have a bundle."""
    from zbot_cli.commands.class_ import bundle  # noqa: PLC0415 - as above

    return bundle


def _served(folder: Path | None, host: str) -> Served | None:
    """Serve a bundle if a folder is given. Return the bundle that is served now."""
    from zbot.classroom.bundle import service  # noqa: PLC0415 - not needed by `--help`

    return service.start(folder, host) if folder else service.find()


def robot_module() -> Any:
    """Return the module for robots. It is imported late, because few classes have a robot."""
    from zbot_cli.commands.class_ import robot  # noqa: PLC0415 - as above

    return robot


def _robots(texts: list[str]) -> list[RobotSpec]:
    """Return the robots in the values of `--robot`. Check that they can be connected."""
    if not texts:
        return []
    found = [robot_module().RobotSpec.parse(text) for text in texts]
    robot_module().check_rclpy()
    return found


@app.command("run-robot", hidden=True)
def run_robot(
    name: Annotated[str, typer.Argument(help="Name of the robot")],
    ros_domain: Annotated[int, typer.Option("--ros-domain", help="Domain of ROS 2")] = 0,
    rate: Annotated[list[str] | None, typer.Option("--rate", help="As for `class start`")] = None,
) -> None:
    """Run the bridge of a robot."""
    from zbot_cli.commands.class_.robot import RobotSpec, run  # noqa: PLC0415 - in the background only

    run(RobotSpec(name, ros_domain), rate or [])


@app.command("give")
def give(
    number: Annotated[int, typer.Argument(min=1, max=232, help="Number of a student")],
    robot: Annotated[str, typer.Argument(help="Name of the robot")] = "robot",
) -> None:
    """Let one student drive the robot.

    On a terminal, any key takes the robot back.
    """
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - not needed by `--help`

    told = command({"op": "give", "number": number, "robot": robot})
    robot_module().until_key(told, lambda: command({"op": "give", "robot": robot}))


@app.command("take")
def take(
    robot: Annotated[str, typer.Argument(help="Name of the robot")] = "robot",
) -> None:
    """Stop the robot, and let nobody drive it."""
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - not needed by `--help`

    command({"op": "give", "robot": robot})
    print(f"nobody drives {robot}")


def _join_text(invitation: Invitation) -> str:
    lines = [f'Class "{invitation.class_name}" is open. Students type:', ""]
    if invitation.code:
        lines.append(f"    zbot join {invitation.code}")
        lines += [f"    zbot join {invitation.address}    (if the code does not work)", ""]
    else:
        lines += [_no_code(invitation.port), "", f"    zbot join {invitation.address}", ""]
    if invitation.pin:
        lines.append(f"PIN: {invitation.pin}")
    return "\n".join([*lines, "`zbot class list` lists students, `zbot class stop` ends the class"])


def _no_code(port: int) -> str:
    from zbot.classroom.join_code import PORTS  # noqa: PLC0415 - few classes have another port

    first, *_, last = sorted(port for port in PORTS if HUB_PORT - 10 < port < HUB_PORT + 10)
    return (
        f"There is no code, because no code can contain the port {port}: "
        f"use the default port, or a port from {first} to {last}"
    )


@app.command("list")
def list_students(as_json: AsJson = False) -> None:
    """List the students and their machines."""
    from zbot.classroom.teacher.invitation import invitation  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - as above

    found = command({"op": "list"})
    invited = invitation()
    if as_json:
        print_json({**found, "join": invited.document()})
        return
    from zbot_cli.commands.class_.table import table  # noqa: PLC0415 - not needed by `--help`

    print(table(found, invited))


class _BagCommand(ManyValuesCommand):
    """Parser of options that take several values."""

    many: ClassVar[frozenset[str]] = frozenset({"--bag", "--students", "--topics", "--program"})


@app.command("check", cls=_BagCommand)
def check(
    expected: Annotated[
        str,
        typer.Argument(
            help='What to check, e.g. "publishes std_msgs/String on /student_id at >= 1 Hz"'
        ),
    ],
    bags: Annotated[
        list[Path] | None,
        typer.Option("--bag", help="Check these bags instead of running programs"),
    ] = None,
    world: Annotated[
        str | None, typer.Option("--sim", help="World in which the programs of --program run")
    ] = None,
    programs: Annotated[
        list[Path] | None,
        typer.Option("--program", help="Run these programs, or all programs of a folder"),
    ] = None,
    robot: Annotated[
        str, typer.Option("--robot", help="Robot in the world, as for `zbot sim`")
    ] = "two_wheeled",
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the noise of sensors")] = 0,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="Folder of the bags of --program")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Check the programs of all students.

    With --sim and --program, run programs in a world and check them there. This needs no class.
    """
    if world or programs:
        if not (world and programs) or bags:
            raise CommandError("--sim and --program need each other, and --bag fits neither")
        from zbot_cli.commands.class_.sim_check import check_programs  # noqa: PLC0415 - few need it

        tell = _tell_nothing if as_json else _print_verdict
        verdicts = check_programs(
            *(expected, programs),
            world=world,
            robot=robot,
            seed=seed,
            output=output,
            tell=tell,
        )
        _end_check(verdicts, as_json=as_json, is_printed=True)
        return
    from zbot.classroom.teacher.expectation import parse_expectations  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher.opening import check_class  # noqa: PLC0415 - as above

    expectations = parse_expectations(expected)
    if bags:
        from zbot_cli.commands.class_.bag_check import check_bag  # noqa: PLC0415 - only for bags

        verdicts = [check_bag(bag, expectations) for bag in bags]
    else:
        verdicts = check_class(expectations)
    if not verdicts:
        raise CommandError(
            "nobody has joined the class, so there is nothing to check",
            hint="`zbot class list` shows who has joined",
        )
    _end_check(verdicts, as_json=as_json)


def _end_check(verdicts: Sequence[Verdict], *, as_json: bool, is_printed: bool = False) -> None:
    """Print verdicts, unless they are printed, and end with an error if one is bad."""
    passed = sum(verdict.passes for verdict in verdicts)
    if as_json:
        print_json([{**asdict(result), "passes": result.passes} for result in verdicts])
    else:
        for result in () if is_printed else verdicts:
            _print_verdict(result)
        print(f"{passed} of {len(verdicts)} pass")
    if passed < len(verdicts):
        raise typer.Exit(Status.ERROR)


def _print_verdict(result: Verdict) -> None:
    mark = "ok  " if result.passes else "FAIL"
    number = f"{result.number:3}  " if result.number else ""
    print(f"{mark}  {number}{result.name}  {'; '.join(result.problems)}".rstrip(), flush=True)


def _tell_nothing(_result: Verdict) -> None:
    """Say nothing: all verdicts are printed at the end."""


@app.command("record", cls=_BagCommand)
def record(
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="Folder; default: a name with date and time"),
    ] = None,
    students: Annotated[
        list[int] | None, typer.Option("--students", help="Numbers of students; default: all")
    ] = None,
    topics: Annotated[
        list[str] | None, typer.Option("--topics", help="Topics of the students; default: all")
    ] = None,
    max_bag_size: Annotated[
        int,
        typer.Option("-b", "--max-bag-size", min=0, help="Maximum bytes of a file; 0: no limit"),
    ] = 0,
) -> None:
    """Record the topics of each student."""
    from zbot_cli.commands.class_.recording import ClassRecording  # noqa: PLC0415 - not needed by `--help`

    ClassRecording(output, students or [], topics or [], max_bag_size).run()


@app.command("say")
def say(text: Annotated[list[str], typer.Argument(help="Text of the message")]) -> None:
    """Send a message to all students."""
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - not needed by `--help`

    heard = command({"op": "say", "text": " ".join(text)})["heard"]
    print(f"sent to {heard} student{'' if heard == 1 else 's'}")


@app.command("free")
def free(
    number: Annotated[int, typer.Argument(min=1, max=232, help="Number of a student")],
) -> None:
    """Free a student's number for another laptop."""
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - not needed by `--help`

    freed = command({"op": "free", "number": number})
    was = "was connected, and is out of the class now" if freed["here"] else "was not connected"
    print(f"number {number} is free; {freed['name']} had it: the laptop {freed['host']} {was}")


@app.command("next")
def begin_next_period(
    students: Annotated[
        Path | None,
        typer.Option("--students", help="File with NUMBER,NAME in each line, for the next period"),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Begin a new period.

    All numbers are free then. The code and the PIN stay.
    """
    from zbot.classroom.teacher.invitation import invitation  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - as above
    from zbot.classroom.teacher.roster import load_roster  # noqa: PLC0415 - as above

    expected = load_roster(students) if students else None
    freed = command({"op": "next", "expected": expected})["freed"]
    if as_json:
        print_json({"freed": freed, "join": invitation().document()})
        return
    what = (
        "1 number of the last period is"
        if freed == 1
        else f"{freed} numbers of the last period are"
    )
    print(f"{what} free again")
    print(_join_text(invitation()))


@app.command("stop")
def stop() -> None:
    """Stop the class."""
    from zbot.classroom.teacher import opening  # noqa: PLC0415 - not needed by `--help`
    from zbot_cli.domain.client import print_programs_outside  # noqa: PLC0415 - as above

    print(f'Class "{opening.stop().class_name}" is closed')
    print_programs_outside()
