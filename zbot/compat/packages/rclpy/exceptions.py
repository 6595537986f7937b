"""rclpy's names of zbot's errors."""

from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.errors import InvalidNameError as NameValidationException
from zbot.errors import InvalidNamespaceError as InvalidNamespaceException
from zbot.errors import InvalidNodeNameError as InvalidNodeNameException
from zbot.errors import InvalidServiceNameError as InvalidServiceNameException
from zbot.errors import InvalidTopicNameError as InvalidTopicNameException
from zbot.errors import NotInitializedError as NotInitializedException
from zbot.executor.errors import RateInterruptedError as ROSInterruptException
from zbot.executor.errors import TimerCancelledError as TimerCancelledError
from zbot.interfaces.errors import NotAMessageTypeError as NoTypeSupportImportedException
from zbot.parameters.errors import InvalidParameterException as InvalidParameterException
from zbot.parameters.errors import InvalidParameterTypeException as InvalidParameterTypeException
from zbot.parameters.errors import InvalidParameterValueException as InvalidParameterValueException
from zbot.parameters.errors import (
    ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException,
)
from zbot.parameters.errors import ParameterException as ParameterException
from zbot.parameters.errors import ParameterImmutableException as ParameterImmutableException
from zbot.parameters.errors import ParameterNotDeclaredException as ParameterNotDeclaredException
from zbot.parameters.errors import (
    ParameterUninitializedException as ParameterUninitializedException,
)
