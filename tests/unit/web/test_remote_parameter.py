from __future__ import annotations

import pytest

from zbot.parameters.errors import ParameterAnswerError
from zbot.parameters.parameter import UnknownParameterTypeError
from zbot.web.remote_parameter import remote_parameters

from rcl_interfaces.msg import ParameterDescriptor, ParameterValue


def test_an_answer_that_does_not_fit_is_refused() -> None:
    names, values, descriptors = ["a"], [ParameterValue()], [ParameterDescriptor()]
    assert len(remote_parameters("/n", names, values, descriptors)) == 1
    with pytest.raises(ParameterAnswerError, match="/n gave a wrong answer"):
        remote_parameters("/n", names, [], descriptors)
    with pytest.raises(ParameterAnswerError):
        remote_parameters("/n", names, values, descriptors * 2)
    with pytest.raises(UnknownParameterTypeError):
        remote_parameters("/n", names, [ParameterValue(type=99)], descriptors)
