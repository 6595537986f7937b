"""Futures and tasks."""

from zbot.task import Future as Future
from zbot.task import FutureState as FutureState
from zbot.task import Task as Task
