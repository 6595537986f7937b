"""Make a robot description in URDF from a xacro file, with the package xacro of PyPI.

Run:         zbot run xacro xacro robot.urdf.xacro [NAME:=VALUE]... [-o robot.urdf]
In launches: Command(["xacro ", path]), also where no program `xacro` is on the PATH
"""

import sys
import xml.parsers.expat  # noqa: F401 - xacro uses it without importing it

from zbot.errors.installation import pip_install


def main() -> None:
    """Run xacro with the arguments of this program."""
    try:
        import xacro  # noqa: PLC0415 - an extra
    except ModuleNotFoundError as error:
        if error.name != "xacro":
            raise
        sys.exit(f"error: xacro is not installed: {pip_install('zbot[robot]')}")
    xacro.main()


if __name__ == "__main__":
    main()
