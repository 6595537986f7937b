"""Story of a page: its files are written and its commands are run, from top to bottom."""

from __future__ import annotations

import re
import shlex
import signal
import time
from pathlib import Path
from typing import TYPE_CHECKING

from tests.conftest import allowed
from tests.docs.expected_output import ExpectedOutput
from tests.docs.page import Block, Command, Note, commands, parts
from tests.docs.shell import Shell

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

#: Commands that change nothing are repeated until other programs have done their work.
_READS = re.compile(r"(zbot|ros2) (node|topic|service|param|action|lifecycle|graph|class|status)\b")
_ACTS = re.compile(r" (pub|call|set|send_goal|load|delete|kill|start|stop|say)\b")
#: Languages of blocks that are neither files nor commands that run here.
_NOT_RUN = {"text", "c", "powershell", "bat", "sh", "json5"}
_KEYS = {"up": b"\x1b[A", "down": b"\x1b[B", "left": b"\x1b[D", "right": b"\x1b[C"}
#: The next command of the shell finds its folder, its variables and its functions.
_SAVE = '\ncode=$?\n{{ echo "cd $(printf %q "$PWD")"; export -p; declare -f; }} >{}\nexit $code'
#: Exit codes of programs that Ctrl-C ends: Python's, a shell's, a signal's.
_INTERRUPTED = {0, 130, -signal.SIGINT}


class Story:
    """Run of one page in a folder and a domain of its own.

    Args:
        page: The Markdown file.
        folder: Empty folder, which is the reader's home.
        environment: Returns the variables of a machine by its name. The machine of a prompt without
            a name is `""`.
        translate: Returns a text of the page with what is different in this test, e.g. addresses.
    """

    def __init__(
        self,
        page: Path,
        folder: Path,
        environment: Callable[[str], dict[str, str]],
        translate: Callable[[str], str] = str,
    ) -> None:
        self.page = page
        self.folder = folder
        self.environment = environment
        self.translate = translate
        self.running: dict[str, Shell] = {}
        self.fails = False
        self.seen: list[tuple[str, str]] = []  #: command lines and their outputs
        self.notebook: list[str] | None = None  #: cells, which are run as one program at the end
        self.where = page.name

    def tell(self) -> None:
        """Do everything that the page says."""
        try:
            for part in parts(self.page):
                self.where = f"{self.page.name}:{part.line}"
                if isinstance(part, Note):
                    self.obey(part.text)
                else:
                    self.do(part)
            if self.notebook:
                self.run_program("\n".join(self.notebook))
            for line, shell in self.running.items():
                assert shell.process.poll() in {None, 0}, f"{line}\n{shell.output}"
                assert "Traceback" not in shell.output, shell.output
        finally:
            self.end()

    def end(self) -> None:
        """End all programs."""
        for shell in self.running.values():
            shell.send(signal.SIGINT)
        for shell in self.running.values():
            shell.close()

    def obey(self, note: str) -> None:
        """Do what a comment of the page says."""
        verb, _, rest = note.partition(" ")
        if verb == "fails":
            self.fails = True
        elif verb == "notebook":
            self.notebook = []
        elif verb == "stop":
            shell = self.running.pop(rest)
            shell.send(signal.SIGINT)
            assert shell.wait() in _INTERRUPTED, shell.output
            shell.close()
        elif verb == "press":
            key, _, line = rest.partition(" in ")
            self.running[line].press(_KEYS.get(key, key.encode()))
        elif verb == "see":
            line, _, text = rest.partition(": ")
            shell = self.running[line]
            assert shell.wait_for(lambda output: text in output), f"{self.where}\n{shell.output}"
        else:
            raise ValueError(f"{self.where}: unknown comment {note!r}")

    def do(self, block: Block) -> None:
        """Write the block's file, or run its commands or its program."""
        if block.change:
            self.replace(*block.change, block.text)
        elif block.file:
            path = self.path(block.file)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text, encoding="utf-8")
        elif block.language == "console":
            for command in commands(block):
                self.run(command)
        elif block.language == "python" and self.notebook is not None:
            self.notebook.append(block.text)
        elif block.language == "python":
            self.run_program(block.text)
        else:
            is_known = block.language in _NOT_RUN or block.language.startswith("{")
            assert is_known, f"{self.where}: this block is no file, and no commands"

    def run_program(self, text: str) -> None:
        """Run a Python program that has no file on the page."""
        (self.folder / "block.py").write_text(text, encoding="utf-8")
        shell = self.start(Command("", "python ~/block.py", ()))
        assert shell.wait() == 0, f"{self.where}\n{shell.output}"
        shell.close()

    def replace(self, old: str, name: str, new: str) -> None:
        """Replace a text of a file."""
        path = self.path(name)
        text = path.read_text(encoding="utf-8")
        assert text.count(old) == 1, f"{self.where}: {old!r} is {text.count(old)} times in {name}"
        path.write_text(text.replace(old, new.strip()), encoding="utf-8")

    def path(self, name: str) -> Path:
        """Return the path of a file that the page names."""
        if name.startswith("~/"):
            return self.folder / name[2:]
        state = self.state("")
        if not state.exists():
            return self.folder / name
        first = state.read_text(encoding="utf-8").partition("\n")[0]
        return Path(shlex.split(first)[1]) / name

    def state(self, machine: str) -> Path:
        """Return the file with the state of a machine's shell."""
        return self.folder.parent / f"{self.folder.name}-{machine}.sh"

    def start(self, command: Command) -> Shell:
        """Start a command in the state that the former commands left behind."""
        state = self.state(command.machine)
        before = f". {shlex.quote(str(state))} 2>/dev/null\n" if state.exists() else ""
        after = "" if command.is_endless else _SAVE.format(shlex.quote(str(state)))
        environment = {**self.environment(command.machine), "HOME": str(self.folder)}
        line = self.translate(command.line)
        return Shell(before + line + after, self.folder, environment)

    def expected(self, output: Sequence[str]) -> list[str]:
        """Return the lines of an output as they are in this test."""
        # A machine may show any of its addresses. The port of a test is in no code.
        lines = [line.replace("    (if the code does not work)", "") for line in output]
        return [self.translate(line).replace("127.0.0.1", "...") for line in lines]

    def run(self, command: Command) -> None:
        """Run a command, and compare its output with that of the page."""
        if command.is_endless:
            self.run_endless(command)
            return
        deadline = time.monotonic() + min(allowed(15), 60)
        while True:
            begun = time.monotonic()
            shell = self.start(command)
            wanted = ExpectedOutput(self.expected(command.output))
            code = shell.wait()
            shell.close()
            self.seen.append((command.line, shell.output))
            is_right = wanted.matches(shell.output) and (code != 0) == self.fails
            repeats = _READS.match(command.line) and not _ACTS.search(command.line)
            now = time.monotonic()
            if is_right or not repeats or now > deadline:
                break
            time.sleep(min(now - begun, 0.5))  # for the programs that the command looks at
        self.fails = False
        assert is_right, self.difference(command, shell, code)
        assert "Traceback" not in shell.output, shell.output

    def run_endless(self, command: Command) -> None:
        """Start a command, and wait until its output is that of the page."""
        shell = self.start(command)
        if command.line in self.running:  # the page starts it again, and `end` must end both
            self.running[f"{command.line} ({len(self.running)})"] = self.running[command.line]
        self.running[command.line] = shell
        shown = self.expected(command.output[:-1])
        while shown[-1:] == ["..."]:
            shown.pop()
        wanted = ExpectedOutput(shown, is_endless=True)
        assert shell.wait_for(wanted.matches), self.difference(command, shell, shell.process.poll())
        self.seen.append((command.line, shell.output))
        if command.is_interrupted:
            self.obey(f"stop {command.line}")

    def difference(self, command: Command, shell: Shell, code: int | None) -> str:
        """Return a text with what the page says and what was seen."""
        expected = "\n".join(command.output)
        return (
            f"{self.where}: {command.line}\n--- the page says\n{expected}\n"
            f"--- exit code {code}, and output\n{shell.output}"
        )
