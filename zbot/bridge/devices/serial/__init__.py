"""Boards on a serial port: the lines that a board prints are topics, and topics are lines.

`port.py` finds and opens ports, `line_buffer.py` and `line.py` read lines, and `board.py` is the
loop.
"""

from __future__ import annotations
