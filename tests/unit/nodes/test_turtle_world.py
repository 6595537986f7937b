"""Tests of the turtles' world, tick by tick, against numbers of ROS 2's turtlesim."""

from __future__ import annotations

import math

import pytest

from zbot_nodes.turtlesim.drawing import Drawing, Line, Pen
from zbot_nodes.turtlesim.world import SIZE, Rotation, RotationState, Turtle, TurtleWorld, normal

PEN = (179, 184, 255)
WHITE = (255, 255, 255)


class Events(list[tuple[str, str]]):
    """Log lines of the world: level and text."""

    def __call__(self, level: str, text: str) -> None:
        self.append((level, text))


@pytest.fixture
def events() -> Events:
    return Events()


@pytest.fixture
def world(events: Events) -> TurtleWorld:
    made = TurtleWorld(events)
    assert not made.tick()  # the first tick only starts the time
    events.clear()
    return made


@pytest.fixture
def turtle(world: TurtleWorld) -> Turtle:
    return world.turtles["turtle1"]


def ticks(world: TurtleWorld, count: int) -> None:
    for _ in range(count):
        assert world.tick()


def test_the_world_has_the_size_of_a_32_bit_float() -> None:
    assert SIZE == 11.088889122009277


def test_the_first_turtle_is_announced() -> None:
    events = Events()
    TurtleWorld(events)
    text = "Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]"
    assert events == [("info", text)]


def test_a_command_lasts_a_second(world: TurtleWorld, turtle: Turtle) -> None:
    world.command("turtle1", 2.0, 1.8)
    ticks(world, 100)
    assert (turtle.x, turtle.y_up, turtle.heading) == pytest.approx(
        (6.6105, 6.9079, 1.7856), abs=1e-4
    )
    assert (turtle.speed, turtle.turn) == (0, 0)


@pytest.mark.parametrize(
    ("forward", "turn", "x", "heading"), [(2, 0, 7.5284, 0), (0, 2, SIZE / 2, 1.984)]
)
def test_an_arrow_key_moves_two_units(
    world: TurtleWorld, turtle: Turtle, forward: float, turn: float, x: float, heading: float
) -> None:
    world.command("turtle1", forward, turn)
    ticks(world, 100)
    assert (turtle.x, turtle.heading) == pytest.approx((x, heading), abs=1e-4)


def test_the_wall_is_hit_on_tick_174(world: TurtleWorld, turtle: Turtle, events: Events) -> None:
    for _ in range(173):
        world.command("turtle1", 2.0, 0.0)
        ticks(world, 1)
    assert not events
    world.command("turtle1", 2.0, 0.0)
    ticks(world, 1)
    text = "Oh no! I hit the wall! (Clamping from [x=11.112445, y=5.544445])"
    assert events == [("warning", text)]
    assert turtle.x == SIZE


def test_turning_left_gives_a_negative_delta(world: TurtleWorld, events: Events) -> None:
    progress: list[float] = []
    ends: list[tuple[RotationState, float]] = []
    rotation = Rotation(1.57, progress.append, lambda state, delta: ends.append((state, delta)))
    world.rotate("turtle1", rotation)
    ticks(world, 120)
    ((state, delta),) = ends
    assert state is RotationState.SUCCEEDED
    assert delta == pytest.approx(-1.5520, abs=1e-4)
    assert len(progress) == 98  # 97 of these ticks moved the turtle
    assert events == [("info", "Rotation goal completed successfully")]


def test_a_rotation_turns_the_shorter_way(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.heading = 3.0
    world.rotate("turtle1", Rotation(-3.0))
    ticks(world, 1)
    assert turtle.turn == 1.0


@pytest.mark.parametrize(
    ("disturb", "state", "line"),
    [
        (
            lambda world: world.command("turtle1", 1, 0),
            RotationState.ABORTED,
            "Velocity command received during rotation goal. Aborting goal",
        ),
        (
            lambda world: world.rotate("turtle1", Rotation(0.5)),
            RotationState.ABORTED,
            "Rotation goal received before a previous goal finished. Aborting previous goal",
        ),
    ],
)
def test_a_rotation_ends_when_it_is_interrupted(
    world: TurtleWorld, events: Events, disturb: object, state: RotationState, line: str
) -> None:
    ends: list[RotationState] = []
    world.rotate("turtle1", Rotation(2.0, on_end=lambda ended, _: ends.append(ended)))
    ticks(world, 5)
    assert callable(disturb)
    disturb(world)
    assert ends == [state]
    assert events == [("warning", line)]


def test_a_rotation_can_be_canceled(world: TurtleWorld, turtle: Turtle, events: Events) -> None:
    ends: list[RotationState] = []
    asked: list[bool] = []
    world.rotate(
        "turtle1",
        Rotation(
            2.0, on_end=lambda ended, _: ends.append(ended), is_cancel_requested=lambda: bool(asked)
        ),
    )
    ticks(world, 5)
    asked.append(True)
    ticks(world, 1)
    assert ends == [RotationState.CANCELED]
    assert events == [("info", "Rotation goal canceled")]
    assert turtle.turn == 0


def test_teleports_happen_in_order_at_the_next_tick(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.teleport_to(2.0, 3.0, math.pi / 2)
    turtle.teleport_by(1.0, 0.0)
    assert turtle.x == SIZE / 2
    ticks(world, 1)
    assert (turtle.x, turtle.y_up) == pytest.approx((2.0, 4.0))
    assert len(world.drawing.lines) == 2


def test_a_teleport_beyond_the_wall_ends_at_it(
    world: TurtleWorld, turtle: Turtle, events: Events
) -> None:
    turtle.teleport_to(-1.0, 20.0, 0.0)
    ticks(world, 1)
    assert (turtle.x, turtle.y_up) == (0, SIZE)
    assert events == [
        ("warning", "Oh no! I hit the wall! (Clamping from [x=-1.000000, y=0.000000])")
    ]


def test_sideways_speed_is_kept_until_the_next_command(world: TurtleWorld, turtle: Turtle) -> None:
    world.command("turtle1", 0.0, 0.0, 1.0)
    ticks(world, 1)
    assert turtle.y_up == pytest.approx(SIZE / 2 + 0.016)
    world.command("turtle1", 0.0, 0.0)
    ticks(world, 1)
    assert turtle.y_up == pytest.approx(SIZE / 2 + 0.032)
    assert turtle.speed == 1.0


def test_generated_names_skip_taken_names(world: TurtleWorld, events: Events) -> None:
    assert world.spawn(1, 1, 0, "turtle2") is not None
    spawned = world.spawn(1, 1, 0)
    assert spawned is not None
    assert spawned.name == "turtle3"
    assert world.spawn(1, 1, 0, "turtle3") is None
    assert events[-1] == ("error", "A turtle named [turtle3] already exists")
    world.kill("nobody")
    assert events[-1] == ("error", "Tried to kill turtle [nobody], which does not exist")
    world.kill("turtle3")
    assert sorted(world.turtles) == ["turtle1", "turtle2"]


def test_reset_restores_the_start(world: TurtleWorld, turtle: Turtle, events: Events) -> None:
    world.spawn(1, 1, 0)
    world.command("turtle1", 2.0, 0.0)
    ticks(world, 10)
    world.reset()
    assert list(world.turtles) == ["turtle1"]
    assert world.turtles["turtle1"] is not turtle
    assert not world.drawing.lines
    assert events[-2:] == [
        ("info", "Resetting turtlesim."),
        ("info", "Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]"),
    ]


def test_clear_keeps_the_turtles(world: TurtleWorld, turtle: Turtle, events: Events) -> None:
    world.command("turtle1", 2.0, 0.0)
    ticks(world, 10)
    assert world.colour_under(turtle) == PEN
    world.clear()
    assert world.colour_under(turtle) == WHITE
    assert world.turtles["turtle1"] is turtle
    assert events == [("info", "Clearing turtlesim.")]


@pytest.mark.parametrize(
    ("wanted", "pen"),
    [
        ((1, 2, 3, 5, 0), Pen(1, 2, 3, 5)),
        ((1, 2, 3, 0, 0), Pen(1, 2, 3, 1)),
        ((1, 2, 3, 5, 1), Pen(is_down=False)),
    ],
)
def test_a_pen_is_set(turtle: Turtle, wanted: tuple[int, int, int, int, int], pen: Pen) -> None:
    turtle.set_pen(*wanted)
    assert turtle.pen == pen


def test_a_lifted_pen_leaves_no_line(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.set_pen(0, 0, 0, 0, 1)
    world.command("turtle1", 2.0, 0.0)
    ticks(world, 10)
    assert not world.drawing.lines
    assert world.colour_under(turtle) == WHITE


def test_lines_have_their_width() -> None:
    drawing = Drawing()
    drawing.add(Line(100, 100, 120, 100, Pen(1, 2, 3, 3)))
    coloured = [y for y in range(90, 111) if drawing.colour_at(110, y) == (1, 2, 3)]
    assert coloured == [99, 100, 101]
    assert drawing.colour_at(98, 100) == WHITE
    assert drawing.colour_at(121, 101) == (1, 2, 3)


@pytest.mark.parametrize("corner", [(-50, -50), (0, 0), (499, 499), (600, 700)])
def test_lines_outside_of_the_sheet_are_not_drawn(corner: tuple[int, int]) -> None:
    drawing = Drawing()
    drawing.add(Line(*corner, *corner, Pen(width=255)))
    assert drawing.colour_at(250, 250) == WHITE


@pytest.mark.parametrize(
    ("angle", "same"), [(0, 0), (4, 4 - 2 * math.pi), (-4, 2 * math.pi - 4), (7, 7 - 2 * math.pi)]
)
def test_angles_are_between_minus_pi_and_pi(angle: float, same: float) -> None:
    assert normal(angle) == pytest.approx(same, abs=1e-6)


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -math.inf])
def test_values_that_are_no_numbers_do_not_end_the_world(world: TurtleWorld, wrong: float) -> None:
    turtle = world.spawn(wrong, wrong, wrong)
    assert turtle is not None
    turtle.command(wrong, wrong, wrong)
    world.tick()
    turtle.teleport_to(wrong, 3.0, wrong)
    world.tick()
    turtle.teleport_by(wrong, wrong)
    turtle.rotate(Rotation(wrong), Events())
    world.tick()
    assert (turtle.x, turtle.y_up, turtle.heading) == (0.0, 3.0, 0.0)
