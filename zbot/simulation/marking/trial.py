"""Trial: one run of one program in a world, until its goals are decided."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

from zbot.context import Context
from zbot.errors.suggestion import did_you_mean
from zbot.executor.single_threaded_executor import SingleThreadedExecutor
from zbot.simulation.errors import SimulationError
from zbot.simulation.marking.grammar import Task, parse_task
from zbot.simulation.marking.program import MarkedProgram, is_launch_file
from zbot.simulation.marking.recording import RunRecording
from zbot.simulation.marking.sight import Sight
from zbot.simulation.node.pace import Pace
from zbot.simulation.node.program import Options, robots_of
from zbot.simulation.node.simulator import Simulator
from zbot.simulation.world import World
from zbot.simulation.worlds.catalog import WORLDS
from zbot.simulation.worlds.file import find_world
from zbot.simulation.worlds.plan import Plan
from zbot.threads.deadline import Deadline

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.classroom.teacher.expectation import Observed
    from zbot.simulation.worlds.file import FoundWorld

#: How long a program may need until its first node waits for work.
START_S = 20.0
#: A program that has ended, or hangs, cannot change anything after this time of the world.
_AFTER_END_S = 2.0
_HANGING_S = 5.0
#: Real seconds without a new node after which all nodes of a launch file have started.
_LAUNCH_S = 2.0
_LOOK_S = 0.02
_MOVED_M = 0.01


@dataclass(frozen=True)
class Course:
    """What all programs of a check have in common.

    Attributes:
        task: The goals in the words of the teacher.
        options: The world, its only robot, and the seed.
        domain: A domain that nobody else uses.
        limit_s: Seconds after which the world goes on without a node that is not done.
    """

    task: str
    options: Options
    domain: int
    limit_s: float = 5.0

    def world(self) -> FoundWorld:
        """Return a new world."""
        return find_world(self.options.world)

    def read(self, found: FoundWorld) -> Task:
        """Return the task, with the places of a world."""
        return parse_task(self.task, named_places(self.options.world, found))


def named_places(name: str, found: FoundWorld) -> dict[str, tuple[float, float]]:
    """Return the named places of a world: those of its plan, and its things."""
    plan = WORLDS[name]() if name in WORLDS else Plan()
    bodies = {
        body.name: (float(body.pos[0]), float(body.pos[1]))
        for body in found.spec.bodies
        if body.name and body.name != "world"
    }
    places = {name: (place.x, place.y) for name, place in plan.places.items()}
    return bodies | {"start": (found.start.x, found.start.y)} | places


@dataclass(frozen=True)
class Mark:
    """Result of a trial.

    Attributes:
        problems: Why the program does not pass. Empty if it passes.
        time_s: How long the run took, in the time of the world.
        is_exact: Whether each run of the program gives the same result: all was in lockstep.
    """

    problems: tuple[str, ...]
    time_s: float
    is_exact: bool


class Trial:
    """One run of one program.

    Args:
        course: What all programs have in common.
        program: The file of the program.
        bag: The folder of the bag, which must not exist.
    """

    def __init__(self, course: Course, program: Path, bag: Path) -> None:
        self._course, self._path = course, program
        found = course.world()
        self._task = course.read(found)
        self._world = World(found.spec, seed=course.options.seed, earth=found.earth)
        self._context = Context()
        self._context.init(args=[], domain_id=course.domain)
        self._simulator = self._new_simulator()
        robots = robots_of(course.options, self._world, found.start)
        self._simulator.add_robots(robots)
        self._robot = self._world.robots[robots[0][0]]
        self._sight = Sight(self._world, self._robot)
        self._recording = RunRecording(self._simulator, bag)
        self._late_since_s: float | None = None
        self._ended_s: float | None = None
        self._was_late = ""
        self._pace = Pace(1.0)  # while a node is late
        self.output = ""  #: what the program has printed

    def _new_simulator(self) -> Simulator:
        simulator = Simulator(self._world, Pace(None), in_lockstep=True, context=self._context)
        simulator.is_paused = True  # this trial does the steps
        assert simulator.lockstep is not None
        self._lockstep = simulator.lockstep
        self._lockstep.limit_s = self._course.limit_s
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(simulator)
        return simulator

    def run(self) -> Mark:
        """Run the program until its goals are decided."""
        environment = {**os.environ, "ZBOT_DOMAIN_ID": str(self._course.domain)}
        environment["ROS_DOMAIN_ID"] = environment["ZBOT_DOMAIN_ID"]
        program = MarkedProgram(self._path, environment)
        try:
            problem = self._wait_for_start(program) or self._drive(program)
            problems = self._problems(problem or program.failure or self._was_late)
        finally:
            program.end()
            self.output = program.output
            self._recording.close()
            self._executor.shutdown()
            self._simulator.destroy_node()
            self._context.try_shutdown()
        is_exact = not self._was_late and not self._ended_s
        return Mark(problems, self._sight.now_s, is_exact)

    def _wait_for_start(self, program: MarkedProgram) -> str:
        """Wait until the program waits for work. Return why it does not."""
        deadline = Deadline(START_S)
        lockstep = self._lockstep
        while not lockstep.present:
            if program.has_ended:
                return program.failure or "the program ended before it made a node"
            if deadline.is_over:
                return self._no_follower()
            self._executor.spin_once(_LOOK_S)
            lockstep.notice_changes()
        if is_launch_file(self._path):
            self._wait_for_others()
        self._settle()
        self._settle()  # with the subscriptions to the program's topics
        return ""

    def _wait_for_others(self) -> None:
        """Wait until no more nodes of a launch file come. The time of the world stands."""
        lockstep, known = self._lockstep, len(self._lockstep.present)
        start, quiet = Deadline(START_S), Deadline(_LAUNCH_S)
        while not (start.is_over or quiet.is_over):
            self._executor.spin_once(_LOOK_S)
            lockstep.notice_changes()
            if len(lockstep.present) != known:
                known, quiet = len(lockstep.present), Deadline(_LAUNCH_S)

    def _no_follower(self) -> str:
        own = self._simulator.handle.token.zid
        nodes = [node for node in self._context.graph.snapshot().nodes if node.zid != own]
        if not nodes:
            return f"the program made no node within {START_S:g} s"
        return (
            "the program's nodes do not follow the time of the world: rclpy.init() must get the "
            "words after --ros-args"
        )

    def _settle(self) -> None:
        self._recording.follow_program()
        for topics in self._simulator.topics.values():
            topics.follow_commands()
        self._simulator.send()
        self._lockstep.settle(self._world.time_ns)
        self._recording.end_instant()

    def _drive(self, program: MarkedProgram) -> str:
        """Move the world. Return a problem of the program, if it ends the run."""
        while not self._is_decided():
            self._keep_pace()
            self._simulator.step()
            if self._lockstep.has_changed:
                self._lockstep.has_changed = False
                self._settle()
            self._recording.end_instant()
            self._look()
            problem = self._end_of(program)
            if problem is not None:
                return problem
        return ""

    def _keep_pace(self) -> None:
        """Let the world run in real time while a node is late: nothing else would be fair."""
        late = self._lockstep.late
        if not late:
            self._late_since_s = None
            return
        self._was_late = self._was_late or (
            f"{late[0]} did not end its work of {self._sight.now_s:.1f} s within "
            f"{self._lockstep.limit_s:g} s"
        )
        if self._late_since_s is None:
            self._late_since_s = self._sight.now_s
            self._pace.restart()
        while not self._pace.is_due(self._world.step_s):
            self._executor.spin_once(self._world.step_s / 2)

    def _look(self) -> None:
        self._sight.advance()
        for goal in self._task.goals:
            if goal.is_decided:
                continue
            goal.look(self._sight)
            goal.is_missed = goal.is_missed or (
                not goal.is_met and not goal.holds and self._sight.now_s >= goal.limit_s
            )

    def _is_decided(self) -> bool:
        """Return whether nothing more can change the mark."""
        goals = self._task.goals
        now_s = self._sight.now_s
        aims = [goal for goal in goals if not goal.holds]
        if now_s >= self._task.limit_s or (aims and all(goal.is_decided for goal in aims)):
            return True
        return bool(goals) and all(goal.is_missed for goal in goals)

    def _end_of(self, program: MarkedProgram) -> str | None:
        """Return the problem that ends the run early. None means that it goes on."""
        now_s = self._sight.now_s
        if program.has_ended:
            self._ended_s = now_s if self._ended_s is None else self._ended_s
            if now_s - self._ended_s >= _AFTER_END_S:
                return program.failure or f"the program ended at {self._ended_s:.1f} s"
        since_s = self._late_since_s
        if since_s is not None and now_s - since_s >= _HANGING_S and not self._moves():
            return self._was_late
        return None

    def _moves(self) -> bool:
        return not self._sight.stands or any(self._robot.command)

    def _problems(self, first: str) -> tuple[str, ...]:
        """Return all problems. That of the program is the first, and hides what follows from it."""
        found = [goal.problem for goal in self._task.goals]
        graph: Observed = self._context.graph.snapshot()  # pyright: ignore[reportAssignmentType] - see Observed
        passed_s = max(self._sight.now_s, 0.1)
        rates_hz = {topic: count / passed_s for topic, count in self._recording.counts.items()}
        found += [wanted.problem(graph, rates_hz) for wanted in self._task.expectations]
        found = list(filter(None, found))
        if first and self._sight.way_m < _MOVED_M:
            return (first,)  # all other problems follow from it
        if found and self._sight.way_m < _MOVED_M:
            found.append(self._no_command())
        return tuple(dict.fromkeys(filter(None, [first if found else "", *found])))

    def _no_command(self) -> str:
        """Return why the robot has not moved, if that is known."""
        drive = self._robot.model.equipment.drive
        topic = "/" + (drive.command_topic if drive is not None else "cmd_vel").lstrip("/")
        if self._recording.counts[topic]:
            return ""
        theirs = [name for name in self._recording.counts if name != topic]
        return f"no message came on {topic}{did_you_mean(topic, theirs, before='; ')}"


def check_course(course: Course) -> None:
    """Check a course before any program runs.

    Raises:
        SimulationError: The world or the robot cannot be simulated.
        ClassValueError: A part of the task is not a goal.
    """
    found = course.world()
    course.read(found)
    if len(robots_of(course.options, World(found.spec), found.start)) != 1:
        raise SimulationError("a check needs one robot")
