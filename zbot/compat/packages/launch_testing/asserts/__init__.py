"""What tests assert about processes."""

from zbot.launch_test.assertion import EXIT_OK as EXIT_OK
from zbot.launch_test.assertion import EXIT_SIGINT as EXIT_SIGINT
from zbot.launch_test.assertion import EXIT_SIGKILL as EXIT_SIGKILL
from zbot.launch_test.assertion import EXIT_SIGQUIT as EXIT_SIGQUIT
from zbot.launch_test.assertion import EXIT_SIGSEGV as EXIT_SIGSEGV
from zbot.launch_test.assertion import SequentialTextChecker as SequentialTextChecker
from zbot.launch_test.assertion import assertExitCodes as assertExitCodes
from zbot.launch_test.assertion import assertInStderr as assertInStderr
from zbot.launch_test.assertion import assertInStdout as assertInStdout
from zbot.launch_test.assertion import assertSequentialStdout as assertSequentialStdout
from zbot.launch_test.process_lookup import NO_CMD_ARGS as NO_CMD_ARGS
