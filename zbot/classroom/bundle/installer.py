"""Install zbot from this folder. It needs Python, and no internet.

`install.sh`, `install.ps1` and `install.cmd` run this program. It makes an environment for Python,
checks each file, installs zbot, and says what to type then.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import platform
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
WHEELS = FOLDER / "wheels"
WINDOWS = os.name == "nt"


def main() -> int:
    """Install zbot, and return the exit code."""
    parser = argparse.ArgumentParser(description="Install zbot from this folder.")
    parser.add_argument("--to", type=Path, default=Path.home() / "zbot-env", metavar="FOLDER")
    to = parser.parse_args().to.absolute()
    try:
        bundle = json.loads((FOLDER / "bundle.json").read_text(encoding="utf-8"))
        target = this_target()
        if target not in bundle["targets"]:
            return other_python(bundle["targets"], target)
        install(bundle, bundle["targets"][target], to)
    except (OSError, ValueError, KeyError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except subprocess.CalledProcessError:
        print("error: pip did not install zbot: see above", file=sys.stderr)
        return 1
    print_end(to)
    return 0


def this_target() -> str:
    """Return the name of this system, processor and Python, e.g. `linux-x86_64-3.13`."""
    system = {"win32": "windows", "darwin": "macos"}.get(sys.platform, sys.platform)
    processor = sysconfig.get_platform().rpartition("-")[2]
    if system == "macos":  # one Python may run on both processors
        processor = platform.machine()
    processor = {"amd64": "x86_64"}.get(processor, processor)
    return f"{system}-{processor}-{sys.version_info[0]}.{sys.version_info[1]}"


def other_python(targets: dict[str, Any], target: str) -> int:
    """Run this program with another Python of this machine that the bundle is for."""
    machine = target.rpartition("-")[0]
    versions = [name.rpartition("-")[2] for name in targets if name.rpartition("-")[0] == machine]
    for version in sorted(versions, key=lambda text: int(text.partition(".")[2]), reverse=True):
        command = ["py", f"-{version}"] if WINDOWS else [f"python{version}"]
        if shutil.which(command[0]) and answers(command):
            print(f"This Python is not in the bundle; Python {version} of this machine is used")
            return subprocess.run([*command, __file__, *sys.argv[1:]], check=False).returncode
    known = ", ".join(versions) or "no Python"
    print(f"error: this Python is {target}; the bundle has {known} for {machine}", file=sys.stderr)
    return 1


def answers(command: list[str]) -> bool:
    """Return whether a command starts a Python."""
    return subprocess.run([*command, "--version"], capture_output=True, check=False).returncode == 0


def install(bundle: dict[str, Any], target: dict[str, Any], to: Path) -> None:
    """Check the files of a target, make the environment, and install into it."""
    names = [f"wheels/{name}" for name in target["wheels"]]
    print(f"1. Check {len(names)} files of this folder")
    digests = {name: bundle["files"][name] for name in names}
    for name, digest in digests.items():
        check(FOLDER / name, digest)
    print(f"2. Make an environment for Python in {to}")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(to)], check=True)
    python = to / ("Scripts/python.exe" if WINDOWS else "bin/python")
    extras = f"[{','.join(target['extras'])}]" if target["extras"] else ""
    print(f"3. Install zbot{extras} {bundle['zbot']}")
    with tempfile.TemporaryDirectory() as folder:
        requirements = Path(folder) / "requirements.txt"
        requirements.write_text(requirement_lines(digests), encoding="utf-8")
        pip(python, ["-r", str(requirements)], digests)


def check(path: Path, digest: str) -> None:
    """Raise an error that names a file with other bytes."""
    if not path.is_file():
        raise ValueError(f"{path} is missing: copy the whole folder again")
    if hashlib.sha256(path.read_bytes()).hexdigest() != digest:
        raise ValueError(f"{path} is damaged, its SHA-256 is another one: copy the folder again")


def requirement_lines(digests: dict[str, str]) -> str:
    """Return a requirement with its hash for each wheel."""
    lines = []
    for name, digest in digests.items():
        package, version = name.rpartition("/")[2].split("-")[:2]
        lines.append(f"{package}=={version} --hash=sha256:{digest}\n")
    return "".join(lines)


def pip(python: Path, words: list[str], digests: dict[str, str]) -> None:
    """Run the pip of the bundle in the environment. No settings of the user change what it does."""
    wheel = next(name for name in digests if name.startswith("wheels/pip-"))
    command = [str(python), "-m", "pip", "--isolated", "--disable-pip-version-check", "install"]
    command += ["--quiet", "--no-index", "--find-links", str(WHEELS), "--require-hashes", *words]
    kept = {name: value for name, value in os.environ.items() if not name.startswith("PIP_")}
    variables = {**kept, "PYTHONPATH": str(FOLDER / wheel), "PIP_CONFIG_FILE": os.devnull}
    subprocess.run(command, env=variables, check=True)


def print_end(to: Path) -> None:
    """Say what to type."""
    print("\nzbot is installed. Type this in each new terminal:\n")
    if WINDOWS:
        print(f"    {to}\\Scripts\\Activate.ps1       (in PowerShell)")
        print(f"    {to}\\Scripts\\activate.bat       (in cmd)\n")
    else:
        print(f"    . {to}/bin/activate\n")
    print("Then type:\n\n    zbot doctor\n")
    print("If `zbot` is refused or not found, type `python -m zbot` in its place.")


if __name__ == "__main__":
    sys.exit(main())
