"""Type checkers and editors find ROS 2's names, and report wrong ones."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PROGRAMS = ROOT / "tests" / "programs" / "ros2_names"


def test_pyright_reports_the_wrong_names_and_no_others(tmp_path: Path) -> None:
    pytest.importorskip("pyright")
    for program in PROGRAMS.glob("*.py"):
        shutil.copy(program, tmp_path)
    folders = (ROOT, ROOT / "zbot" / "compat" / "stubs", ROOT / "zbot" / "compat" / "packages")
    config = {"include": ["."], "extraPaths": [str(folder) for folder in folders]}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(config))
    command = (sys.executable, "-m", "pyright", "--project", str(tmp_path), "--outputjson")
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    found = {
        (Path(problem["file"]).name, problem["range"]["start"]["line"])
        for problem in json.loads(result.stdout)["generalDiagnostics"]
        if problem["severity"] == "error"
    }
    lines = (PROGRAMS / "wrong.py").read_text(encoding="utf-8").split("\n")
    wrong = {("wrong.py", at) for at, line in enumerate(lines) if line.endswith("# wrong")}
    assert found == wrong
