"""Functions that read definitions."""

from zbot.compat.rosidl.definition_text import (
    PRIMITIVE_TYPES,
    ActionSpecification,
    BaseType,
    Constant,
    Field,
    InvalidActionSpecification,
    InvalidFieldDefinition,
    InvalidResourceName,
    InvalidServiceSpecification,
    InvalidSpecification,
    InvalidValue,
    MessageSpecification,
    ServiceSpecification,
    Type,
    UnknownMessageType,
    parse_action_file,
    parse_action_string,
    parse_message_file,
    parse_message_string,
    parse_service_file,
    parse_service_string,
    parse_value_string,
    validate_field_types,
)

ACTION_REQUEST_RESPONSE_SEPARATOR = SERVICE_REQUEST_RESPONSE_SEPARATOR = "---"
ARRAY_UPPER_BOUND_TOKEN = STRING_UPPER_BOUND_TOKEN = "<="  # noqa: S105 - no password
COMMENT_DELIMITER, CONSTANT_SEPARATOR, PACKAGE_NAME_MESSAGE_TYPE_SEPARATOR = "#", "=", "/"
SERVICE_EVENT_MESSAGE_SUFFIX = "_Event"
SERVICE_REQUEST_MESSAGE_SUFFIX, SERVICE_RESPONSE_MESSAGE_SUFFIX = "_Request", "_Response"
ACTION_GOAL_SUFFIX, ACTION_RESULT_SUFFIX, ACTION_FEEDBACK_SUFFIX = "_Goal", "_Result", "_Feedback"
parse_primitive_value_string = parse_value_string
