# Written by python -m zbot.compat.generator; do not edit.
"""zbot's errors under rclpy's names."""

from zbot.errors import (
    InvalidHandleError as InvalidHandle,
    InvalidNameError as NameValidationException,
    InvalidNamespaceError as InvalidNamespaceException,
    InvalidNodeNameError as InvalidNodeNameException,
    InvalidServiceNameError as InvalidServiceNameException,
    InvalidTopicNameError as InvalidTopicNameException,
    NotInitializedError as NotInitializedException,
)
from zbot.executor.errors import RateInterruptedError as ROSInterruptException, TimerCancelledError
from zbot.interfaces.errors import NotAMessageTypeError as NoTypeSupportImportedException
from zbot.parameters.errors import (
    InvalidParameterException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from zbot.parameters.parameter import InvalidParameterTypeException

__all__ = [
    "InvalidHandle",
    "InvalidNamespaceException",
    "InvalidNodeNameException",
    "InvalidParameterException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "NameValidationException",
    "NoTypeSupportImportedException",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterException",
    "ParameterImmutableException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
    "ROSInterruptException",
    "TimerCancelledError",
]
