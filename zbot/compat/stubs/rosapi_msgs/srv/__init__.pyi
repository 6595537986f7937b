# Written by python -m zbot.interfaces.stubs; do not edit.
from array import array
from collections.abc import Collection
from typing import Final, TypeAlias

import numpy
from numpy.typing import NDArray

import builtin_interfaces.msg
import rosapi_msgs.msg
import rosapi_msgs.srv
import service_msgs.msg
from zbot.interfaces import Action, Message, Service

class ActionFeedbackDetails_Request(Message):
    """rosapi_msgs/srv/ActionFeedbackDetails_Request

    # Describes the feedback of an action type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ActionFeedbackDetails_Response(Message):
    """rosapi_msgs/srv/ActionFeedbackDetails_Response

    TypeDef[] typedefs
    """
    def __init__(self, *, typedefs: Collection[rosapi_msgs.msg.TypeDef] = ..., check_fields: bool = ...) -> None: ...
    @property
    def typedefs(self) -> list[rosapi_msgs.msg.TypeDef]: ...
    @typedefs.setter
    def typedefs(self, value: Collection[rosapi_msgs.msg.TypeDef]) -> None: ...

class ActionFeedbackDetails_Event(Message):
    """rosapi_msgs/srv/ActionFeedbackDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ActionFeedbackDetails_Request] = ..., response: Collection[rosapi_msgs.srv.ActionFeedbackDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ActionFeedbackDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ActionFeedbackDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ActionFeedbackDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ActionFeedbackDetails_Response]) -> None: ...

class ActionFeedbackDetails(Service):
    Request: TypeAlias = ActionFeedbackDetails_Request
    Response: TypeAlias = ActionFeedbackDetails_Response
    Event: TypeAlias = ActionFeedbackDetails_Event

class ActionGoalDetails_Request(Message):
    """rosapi_msgs/srv/ActionGoalDetails_Request

    # Describes the goal of an action type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ActionGoalDetails_Response(Message):
    """rosapi_msgs/srv/ActionGoalDetails_Response

    TypeDef[] typedefs
    """
    def __init__(self, *, typedefs: Collection[rosapi_msgs.msg.TypeDef] = ..., check_fields: bool = ...) -> None: ...
    @property
    def typedefs(self) -> list[rosapi_msgs.msg.TypeDef]: ...
    @typedefs.setter
    def typedefs(self, value: Collection[rosapi_msgs.msg.TypeDef]) -> None: ...

class ActionGoalDetails_Event(Message):
    """rosapi_msgs/srv/ActionGoalDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ActionGoalDetails_Request] = ..., response: Collection[rosapi_msgs.srv.ActionGoalDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ActionGoalDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ActionGoalDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ActionGoalDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ActionGoalDetails_Response]) -> None: ...

class ActionGoalDetails(Service):
    Request: TypeAlias = ActionGoalDetails_Request
    Response: TypeAlias = ActionGoalDetails_Response
    Event: TypeAlias = ActionGoalDetails_Event

class ActionResultDetails_Request(Message):
    """rosapi_msgs/srv/ActionResultDetails_Request

    # Describes the result of an action type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ActionResultDetails_Response(Message):
    """rosapi_msgs/srv/ActionResultDetails_Response

    TypeDef[] typedefs
    """
    def __init__(self, *, typedefs: Collection[rosapi_msgs.msg.TypeDef] = ..., check_fields: bool = ...) -> None: ...
    @property
    def typedefs(self) -> list[rosapi_msgs.msg.TypeDef]: ...
    @typedefs.setter
    def typedefs(self, value: Collection[rosapi_msgs.msg.TypeDef]) -> None: ...

class ActionResultDetails_Event(Message):
    """rosapi_msgs/srv/ActionResultDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ActionResultDetails_Request] = ..., response: Collection[rosapi_msgs.srv.ActionResultDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ActionResultDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ActionResultDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ActionResultDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ActionResultDetails_Response]) -> None: ...

class ActionResultDetails(Service):
    Request: TypeAlias = ActionResultDetails_Request
    Response: TypeAlias = ActionResultDetails_Response
    Event: TypeAlias = ActionResultDetails_Event

class ActionType_Request(Message):
    """rosapi_msgs/srv/ActionType_Request

    # Returns the type of an action.

    string action
    """
    def __init__(self, *, action: str = ..., check_fields: bool = ...) -> None: ...
    action: str

class ActionType_Response(Message):
    """rosapi_msgs/srv/ActionType_Response

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ActionType_Event(Message):
    """rosapi_msgs/srv/ActionType_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ActionType_Request] = ..., response: Collection[rosapi_msgs.srv.ActionType_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ActionType_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ActionType_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ActionType_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ActionType_Response]) -> None: ...

class ActionType(Service):
    Request: TypeAlias = ActionType_Request
    Response: TypeAlias = ActionType_Response
    Event: TypeAlias = ActionType_Event

class DeleteParam_Request(Message):
    """rosapi_msgs/srv/DeleteParam_Request

    # Deletes a parameter.

    string name  # NODE:PARAMETER
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class DeleteParam_Response(Message):
    """rosapi_msgs/srv/DeleteParam_Response

    bool successful
    string reason  # why it failed
    """
    def __init__(self, *, successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    successful: bool
    reason: str

class DeleteParam_Event(Message):
    """rosapi_msgs/srv/DeleteParam_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.DeleteParam_Request] = ..., response: Collection[rosapi_msgs.srv.DeleteParam_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.DeleteParam_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.DeleteParam_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.DeleteParam_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.DeleteParam_Response]) -> None: ...

class DeleteParam(Service):
    Request: TypeAlias = DeleteParam_Request
    Response: TypeAlias = DeleteParam_Response
    Event: TypeAlias = DeleteParam_Event

class GetActionServers_Request(Message):
    """rosapi_msgs/srv/GetActionServers_Request

    # Lists the action servers.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetActionServers_Response(Message):
    """rosapi_msgs/srv/GetActionServers_Response

    string[] action_servers
    """
    def __init__(self, *, action_servers: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def action_servers(self) -> list[str]: ...
    @action_servers.setter
    def action_servers(self, value: Collection[str]) -> None: ...

class GetActionServers_Event(Message):
    """rosapi_msgs/srv/GetActionServers_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.GetActionServers_Request] = ..., response: Collection[rosapi_msgs.srv.GetActionServers_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.GetActionServers_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.GetActionServers_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.GetActionServers_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.GetActionServers_Response]) -> None: ...

class GetActionServers(Service):
    Request: TypeAlias = GetActionServers_Request
    Response: TypeAlias = GetActionServers_Response
    Event: TypeAlias = GetActionServers_Event

class GetParam_Request(Message):
    """rosapi_msgs/srv/GetParam_Request

    # Returns the value of a parameter.

    string name  # NODE:PARAMETER
    string default_value  # JSON, if there is no such parameter
    """
    def __init__(self, *, name: str = ..., default_value: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    default_value: str

class GetParam_Response(Message):
    """rosapi_msgs/srv/GetParam_Response

    string value  # JSON
    bool successful
    string reason  # why it failed
    """
    def __init__(self, *, value: str = ..., successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    value: str
    successful: bool
    reason: str

class GetParam_Event(Message):
    """rosapi_msgs/srv/GetParam_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.GetParam_Request] = ..., response: Collection[rosapi_msgs.srv.GetParam_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.GetParam_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.GetParam_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.GetParam_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.GetParam_Response]) -> None: ...

class GetParam(Service):
    Request: TypeAlias = GetParam_Request
    Response: TypeAlias = GetParam_Response
    Event: TypeAlias = GetParam_Event

class GetParamNames_Request(Message):
    """rosapi_msgs/srv/GetParamNames_Request

    # Lists the parameters of all nodes.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetParamNames_Response(Message):
    """rosapi_msgs/srv/GetParamNames_Response

    string[] names  # NODE:PARAMETER
    """
    def __init__(self, *, names: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def names(self) -> list[str]: ...
    @names.setter
    def names(self, value: Collection[str]) -> None: ...

class GetParamNames_Event(Message):
    """rosapi_msgs/srv/GetParamNames_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.GetParamNames_Request] = ..., response: Collection[rosapi_msgs.srv.GetParamNames_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.GetParamNames_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.GetParamNames_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.GetParamNames_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.GetParamNames_Response]) -> None: ...

class GetParamNames(Service):
    Request: TypeAlias = GetParamNames_Request
    Response: TypeAlias = GetParamNames_Response
    Event: TypeAlias = GetParamNames_Event

class GetROSVersion_Request(Message):
    """rosapi_msgs/srv/GetROSVersion_Request

    # Returns the version of ROS.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetROSVersion_Response(Message):
    """rosapi_msgs/srv/GetROSVersion_Response

    uint8 version  # 1 or 2
    string distro  # e.g. jazzy
    """
    def __init__(self, *, version: int = ..., distro: str = ..., check_fields: bool = ...) -> None: ...
    version: int
    distro: str

class GetROSVersion_Event(Message):
    """rosapi_msgs/srv/GetROSVersion_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.GetROSVersion_Request] = ..., response: Collection[rosapi_msgs.srv.GetROSVersion_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.GetROSVersion_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.GetROSVersion_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.GetROSVersion_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.GetROSVersion_Response]) -> None: ...

class GetROSVersion(Service):
    Request: TypeAlias = GetROSVersion_Request
    Response: TypeAlias = GetROSVersion_Response
    Event: TypeAlias = GetROSVersion_Event

class GetTime_Request(Message):
    """rosapi_msgs/srv/GetTime_Request

    # Returns the time.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class GetTime_Response(Message):
    """rosapi_msgs/srv/GetTime_Response

    builtin_interfaces/Time time
    """
    def __init__(self, *, time: builtin_interfaces.msg.Time = ..., check_fields: bool = ...) -> None: ...
    time: builtin_interfaces.msg.Time

class GetTime_Event(Message):
    """rosapi_msgs/srv/GetTime_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.GetTime_Request] = ..., response: Collection[rosapi_msgs.srv.GetTime_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.GetTime_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.GetTime_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.GetTime_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.GetTime_Response]) -> None: ...

class GetTime(Service):
    Request: TypeAlias = GetTime_Request
    Response: TypeAlias = GetTime_Response
    Event: TypeAlias = GetTime_Event

class HasParam_Request(Message):
    """rosapi_msgs/srv/HasParam_Request

    # Says whether a parameter exists.

    string name  # NODE:PARAMETER
    """
    def __init__(self, *, name: str = ..., check_fields: bool = ...) -> None: ...
    name: str

class HasParam_Response(Message):
    """rosapi_msgs/srv/HasParam_Response

    bool exists
    """
    def __init__(self, *, exists: bool = ..., check_fields: bool = ...) -> None: ...
    exists: bool

class HasParam_Event(Message):
    """rosapi_msgs/srv/HasParam_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.HasParam_Request] = ..., response: Collection[rosapi_msgs.srv.HasParam_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.HasParam_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.HasParam_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.HasParam_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.HasParam_Response]) -> None: ...

class HasParam(Service):
    Request: TypeAlias = HasParam_Request
    Response: TypeAlias = HasParam_Response
    Event: TypeAlias = HasParam_Event

class Interfaces_Request(Message):
    """rosapi_msgs/srv/Interfaces_Request

    # Lists the types.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Interfaces_Response(Message):
    """rosapi_msgs/srv/Interfaces_Response

    string[] interfaces
    """
    def __init__(self, *, interfaces: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def interfaces(self) -> list[str]: ...
    @interfaces.setter
    def interfaces(self, value: Collection[str]) -> None: ...

class Interfaces_Event(Message):
    """rosapi_msgs/srv/Interfaces_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.Interfaces_Request] = ..., response: Collection[rosapi_msgs.srv.Interfaces_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.Interfaces_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.Interfaces_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.Interfaces_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.Interfaces_Response]) -> None: ...

class Interfaces(Service):
    Request: TypeAlias = Interfaces_Request
    Response: TypeAlias = Interfaces_Response
    Event: TypeAlias = Interfaces_Event

class MessageDetails_Request(Message):
    """rosapi_msgs/srv/MessageDetails_Request

    # Describes a message type and the types inside it.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class MessageDetails_Response(Message):
    """rosapi_msgs/srv/MessageDetails_Response

    TypeDef[] typedefs
    """
    def __init__(self, *, typedefs: Collection[rosapi_msgs.msg.TypeDef] = ..., check_fields: bool = ...) -> None: ...
    @property
    def typedefs(self) -> list[rosapi_msgs.msg.TypeDef]: ...
    @typedefs.setter
    def typedefs(self, value: Collection[rosapi_msgs.msg.TypeDef]) -> None: ...

class MessageDetails_Event(Message):
    """rosapi_msgs/srv/MessageDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.MessageDetails_Request] = ..., response: Collection[rosapi_msgs.srv.MessageDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.MessageDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.MessageDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.MessageDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.MessageDetails_Response]) -> None: ...

class MessageDetails(Service):
    Request: TypeAlias = MessageDetails_Request
    Response: TypeAlias = MessageDetails_Response
    Event: TypeAlias = MessageDetails_Event

class NodeDetails_Request(Message):
    """rosapi_msgs/srv/NodeDetails_Request

    # Lists the topics and services of a node.

    string node
    """
    def __init__(self, *, node: str = ..., check_fields: bool = ...) -> None: ...
    node: str

class NodeDetails_Response(Message):
    """rosapi_msgs/srv/NodeDetails_Response

    string[] subscribing
    string[] publishing
    string[] services
    """
    def __init__(self, *, subscribing: Collection[str] = ..., publishing: Collection[str] = ..., services: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def subscribing(self) -> list[str]: ...
    @subscribing.setter
    def subscribing(self, value: Collection[str]) -> None: ...
    @property
    def publishing(self) -> list[str]: ...
    @publishing.setter
    def publishing(self, value: Collection[str]) -> None: ...
    @property
    def services(self) -> list[str]: ...
    @services.setter
    def services(self, value: Collection[str]) -> None: ...

class NodeDetails_Event(Message):
    """rosapi_msgs/srv/NodeDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.NodeDetails_Request] = ..., response: Collection[rosapi_msgs.srv.NodeDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.NodeDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.NodeDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.NodeDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.NodeDetails_Response]) -> None: ...

class NodeDetails(Service):
    Request: TypeAlias = NodeDetails_Request
    Response: TypeAlias = NodeDetails_Response
    Event: TypeAlias = NodeDetails_Event

class Nodes_Request(Message):
    """rosapi_msgs/srv/Nodes_Request

    # Lists the nodes.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Nodes_Response(Message):
    """rosapi_msgs/srv/Nodes_Response

    string[] nodes
    """
    def __init__(self, *, nodes: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def nodes(self) -> list[str]: ...
    @nodes.setter
    def nodes(self, value: Collection[str]) -> None: ...

class Nodes_Event(Message):
    """rosapi_msgs/srv/Nodes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.Nodes_Request] = ..., response: Collection[rosapi_msgs.srv.Nodes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.Nodes_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.Nodes_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.Nodes_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.Nodes_Response]) -> None: ...

class Nodes(Service):
    Request: TypeAlias = Nodes_Request
    Response: TypeAlias = Nodes_Response
    Event: TypeAlias = Nodes_Event

class Publishers_Request(Message):
    """rosapi_msgs/srv/Publishers_Request

    # Lists the nodes that publish a topic.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class Publishers_Response(Message):
    """rosapi_msgs/srv/Publishers_Response

    string[] publishers
    """
    def __init__(self, *, publishers: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def publishers(self) -> list[str]: ...
    @publishers.setter
    def publishers(self, value: Collection[str]) -> None: ...

class Publishers_Event(Message):
    """rosapi_msgs/srv/Publishers_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.Publishers_Request] = ..., response: Collection[rosapi_msgs.srv.Publishers_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.Publishers_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.Publishers_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.Publishers_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.Publishers_Response]) -> None: ...

class Publishers(Service):
    Request: TypeAlias = Publishers_Request
    Response: TypeAlias = Publishers_Response
    Event: TypeAlias = Publishers_Event

class ServiceNode_Request(Message):
    """rosapi_msgs/srv/ServiceNode_Request

    # Returns the node that offers a service.

    string service
    """
    def __init__(self, *, service: str = ..., check_fields: bool = ...) -> None: ...
    service: str

class ServiceNode_Response(Message):
    """rosapi_msgs/srv/ServiceNode_Response

    string node
    """
    def __init__(self, *, node: str = ..., check_fields: bool = ...) -> None: ...
    node: str

class ServiceNode_Event(Message):
    """rosapi_msgs/srv/ServiceNode_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ServiceNode_Request] = ..., response: Collection[rosapi_msgs.srv.ServiceNode_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ServiceNode_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ServiceNode_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ServiceNode_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ServiceNode_Response]) -> None: ...

class ServiceNode(Service):
    Request: TypeAlias = ServiceNode_Request
    Response: TypeAlias = ServiceNode_Response
    Event: TypeAlias = ServiceNode_Event

class ServiceProviders_Request(Message):
    """rosapi_msgs/srv/ServiceProviders_Request

    # Lists the services of a type.

    string service  # name of a type
    """
    def __init__(self, *, service: str = ..., check_fields: bool = ...) -> None: ...
    service: str

class ServiceProviders_Response(Message):
    """rosapi_msgs/srv/ServiceProviders_Response

    string[] providers
    """
    def __init__(self, *, providers: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def providers(self) -> list[str]: ...
    @providers.setter
    def providers(self, value: Collection[str]) -> None: ...

class ServiceProviders_Event(Message):
    """rosapi_msgs/srv/ServiceProviders_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ServiceProviders_Request] = ..., response: Collection[rosapi_msgs.srv.ServiceProviders_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ServiceProviders_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ServiceProviders_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ServiceProviders_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ServiceProviders_Response]) -> None: ...

class ServiceProviders(Service):
    Request: TypeAlias = ServiceProviders_Request
    Response: TypeAlias = ServiceProviders_Response
    Event: TypeAlias = ServiceProviders_Event

class ServiceRequestDetails_Request(Message):
    """rosapi_msgs/srv/ServiceRequestDetails_Request

    # Describes the request of a service type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ServiceRequestDetails_Response(Message):
    """rosapi_msgs/srv/ServiceRequestDetails_Response

    TypeDef[] typedefs
    """
    def __init__(self, *, typedefs: Collection[rosapi_msgs.msg.TypeDef] = ..., check_fields: bool = ...) -> None: ...
    @property
    def typedefs(self) -> list[rosapi_msgs.msg.TypeDef]: ...
    @typedefs.setter
    def typedefs(self, value: Collection[rosapi_msgs.msg.TypeDef]) -> None: ...

class ServiceRequestDetails_Event(Message):
    """rosapi_msgs/srv/ServiceRequestDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ServiceRequestDetails_Request] = ..., response: Collection[rosapi_msgs.srv.ServiceRequestDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ServiceRequestDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ServiceRequestDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ServiceRequestDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ServiceRequestDetails_Response]) -> None: ...

class ServiceRequestDetails(Service):
    Request: TypeAlias = ServiceRequestDetails_Request
    Response: TypeAlias = ServiceRequestDetails_Response
    Event: TypeAlias = ServiceRequestDetails_Event

class ServiceResponseDetails_Request(Message):
    """rosapi_msgs/srv/ServiceResponseDetails_Request

    # Describes the response of a service type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ServiceResponseDetails_Response(Message):
    """rosapi_msgs/srv/ServiceResponseDetails_Response

    TypeDef[] typedefs
    """
    def __init__(self, *, typedefs: Collection[rosapi_msgs.msg.TypeDef] = ..., check_fields: bool = ...) -> None: ...
    @property
    def typedefs(self) -> list[rosapi_msgs.msg.TypeDef]: ...
    @typedefs.setter
    def typedefs(self, value: Collection[rosapi_msgs.msg.TypeDef]) -> None: ...

class ServiceResponseDetails_Event(Message):
    """rosapi_msgs/srv/ServiceResponseDetails_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ServiceResponseDetails_Request] = ..., response: Collection[rosapi_msgs.srv.ServiceResponseDetails_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ServiceResponseDetails_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ServiceResponseDetails_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ServiceResponseDetails_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ServiceResponseDetails_Response]) -> None: ...

class ServiceResponseDetails(Service):
    Request: TypeAlias = ServiceResponseDetails_Request
    Response: TypeAlias = ServiceResponseDetails_Response
    Event: TypeAlias = ServiceResponseDetails_Event

class ServiceType_Request(Message):
    """rosapi_msgs/srv/ServiceType_Request

    # Returns the type of a service.

    string service
    """
    def __init__(self, *, service: str = ..., check_fields: bool = ...) -> None: ...
    service: str

class ServiceType_Response(Message):
    """rosapi_msgs/srv/ServiceType_Response

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ServiceType_Event(Message):
    """rosapi_msgs/srv/ServiceType_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ServiceType_Request] = ..., response: Collection[rosapi_msgs.srv.ServiceType_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ServiceType_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ServiceType_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ServiceType_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ServiceType_Response]) -> None: ...

class ServiceType(Service):
    Request: TypeAlias = ServiceType_Request
    Response: TypeAlias = ServiceType_Response
    Event: TypeAlias = ServiceType_Event

class Services_Request(Message):
    """rosapi_msgs/srv/Services_Request

    # Lists the services.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Services_Response(Message):
    """rosapi_msgs/srv/Services_Response

    string[] services
    """
    def __init__(self, *, services: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def services(self) -> list[str]: ...
    @services.setter
    def services(self, value: Collection[str]) -> None: ...

class Services_Event(Message):
    """rosapi_msgs/srv/Services_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.Services_Request] = ..., response: Collection[rosapi_msgs.srv.Services_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.Services_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.Services_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.Services_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.Services_Response]) -> None: ...

class Services(Service):
    Request: TypeAlias = Services_Request
    Response: TypeAlias = Services_Response
    Event: TypeAlias = Services_Event

class ServicesForType_Request(Message):
    """rosapi_msgs/srv/ServicesForType_Request

    # Lists the services of a type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class ServicesForType_Response(Message):
    """rosapi_msgs/srv/ServicesForType_Response

    string[] services
    """
    def __init__(self, *, services: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def services(self) -> list[str]: ...
    @services.setter
    def services(self, value: Collection[str]) -> None: ...

class ServicesForType_Event(Message):
    """rosapi_msgs/srv/ServicesForType_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.ServicesForType_Request] = ..., response: Collection[rosapi_msgs.srv.ServicesForType_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.ServicesForType_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.ServicesForType_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.ServicesForType_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.ServicesForType_Response]) -> None: ...

class ServicesForType(Service):
    Request: TypeAlias = ServicesForType_Request
    Response: TypeAlias = ServicesForType_Response
    Event: TypeAlias = ServicesForType_Event

class SetParam_Request(Message):
    """rosapi_msgs/srv/SetParam_Request

    # Sets a parameter.

    string name  # NODE:PARAMETER
    string value  # JSON
    """
    def __init__(self, *, name: str = ..., value: str = ..., check_fields: bool = ...) -> None: ...
    name: str
    value: str

class SetParam_Response(Message):
    """rosapi_msgs/srv/SetParam_Response

    bool successful
    string reason  # why it failed
    """
    def __init__(self, *, successful: bool = ..., reason: str = ..., check_fields: bool = ...) -> None: ...
    successful: bool
    reason: str

class SetParam_Event(Message):
    """rosapi_msgs/srv/SetParam_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.SetParam_Request] = ..., response: Collection[rosapi_msgs.srv.SetParam_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.SetParam_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.SetParam_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.SetParam_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.SetParam_Response]) -> None: ...

class SetParam(Service):
    Request: TypeAlias = SetParam_Request
    Response: TypeAlias = SetParam_Response
    Event: TypeAlias = SetParam_Event

class Subscribers_Request(Message):
    """rosapi_msgs/srv/Subscribers_Request

    # Lists the nodes that subscribe to a topic.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class Subscribers_Response(Message):
    """rosapi_msgs/srv/Subscribers_Response

    string[] subscribers
    """
    def __init__(self, *, subscribers: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def subscribers(self) -> list[str]: ...
    @subscribers.setter
    def subscribers(self, value: Collection[str]) -> None: ...

class Subscribers_Event(Message):
    """rosapi_msgs/srv/Subscribers_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.Subscribers_Request] = ..., response: Collection[rosapi_msgs.srv.Subscribers_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.Subscribers_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.Subscribers_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.Subscribers_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.Subscribers_Response]) -> None: ...

class Subscribers(Service):
    Request: TypeAlias = Subscribers_Request
    Response: TypeAlias = Subscribers_Response
    Event: TypeAlias = Subscribers_Event

class TopicType_Request(Message):
    """rosapi_msgs/srv/TopicType_Request

    # Returns the type of a topic.

    string topic
    """
    def __init__(self, *, topic: str = ..., check_fields: bool = ...) -> None: ...
    topic: str

class TopicType_Response(Message):
    """rosapi_msgs/srv/TopicType_Response

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class TopicType_Event(Message):
    """rosapi_msgs/srv/TopicType_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.TopicType_Request] = ..., response: Collection[rosapi_msgs.srv.TopicType_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.TopicType_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.TopicType_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.TopicType_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.TopicType_Response]) -> None: ...

class TopicType(Service):
    Request: TypeAlias = TopicType_Request
    Response: TypeAlias = TopicType_Response
    Event: TypeAlias = TopicType_Event

class Topics_Request(Message):
    """rosapi_msgs/srv/Topics_Request

    # Lists the topics with their types.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class Topics_Response(Message):
    """rosapi_msgs/srv/Topics_Response

    string[] topics
    string[] types
    """
    def __init__(self, *, topics: Collection[str] = ..., types: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def topics(self) -> list[str]: ...
    @topics.setter
    def topics(self, value: Collection[str]) -> None: ...
    @property
    def types(self) -> list[str]: ...
    @types.setter
    def types(self, value: Collection[str]) -> None: ...

class Topics_Event(Message):
    """rosapi_msgs/srv/Topics_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.Topics_Request] = ..., response: Collection[rosapi_msgs.srv.Topics_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.Topics_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.Topics_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.Topics_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.Topics_Response]) -> None: ...

class Topics(Service):
    Request: TypeAlias = Topics_Request
    Response: TypeAlias = Topics_Response
    Event: TypeAlias = Topics_Event

class TopicsAndRawTypes_Request(Message):
    """rosapi_msgs/srv/TopicsAndRawTypes_Request

    # Lists the topics with their types and definitions.
    """
    def __init__(self, *, check_fields: bool = ...) -> None: ...

class TopicsAndRawTypes_Response(Message):
    """rosapi_msgs/srv/TopicsAndRawTypes_Response

    string[] topics
    string[] types
    string[] typedefs_full_text
    """
    def __init__(self, *, topics: Collection[str] = ..., types: Collection[str] = ..., typedefs_full_text: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def topics(self) -> list[str]: ...
    @topics.setter
    def topics(self, value: Collection[str]) -> None: ...
    @property
    def types(self) -> list[str]: ...
    @types.setter
    def types(self, value: Collection[str]) -> None: ...
    @property
    def typedefs_full_text(self) -> list[str]: ...
    @typedefs_full_text.setter
    def typedefs_full_text(self, value: Collection[str]) -> None: ...

class TopicsAndRawTypes_Event(Message):
    """rosapi_msgs/srv/TopicsAndRawTypes_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.TopicsAndRawTypes_Request] = ..., response: Collection[rosapi_msgs.srv.TopicsAndRawTypes_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.TopicsAndRawTypes_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.TopicsAndRawTypes_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.TopicsAndRawTypes_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.TopicsAndRawTypes_Response]) -> None: ...

class TopicsAndRawTypes(Service):
    Request: TypeAlias = TopicsAndRawTypes_Request
    Response: TypeAlias = TopicsAndRawTypes_Response
    Event: TypeAlias = TopicsAndRawTypes_Event

class TopicsForType_Request(Message):
    """rosapi_msgs/srv/TopicsForType_Request

    # Lists the topics of a type.

    string type
    """
    def __init__(self, *, type: str = ..., check_fields: bool = ...) -> None: ...
    type: str

class TopicsForType_Response(Message):
    """rosapi_msgs/srv/TopicsForType_Response

    string[] topics
    """
    def __init__(self, *, topics: Collection[str] = ..., check_fields: bool = ...) -> None: ...
    @property
    def topics(self) -> list[str]: ...
    @topics.setter
    def topics(self, value: Collection[str]) -> None: ...

class TopicsForType_Event(Message):
    """rosapi_msgs/srv/TopicsForType_Event"""
    def __init__(self, *, info: service_msgs.msg.ServiceEventInfo = ..., request: Collection[rosapi_msgs.srv.TopicsForType_Request] = ..., response: Collection[rosapi_msgs.srv.TopicsForType_Response] = ..., check_fields: bool = ...) -> None: ...
    info: service_msgs.msg.ServiceEventInfo
    @property
    def request(self) -> list[rosapi_msgs.srv.TopicsForType_Request]: ...
    @request.setter
    def request(self, value: Collection[rosapi_msgs.srv.TopicsForType_Request]) -> None: ...
    @property
    def response(self) -> list[rosapi_msgs.srv.TopicsForType_Response]: ...
    @response.setter
    def response(self, value: Collection[rosapi_msgs.srv.TopicsForType_Response]) -> None: ...

class TopicsForType(Service):
    Request: TypeAlias = TopicsForType_Request
    Response: TypeAlias = TopicsForType_Response
    Event: TypeAlias = TopicsForType_Event
