"""Service of a node that returns the definitions of types."""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.interfaces import MessageSpec, get_spec, type_description, type_hash
from zbot.interfaces.errors import UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.registry import LazyService
from zbot.node.parameters import START_TYPE_DESCRIPTION_SERVICE
from zbot.node.service import Service
from zbot.node.service_types import DESCRIPTION_SERVICE
from zbot.qos import qos_profile_services_default
from zbot.threads.foreign_call import called_by_zenoh
from zbot.threads.on_demand_thread import OnDemandThread
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zenoh

    from zbot.context import Context
    from zbot.interfaces import InterfaceSpec
    from zbot.node.entities import NodeEntities


class _ThreadedService(Service[Any, Any]):
    """Service that serves requests in a thread of its own, so that no executor is needed."""

    def __init__(self, context: Context, *args: Any, **options: Any) -> None:
        start = partial(context.start_thread, "zbot type description")
        self._work = OnDemandThread(start, self._serve_next)  # before the first request
        super().__init__(context, *args, **options)

    @called_by_zenoh
    def _receive(self, query: zenoh.Query) -> None:
        self._queries.append((query, time.monotonic()))
        self._work.wake()

    def _serve_next(self) -> float | None:
        taken = self.take()
        if taken is None:
            return None
        self.execute(taken)
        return 0.0


class TypeDescriptionService:
    """The service `~/get_type_description`, which every node creates.

    Args:
        node: The node. Its parameter `start_type_description_service` turns the service on or off.
    """

    def __init__(self, node: NodeEntities) -> None:
        handle = node.handle
        self.service_name = f"{handle.full_name}/get_type_description"
        self.enabled: bool = handle.parameters.get(START_TYPE_DESCRIPTION_SERVICE).value is True
        self._handle = handle
        self._service: Service[Any, Any] | None = None
        if self.enabled:
            name = handle.resolve(self.service_name, is_service=True)
            self._service = self._serve(name)
            handle.services.append(self._service)

    def _serve(self, name: str) -> Service[Any, Any]:
        handle = self._handle
        return _ThreadedService(
            handle.context,
            LazyService(DESCRIPTION_SERVICE[0]),
            _describe,
            handle.named_endpoint(
                EntityKind.SERVICE, name, DESCRIPTION_SERVICE, qos_profile_services_default
            ),
            ready_queue=handle.ready_queue,
            callback_group=handle.default_callback_group,
            logger_name=handle.logger_name,
        )

    def destroy(self) -> None:
        """End the service. This method may be called twice."""
        service, self._service = self._service, None
        if service is not None:
            self._handle.services.remove(service)
            service.destroy()


def _describe(request: Any, response: Any) -> Any:
    name = request.type_name
    try:
        spec = get_spec(name)
    except (UnknownPackageError, UnknownInterfaceError) as error:
        response.failure_reason = str(error)
        return response
    found = type_hash(spec.name)
    if request.type_hash not in {"", found}:
        response.failure_reason = f"{name} has the hash {found} here, not {request.type_hash}"
        return response
    described = type_description(spec.name)
    response.type_description = _description_message(described)
    if request.include_type_sources:
        response.type_sources = list(map(_source_message, _specs(described)))
    response.successful = True
    return response


def _specs(described: dict[str, Any]) -> Iterator[InterfaceSpec]:
    for part in (described["type_description"], *described["referenced_type_descriptions"]):
        yield get_spec(part["type_name"])


def _description_message(described: dict[str, Any]) -> Any:
    from type_description_interfaces.msg import (  # noqa: PLC0415 - the import makes the class
        TypeDescription,
    )

    return TypeDescription(
        type_description=_individual(described["type_description"]),
        referenced_type_descriptions=list(
            map(_individual, described["referenced_type_descriptions"])
        ),
    )


def _individual(described: dict[str, Any]) -> Any:
    from type_description_interfaces.msg import (  # noqa: PLC0415 - the import makes the class
        Field,
        FieldType,
        IndividualTypeDescription,
    )

    defaults = _defaults(get_spec(described["type_name"]))
    fields = [
        Field(
            name=field["name"],
            type=FieldType(**field["type"]),
            default_value=defaults.get(field["name"], ""),
        )
        for field in described["fields"]
    ]
    return IndividualTypeDescription(type_name=described["type_name"], fields=fields)


def _defaults(spec: InterfaceSpec) -> dict[str, str]:
    fields = spec.fields if isinstance(spec, MessageSpec) else ()
    return {field.name: str(field.default) for field in fields if field.default is not None}


def _source_message(spec: InterfaceSpec) -> Any:
    from type_description_interfaces.msg import TypeSource  # noqa: PLC0415 - the import makes the class

    encoding = _encoding(spec)
    text = "" if encoding == "implicit" else spec.text
    return TypeSource(type_name=spec.name, encoding=encoding, raw_file_contents=text)


def _encoding(spec: InterfaceSpec) -> str:
    """Return the encoding of a definition, as in `type_description_interfaces/msg/TypeSource`.

    A definition without its own file has no text. Its encoding is `implicit` or `dynamic`.
    """
    if "_" in spec.name.rpartition("/")[2]:
        return "implicit"  # a part of a service or action, because only such names have `_`
    if isinstance(spec, MessageSpec) and spec.fields and not spec.text:
        return "dynamic"
    return spec.name.split("/")[1]
