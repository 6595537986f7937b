.PHONY: check mypy pyright docs pictures test bench bags classroom torture chaos soak ends holders churn periods attacks nightly zenoh-faults

# Tests use what only POSIX has. What is shipped is checked for macOS and Windows, too: one checker is
# enough for each, because names that a system lacks are an error of both.
SHIPPED = zbot cli nodes
check:
	ruff format --check . && ruff check . && PYTHONPATH=cli:nodes lint-imports
	$(MAKE) --jobs=2 --output-sync=target mypy pyright

mypy:
	mypy
	mypy --platform darwin --cache-dir .mypy_cache/darwin $(SHIPPED)

pyright:
	pyright
	pyright --pythonplatform Windows $(SHIPPED)

# The site, in build/site. A warning is an error.
docs:
	python -m sphinx -c docs -E -W --keep-going -q . build/site

# The pictures in docs/images, taken from a running system. Needs a Chromium.
pictures:
	python -m docs.generator.pictures

test:
	python -m pytest -n auto

# A million inputs for each reader of foreign bytes or text. `make torture N=1000` is quick.
# LIMIT is in minutes, for each reader. JOBS readers run at the same time.
N = 1000000
LIMIT = inf
JOBS = 1
torture:
	python -m tests.torture -n $(N) --minutes $(LIMIT) --jobs $(JOBS)

# Random faults in a domain of 20 nodes and in a class of 4 laptops, with an observer. Linux, root.
# The seed is printed. `make chaos SEED=5f2a MINUTES=60` makes the same faults again.
SEED =
MINUTES = 60
chaos:
	python -m tests.torture.chaos --minutes $(MINUTES) --seed "$(SEED)"

# A domain under load for a long time: figures of memory, descriptors, losses and delays.
soak: MINUTES = 100
soak:
	python -m tests.torture.soak --minutes $(MINUTES)

# Programs that get a signal at a random moment.
ends: RUNS = 1000
ends:
	python -m tests.torture.random_ends --runs $(RUNS) --seed "$(SEED)"

# Routers that are stopped, stuck, killed and paused. `stuck` needs root.
holders: RUNS = 50
holders:
	python -m tests.torture.meeting_point_holders --runs $(RUNS) --seed "$(SEED)"

# Entities and programs that come and go: memory and times at the begin and at the end.
churn: RUNS = 24000
STARTS = 200000
churn:
	python -m tests.torture.churn --runs $(RUNS) --starts $(STARTS)

# Students of a class who leave while others join. Needs root.
periods: ROUNDS = 20
periods:
	python -m tests.torture.periods --rounds $(ROUNDS) --seed "$(SEED)"

# Clients of `zbot foxglove` and rosbridge, and students, that want too much, beside honest ones.
# Linux, and root for the class.
SECONDS = 600
attacks:
	python -m tests.torture.client_attacks --seconds $(SECONDS)
	python -m tests.torture.class_attacks --seconds $(SECONDS)

# All of these runs in one hour, with a report of one page. Needs root for the class and stuck routers.
nightly:
	python -m tests.torture.nightly --minutes $(MINUTES)

# Which faults of Zenoh are still there (docs/design/zenoh-faults.md).
zenoh-faults:
	python -m tests.torture.zenoh_faults

bench:
	python -m benchmarks

# Recording and playing: losses, kills, full disks and timing.
bags: ARGUMENTS =
bags:
	python -m benchmarks.bags $(ARGUMENTS)

# Thirty laptops in network namespaces; needs Linux, root and iproute2.
classroom:
	python -m benchmarks.classroom --pin --netem-minutes 10 --write
