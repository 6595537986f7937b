"""Short form of the torture test. `make torture` runs the long form."""

from __future__ import annotations

import ast
import functools
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.torture.fuzzer import failures, input_of, problem_with
from tests.torture.reader import Reader
from tests.torture.readers import EXCEPTIONS, READERS

if TYPE_CHECKING:
    from collections.abc import Iterator

IS_SHORT = "ZBOT_TORTURE_INPUTS" not in os.environ
INPUTS = int(os.environ.get("ZBOT_TORTURE_INPUTS", "50"))
#: Above this number of bytes, an input takes up to a second. `make torture` reads all of them.
LARGE = 8_192
EXAMPLES = max(15, INPUTS // 10)
SEED = os.environ.get("ZBOT_TORTURE_SEED", "zbot")
ROOT = Path(__file__).parents[2]
SOURCES = {"zbot": ROOT, "cli/zbot_cli": ROOT / "cli", "nodes/zbot_nodes": ROOT / "nodes"}
#: Functions that read bytes or text, of any module or object.
FUNCTIONS = frozenset(
    (
        *("loads", "unpackb", "Unpacker", "unpack", "unpack_from", "iter_unpack", "fromstring"),
        *("ParserCreate", "literal_eval", "from_bytes", "fromhex", "b64decode", "read_string"),
        *("read_json", "read_json_object", "read_yaml", "compose_yaml", "construct_yaml"),
        *("frombytes", "frombuffer", "ConfigParser", "safe_load", "parse_qsl", "parse_qs"),
        *(
            "ZipFile",
            "extractfile",
            "urlsplit",
            "load_pem_x509_certificate",
            "load_der_x509_certificate",
            "XMLParser",
        ),
    )
)
#: Modules whose `load`, `parse`, `compose` and `reader` read bytes or text.
PARSERS = frozenset(
    ("ast", "configparser", "csv", "json", "marshal", "msgpack", "pickle", "tomllib", "yaml", "ET")
)
METHODS = frozenset(("load", "parse", "compose", "reader", "DictReader"))
#: Python parses only modules with one of these names, because it needs seconds for all of them.
NAMES = re.compile(rf"\b({'|'.join(sorted(FUNCTIONS | METHODS))})\b")

each_reader = pytest.mark.parametrize("reader", READERS, ids=[reader.name for reader in READERS])


def numbers_of(reader: Reader) -> Iterator[int]:
    """Yield the numbers of inputs. The short form has one large input beside the seeds."""
    was_large = False
    for number in range(INPUTS):
        is_large = number >= len(reader.seeds) and len(input_of(reader, SEED, number)) > LARGE
        if not (is_large and was_large and IS_SHORT):
            yield number
        was_large = was_large or is_large


@each_reader
def test_mutated_inputs_are_read_or_refused(reader: Reader) -> None:
    assert [str(failure) for failure in failures(reader, SEED, numbers_of(reader))] == []


@each_reader
@given(data=st.binary(max_size=500) | st.text(max_size=300).map(lambda text: text.encode()))
@settings(
    max_examples=EXAMPLES,
    suppress_health_check=(HealthCheck.too_slow, HealthCheck.data_too_large),
    deadline=None,
)
def test_any_input_is_read_or_refused(reader: Reader, data: bytes) -> None:
    assert problem_with(reader, data) == ""


def test_each_seed_makes_the_same_inputs() -> None:
    for number in (0, 5, 77, 1000):
        assert input_of(READERS[0], "a", number) == input_of(READERS[0], "a", number)
    assert input_of(READERS[0], "a", 77) != input_of(READERS[0], "b", 77)


def test_a_reader_with_a_defect_is_found() -> None:
    def defect(data: bytes) -> None:
        if b"[[" in data:
            raise KeyError(data)

    reader = Reader("defect", (), defect, (ValueError,), (b"[a]",))
    found = list(failures(reader, "a", range(300)))
    assert found
    assert "KeyError" in found[0].problem
    assert f"--reader defect --seed a --input {found[0].number}" in str(found[0])


# -- no reader is missing ------------------------------------------------------------------------


def parsers_in(source: str) -> set[str]:
    """Return the calls of a module that read bytes or text."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            function = node.func
            name = getattr(function, "attr", getattr(function, "id", ""))
            owner = getattr(getattr(function, "value", None), "id", "")
            if name in FUNCTIONS or (owner in PARSERS and name in METHODS):
                found.add(f"{owner}.{name}")
    return found


@functools.cache
def modules_with_parsers() -> dict[str, set[str]]:
    found = {}
    for folder, start in SOURCES.items():
        for path in sorted((ROOT / folder).rglob("*.py")):
            source = path.read_text(encoding="utf-8")
            calls = parsers_in(source) if NAMES.search(source) else set()
            if calls:
                parts = path.relative_to(start).with_suffix("").parts
                found[".".join(parts).removesuffix(".__init__")] = calls
    return found


def test_every_module_that_reads_foreign_bytes_has_a_reader() -> None:
    listed = {module for reader in READERS for module in reader.modules}
    missing = {
        module: calls
        for module, calls in modules_with_parsers().items()
        if module not in listed and module not in EXCEPTIONS
    }
    assert missing == {}, "add a Reader to tests/torture, or a reason to EXCEPTIONS"


def test_the_lists_name_only_modules_that_exist() -> None:
    known = set(modules_with_parsers())
    assert set(EXCEPTIONS) <= known
    listed = {module for reader in READERS for module in reader.modules}
    for module in listed:
        path = module.replace(".", "/")
        assert any((start / f"{path}.py").is_file() for start in SOURCES.values()), module


def test_a_new_reader_is_noticed() -> None:
    assert parsers_in("import json\nx = json.loads(y)") == {"json.loads"}
    assert parsers_in("import yaml\nx = yaml.load(y, Loader=z)") == {"yaml.load"}
    assert parsers_in("from struct import unpack\nunpack('f', y)") == {".unpack"}
    assert parsers_in("tree = ET.parse(y)") == {"ET.parse"}
    assert parsers_in("json.dumps(5)\nparse(6)\npath.load()") == set()


def test_a_process_runs_the_inputs_of_a_reader() -> None:
    from tests.torture.worker import run  # noqa: PLC0415 - only for this test

    reader = next(each for each in READERS if each.name == "attachment")
    assert run(reader, SEED, 20) == ([], 20)


def test_a_run_ends_when_its_time_is_over() -> None:
    from tests.torture.worker import run  # noqa: PLC0415 - only for this test

    reader = next(each for each in READERS if each.name == "attachment")
    failures_, inputs = run(reader, SEED, 10**9, 0.01)
    assert failures_ == []
    assert inputs < 10**9
