.PHONY: check test bench

check:
	ruff format --check . && ruff check . && mypy && pyright && PYTHONPATH=cli:nodes lint-imports

test:
	python -m pytest -n auto

bench:
	python -m benchmarks
