"""Python's own handlers of log lines."""

from logging.handlers import RotatingFileHandler as RotatingFileHandler
from logging.handlers import TimedRotatingFileHandler as TimedRotatingFileHandler
