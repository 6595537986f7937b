"""Check of a callback when it is given to zbot, so that the error names the program's own line."""

from __future__ import annotations

import ast
import inspect
from types import FunctionType, MethodType
from typing import TYPE_CHECKING, Any

from zbot.errors import WrongStateError, WrongTypeError
from zbot.errors.call_source import argument_source
from zbot.executor.errors import callback_signature_error, not_callable_error
from zbot.log import get_logger

if TYPE_CHECKING:
    from collections.abc import Callable


def never(source: ast.expr | None) -> bool:
    """Accept no callback that is `None`."""
    del source
    return False


def always(source: ast.expr | None) -> bool:
    """Accept `None`."""
    del source
    return True


def unless_called(source: ast.expr | None) -> bool:
    """Accept `None`, but not as the result of a call such as `self.tick()`."""
    return not isinstance(source, ast.Call)


def if_written(source: ast.expr | None) -> bool:
    """Accept the word `None`, but not a variable that is `None`."""
    return isinstance(source, ast.Constant)


def check_callback(
    call: str,
    callback: object,
    *forms: str,
    argument: str = "callback",
    position: int | None = 0,
    may_be_none: Callable[[ast.expr | None], bool] = never,
    may_do_nothing: bool = False,
) -> int:
    """Check that a callback can be called, and return which of the `forms` it accepts first.

    A callable whose parameters are unknown, e.g. some builtin functions, accepts the first form.

    Args:
        call: The function of the program's call, as an error names it.
        callback: What the program gave.
        forms: The arguments that the callback may get, e.g. `(message)`. Without forms, only
            `callable()` is checked.
        argument: Name of the argument of the call.
        position: Index of this argument in the call, or `None` if it is always given by its name.
        may_be_none: Tells whether `None` is accepted. It gets what the program wrote for the
            argument, or `None` if that is unknown.
        may_do_nothing: Whether a lambda that does nothing is accepted whatever its parameters are,
            with a warning. Programs give it to a service or an action that nobody calls.

    Raises:
        WrongTypeError: The callback is not callable, or is a method of a class without an object.
        WrongStateError: The callback does not accept any of the forms.
    """
    if not callable(callback):
        if callback is None and may_be_none is always:
            return 0  # the source is not read for the default of each call
        source = argument_source(call.partition("'")[0], argument, position)
        if callback is not None or not may_be_none(source):
            if inspect.iscoroutine(callback):
                callback.close()  # Python would warn that it was never awaited
            raise not_callable_error(call, callback, _advice(callback, source, forms))
        return 0
    if not forms or _surely_accepts(callback, _count(forms[0])):
        return 0
    try:
        return _accepted_form(call, callback, forms)
    except WrongStateError as error:
        if not may_do_nothing or not _does_nothing(callback):
            raise
        get_logger("zbot").warning(str(error))
        return 0


def _advice(callback: object, source: ast.expr | None, forms: tuple[str, ...]) -> str:
    """Return what to write in place of something that is not callable."""
    if isinstance(source, ast.Call):
        return _advice_for_call(source, forms)
    if inspect.iscoroutine(callback):
        return "the result of calling an async function: write the function without parentheses"
    if isinstance(callback, str) and callback.isidentifier():
        return f"a text: write self.{callback} or {callback} without quotes"
    return "which is not a function: write the name of a function without parentheses"


def _advice_for_call(source: ast.Call, forms: tuple[str, ...]) -> str:
    function = ast.unparse(source.func)
    advice = f"the result of calling {function}: write {function} without parentheses"
    if source.args or source.keywords:
        parameters = forms[0][1:-1] if forms else ""
        advice += f", or {f'lambda {parameters}'.strip()}: {ast.unparse(source)}"
    return advice


def _count(form: str) -> int:
    return form.count(",") + 1 if form != "()" else 0


def _surely_accepts(callback: Any, count: int) -> bool:
    """Return whether a plain function or method takes `count` arguments. This check is quick."""
    if type(callback) is MethodType:
        callback, count = callback.__func__, count + 1
    elif type(callback) is FunctionType and callback.__code__.co_varnames[:1] == ("self",):
        return False
    if type(callback) is not FunctionType or callback.__code__.co_kwonlyargcount:
        return False
    largest = callback.__code__.co_argcount
    return largest - len(callback.__defaults__ or ()) <= count <= largest


def _accepted_form(call: str, callback: Any, forms: tuple[str, ...]) -> int:
    try:
        # A decorator may give its function other arguments than the ones that it takes itself.
        written, own = (inspect.signature(callback, follow_wrapped=each) for each in (True, False))
    except (TypeError, ValueError):
        if _takes_nothing(callback):
            raise _signature_error(call, callback, forms) from None
        return 0
    if _is_method_of_class(callback, own):
        raise WrongTypeError(
            f"{call} was given {callback.__qualname__}, a method without its object: "
            f"write self.{callback.__name__}"
        )
    for signature in (_bound(written, own), own):
        for index, form in enumerate(forms):
            if _accepts(signature, _count(form)):
                return index
    raise _signature_error(call, callback, forms)


def _bound(written: inspect.Signature, own: inspect.Signature) -> inspect.Signature:
    """Return the signature of a method without `self` if a wrapper around it gives the object."""
    first = next(iter(written.parameters), "")
    if first != "self" or first in own.parameters:
        return written
    return written.replace(parameters=list(written.parameters.values())[1:])


def _does_nothing(callback: Any) -> bool:
    """Return whether this is a lambda that only returns `None`, e.g. `lambda: None`."""
    if type(callback) is not FunctionType or callback.__name__ != "<lambda>":
        return False
    return callback.__code__.co_code == (lambda: None).__code__.co_code


def _takes_nothing(callback: Any) -> bool:
    """Return whether this is a method without `self`, which nobody can call."""
    function = callback.__func__ if type(callback) is MethodType else None
    if type(function) is not FunctionType:
        return False
    takes_many = function.__code__.co_flags & inspect.CO_VARARGS
    return not function.__code__.co_argcount and not takes_many


def _signature_error(call: str, callback: Any, forms: tuple[str, ...]) -> WrongStateError:
    written = callback.__func__ if type(callback) is MethodType else callback
    return callback_signature_error(call, callback, inspect.signature(written), forms)


def _accepts(signature: inspect.Signature, count: int) -> bool:
    try:
        signature.bind(*[None] * count)
    except TypeError:
        return False
    return True


def _is_method_of_class(callback: Any, signature: inspect.Signature) -> bool:
    """Return whether this is e.g. `Talker.tick`, which needs an object as its first argument."""
    owner = getattr(callback, "__qualname__", "").rpartition(".")[0]
    has_owner = bool(owner) and not owner.endswith("<locals>")
    is_function = isinstance(callback, FunctionType)
    return is_function and has_owner and next(iter(signature.parameters), "") == "self"
