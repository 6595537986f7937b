"""Text of other people and programs. It is read with limits, and is made safe to print."""
