"""What tests assert about processes."""

from zbot.launch.testing.assertion import EXIT_OK as EXIT_OK
from zbot.launch.testing.assertion import EXIT_SIGINT as EXIT_SIGINT
from zbot.launch.testing.assertion import EXIT_SIGKILL as EXIT_SIGKILL
from zbot.launch.testing.assertion import EXIT_SIGQUIT as EXIT_SIGQUIT
from zbot.launch.testing.assertion import EXIT_SIGSEGV as EXIT_SIGSEGV
from zbot.launch.testing.assertion import SequentialTextChecker as SequentialTextChecker
from zbot.launch.testing.assertion import assertExitCodes as assertExitCodes
from zbot.launch.testing.assertion import assertInStderr as assertInStderr
from zbot.launch.testing.assertion import assertInStdout as assertInStdout
from zbot.launch.testing.assertion import assertSequentialStdout as assertSequentialStdout
from zbot.launch.testing.process_lookup import NO_CMD_ARGS as NO_CMD_ARGS
