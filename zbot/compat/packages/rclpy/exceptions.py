"""zbot's errors under rclpy's names."""

from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.errors import InvalidNameError as NameValidationException
from zbot.errors import InvalidNamespaceError as InvalidNamespaceException
from zbot.errors import InvalidNodeNameError as InvalidNodeNameException
from zbot.errors import InvalidServiceNameError as InvalidServiceNameException
from zbot.errors import InvalidTopicNameError as InvalidTopicNameException
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.executor.errors import RateInterruptedError as ROSInterruptException
from zbot.executor.errors import TimerCancelledError
from zbot.interfaces.errors import NotAMessageTypeError as NoTypeSupportImportedException
from zbot.parameters.errors import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
