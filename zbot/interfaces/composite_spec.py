"""Specs of services and actions, with the messages and services that ROS 2 adds to their parts."""

from __future__ import annotations

from zbot.interfaces.spec import ActionSpec, Field, FieldType, MessageSpec, ServiceSpec

_GOAL_ID = Field("goal_id", FieldType("unique_identifier_msgs/msg/UUID"))
_STAMP = Field("stamp", FieldType("builtin_interfaces/msg/Time"))
_INFO = Field("info", FieldType("service_msgs/msg/ServiceEventInfo"))


def service(name: str, request: MessageSpec, response: MessageSpec, text: str = "") -> ServiceSpec:
    """Return a service of two messages, with the `_Event` message of service introspection."""
    event = MessageSpec(
        f"{name}_Event",
        (
            _INFO,
            Field("request", FieldType(request.name, "sequence", 1)),
            Field("response", FieldType(response.name, "sequence", 1)),
        ),
    )
    return ServiceSpec(name, request, response, event, text)


def action(
    name: str, goal: MessageSpec, result: MessageSpec, feedback: MessageSpec, text: str = ""
) -> ActionSpec:
    """Return an action of three messages, and the services and message that contain these three."""
    return ActionSpec(
        name,
        goal,
        result,
        feedback,
        _send_goal(name, goal),
        _get_result(name, result),
        MessageSpec(
            f"{name}_FeedbackMessage", (_GOAL_ID, Field("feedback", FieldType(feedback.name)))
        ),
        text,
    )


def _send_goal(action_name: str, goal: MessageSpec) -> ServiceSpec:
    name = f"{action_name}_SendGoal"
    request = MessageSpec(f"{name}_Request", (_GOAL_ID, Field("goal", FieldType(goal.name))))
    response = MessageSpec(f"{name}_Response", (Field("accepted", FieldType("bool")), _STAMP))
    return service(name, request, response)


def _get_result(action_name: str, result: MessageSpec) -> ServiceSpec:
    name = f"{action_name}_GetResult"
    request = MessageSpec(f"{name}_Request", (_GOAL_ID,))
    fields = (Field("status", FieldType("int8")), Field("result", FieldType(result.name)))
    return service(name, request, MessageSpec(f"{name}_Response", fields))
