# `make demo` and `make test` need Python 3.11 or newer, make and a C compiler; everything else is installed into .venv.
# PIP_ARGS reaches every pip install, e.g. to choose another index or another build of torch.
PYTHON ?= python3
PIP_ARGS ?=
PROMPT ?= two-bedroom flat
WORKERS ?= auto

BIN := .venv/bin
READY := .venv/.ready
CONSUMERS := build/consumers
TYPED := build/typed
AUDIT := build/audit

.PHONY: demo test acceptance consumers mutants pictures site digests wide weights lint types check docs sbom audit lock clean

demo: $(READY)
	$(BIN)/apartgen make "$(PROMPT)" -o demo/

test: $(READY)
	$(BIN)/python -m pytest -q -n $(WORKERS) --dist loadfile

# Minutes: twenty prompts through every stage and into the simulator, and what one run costs.
acceptance: $(READY)
	$(BIN)/python -m pytest -q -s -m slow tests/test_acceptance.py

# What exports are for reads them: simulators and validators that pip has, some GB, in an environment of their own.
consumers: $(CONSUMERS)/.ready
	$(CONSUMERS)/bin/python -m pytest -q -rs -n $(WORKERS) --dist loadfile tests/export > $(CONSUMERS)/report.txt; \
	status=$$?; cat $(CONSUMERS)/report.txt; exit $$status
	@! grep "could not import" $(CONSUMERS)/report.txt

# Hours: small faults in every stage, each tried against the tests that run it; goes on where it stopped.
mutants: $(READY)
	PYTHONPATH=tests nice $(BIN)/python -m mutants

# What stages give for inputs that stay the same, written anew: for a change that is meant (docs/tests.md).
digests: $(READY)
	rm -f tests/digests/*.json
	APARTGEN_WRITE_GOLDEN=1 $(BIN)/python -m pytest -q -m "not slow" tests/digests

# What `make test` leaves out for time: the other digests, and what is shown over many homes.
wide: $(READY)
	$(BIN)/python -m pytest -q -m "wide and not slow" -n $(WORKERS) --dist loadfile

# Hours: the corpus and the weights of the layout model, as those that are shipped came of the ones before them.
weights: $(READY)
	$(BIN)/python docs/experiments/training/plans.py build/plans
	$(BIN)/apartgen train corpus sampled=build/plans/ --seed 9 -o build/corpus.npz
	$(BIN)/apartgen train layout --corpus build/corpus.npz --start stages/layout/relations/weights.safetensors \
		--steps 2200 --batch 192 --objects 768 --lr 1e-3 --warmup 100 --held 700 --save-every 200

# The pictures of the README and of the example, of this version.
pictures: $(READY)
	$(BIN)/python docs/experiments/pictures.py

# The documents as a folder of pages for any web server, with homes to walk about in: build/site.
site: $(READY)
	$(BIN)/python docs/site/build.py build/site --homes

lint: $(READY)
	$(BIN)/ruff check .

# Modules are checked by the names they are installed under.
types: $(READY)
	rm -rf $(TYPED) && mkdir -p $(TYPED)/apartgen
	ln -s $(CURDIR)/apartgen/* $(CURDIR)/schemas $(CURDIR)/stages $(TYPED)/apartgen/
	ln -s $(CURDIR)/apartgen_cli $(TYPED)/
	MYPYPATH=$(TYPED) $(BIN)/mypy -p apartgen -p apartgen_cli

check: test lint types

# Quotes the program's help in the documents anew.
docs: $(READY)
	-APARTGEN_WRITE_DOCS=1 $(BIN)/python -m pytest -q tests/test_docs.py tests/populate/test_mechanisms.py -k "not part"
	$(BIN)/python -m pytest -q tests/test_docs.py tests/populate/test_mechanisms.py -k "not part"

# What .venv is made of, with versions and licences, as CycloneDX.
sbom: $(READY) $(AUDIT)/.ready
	$(AUDIT)/bin/cyclonedx-py environment $(BIN)/python --pyproject pyproject.toml --output-file build/sbom.json

# Whether faults are known of the pinned versions; asks a public list of faults, and fails where it cannot.
audit: $(AUDIT)/.ready
	$(AUDIT)/bin/pip-audit --strict --progress-spinner off --disable-pip --no-deps -r constraints.txt

$(READY): pyproject.toml setup.py constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(0 if sys.version_info >= (3, 11) else "Python 3.11 or newer is needed: make PYTHON=python3.12 ...")'
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check $(PIP_ARGS) -c constraints.txt -e ".[dev]"
	$(BIN)/python -c "import apartgen.stages.layout.projection; from apartgen.stages import plan; plan.warm()"
	@touch $@

$(CONSUMERS)/.ready: pyproject.toml constraints.txt
	test -x $(CONSUMERS)/bin/python || $(PYTHON) -m venv $(CONSUMERS)
	$(CONSUMERS)/bin/python -m pip install --quiet --disable-pip-version-check $(PIP_ARGS) -c constraints.txt -e ".[dev,consumers]"
	@touch $@

$(AUDIT)/.ready:
	test -x $(AUDIT)/bin/python || $(PYTHON) -m venv $(AUDIT)
	$(AUDIT)/bin/python -m pip install --quiet --disable-pip-version-check $(PIP_ARGS) "cyclonedx-bom>=7,<8" "pip-audit>=2.7,<3"
	@touch $@

# Pins what is installed now, after trying newer versions.
lock: $(READY)
	$(BIN)/python -m pip freeze --exclude-editable | sed 's/+cpu$$//' > constraints.txt

clean:
	rm -rf .venv build demo *.egg-info
