# Needs Python >= 3.11 and make; everything else comes from pinned versions into .venv.
# `make reproduce` and `make test` each start from a bare clone. PYTHON=... chooses the interpreter.

.DEFAULT_GOAL := help
.NOTPARALLEL:
.DELETE_ON_ERROR:
.PHONY: help reproduce test lint types format look bench bench-labels oracles verified lock clean

VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check install --quiet
PYTHONS := $(or $(PYTHON),python3.13 python3.12 python3.14 python3.11 python3.15 python3 python)
SUITABLE := import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))

# The wheel brings pyright and node: nothing is fetched, and no newer version is asked for.
export PYRIGHT_PYTHON_IGNORE_WARNINGS := 1
export PYRIGHT_PYTHON_GLOBAL_NODE := 0

# A shell may forbid Python to write bytecode; then each of the hundreds of processes that tests start would compile
# the package anew, and each worker every test.
export PYTHONDONTWRITEBYTECODE :=

help:
	@echo "make reproduce  environment, then the whole study; says where the report is"
	@echo "make test       environment, then format, lint, types, layers and every test with coverage"
	@echo "make lint | types | format    one of these alone"
	@echo "make bench      gearlash and other solvers on the same work; renews docs/benchmarks.md (a quiet machine, please)"
	@echo "make bench-labels  2,000 labels against brute force; renews docs/benchmark-labels.md"
	@echo "make oracles    what AUTO-07p finds on smoothed systems, kept for the tests (needs auto-07p and gfortran)"
	@echo "make verified   the article's pair with real teeth, kept for its report (minutes)"
	@echo "make look       pages and figures of the report as numbered PNGs (needs a Chromium)"
	@echo "make lock       pin the newest versions (needs uv)"
	@echo "make clean      remove .venv and everything made"

# A name on the path may be a shim that fails when called, so each one is tried, not just looked up.
$(BIN)/python:
	@for python in $(PYTHONS); do \
		if "$$python" -c '$(SUITABLE)' >/dev/null 2>&1; then \
			echo "Making $(VENV) with $$("$$python" --version) ($$python)"; \
			exec "$$python" -m venv --clear $(VENV); \
		fi; \
	done; \
	echo "gearlash needs Python 3.11 or newer with the modules venv and ensurepip; none of these is one:" >&2; \
	echo "    $(PYTHONS)" >&2; \
	echo "Install one (Debian and Ubuntu: also python3-venv) or name it: make PYTHON=/path/to/python3" >&2; \
	exit 1

$(VENV)/.run: requirements/run.txt pyproject.toml | $(BIN)/python
	$(PIP) --requirement requirements/run.txt
	$(PIP) --no-deps --no-build-isolation --editable .
	$(BIN)/python -m compileall -q src
	@touch $@

$(VENV)/.dev: requirements/dev.txt $(VENV)/.run
	$(PIP) --requirement requirements/dev.txt
	@touch $@

reproduce: $(VENV)/.run
	$(BIN)/gearlash reproduce --out reproduce

# Only these are collected for the run without compiled kernels, not all tests.
WITHOUT_JIT = $$(grep -rl --include='test_*.py' jit_and_nojit tests)

test: lint types
	rm -f .coverage .coverage.*
	NUMBA_DISABLE_JIT=1 $(BIN)/python -m pytest -n 0 -m jit_and_nojit --cov --cov-report= --cov-fail-under=0 $(WITHOUT_JIT)
	$(BIN)/python -m pytest --cov --cov-append --cov-report=term --durations=40 --durations-min=2

lint: $(VENV)/.dev
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/lint-imports

types: $(VENV)/.dev
	$(BIN)/pyright --pythonpath $(BIN)/python

format: $(VENV)/.dev
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

look: $(VENV)/.dev
	test -d reproduce || $(MAKE) reproduce
	$(BIN)/python -m tools.look

bench: $(VENV)/.dev
	$(BIN)/python -m benchmarks docs

bench-labels: $(VENV)/.dev
	$(BIN)/python -m benchmarks.labels 2000 docs/benchmark-labels.md

oracles: $(VENV)/.dev
	cd tests && ../$(BIN)/python -m oracles.auto

LOCK := uv pip compile --quiet --upgrade --universal --python-version 3.11 --no-emit-index-url \
	--annotation-style line --custom-compile-command "make lock" pyproject.toml requirements/build.in

verified: $(VENV)/.dev
	$(BIN)/python -m tools.verified

lock:
	$(LOCK) --output-file requirements/run.txt
	$(LOCK) --extra dev --constraint requirements/run.txt --output-file requirements/dev.txt

clean:
	rm -rf $(VENV) reproduce look bench .coverage .coverage.* .hypothesis .pytest_cache .ruff_cache .import_linter_cache
