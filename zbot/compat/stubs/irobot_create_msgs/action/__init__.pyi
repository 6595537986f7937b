# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import action_msgs.msg
import action_msgs.srv
import builtin_interfaces.msg
import geometry_msgs.msg
import irobot_create_msgs.action
import irobot_create_msgs.msg
import service_msgs.msg
import unique_identifier_msgs.msg
from zbot.interfaces import Action, Message, Service

class AudioNoteSequence_Goal(Message):
    """irobot_create_msgs/action/AudioNoteSequence_Goal

    # Plays notes.

    int32 INFINITE=-1
    int32 iterations 1  # or INFINITE
    irobot_create_msgs/AudioNoteVector note_sequence
    """
    INFINITE: Final = -1
    def __init__(self, *, iterations: int = ..., note_sequence: irobot_create_msgs.msg.AudioNoteVector = ..., check_fields: bool = ...) -> None: ...
    iterations: int
    note_sequence: irobot_create_msgs.msg.AudioNoteVector

class AudioNoteSequence_Result(Message):
    """irobot_create_msgs/action/AudioNoteSequence_Result

    bool complete
    int32 iterations_played
    builtin_interfaces/Duration runtime
    """
    def __init__(self, *, complete: bool = ..., iterations_played: int = ..., runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    complete: bool
    iterations_played: int
    runtime: builtin_interfaces.msg.Duration

class AudioNoteSequence_Feedback(Message):
    """irobot_create_msgs/action/AudioNoteSequence_Feedback

    int32 iterations_played
    builtin_interfaces/Duration current_runtime
    """
    def __init__(self, *, iterations_played: int = ..., current_runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    iterations_played: int
    current_runtime: builtin_interfaces.msg.Duration

class AudioNoteSequence_FeedbackMessage(Message):
    """irobot_create_msgs/action/AudioNoteSequence_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.AudioNoteSequence_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.AudioNoteSequence_Feedback

class AudioNoteSequence_SendGoal_Request(Message):
    """irobot_create_msgs/action/AudioNoteSequence_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.AudioNoteSequence_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.AudioNoteSequence_Goal

class AudioNoteSequence_SendGoal_Response(Message):
    """irobot_create_msgs/action/AudioNoteSequence_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class AudioNoteSequence_SendGoal_Event(Message):
    """irobot_create_msgs/action/AudioNoteSequence_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.AudioNoteSequence_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.AudioNoteSequence_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.AudioNoteSequence_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.AudioNoteSequence_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.AudioNoteSequence_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.AudioNoteSequence_SendGoal_Response]) -> None: ...

class AudioNoteSequence_GetResult_Request(Message):
    """irobot_create_msgs/action/AudioNoteSequence_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class AudioNoteSequence_GetResult_Response(Message):
    """irobot_create_msgs/action/AudioNoteSequence_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.AudioNoteSequence_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.AudioNoteSequence_Result

class AudioNoteSequence_GetResult_Event(Message):
    """irobot_create_msgs/action/AudioNoteSequence_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.AudioNoteSequence_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.AudioNoteSequence_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.AudioNoteSequence_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.AudioNoteSequence_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.AudioNoteSequence_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.AudioNoteSequence_GetResult_Response]) -> None: ...

class AudioNoteSequence_SendGoal(Service):
    Request: TypeAlias = AudioNoteSequence_SendGoal_Request
    Response: TypeAlias = AudioNoteSequence_SendGoal_Response
    Event: TypeAlias = AudioNoteSequence_SendGoal_Event

class AudioNoteSequence_GetResult(Service):
    Request: TypeAlias = AudioNoteSequence_GetResult_Request
    Response: TypeAlias = AudioNoteSequence_GetResult_Response
    Event: TypeAlias = AudioNoteSequence_GetResult_Event

class AudioNoteSequence(Action):
    Goal: TypeAlias = AudioNoteSequence_Goal
    Result: TypeAlias = AudioNoteSequence_Result
    Feedback: TypeAlias = AudioNoteSequence_Feedback
    class Impl:
        SendGoalService: TypeAlias = AudioNoteSequence_SendGoal
        GetResultService: TypeAlias = AudioNoteSequence_GetResult
        FeedbackMessage: TypeAlias = AudioNoteSequence_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class Dock_Goal(Message):
    """irobot_create_msgs/action/Dock_Goal

    # Drives to the dock.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Dock_Result(Message):
    """irobot_create_msgs/action/Dock_Result

    bool is_docked
    """
    def __init__(self, *, is_docked: bool = ..., check_fields: bool = ...) -> None: ...
    is_docked: bool

class Dock_Feedback(Message):
    """irobot_create_msgs/action/Dock_Feedback

    bool sees_dock
    """
    def __init__(self, *, sees_dock: bool = ..., check_fields: bool = ...) -> None: ...
    sees_dock: bool

class Dock_FeedbackMessage(Message):
    """irobot_create_msgs/action/Dock_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.Dock_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.Dock_Feedback

class Dock_SendGoal_Request(Message):
    """irobot_create_msgs/action/Dock_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.Dock_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.Dock_Goal

class Dock_SendGoal_Response(Message):
    """irobot_create_msgs/action/Dock_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Dock_SendGoal_Event(Message):
    """irobot_create_msgs/action/Dock_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.Dock_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.Dock_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.Dock_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.Dock_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.Dock_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.Dock_SendGoal_Response]) -> None: ...

class Dock_GetResult_Request(Message):
    """irobot_create_msgs/action/Dock_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Dock_GetResult_Response(Message):
    """irobot_create_msgs/action/Dock_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.Dock_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.Dock_Result

class Dock_GetResult_Event(Message):
    """irobot_create_msgs/action/Dock_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.Dock_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.Dock_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.Dock_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.Dock_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.Dock_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.Dock_GetResult_Response]) -> None: ...

class Dock_SendGoal(Service):
    Request: TypeAlias = Dock_SendGoal_Request
    Response: TypeAlias = Dock_SendGoal_Response
    Event: TypeAlias = Dock_SendGoal_Event

class Dock_GetResult(Service):
    Request: TypeAlias = Dock_GetResult_Request
    Response: TypeAlias = Dock_GetResult_Response
    Event: TypeAlias = Dock_GetResult_Event

class Dock(Action):
    Goal: TypeAlias = Dock_Goal
    Result: TypeAlias = Dock_Result
    Feedback: TypeAlias = Dock_Feedback
    class Impl:
        SendGoalService: TypeAlias = Dock_SendGoal
        GetResultService: TypeAlias = Dock_GetResult
        FeedbackMessage: TypeAlias = Dock_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class DriveArc_Goal(Message):
    """irobot_create_msgs/action/DriveArc_Goal

    # Drives along an arc.

    int8 TRANSLATE_FORWARD=1
    int8 TRANSLATE_BACKWARD=-1
    int8 translate_direction  # TRANSLATE_FORWARD or TRANSLATE_BACKWARD
    float32 angle  # rad
    float32 radius  # m
    float32 max_translation_speed 0.3  # m/s
    """
    TRANSLATE_FORWARD: Final = 1
    TRANSLATE_BACKWARD: Final = -1
    def __init__(self, *, translate_direction: int = ..., angle: float = ..., radius: float = ..., max_translation_speed: float = ..., check_fields: bool = ...) -> None: ...
    translate_direction: int
    angle: float
    radius: float
    max_translation_speed: float

class DriveArc_Result(Message):
    """irobot_create_msgs/action/DriveArc_Result

    geometry_msgs/PoseStamped pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseStamped = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseStamped

class DriveArc_Feedback(Message):
    """irobot_create_msgs/action/DriveArc_Feedback

    float32 remaining_angle_travel  # rad
    """
    def __init__(self, *, remaining_angle_travel: float = ..., check_fields: bool = ...) -> None: ...
    remaining_angle_travel: float

class DriveArc_FeedbackMessage(Message):
    """irobot_create_msgs/action/DriveArc_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.DriveArc_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.DriveArc_Feedback

class DriveArc_SendGoal_Request(Message):
    """irobot_create_msgs/action/DriveArc_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.DriveArc_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.DriveArc_Goal

class DriveArc_SendGoal_Response(Message):
    """irobot_create_msgs/action/DriveArc_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class DriveArc_SendGoal_Event(Message):
    """irobot_create_msgs/action/DriveArc_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.DriveArc_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.DriveArc_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.DriveArc_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.DriveArc_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.DriveArc_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.DriveArc_SendGoal_Response]) -> None: ...

class DriveArc_GetResult_Request(Message):
    """irobot_create_msgs/action/DriveArc_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class DriveArc_GetResult_Response(Message):
    """irobot_create_msgs/action/DriveArc_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.DriveArc_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.DriveArc_Result

class DriveArc_GetResult_Event(Message):
    """irobot_create_msgs/action/DriveArc_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.DriveArc_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.DriveArc_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.DriveArc_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.DriveArc_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.DriveArc_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.DriveArc_GetResult_Response]) -> None: ...

class DriveArc_SendGoal(Service):
    Request: TypeAlias = DriveArc_SendGoal_Request
    Response: TypeAlias = DriveArc_SendGoal_Response
    Event: TypeAlias = DriveArc_SendGoal_Event

class DriveArc_GetResult(Service):
    Request: TypeAlias = DriveArc_GetResult_Request
    Response: TypeAlias = DriveArc_GetResult_Response
    Event: TypeAlias = DriveArc_GetResult_Event

class DriveArc(Action):
    Goal: TypeAlias = DriveArc_Goal
    Result: TypeAlias = DriveArc_Result
    Feedback: TypeAlias = DriveArc_Feedback
    class Impl:
        SendGoalService: TypeAlias = DriveArc_SendGoal
        GetResultService: TypeAlias = DriveArc_GetResult
        FeedbackMessage: TypeAlias = DriveArc_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class DriveDistance_Goal(Message):
    """irobot_create_msgs/action/DriveDistance_Goal

    # Drives straight on.

    float32 distance  # m
    float32 max_translation_speed 0.3  # m/s
    """
    def __init__(self, *, distance: float = ..., max_translation_speed: float = ..., check_fields: bool = ...) -> None: ...
    distance: float
    max_translation_speed: float

class DriveDistance_Result(Message):
    """irobot_create_msgs/action/DriveDistance_Result

    geometry_msgs/PoseStamped pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseStamped = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseStamped

class DriveDistance_Feedback(Message):
    """irobot_create_msgs/action/DriveDistance_Feedback

    float32 remaining_travel_distance  # m
    """
    def __init__(self, *, remaining_travel_distance: float = ..., check_fields: bool = ...) -> None: ...
    remaining_travel_distance: float

class DriveDistance_FeedbackMessage(Message):
    """irobot_create_msgs/action/DriveDistance_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.DriveDistance_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.DriveDistance_Feedback

class DriveDistance_SendGoal_Request(Message):
    """irobot_create_msgs/action/DriveDistance_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.DriveDistance_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.DriveDistance_Goal

class DriveDistance_SendGoal_Response(Message):
    """irobot_create_msgs/action/DriveDistance_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class DriveDistance_SendGoal_Event(Message):
    """irobot_create_msgs/action/DriveDistance_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.DriveDistance_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.DriveDistance_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.DriveDistance_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.DriveDistance_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.DriveDistance_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.DriveDistance_SendGoal_Response]) -> None: ...

class DriveDistance_GetResult_Request(Message):
    """irobot_create_msgs/action/DriveDistance_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class DriveDistance_GetResult_Response(Message):
    """irobot_create_msgs/action/DriveDistance_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.DriveDistance_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.DriveDistance_Result

class DriveDistance_GetResult_Event(Message):
    """irobot_create_msgs/action/DriveDistance_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.DriveDistance_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.DriveDistance_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.DriveDistance_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.DriveDistance_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.DriveDistance_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.DriveDistance_GetResult_Response]) -> None: ...

class DriveDistance_SendGoal(Service):
    Request: TypeAlias = DriveDistance_SendGoal_Request
    Response: TypeAlias = DriveDistance_SendGoal_Response
    Event: TypeAlias = DriveDistance_SendGoal_Event

class DriveDistance_GetResult(Service):
    Request: TypeAlias = DriveDistance_GetResult_Request
    Response: TypeAlias = DriveDistance_GetResult_Response
    Event: TypeAlias = DriveDistance_GetResult_Event

class DriveDistance(Action):
    Goal: TypeAlias = DriveDistance_Goal
    Result: TypeAlias = DriveDistance_Result
    Feedback: TypeAlias = DriveDistance_Feedback
    class Impl:
        SendGoalService: TypeAlias = DriveDistance_SendGoal
        GetResultService: TypeAlias = DriveDistance_GetResult
        FeedbackMessage: TypeAlias = DriveDistance_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class LedAnimation_Goal(Message):
    """irobot_create_msgs/action/LedAnimation_Goal

    # Lets the ring of lights blink or spin.

    int8 BLINK_LIGHTS=1
    int8 SPIN_LIGHTS=2
    int8 animation_type  # BLINK_LIGHTS or SPIN_LIGHTS
    irobot_create_msgs/LightringLeds lightring
    builtin_interfaces/Duration max_runtime
    """
    BLINK_LIGHTS: Final = 1
    SPIN_LIGHTS: Final = 2
    def __init__(self, *, animation_type: int = ..., lightring: irobot_create_msgs.msg.LightringLeds = ..., max_runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    animation_type: int
    lightring: irobot_create_msgs.msg.LightringLeds
    max_runtime: builtin_interfaces.msg.Duration

class LedAnimation_Result(Message):
    """irobot_create_msgs/action/LedAnimation_Result

    builtin_interfaces/Duration runtime
    """
    def __init__(self, *, runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    runtime: builtin_interfaces.msg.Duration

class LedAnimation_Feedback(Message):
    """irobot_create_msgs/action/LedAnimation_Feedback

    builtin_interfaces/Duration remaining_runtime
    """
    def __init__(self, *, remaining_runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    remaining_runtime: builtin_interfaces.msg.Duration

class LedAnimation_FeedbackMessage(Message):
    """irobot_create_msgs/action/LedAnimation_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.LedAnimation_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.LedAnimation_Feedback

class LedAnimation_SendGoal_Request(Message):
    """irobot_create_msgs/action/LedAnimation_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.LedAnimation_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.LedAnimation_Goal

class LedAnimation_SendGoal_Response(Message):
    """irobot_create_msgs/action/LedAnimation_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class LedAnimation_SendGoal_Event(Message):
    """irobot_create_msgs/action/LedAnimation_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.LedAnimation_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.LedAnimation_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.LedAnimation_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.LedAnimation_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.LedAnimation_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.LedAnimation_SendGoal_Response]) -> None: ...

class LedAnimation_GetResult_Request(Message):
    """irobot_create_msgs/action/LedAnimation_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class LedAnimation_GetResult_Response(Message):
    """irobot_create_msgs/action/LedAnimation_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.LedAnimation_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.LedAnimation_Result

class LedAnimation_GetResult_Event(Message):
    """irobot_create_msgs/action/LedAnimation_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.LedAnimation_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.LedAnimation_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.LedAnimation_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.LedAnimation_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.LedAnimation_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.LedAnimation_GetResult_Response]) -> None: ...

class LedAnimation_SendGoal(Service):
    Request: TypeAlias = LedAnimation_SendGoal_Request
    Response: TypeAlias = LedAnimation_SendGoal_Response
    Event: TypeAlias = LedAnimation_SendGoal_Event

class LedAnimation_GetResult(Service):
    Request: TypeAlias = LedAnimation_GetResult_Request
    Response: TypeAlias = LedAnimation_GetResult_Response
    Event: TypeAlias = LedAnimation_GetResult_Event

class LedAnimation(Action):
    Goal: TypeAlias = LedAnimation_Goal
    Result: TypeAlias = LedAnimation_Result
    Feedback: TypeAlias = LedAnimation_Feedback
    class Impl:
        SendGoalService: TypeAlias = LedAnimation_SendGoal
        GetResultService: TypeAlias = LedAnimation_GetResult
        FeedbackMessage: TypeAlias = LedAnimation_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class NavigateToPosition_Goal(Message):
    """irobot_create_msgs/action/NavigateToPosition_Goal

    # Turns to a position, drives there, and turns to the heading.

    geometry_msgs/PoseStamped goal_pose
    bool achieve_goal_heading  # turn to the heading at the end
    float32 max_translation_speed 0.3  # m/s
    float32 max_rotation_speed 1.9  # rad/s
    """
    def __init__(self, *, goal_pose: geometry_msgs.msg.PoseStamped = ..., achieve_goal_heading: bool = ..., max_translation_speed: float = ..., max_rotation_speed: float = ..., check_fields: bool = ...) -> None: ...
    goal_pose: geometry_msgs.msg.PoseStamped
    achieve_goal_heading: bool
    max_translation_speed: float
    max_rotation_speed: float

class NavigateToPosition_Result(Message):
    """irobot_create_msgs/action/NavigateToPosition_Result

    geometry_msgs/PoseStamped pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseStamped = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseStamped

class NavigateToPosition_Feedback(Message):
    """irobot_create_msgs/action/NavigateToPosition_Feedback

    int8 ROTATING_TO_GOAL_POSITION=1
    int8 DRIVING_TO_GOAL_POSITION=2
    int8 ROTATING_TO_GOAL_ORIENTATION=3
    int8 navigate_state  # one of the constants above
    float32 remaining_angle_travel  # rad
    float32 remaining_travel_distance  # m
    """
    ROTATING_TO_GOAL_POSITION: Final = 1
    DRIVING_TO_GOAL_POSITION: Final = 2
    ROTATING_TO_GOAL_ORIENTATION: Final = 3
    def __init__(self, *, navigate_state: int = ..., remaining_angle_travel: float = ..., remaining_travel_distance: float = ..., check_fields: bool = ...) -> None: ...
    navigate_state: int
    remaining_angle_travel: float
    remaining_travel_distance: float

class NavigateToPosition_FeedbackMessage(Message):
    """irobot_create_msgs/action/NavigateToPosition_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.NavigateToPosition_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.NavigateToPosition_Feedback

class NavigateToPosition_SendGoal_Request(Message):
    """irobot_create_msgs/action/NavigateToPosition_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.NavigateToPosition_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.NavigateToPosition_Goal

class NavigateToPosition_SendGoal_Response(Message):
    """irobot_create_msgs/action/NavigateToPosition_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class NavigateToPosition_SendGoal_Event(Message):
    """irobot_create_msgs/action/NavigateToPosition_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.NavigateToPosition_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.NavigateToPosition_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.NavigateToPosition_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.NavigateToPosition_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.NavigateToPosition_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.NavigateToPosition_SendGoal_Response]) -> None: ...

class NavigateToPosition_GetResult_Request(Message):
    """irobot_create_msgs/action/NavigateToPosition_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class NavigateToPosition_GetResult_Response(Message):
    """irobot_create_msgs/action/NavigateToPosition_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.NavigateToPosition_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.NavigateToPosition_Result

class NavigateToPosition_GetResult_Event(Message):
    """irobot_create_msgs/action/NavigateToPosition_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.NavigateToPosition_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.NavigateToPosition_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.NavigateToPosition_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.NavigateToPosition_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.NavigateToPosition_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.NavigateToPosition_GetResult_Response]) -> None: ...

class NavigateToPosition_SendGoal(Service):
    Request: TypeAlias = NavigateToPosition_SendGoal_Request
    Response: TypeAlias = NavigateToPosition_SendGoal_Response
    Event: TypeAlias = NavigateToPosition_SendGoal_Event

class NavigateToPosition_GetResult(Service):
    Request: TypeAlias = NavigateToPosition_GetResult_Request
    Response: TypeAlias = NavigateToPosition_GetResult_Response
    Event: TypeAlias = NavigateToPosition_GetResult_Event

class NavigateToPosition(Action):
    Goal: TypeAlias = NavigateToPosition_Goal
    Result: TypeAlias = NavigateToPosition_Result
    Feedback: TypeAlias = NavigateToPosition_Feedback
    class Impl:
        SendGoalService: TypeAlias = NavigateToPosition_SendGoal
        GetResultService: TypeAlias = NavigateToPosition_GetResult
        FeedbackMessage: TypeAlias = NavigateToPosition_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class RotateAngle_Goal(Message):
    """irobot_create_msgs/action/RotateAngle_Goal

    # Turns in place.

    float32 angle  # rad
    float32 max_rotation_speed 1.9  # rad/s
    """
    def __init__(self, *, angle: float = ..., max_rotation_speed: float = ..., check_fields: bool = ...) -> None: ...
    angle: float
    max_rotation_speed: float

class RotateAngle_Result(Message):
    """irobot_create_msgs/action/RotateAngle_Result

    geometry_msgs/PoseStamped pose
    """
    def __init__(self, *, pose: geometry_msgs.msg.PoseStamped = ..., check_fields: bool = ...) -> None: ...
    pose: geometry_msgs.msg.PoseStamped

class RotateAngle_Feedback(Message):
    """irobot_create_msgs/action/RotateAngle_Feedback

    float32 remaining_angle_travel  # rad
    """
    def __init__(self, *, remaining_angle_travel: float = ..., check_fields: bool = ...) -> None: ...
    remaining_angle_travel: float

class RotateAngle_FeedbackMessage(Message):
    """irobot_create_msgs/action/RotateAngle_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.RotateAngle_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.RotateAngle_Feedback

class RotateAngle_SendGoal_Request(Message):
    """irobot_create_msgs/action/RotateAngle_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.RotateAngle_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.RotateAngle_Goal

class RotateAngle_SendGoal_Response(Message):
    """irobot_create_msgs/action/RotateAngle_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class RotateAngle_SendGoal_Event(Message):
    """irobot_create_msgs/action/RotateAngle_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.RotateAngle_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.RotateAngle_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.RotateAngle_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.RotateAngle_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.RotateAngle_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.RotateAngle_SendGoal_Response]) -> None: ...

class RotateAngle_GetResult_Request(Message):
    """irobot_create_msgs/action/RotateAngle_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class RotateAngle_GetResult_Response(Message):
    """irobot_create_msgs/action/RotateAngle_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.RotateAngle_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.RotateAngle_Result

class RotateAngle_GetResult_Event(Message):
    """irobot_create_msgs/action/RotateAngle_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.RotateAngle_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.RotateAngle_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.RotateAngle_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.RotateAngle_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.RotateAngle_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.RotateAngle_GetResult_Response]) -> None: ...

class RotateAngle_SendGoal(Service):
    Request: TypeAlias = RotateAngle_SendGoal_Request
    Response: TypeAlias = RotateAngle_SendGoal_Response
    Event: TypeAlias = RotateAngle_SendGoal_Event

class RotateAngle_GetResult(Service):
    Request: TypeAlias = RotateAngle_GetResult_Request
    Response: TypeAlias = RotateAngle_GetResult_Response
    Event: TypeAlias = RotateAngle_GetResult_Event

class RotateAngle(Action):
    Goal: TypeAlias = RotateAngle_Goal
    Result: TypeAlias = RotateAngle_Result
    Feedback: TypeAlias = RotateAngle_Feedback
    class Impl:
        SendGoalService: TypeAlias = RotateAngle_SendGoal
        GetResultService: TypeAlias = RotateAngle_GetResult
        FeedbackMessage: TypeAlias = RotateAngle_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class Undock_Goal(Message):
    """irobot_create_msgs/action/Undock_Goal

    # Drives away from the dock.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Undock_Result(Message):
    """irobot_create_msgs/action/Undock_Result

    bool is_docked
    """
    def __init__(self, *, is_docked: bool = ..., check_fields: bool = ...) -> None: ...
    is_docked: bool

class Undock_Feedback(Message):
    """irobot_create_msgs/action/Undock_Feedback"""
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Undock_FeedbackMessage(Message):
    """irobot_create_msgs/action/Undock_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.Undock_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.Undock_Feedback

class Undock_SendGoal_Request(Message):
    """irobot_create_msgs/action/Undock_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.Undock_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.Undock_Goal

class Undock_SendGoal_Response(Message):
    """irobot_create_msgs/action/Undock_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class Undock_SendGoal_Event(Message):
    """irobot_create_msgs/action/Undock_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.Undock_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.Undock_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.Undock_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.Undock_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.Undock_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.Undock_SendGoal_Response]) -> None: ...

class Undock_GetResult_Request(Message):
    """irobot_create_msgs/action/Undock_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class Undock_GetResult_Response(Message):
    """irobot_create_msgs/action/Undock_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.Undock_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.Undock_Result

class Undock_GetResult_Event(Message):
    """irobot_create_msgs/action/Undock_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.Undock_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.Undock_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.Undock_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.Undock_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.Undock_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.Undock_GetResult_Response]) -> None: ...

class Undock_SendGoal(Service):
    Request: TypeAlias = Undock_SendGoal_Request
    Response: TypeAlias = Undock_SendGoal_Response
    Event: TypeAlias = Undock_SendGoal_Event

class Undock_GetResult(Service):
    Request: TypeAlias = Undock_GetResult_Request
    Response: TypeAlias = Undock_GetResult_Response
    Event: TypeAlias = Undock_GetResult_Event

class Undock(Action):
    Goal: TypeAlias = Undock_Goal
    Result: TypeAlias = Undock_Result
    Feedback: TypeAlias = Undock_Feedback
    class Impl:
        SendGoalService: TypeAlias = Undock_SendGoal
        GetResultService: TypeAlias = Undock_GetResult
        FeedbackMessage: TypeAlias = Undock_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray

class WallFollow_Goal(Message):
    """irobot_create_msgs/action/WallFollow_Goal

    # Drives along a wall.

    int8 FOLLOW_RIGHT=-1
    int8 FOLLOW_LEFT=1
    int8 follow_side  # FOLLOW_RIGHT or FOLLOW_LEFT
    builtin_interfaces/Duration max_runtime
    """
    FOLLOW_RIGHT: Final = -1
    FOLLOW_LEFT: Final = 1
    def __init__(self, *, follow_side: int = ..., max_runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    follow_side: int
    max_runtime: builtin_interfaces.msg.Duration

class WallFollow_Result(Message):
    """irobot_create_msgs/action/WallFollow_Result

    builtin_interfaces/Duration runtime
    """
    def __init__(self, *, runtime: builtin_interfaces.msg.Duration = ..., check_fields: bool = ...) -> None: ...
    runtime: builtin_interfaces.msg.Duration

class WallFollow_Feedback(Message):
    """irobot_create_msgs/action/WallFollow_Feedback

    bool engaged  # there is a wall
    """
    def __init__(self, *, engaged: bool = ..., check_fields: bool = ...) -> None: ...
    engaged: bool

class WallFollow_FeedbackMessage(Message):
    """irobot_create_msgs/action/WallFollow_FeedbackMessage"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., feedback: irobot_create_msgs.action.WallFollow_Feedback = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    feedback: irobot_create_msgs.action.WallFollow_Feedback

class WallFollow_SendGoal_Request(Message):
    """irobot_create_msgs/action/WallFollow_SendGoal_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., goal: irobot_create_msgs.action.WallFollow_Goal = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID
    goal: irobot_create_msgs.action.WallFollow_Goal

class WallFollow_SendGoal_Response(Message):
    """irobot_create_msgs/action/WallFollow_SendGoal_Response"""
    def __init__(self, *, accepted: bool = ..., stamp: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    accepted: bool
    stamp: builtin_interfaces.msg.Time

class WallFollow_SendGoal_Event(Message):
    """irobot_create_msgs/action/WallFollow_SendGoal_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.WallFollow_SendGoal_Request] = ..., response: Collection[irobot_create_msgs.action.WallFollow_SendGoal_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.WallFollow_SendGoal_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.WallFollow_SendGoal_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.WallFollow_SendGoal_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.WallFollow_SendGoal_Response]) -> None: ...

class WallFollow_GetResult_Request(Message):
    """irobot_create_msgs/action/WallFollow_GetResult_Request"""
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., check_fields: bool = ...) -> None: ...
    goal_id: unique_identifier_msgs.msg.UUID

class WallFollow_GetResult_Response(Message):
    """irobot_create_msgs/action/WallFollow_GetResult_Response"""
    def __init__(self, *, status: int = ..., result: irobot_create_msgs.action.WallFollow_Result = ..., check_fields: bool = ...) -> None: ...
    status: int
    result: irobot_create_msgs.action.WallFollow_Result

class WallFollow_GetResult_Event(Message):
    """irobot_create_msgs/action/WallFollow_GetResult_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[irobot_create_msgs.action.WallFollow_GetResult_Request] = ..., response: Collection[irobot_create_msgs.action.WallFollow_GetResult_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[irobot_create_msgs.action.WallFollow_GetResult_Request]: ...
    @request.setter
    def request(self, value: Collection[irobot_create_msgs.action.WallFollow_GetResult_Request]) -> None: ...
    @property
    def response(self) -> list[irobot_create_msgs.action.WallFollow_GetResult_Response]: ...
    @response.setter
    def response(self, value: Collection[irobot_create_msgs.action.WallFollow_GetResult_Response]) -> None: ...

class WallFollow_SendGoal(Service):
    Request: TypeAlias = WallFollow_SendGoal_Request
    Response: TypeAlias = WallFollow_SendGoal_Response
    Event: TypeAlias = WallFollow_SendGoal_Event

class WallFollow_GetResult(Service):
    Request: TypeAlias = WallFollow_GetResult_Request
    Response: TypeAlias = WallFollow_GetResult_Response
    Event: TypeAlias = WallFollow_GetResult_Event

class WallFollow(Action):
    Goal: TypeAlias = WallFollow_Goal
    Result: TypeAlias = WallFollow_Result
    Feedback: TypeAlias = WallFollow_Feedback
    class Impl:
        SendGoalService: TypeAlias = WallFollow_SendGoal
        GetResultService: TypeAlias = WallFollow_GetResult
        FeedbackMessage: TypeAlias = WallFollow_FeedbackMessage
        CancelGoalService: TypeAlias = action_msgs.srv.CancelGoal
        GoalStatusMessage: TypeAlias = action_msgs.msg.GoalStatusArray
