# SPDX-License-Identifier: GPL-3.0-or-later
# Thin: the build itself is CMake's (see CMakePresets.json). `make help` lists the goals.

SHELL := /bin/bash
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
CASE ?= cases/sphere.toml
OUT ?= runs/$(basename $(notdir $(CASE)))
PYTHON ?= $(firstword $(wildcard /usr/bin/python3) python3)
COMMAND := build/release/bin/corticle

MAKEFLAGS += --no-print-directory

.NOTPARALLEL:
.PHONY: fold command mpi test build install package python docs dev asan tsan validate validate-thesis bench format format-check lint setup setup-tests setup-dev setup-python clean help
.DEFAULT_GOAL := help

help: ## list the goals
	@sed -nE 's/^([a-z-]+):.*## (.*)/  \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t 18

fold: command ## set up, build the command, fold the sphere (or CASE=…, OUT=…); says where the pictures are
	@$(PYTHON) scripts/fold.py --command $(COMMAND) --case $(CASE) --out $(OUT)

test: setup-tests build ## set up, build, run all tests, those of the Python package too
	ctest --preset release --parallel $(JOBS)
	@scripts/python.sh --test --if-possible

command: setup build/release/.configured ## set up and build the command alone
	cmake --build --preset release --parallel $(JOBS) --target corticle_command

build: setup build/release/.configured ## set up and build the optimised version, tests and benchmarks
	cmake --build --preset release --parallel $(JOBS)

install: command ## install the program and its C++ library (PREFIX=/usr/local): docs/guide/installing.md
	cmake --install build/release --prefix $(PREFIX) --component program
	cmake --install build/release --prefix $(PREFIX) --component development

package: setup-python command ## make Debian packages of the program and the Python package, in build/release
	cmake --preset release -D CORTICLE_PYTHON_MODULE=ON -D Python_EXECUTABLE=/usr/bin/python3
	cmake --build --preset release --parallel $(JOBS) --target corticle_python
	cd build/release && cpack

mpi: setup-mpi build/mpi/.configured ## build the command for runs by many processes (docs/guide/clusters.md)
	cmake --build --preset mpi --parallel $(JOBS) --target corticle_command

python: setup-python command ## build the Python package, install it into build/venv, run its tests
	@scripts/python.sh --test

docs: python ## write all pages as a site to build/site, the reference of the Python package with them
	/usr/bin/python3 -m sphinx -W -q -b html -c docs/site . build/site
	build/venv/bin/python -m sphinx -W -q -b html docs/api build/site/api

dev: setup-tests build/dev/.configured ## build and test with assertions, warnings as errors
	cmake --build --preset dev --parallel $(JOBS)
	ctest --preset dev --parallel $(JOBS)

asan: setup-tests build/asan/.configured ## build and test with the address and undefined sanitizers
	cmake --build --preset asan --parallel $(JOBS)
	ctest --preset asan --parallel $(JOBS)

tsan: setup-dev build/tsan/.configured ## build and test with clang's thread sanitizer
	cmake --build --preset tsan --parallel $(JOBS)
	ctest --preset tsan --parallel $(JOBS)

validate: build ## compare with theory and published numbers (validation/*/run.py or run.sh)
	@$(PYTHON) scripts/validate.py --command $(COMMAND)

validate-thesis: build ## make the ablation and the sweeps of cases/thesis; results go to validation/thesis
	@$(PYTHON) validation/thesis/ablation/run.py --command $(COMMAND)
	@$(PYTHON) scripts/validate_thesis.py --command $(COMMAND)

bench: build ## run the benchmarks: a table (docs/performance.md), JSON in build/release/benchmarks
	cmake --build --preset release --parallel $(JOBS) --target bench

format: setup ## rewrite the sources in the project's format
	$(PYTHON) tests/project/check_format.py --fix

format-check: setup ## check the format
	$(PYTHON) tests/project/check_format.py

lint: setup-dev build/dev/.configured ## clang-tidy over all sources
	@$(PYTHON) scripts/lint.py --build build/dev --jobs 2

setup: ## install the Debian packages that are missing
	@scripts/setup.sh

setup-tests:
	@scripts/setup.sh --tests

setup-dev:
	@scripts/setup.sh --dev

setup-mpi:
	@scripts/setup.sh --mpi

setup-python:
	@scripts/setup.sh --python

clean: ## delete what was built (runs/ is kept)
	rm -rf build

# CMake looks after later changes to the CMakeLists itself; the stamp is left only by a configure that went well.
build/%/.configured: CMakePresets.json
	cmake --preset $*
	@touch $@
