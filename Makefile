# Turnbuckle. `make` builds and runs everything for the stock machine; `make help` lists the rest.
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
MAKEFLAGS += --no-builtin-rules
# Python keeps what it has compiled: every command starts in two thirds of the time.
unexport PYTHONDONTWRITEBYTECODE

PYTHON ?= python3.11
MACHINE ?= machines/yoon2023.toml

VENV := .venv
TURNBUCKLE := $(VENV)/bin/turnbuckle
# That with most C first, so that no core waits for it at the end.
MACHINES := $(shell ls -S generated/*/tb_tension.c 2>/dev/null | sed 's|generated/\(.*\)/tb_tension.c|machines/\1.toml|')
MACHINES := $(filter $(wildcard machines/*.toml),$(MACHINES)) $(filter-out $(MACHINES),$(sort $(wildcard machines/*.toml)))
NAMES := $(basename $(notdir $(MACHINES)))
TEST_FOLDERS := $(wildcard $(addprefix tests/,unit property equivalence wire closed_loop faults gates fuzz target))

# A stamp's name holds the hash of all that a set-up depends on: when it exists there is nothing to do.
# What only tests need is a set-up of its own, so that a newcomer's first `make` does not wait for it.
stamp = $(VENV)/$(1)-$(shell cat $(2) | sha256sum | cut -c 1-16)
SETUP := $(call stamp,setup,requirements.lock pyproject.toml .ci/packages)
TEST_SETUP := $(call stamp,test_setup,requirements-dev.lock .ci/packages_of_tests)
# Without compiling what is never imported; Python compiles the rest at its first use.
INSTALL := $(VENV)/bin/python -m pip install --quiet --disable-pip-version-check --no-compile
PINNED := --only-binary :all: --require-hashes --requirement

.PHONY: all help setup generate verify build demo deploy rollback flash test soak campaign fuzz mutants figures bench budgets docs format lint lock clean distclean
.PHONY: lint_python lint_c

all: ## set up, generate the stock machines, build and verify them, run the demo (the default)
	@$(MAKE) --no-print-directory generate
	@$(MAKE) --no-print-directory --jobs=2 build
	@$(MAKE) --no-print-directory verify
	@$(MAKE) --no-print-directory demo

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "  make %-10s %s\n", $$1, $$2 }' Makefile

setup: $(TEST_SETUP) ## install what is missing: Debian packages, the pinned Python packages, Turnbuckle itself

$(SETUP):
	.ci/install_packages .ci/packages
	$(PYTHON) -m venv $(VENV)
	$(INSTALL) $(PINNED) requirements.lock
	$(INSTALL) --no-index --no-deps --no-build-isolation --editable .
	rm -f $(VENV)/setup-*
	touch $@

$(TEST_SETUP): $(SETUP)
	.ci/install_packages .ci/packages_of_tests
	$(INSTALL) $(PINNED) requirements-dev.lock
	rm -f $(VENV)/test_setup-*
	touch $@

generate: $(SETUP) ## write the C of every machine in machines/ to generated/
	@printf '%s\n' $(NAMES) | xargs -P 2 -I NAME \
	  $(TURNBUCKLE) generate machines/NAME.toml --out generated/NAME

VERIFIED := $(foreach name,$(NAMES),build/$(name)/double/libturnbuckle.a build/$(name)/float/libturnbuckle.a)
verify: $(SETUP) $(VERIFIED) ## check what was built against the independent reference, function by function; POINTS=100000: at so many
	@printf '%s\n' $(NAMES) | xargs -P 2 -I NAME \
	  $(TURNBUCKLE) verify machines/NAME.toml --in generated/NAME --built build/NAME $(POINTS:%=--points %)

# One library a machine and target; each is compiled again when any of its sources changed.
TARGETS := double float cortex-m4f
CFLAGS := -std=c11 -O2 -ffp-contract=off -fno-math-errno -fno-trapping-math \
  -fno-thread-jumps -fno-tree-vectorize -fno-tree-slp-vectorize -Wall -Wextra -Werror
# For programs and shared libraries alike; `verify` judges these very libraries.
CC_double := gcc $(CFLAGS) -fPIC -fno-semantic-interposition
CC_float := $(CC_double) -DTB_REAL_FLOAT
CC_cortex-m4f := arm-none-eabi-gcc $(CFLAGS) -DTB_REAL_FLOAT \
  -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -fno-move-loop-stores
LIBRARIES := $(foreach name,$(NAMES),$(TARGETS:%=build/$(name)/%/libturnbuckle.a))
# The program that runs a machine with buses on Linux.
PROGRAMS := $(patsubst generated/%/tb_drives.c,build/%/turnbuckle,$(wildcard generated/*/tb_drives.c))

build: $(SETUP) $(LIBRARIES) $(PROGRAMS) ## compile generated and runtime C of every machine: double, float, Cortex-M4F; and its Linux program

# A machine with buses takes the whole runtime but what needs an operating system, the others the step.
STEP := runtime/core/controller.c runtime/core/torque_gate.c
ON_LINUX := $(addprefix runtime/can/,serial_line.c slcan.c slcan_opening.c socketcan.c)
FOLDERS := $(filter-out runtime/port,$(wildcard runtime/*))
RUNTIME := $(filter-out $(ON_LINUX),$(wildcard $(FOLDERS:%=%/*.c)))
runtime_of = $(if $(wildcard generated/$(1)/tb_drives.h),$(RUNTIME),$(STEP))
HEADERS := $(wildcard $(FOLDERS:%=%/*.h))
INCLUDES := $(FOLDERS:%=-I%)

.SECONDEXPANSION:
build/%/libturnbuckle.a: $$(wildcard generated/$$(*D)/*.[ch]) $$(call runtime_of,$$(*D)) $(HEADERS) Makefile
	@echo "build $*"
	@rm -rf $(@D) && mkdir -p $(@D)
	@for file in $(filter %.c,$^); do \
	  $(CC_$(*F)) -Igenerated/$(*D) $(INCLUDES) -c $$file -o $(@D)/$$(basename $$file .c).o; \
	done
	@ar rcs $@ $(@D)/*.o

build/%/turnbuckle: build/%/double/libturnbuckle.a $(ON_LINUX) $(wildcard runtime/port/linux/*.[ch])
	@echo "build $*/turnbuckle"
	@$(CC_double) -Igenerated/$* $(INCLUDES) -Iruntime/port/linux $(filter %.c,$^) $< -o $@

demo: $(SETUP) ## run the controller of MACHINE on the virtual bench
	@$(TURNBUCKLE) demo $(MACHINE)

# HOST: a computer that ssh reaches; OPTIONS: such as --unit.
deploy rollback: $(SETUP) # with HOST
	@$(TURNBUCKLE) $@ $(MACHINE) $(or $(HOST),$(error make $@ HOST=user@computer: HOST is missing)) $(OPTIONS)

deploy: ## build MACHINE's program for the computer HOST and bring it there: docs/deploying.md
rollback: ## switch HOST back to the program before

# IMAGE: what turnbuckle image has written; PROBE: stlink, cmsis-dap, jlink, or a .cfg of OpenOCD.
TARGET ?= stm32g474
PROBE ?= stlink

flash: $(SETUP) ## write MACHINE's image IMAGE into the board TARGET by the probe PROBE: docs/flashing.md
	@$(TURNBUCKLE) flash $(MACHINE) --image=$(or $(IMAGE),$(error make $@ IMAGE=file: IMAGE is missing)) \
	  --board=$(TARGET) --probe=$(PROBE)

# One more than there are cores: some tests wait, for simulated drives or another process.
WORKERS ?= $(shell expr $$(nproc) + 1)

test: lint ## lint, then every test; installs what only they need
	$(VENV)/bin/python -m pytest -n $(WORKERS) --dist worksteal $(TEST_FOLDERS)

soak: $(TEST_SETUP) ## ten simulated minutes of the stock machine twice, the same to the bit; every machine on its worst wires; budgets
	$(VENV)/bin/python -m turnbuckle.lab.soak $(CYCLES:%=--cycles %)
	$(VENV)/bin/python -m pytest tests/wire/every_machine_on_its_wires.py
	$(VENV)/bin/python -m turnbuckle.lab.budgets --check

campaign: $(TEST_SETUP) ## inject every fault at every moment again, and pairs: docs/fault-campaign.md
	rm -rf build/fault_campaign build/fault_campaign.md
	WHOLE_CAMPAIGN=1 $(VENV)/bin/python -m pytest -n 2 tests/faults/test_campaign.py \
	  tests/faults/test_pairs.py tests/faults/test_power_on.py -k "not committed"
	cp build/fault_campaign.md docs/fault-campaign.md

fuzz: $(TEST_SETUP) ## ten minutes of random bytes into everything that parses; SECONDS=60: so long
	FUZZ_SECONDS=$(or $(SECONDS),600) $(VENV)/bin/python -m pytest -n 2 tests/fuzz -k "are_taken"

mutants: $(TEST_SETUP) ## make small defects in the runtime, one at a time, and see the tests notice: docs/mutants.md
	$(VENV)/bin/python -m turnbuckle.lab.mutants $(COUNT:%=--count %)

figures: $(TEST_SETUP) ## draw the papers' figures again: docs/figures.md and docs/figures
	$(VENV)/bin/python -m turnbuckle.lab.figures

bench: $(TEST_SETUP) ## time our C against what one would use instead; writes build/bench.json
	$(VENV)/bin/python -m turnbuckle.lab.benchmark

budgets: $(TEST_SETUP) ## count instructions, flash, RAM and stack on a Cortex-M4F again: docs/budgets, README.md
	$(VENV)/bin/python -m turnbuckle.lab.budgets

# The site's generator has an environment of its own: nothing else needs it.
SITE_VENV := .venv-docs
SITE_SETUP := $(SITE_VENV)/setup-$(shell sha256sum docs/requirements.lock | cut -c 1-16)

$(SITE_SETUP):
	$(PYTHON) -m venv $(SITE_VENV)
	$(SITE_VENV)/bin/python -m pip install --quiet --disable-pip-version-check --only-binary :all: --require-hashes --requirement docs/requirements.lock
	rm -f $(SITE_VENV)/setup-*
	touch $@

docs: $(TEST_SETUP) $(SITE_SETUP) ## the documentation as a site, in build/site: documents, machines with equations, API
	$(VENV)/bin/python -m turnbuckle.lab.pages
	NO_MKDOCS_2_WARNING=1 $(SITE_VENV)/bin/mkdocs build --quiet --config-file build/mkdocs.yml
	@echo "site: build/site/index.html"

format: $(TEST_SETUP) ## give Python and C their layout: ruff, clang-format
	$(VENV)/bin/ruff format .
	.ci/format_c -i

lint: $(TEST_SETUP) ## ruff, mypy --strict, clang-format; every C file through gcc and clang with warnings as errors
	@$(MAKE) --no-print-directory --jobs=2 --output-sync lint_python lint_c

lint_python:
	$(VENV)/bin/ruff check .
	$(VENV)/bin/ruff format --check .
	$(VENV)/bin/mypy

lint_c:
	.ci/format_c --dry-run -Werror
	.ci/lint_c

lock: $(TEST_SETUP) ## pin the packages of pyproject.toml again
	$(PIN) --upgrade --extra sim,bus,design --output-file requirements.lock pyproject.toml
	$(PIN) --upgrade --extra dev --constraint requirements.lock --output-file requirements-dev.lock pyproject.toml
	$(PIN) --upgrade --output-file docs/requirements.lock docs/requirements.in

PIN := $(VENV)/bin/pip-compile --quiet --all-build-deps --allow-unsafe --generate-hashes --strip-extras \
  --no-emit-index-url --no-emit-find-links --no-header --no-annotate

clean: ## remove what was built
	rm -rf build .pytest_cache .mypy_cache .ruff_cache .hypothesis

distclean: clean ## remove the virtual environment too
	rm -rf $(VENV) $(SITE_VENV) turnbuckle.egg-info

