"""Generator of the Python source of a message class.

The constructor has a parameter for each field. In the constructor, this parameter hides a builtin
or a global with the same name (`float`, `range`, `args`). So the generated code uses only names
that a field cannot have. Such names begin with an underscore or are in capitals.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.interfaces.spec import FLOAT32_MAX, INTEGER_RANGES, Field, FieldType, MessageSpec

if TYPE_CHECKING:
    from zbot.interfaces.spec import Scalar

_ZEROS: dict[str, Scalar] = {"bool": False, "byte": b"\x00", "string": "", "wstring": ""}


def class_source(spec: MessageSpec, *, is_checked: bool = True) -> str:
    """Return a message's class statement. `classes._namespace` defines the statement's globals.

    Args:
        spec: The message.
        is_checked: Whether all values are checked. Otherwise only messages that are made with
            `check_fields=True` check their values.
    """
    slots = [f"_{field.name}" for field in spec.fields]
    if not is_checked:
        slots.append("_check_fields")
    lines = [
        _class_line(spec),
        "    __doc__ = _DOC",
        f"    __slots__ = {slots!r}",
        *(f"    {constant.name} = {_literal(constant.value)}" for constant in spec.constants),
        *_default_constants(spec),
        "    _SPEC = _SPEC",
        f"    _TYPE_NAME = {spec.name!r}",
        "    SLOT_TYPES = _SlotTypes()",
        f"    _fields_and_field_types = { ({f.name: str(f.type) for f in spec.fields})!r}",
        "",
        *_init(spec, is_checked=is_checked),
        "",
        "    def __repr__(self):",
        f'        return f"{{_shown_name(self)}}({_repr_fields(spec)})"',
        "",
        *_eq(spec),
    ]
    for field in spec.fields:
        lines += ["", *_property(field, is_checked=is_checked)]
    return "\n".join(lines) + "\n"


def _class_line(spec: MessageSpec) -> str:
    has_constants = spec.constants or any(field.default is not None for field in spec.fields)
    metaclass = ", metaclass=_ConstantsMeta" if has_constants else ""
    return f"class {spec.name.rpartition('/')[2]}(_Message{metaclass}):"


def _default_constants(spec: MessageSpec) -> list[str]:
    return [
        f"    {field.name.upper()}__DEFAULT = {_default_constant(field)}"
        for field in spec.fields
        if field.default is not None
    ]


def _default_constant(field: Field) -> str:
    return _new(field) if isinstance(field.default, tuple) else _literal(field.default)


def _init(spec: MessageSpec, *, is_checked: bool) -> list[str]:
    parameters = [f"{field.name}={_parameter_default(field)}" for field in spec.fields]
    signature = ", ".join(["self", "*_args", *parameters, "**_unknown"])
    return [
        f"    def __init__({signature}):",
        "        if _args or _unknown:",
        f"            {'' if is_checked else 'self._check_fields = '}_check_call(_args, _unknown)",
        *(
            f"        self._{field.name} = {_initial(field, is_checked=is_checked)}"
            for field in spec.fields
        ),
    ]


def _eq(spec: MessageSpec) -> list[str]:
    same = [
        f"_same_elements(self._{field.name}, other._{field.name})"
        if _is_fixed_numeric(field.type)
        else f"self._{field.name} == other._{field.name}"
        for field in spec.fields
    ]
    return [
        "    def __eq__(self, other):",
        "        if not isinstance(other, self.__class__):",
        "            return _equals_other(other)",
        f"        return {' and '.join(same) or 'True'}",
    ]


def _property(field: Field, *, is_checked: bool) -> list[str]:
    name = field.name
    return [
        "    @_property",
        f"    def {name}(self):",
        f'        """Message field {name!r}."""',
        f"        return self._{name}",
        "",
        f"    @{name}.setter",
        f"    def {name}(self, value):",
        f"        self._{name} = {_stored(field, 'value', is_checked=is_checked)}",
    ]


def _repr_fields(spec: MessageSpec) -> str:
    # ROS 2 prints a sequence of numbers without `array('d', ...)`.
    return ", ".join(
        f"{field.name}={{_elements_text(self._{field.name})}}"
        if field.type.kind == "sequence" and field.type.typecode
        else f"{field.name}={{self._{field.name}!r}}"
        for field in spec.fields
    )


def _parameter_default(field: Field) -> str:
    """Return the default of a constructor parameter.

    If a list or a message were the default, all messages would share this one object. So the
    default of a list or a message is a placeholder.
    """
    if field.type.kind != "scalar" or field.type.is_message:
        return "_DEFAULT"
    return _literal(_scalar_default(field))


def _scalar_default(field: Field) -> Scalar:
    if field.default is not None and not isinstance(field.default, tuple):
        return field.default
    return _zero(field.type.base)


def _zero(base: str) -> Scalar:
    return _ZEROS.get(base, 0.0 if base.startswith("float") else 0)


def _initial(field: Field, *, is_checked: bool) -> str:
    stored = _stored(field, field.name, is_checked=is_checked)
    if field.type.kind == "scalar" and not field.type.is_message:
        return stored
    return f"{_new(field)} if {field.name} is _DEFAULT else {stored}"


def _new(field: Field) -> str:
    """Return an expression for a new default value of a field that is an array or a message."""
    kind = field.type
    name, default = field.name, field.default
    if kind.is_message:
        if kind.kind == "scalar":
            return f"_class_{name}()"
        return f"[_class_{name}() for _ in _range({kind.size})]" if kind.kind == "array" else "[]"
    if _is_fixed_numeric(kind):
        return f"_new_{name}()"
    elements = ", ".join(_literal(each) for each in default) if isinstance(default, tuple) else ""
    if kind.typecode:
        return (
            f"_array({kind.typecode!r}, [{elements}])" if elements else f"_array({kind.typecode!r})"
        )
    if kind.kind == "array" and default is None:
        return f"[{_literal(_zero(kind.base))}] * {kind.size}"
    return f"[{elements}]"


def _stored(field: Field, variable: str, *, is_checked: bool) -> str:
    """Return an expression for the stored value. It is the checked value or the value itself."""
    checked = _checked(field, variable)
    # Numbers of an array are always converted, and ROS 2's classes do this too.
    if is_checked or (field.type.typecode and field.type.kind != "scalar"):
        return checked
    return f'({checked}) if _getattr(self, "_check_fields", False) else {variable}'


def _checked(field: Field, variable: str) -> str:
    """Return an expression for the stored value. It calls `_check_...` if the inline test fails."""
    test = _inline_test(field, variable)
    slow = f"_check_{field.name}({variable})"
    return f"{variable} if {test} else {slow}" if test else slow


def _inline_test(field: Field, variable: str) -> str:
    kind = field.type
    if kind.kind != "scalar":
        return _inline_array_test(kind, variable)
    if kind.is_message:
        return f"{variable}.__class__ is _class_{field.name}"
    if kind.is_string:
        # An ASCII string has no lone surrogate, and isascii() only reads a flag in CPython.
        test = f"{variable}.__class__ is _str and {variable}.isascii()"
        return f"{test} and _len({variable}) <= {kind.string_bound}" if kind.string_bound else test
    if kind.base in INTEGER_RANGES:
        low, high = INTEGER_RANGES[kind.base]
        return f"{variable}.__class__ is _int and {low} <= {variable} <= {high}"
    if kind.base == "float32":
        limit = repr(FLOAT32_MAX)
        return f"{variable}.__class__ is _float and -{limit} <= {variable} <= {limit}"
    if kind.base == "byte":
        return f"{variable}.__class__ is _bytes and _len({variable}) == 1"
    return f"{variable}.__class__ is _{'bool' if kind.base == 'bool' else 'float'}"


def _inline_array_test(kind: FieldType, variable: str) -> str:
    if not kind.typecode or kind.kind == "array":
        return ""
    test = f"{variable}.__class__ is _array and {variable}.typecode == {kind.typecode!r}"
    return f"{test} and _len({variable}) <= {kind.size}" if kind.size else test


def _is_fixed_numeric(kind: FieldType) -> bool:
    return kind.kind == "array" and bool(kind.typecode)


def _literal(value: Scalar | tuple[Scalar, ...] | None) -> str:
    if isinstance(value, tuple):
        return f"({''.join(f'{_literal(each)}, ' for each in value)})"
    if isinstance(value, float) and not math.isfinite(value):
        return "_NAN" if math.isnan(value) else "_INF" if value > 0 else "-_INF"
    return repr(value)
