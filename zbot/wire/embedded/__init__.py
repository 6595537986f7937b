"""Source code for microcontrollers: messages in C and in MicroPython, and keys for zenoh-pico."""
