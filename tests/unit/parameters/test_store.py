from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    rule,
)

from zbot.parameters.errors import (
    InvalidParameterException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterDeclarationError,
    ParameterException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from zbot.parameters.parameter import InvalidParameterTypeException, Parameter
from zbot.parameters.store import Changes, Declaration, ParameterStore, prefixes_of
from zbot.parameters.validation import Descriptor, Range

Type = Parameter.Type


def store(**overrides: Any) -> ParameterStore:
    return ParameterStore(
        lambda _: None, {name: Parameter(name, value=value) for name, value in overrides.items()}
    )


def declare(where: ParameterStore, name: str, value: Any = None, **rules: Any) -> Any:
    return where.declare([Declaration(name, value, Descriptor(**rules))])[0].value


def set_to(where: ParameterStore, **values: Any) -> str:
    return where.set([Parameter(name, value=value) for name, value in values.items()])


def test_an_override_wins_over_the_default_and_widens() -> None:
    parameters = store(rate=2)
    assert repr(declare(parameters, "rate", 1.0)) == "2.0"
    assert parameters.get("rate").type_ is Type.DOUBLE


def test_an_override_may_be_ignored() -> None:
    found = store(rate=2).declare([Declaration("rate", 1.0)], ignore_override=True)
    assert found[0].value == 1.0


def test_an_override_of_another_type_is_refused() -> None:
    with pytest.raises(
        InvalidParameterTypeException,
        match=r"Trying to set parameter 'rate' to 'fast' of type 'STRING', expecting type 'DOUBLE'",
    ):
        declare(store(rate="fast"), "rate", 1.0)


@pytest.mark.parametrize("value", [True, 7, 0.5])
def test_a_text_without_quotes_is_refused(value: object) -> None:
    with pytest.raises(InvalidParameterTypeException, match="'STRING'; put it into quotes, or"):
        declare(store(name=value), "name", "anna")


def test_a_number_with_a_comma_is_refused_with_a_point() -> None:
    with pytest.raises(InvalidParameterTypeException, match=r"write 1\.5, with"):
        declare(store(rate="1,5"), "rate", 1.0)
    with pytest.raises(InvalidParameterTypeException, match=r"write 1\.5, without quotes"):
        declare(store(rate="1.5"), "rate", 1.0)
    parameters = store()
    declare(parameters, "rate", 1.0)
    assert set_to(parameters, rate="1,5").endswith("and is 1.0; write 1.5, with a point")


def test_an_override_out_of_range_refuses_the_declaration() -> None:
    parameters = store(rate=20)
    with pytest.raises(InvalidParameterValueException, match=r"out of range\. Min: 0, Max: 10"):
        declare(parameters, "rate", 1, integer_range=Range(0, 10))
    assert not parameters.values
    assert not parameters.descriptors


def test_all_declarations_are_checked_before_the_first_one() -> None:
    parameters = store()
    with pytest.raises(InvalidParameterException):
        parameters.declare([Declaration("a", 1), Declaration("", 1)])
    with pytest.raises(ParameterDeclarationError, match=r"'b': give it a value, a Parameter\.Type"):
        parameters.declare([Declaration("a", 1), Declaration("b")])
    with pytest.raises(ParameterDeclarationError, match="not both"):
        declare(parameters, "c", Type.BOOL, dynamic_typing=True)
    with pytest.raises(ParameterDeclarationError, match="NOT_SET"):
        declare(parameters, "c", Type.NOT_SET)
    declare(parameters, "d", 1)
    with pytest.raises(ParameterAlreadyDeclaredException, match="already declared: 'd'"):
        parameters.declare([Declaration("a", 1), Declaration("d", 1)])
    assert list(parameters.values) == ["d"]


def test_a_parameter_declared_by_type_has_to_be_set_before_it_is_read() -> None:
    parameters = store()
    declare(parameters, "port", Type.INTEGER)
    with pytest.raises(
        ParameterUninitializedException, match=r"'port' is not initialized: set it, .* -p port:="
    ):
        parameters.get("port")
    assert "expected 'integer' got 'string'" in set_to(parameters, port="usb")
    assert not set_to(parameters, port=3)
    assert parameters.get("port").value == 3


def test_a_read_only_parameter_takes_its_override_and_never_changes() -> None:
    parameters = store(port=7)
    assert declare(parameters, "port", 1, read_only=True) == 7
    assert set_to(parameters, port=8) == "Trying to set a read-only parameter: port."
    with pytest.raises(ParameterImmutableException):
        parameters.undeclare("port")


def test_an_unknown_name_gets_a_suggestion() -> None:
    parameters = store()
    declare(parameters, "speed", 1)
    with pytest.raises(
        ParameterNotDeclaredException,
        match=r"undeclared parameter\(s\): 'sped'; did you mean 'speed'\?",
    ):
        parameters.get("sped")
    with pytest.raises(ParameterNotDeclaredException):
        parameters.undeclare("sped")


def test_parameters_are_set_all_or_none() -> None:
    parameters = store()
    declare(parameters, "a", 1)
    declare(parameters, "b", 1)
    assert set_to(parameters, a=2, b="x").startswith("Wrong parameter type")
    assert parameters.get("a").value == 1
    with pytest.raises(ParameterNotDeclaredException):
        set_to(parameters, a=2, c=3)
    assert parameters.get("a").value == 1


def test_callbacks_are_called_last_added_first_and_may_replace_or_refuse() -> None:
    parameters = store()
    declare(parameters, "speed", 1.0)
    declare(parameters, "gear", 1)
    calls: list[str] = []
    parameters.pre_set.append(lambda given: [*given, Parameter("gear", value=2)])
    parameters.on_set.append(lambda _: calls.append("first") or "")  # type: ignore[func-returns-value]
    parameters.on_set.insert(0, lambda given: "too fast" if given[0].value > 9 else "")
    parameters.post_set.append(lambda given: calls.append(f"{[p.name for p in given]}"))
    assert set_to(parameters, speed=10) == "too fast"
    assert calls == []
    assert set_to(parameters, speed=5) == ""
    assert calls == ["first", "['speed', 'gear']"]
    assert parameters.get("gear").value == 2


def test_a_pre_set_callback_that_empties_the_list_refuses() -> None:
    parameters = store()
    declare(parameters, "a", 1)
    parameters.pre_set.append(lambda _: [])
    assert set_to(parameters, a=2).startswith("parameter list cannot be empty")


def test_undeclared_parameters_may_be_allowed() -> None:
    parameters = ParameterStore(lambda _: None, allow_undeclared=True)
    assert parameters.get("x").type_ is Type.NOT_SET
    assert parameters.type_of("x") is Type.NOT_SET
    assert set_to(parameters, x=1) == set_to(parameters, x="now a string") == ""
    assert parameters.describe("x") == Descriptor(Type.STRING, dynamic_typing=True)
    assert parameters.describe("y") == Descriptor()


def test_a_new_descriptor_needs_a_value_that_complies() -> None:
    parameters = store()
    declare(parameters, "a", 50)
    limits = Descriptor(integer_range=Range(0, 10))
    with pytest.raises(InvalidParameterValueException, match="out of range"):
        parameters.set_descriptor("a", limits, None)
    assert parameters.describe("a").integer_range is None
    assert parameters.set_descriptor("a", limits, Parameter("a", value=5)).value == 5
    assert parameters.describe("a") == Descriptor(Type.INTEGER, integer_range=Range(0, 10))
    parameters.set_descriptor("a", Descriptor(read_only=True), None)
    with pytest.raises(ParameterImmutableException):
        parameters.set_descriptor("a", limits, None)


NAMES = ["a", "cam", "cam.fps", "cam.lens.zoom", "camera", "cam.lens.iris"]


@pytest.mark.parametrize(
    ("prefixes", "depth", "expected"),
    [
        ([], 0, NAMES),
        ([], 1, ["a", "cam", "camera"]),
        ([], 2, ["a", "cam", "cam.fps", "camera"]),
        (["cam"], 0, ["cam", "cam.fps", "cam.lens.zoom", "cam.lens.iris"]),
        (["cam"], 1, ["cam", "cam.fps"]),
        (["cam.lens", "a"], 1, ["a", "cam.lens.zoom", "cam.lens.iris"]),
        (["lens"], 0, []),
    ],
)
def test_names_are_listed_by_group_and_depth(
    prefixes: list[str], depth: int, expected: list[str]
) -> None:
    parameters = store()
    for name in NAMES:
        declare(parameters, name, 1)
    assert parameters.names(prefixes, depth) == expected


def test_parameters_of_a_group_are_returned_without_its_prefix() -> None:
    parameters = store()
    for name in NAMES:
        declare(parameters, name, name)
    assert list(prefixes_of(NAMES)) == ["cam", "cam.lens"]
    assert {name: p.value for name, p in parameters.in_group("cam.lens").items()} == {
        "zoom": "cam.lens.zoom",
        "iris": "cam.lens.iris",
    }
    assert list(parameters.in_group("")) == NAMES


@dataclass
class Facts:
    """State of a parameter by the documented rules; a range is of integers from 0 to 10."""

    type: Parameter.Type
    value: Any
    dynamic: bool
    read_only: bool
    limited: bool


names = st.sampled_from(["a", "b", "c.d"])
values = st.one_of(
    st.booleans(),
    st.integers(-3, 13),
    st.floats(-5, 5),
    st.sampled_from(["x", "y"]),
    st.lists(st.integers(0, 3), max_size=2),
    st.lists(st.floats(0, 3), min_size=1, max_size=2),
)
maybe = st.one_of(st.none(), values)


def model_widened(value: Any, type_: Parameter.Type) -> Any:
    if type_ is Type.DOUBLE and type(value) is int:
        return float(value)
    if type_ is Type.DOUBLE_ARRAY and isinstance(value, list):
        return [float(item) for item in value]
    return value


def model_type(value: Any) -> Parameter.Type:
    kinds = {bool: Type.BOOL, int: Type.INTEGER, float: Type.DOUBLE, str: Type.STRING}
    if value is None:
        return Type.NOT_SET
    if not isinstance(value, list):
        return kinds[type(value)]
    if not value:
        return Type.BYTE_ARRAY
    return Type.INTEGER_ARRAY if type(value[0]) is int else Type.DOUBLE_ARRAY


def fits(known: Facts, value: Any) -> bool:
    found = model_type(model_widened(value, known.type))
    is_empty_array = value == [] and known.type.is_array
    if not known.dynamic and found is not known.type and not is_empty_array:
        return False
    return not (known.limited and found is Type.INTEGER and not 0 <= value <= 10)


class ParameterRules(RuleBasedStateMachine):
    """Comparison of a parameter store with a model of the documented rules."""

    @initialize(allow=st.booleans())
    def begin(self, allow: bool) -> None:
        self.model: dict[str, Facts] = {}
        self.replayed: dict[str, Any] = {}
        self.announced: list[list[str]] = []
        self.vetoed: str | None = None
        self.allow = allow
        self.store = ParameterStore(self.replay, allow_undeclared=allow)
        self.store.on_set.append(self.veto)
        self.store.post_set.append(lambda given: self.announced.append([p.name for p in given]))

    def replay(self, changes: Changes) -> None:
        for parameter in changes.new:
            assert self.replayed.get(parameter.name) is None
        for parameter in changes.changed:
            assert self.replayed[parameter.name] is not None
        self.replayed |= {
            parameter.name: parameter.value for parameter in (*changes.new, *changes.changed)
        }
        for parameter in changes.deleted:
            self.replayed.pop(parameter.name, None)

    def veto(self, given: list[Parameter[Any]]) -> str:
        return "no" if any(parameter.name == self.vetoed for parameter in given) else ""

    @rule(name=st.one_of(st.none(), names))
    def a_callback_refuses_from_now_on(self, name: str | None) -> None:
        self.vetoed = name

    @rule(
        name=names,
        value=maybe,
        dynamic=st.booleans(),
        read_only=st.booleans(),
        limited=st.booleans(),
    )
    def declare(self, name: str, value: Any, dynamic: bool, read_only: bool, limited: bool) -> None:
        known = Facts(model_type(value), value, dynamic, read_only, limited)
        descriptor = Descriptor(
            dynamic_typing=dynamic,
            read_only=read_only,
            integer_range=Range(0, 10) if limited else None,
        )
        wanted = [Declaration(name, value, descriptor)]
        if value is None and not dynamic:
            self.refused(ParameterDeclarationError, lambda: self.store.declare(wanted))
        elif name in self.model:
            self.refused(ParameterAlreadyDeclaredException, lambda: self.store.declare(wanted))
        elif not fits(known, value) or name == self.vetoed:
            self.refused(InvalidParameterValueException, lambda: self.store.declare(wanted))
        else:
            self.store.declare(wanted)
            self.model[name] = known
            assert self.announced.pop() == [name]

    @rule(name=names, type_=st.sampled_from([Type.DOUBLE, Type.STRING, Type.DOUBLE_ARRAY]))
    def declare_by_type(self, name: str, type_: Parameter.Type) -> None:
        wanted = [Declaration(name, type_)]
        if name in self.model:
            self.refused(ParameterAlreadyDeclaredException, lambda: self.store.declare(wanted))
        elif name == self.vetoed:
            self.refused(InvalidParameterValueException, lambda: self.store.declare(wanted))
        else:
            self.store.declare(wanted)
            self.model[name] = Facts(type_, None, dynamic=False, read_only=False, limited=False)
            assert self.announced.pop() == [name]

    @rule(given=st.lists(st.tuples(names, maybe), min_size=1, max_size=3))
    def set_atomically(self, given: list[tuple[str, Any]]) -> None:
        parameters = [Parameter(name, value=value) for name, value in given]
        wanted = dict(given)
        if not self.allow and any(name not in self.model for name in wanted):
            self.refused(ParameterNotDeclaredException, lambda: self.store.set(parameters))
        elif any(self.is_refused(name, value) for name, value in wanted.items()):
            before = dict(self.store.values)
            assert self.store.set(parameters)
            assert self.store.values == before
        else:
            assert not self.store.set(parameters)
            for name, value in wanted.items():
                self.model_set(name, value)
            assert self.announced.pop() == list(wanted)

    def is_refused(self, name: str, value: Any) -> bool:
        known = self.model.get(name)
        if name == self.vetoed:
            return True
        if known is None:
            return False
        if value is None and not known.read_only:
            return not known.dynamic
        return known.read_only or not fits(known, value)

    def model_set(self, name: str, value: Any) -> None:
        if value is None:
            self.model.pop(name, None)
            return
        known = self.model.setdefault(
            name, Facts(Type.NOT_SET, None, dynamic=True, read_only=False, limited=False)
        )
        known.value = value if known.dynamic else model_widened(value, known.type)
        if known.dynamic:
            known.type = model_type(value)

    @rule(name=names)
    def undeclare(self, name: str) -> None:
        if name not in self.model:
            self.refused(ParameterNotDeclaredException, lambda: self.store.undeclare(name))
        elif self.model[name].read_only:
            self.refused(ParameterImmutableException, lambda: self.store.undeclare(name))
        else:
            self.store.undeclare(name)
            del self.model[name]

    @rule(name=names)
    def get(self, name: str) -> None:
        known = self.model.get(name)
        if known is None and not self.allow:
            self.refused(ParameterNotDeclaredException, lambda: self.store.get(name))
        elif known is not None and known.value is None and not known.dynamic:
            self.refused(ParameterUninitializedException, lambda: self.store.get(name))
        else:
            assert self.store.get(name).value == (None if known is None else known.value)

    def refused(self, error: type[Exception], action: Any) -> None:
        before = dict(self.store.values)
        with pytest.raises(error) as caught:
            action()
        assert isinstance(caught.value, (ParameterException, ParameterDeclarationError))
        assert self.store.values == before

    @invariant()
    def the_node_is_what_the_model_says(self) -> None:
        if not hasattr(self, "model"):
            return
        found = {name: value.value for name, value in self.store.values.items()}
        assert found == {name: known.value for name, known in self.model.items()} == self.replayed
        assert self.announced == []
        for name, known in self.model.items():
            descriptor = self.store.describe(name)
            assert (descriptor.type, descriptor.read_only) == (known.type, known.read_only)
            if known.value is not None:
                assert descriptor.type is self.store.type_of(name)


TestParametersByTheRules = ParameterRules.TestCase
TestParametersByTheRules.settings = settings(max_examples=100, stateful_step_count=30)
