.PHONY: check test bench classroom

check:
	ruff format --check . && ruff check . && mypy && pyright && PYTHONPATH=cli:nodes lint-imports

test:
	python -m pytest -n auto

bench:
	python -m benchmarks

# Thirty laptops in network namespaces; needs Linux, root and iproute2.
classroom:
	python -m benchmarks.classroom --pin --netem-minutes 10 --write
