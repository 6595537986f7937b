"""Callbacks that cannot be called are refused, in the words of the program."""

from __future__ import annotations

import functools
import operator
from typing import Any
from unittest.mock import MagicMock, Mock

import pytest

from zbot.errors import WrongStateError, WrongTypeError
from zbot.executor.callback_check import (
    always,
    check_callback,
    if_written,
    never,
    unless_called,
)

MESSAGE = ("(message)", "(message, info)")
TIMER = ("()", "(timer_info)")


class Robot:
    def tick(self) -> None: ...
    def move(self, speed: float = 1.0) -> None: ...
    async def wait(self) -> None: ...
    def hear(self, message: Any) -> None: ...
    def both(self, message: Any, info: Any) -> None: ...
    def add(self, request: Any, response: Any) -> None: ...
    def keyword(self, message: Any, *, scale: float) -> None: ...
    def forgot_self(message: Any) -> None: ...  # noqa: N805 # pyright: ignore[reportSelfClsParameterName]

    def forgot_all() -> None: ...  # type: ignore[misc] # pyright: ignore[reportSelfClsParameterName]

    @classmethod
    def of_class(cls) -> None: ...

    @staticmethod
    def still() -> None: ...

    def __call__(self, message: Any) -> None: ...


robot = Robot()


def called_with(callback: object, *forms: str, **options: Any) -> int:
    return check_callback("create_timer", callback, *forms, **options)


@pytest.mark.parametrize(
    ("callback", "forms", "index"),
    [
        (robot.tick, TIMER, 0),
        (robot.move, TIMER, 0),
        (robot.wait, TIMER, 0),
        (robot.still, TIMER, 0),
        (robot.hear, TIMER, 1),
        (robot.hear, MESSAGE, 0),
        (robot.both, MESSAGE, 1),
        (robot, MESSAGE, 0),
        (lambda: None, TIMER, 0),
        (lambda *all_of_them: None, MESSAGE, 0),  # noqa: ARG005
        (functools.partial(robot.both, 1), MESSAGE, 0),
        (functools.partial(robot.add, response=2), MESSAGE, 0),
        (print, TIMER, 0),
        ([].append, MESSAGE, 0),
        ({}.update, MESSAGE, 0),
        (dict, TIMER, 0),
        (operator.itemgetter(0), MESSAGE, 0),
        (Mock(), MESSAGE, 0),
        (MagicMock(), TIMER, 0),
        (Mock(side_effect=robot.both), TIMER, 0),
    ],
)
def test_whatever_can_be_called_is_accepted(
    callback: object, forms: tuple[str, ...], index: int
) -> None:
    assert called_with(callback, *forms) == index


def test_a_decorator_may_add_an_argument() -> None:
    def with_scale(function: Any) -> Any:
        @functools.wraps(function)
        def wrapper(message: Any) -> Any:
            return function(message, 2, 3)

        return wrapper

    @with_scale
    def hear(message: Any, scale: int, offset: int) -> None: ...

    assert called_with(hear, *MESSAGE) == 0


@pytest.mark.parametrize(
    ("callback", "forms", "text"),
    [
        (robot.add, TIMER, r"takes \(\) or \(timer_info\), but add takes \(self, request, respons"),
        (robot.tick, MESSAGE, r"write def tick\(self, message\):$"),
        (robot.hear, ("(request, response)",), r"write def hear\(self, request, response\):$"),
        (robot.keyword, MESSAGE, r"but keyword takes \(self, message, scale\)"),
        (
            robot.forgot_self,
            MESSAGE,
            r"takes \(message\): write def forgot_self\(self, message\):$",
        ),
        (robot.forgot_all, MESSAGE, r"takes \(\): write def forgot_all\(self, message\):$"),  # type: ignore[misc]
        (robot.forgot_all, TIMER, r"takes \(\): write def forgot_all\(self\):$"),  # type: ignore[misc]
        (robot.of_class, MESSAGE, r"write def of_class\(cls, message\):$"),
        (len, TIMER[:1], r"but len takes \(obj\): write def len\(\):$"),
        (lambda: None, MESSAGE, r"but the lambda takes \(\): write lambda message:$"),
        (robot.both, ("()",), r"write def both\(self\):$"),
        (Robot.still, MESSAGE, r"write def still\(message\):$"),
    ],
)
def test_a_callback_with_other_arguments_is_refused(
    callback: object, forms: tuple[str, ...], text: str
) -> None:
    with pytest.raises(WrongStateError, match=text):
        called_with(callback, *forms)


def test_a_lambda_that_does_nothing_is_accepted_with_a_warning(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert called_with(lambda: None, "(request, response)", may_do_nothing=True) == 0
    assert "needs a callback that takes (request, response), but" in capfd.readouterr().err


def test_a_wrapper_around_a_method_of_the_class_is_accepted() -> None:
    @functools.wraps(Robot.add)
    def wrapper(*arguments: Any) -> Any:
        return Robot.add(robot, *arguments)

    assert called_with(wrapper, "(request, response)") == 0


def test_a_method_for_several_types_is_accepted() -> None:
    class Listener:
        @functools.singledispatchmethod
        def hear(self, message: Any) -> None: ...

    assert called_with(Listener().hear, *MESSAGE) == 0


@pytest.mark.parametrize("method", [Robot.tick, Robot.hear])
def test_a_method_of_the_class_is_refused(method: Any) -> None:
    text = f"was given Robot.{method.__name__}, .* write self.{method.__name__}$"
    with pytest.raises(WrongTypeError, match=text):
        called_with(method, *TIMER)


def test_the_result_of_a_call_is_refused_in_the_words_of_the_program() -> None:
    with pytest.raises(
        WrongTypeError,
        match=r"^check_callback was given None, the result of calling robot.tick: "
        r"write robot.tick without parentheses$",
    ):
        check_callback("check_callback", robot.tick(), *TIMER, position=1)  # type: ignore[func-returns-value]


def test_the_call_may_have_arguments_and_several_lines() -> None:
    with pytest.raises(WrongTypeError, match=r"parentheses, or lambda: robot.move\(0.5\)$"):
        check_callback(
            "check_callback",
            robot.move(  # type: ignore[func-returns-value]
                0.5
            ),
            *TIMER,
            position=1,
        )
    with pytest.raises(WrongTypeError, match=r"or lambda message: robot.hear\(1\)$"):
        check_callback("check_callback", robot.hear(1), *MESSAGE, position=1)  # type: ignore[func-returns-value]


@pytest.mark.filterwarnings("error")
def test_a_coroutine_is_refused_and_closed() -> None:
    with pytest.raises(WrongTypeError, match="was given a coroutine, the result of calling"):
        check_callback("check_callback", robot.wait(), *TIMER, position=1)
    given = robot.wait()
    with pytest.raises(WrongTypeError, match="write the function without parentheses"):
        check_callback("check_callback", given, *TIMER, position=1)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("tick", "was given 'tick', a text: write self.tick or tick without quotes"),
        (5, "was given 5, which is not a function"),
        (None, "was given None, which is not a function"),
    ],
)
def test_other_things_are_refused(value: object, text: str) -> None:
    with pytest.raises(WrongTypeError, match=text):
        called_with(value, *TIMER)


def test_none_is_accepted_where_it_means_something() -> None:
    nothing = None
    check_callback("check_callback", None, *TIMER, position=1, may_be_none=if_written)
    check_callback("guard", nothing, "()", position=1, may_be_none=unless_called)
    check_callback("event", robot.tick(), "()", position=1, may_be_none=always)  # type: ignore[func-returns-value]
    for rule in (if_written, never):
        with pytest.raises(WrongTypeError):
            check_callback("check_callback", nothing, *TIMER, position=1, may_be_none=rule)
    with pytest.raises(WrongTypeError):
        check_callback("check_callback", robot.tick(), "()", position=1, may_be_none=unless_called)  # type: ignore[func-returns-value]


def test_a_callback_without_a_source_is_refused_too() -> None:
    call = "check_callback('create_timer', robot.tick(), '()', position=1)"
    with pytest.raises(WrongTypeError, match="which is not a function"):
        eval(call, {"check_callback": check_callback, "robot": robot})
