"""Sizes as text, as `ros2 bag info` prints them."""

_UNITS = ("B", "KiB", "MiB", "GiB", "TiB")


def size_text(size: int) -> str:
    """Return bytes as text with a unit, e.g. `228.5 KiB`."""
    number, index = float(size), 0
    while number >= 1024 and index < len(_UNITS) - 1:
        number, index = number / 1024, index + 1
    return f"{number:.1f} {_UNITS[index]}" if index else f"{size} B"
