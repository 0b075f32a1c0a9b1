# SPDX-License-Identifier: Apache-2.0
# The tests.  Part 1 of this file says how test programs are built, and has the targets of long campaigns; part 2 is the table of
# the tests, one row each.  tests/README.md describes the folders.
#
# make quick            the part `quick`: the loop of a developer
# make check            all parts, one after another: quick, thorough, targets
# make check-thorough   the part `thorough`: everything else that needs cc and make only
# make check-targets    the part `targets`: other compilers, emulated boards, sizes
# make check-NAME       the test of one row
# make list-tests       every row: its part in brackets before the first, then NAME: COMMAND
# make list-files       every module of the product with its purpose

PARTS = quick thorough targets

# $(call test,NAME,PART,NEEDS,COMMAND): a row of the table.
#   NAME     unique; a + before it says that the command calls make for files of B, which only one may do at a time
#   NEEDS    files that are built first, besides smc
#   COMMAND  run by sh in this folder; its last line is "N passed, N failed" or "N passed, N failed, N skipped".  It can contain up to
#            four commas, no $ and no ".  Patterns such as *.smt are expanded by sh, since one argument holds all rows (128 KB).
# Defines check-NAME, and adds the row to LINES_PART and its needs to NEEDS_PART, unless LEFT_OUT names it.
,    := ,
test  = $(eval $(call test_row,$(strip $(1)),$(strip $(2)),$(3),$(strip $(4)$(if $(5),$(,)$(5))$(if $(6),$(,)$(6))$(if $(7),$(,)$(7))$(if $(8),$(,)$(8)))))
define test_row
ROWS += $(patsubst +%,%,$(1))
LINES_$(2) += $(if $(filter $(LEFT_OUT),$(patsubst +%,%,$(1))),,"$(1): $(4)")
NEEDS_$(2) += $(if $(filter $(LEFT_OUT),$(patsubst +%,%,$(1))),,$(3))
check-$(patsubst check-%,%,$(patsubst +%,%,$(1))): all $(3)
	unset MAKEFLAGS MFLAGS MAKELEVEL; $(4)
.PHONY: check-$(patsubst check-%,%,$(patsubst +%,%,$(1)))
endef

run_parts = @printf '%s\n' $(foreach part,$(1),"[$(part)]" $(LINES_$(part))) | sh tests/run.sh

# ---- part 1: test programs and campaigns ----

# Programs that consist of one file and libsmc.  They have objects, so that a change of libsmc only links them again.
UNIT     = $(patsubst tests/unit/%.c,$(B)/unit/%,$(wildcard tests/unit/*.c))
ONE_FILE = $(UNIT) $(B)/ir/run $(B)/ir/verify $(B)/ir/read $(B)/graph/layout
$(ONE_FILE): $(B)/%: $(B)/obj/tests/%.o $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o %.a,$^) -lm
$(B)/golden: $(B)/obj/tests/golden/run.o $(B)/libsmc.a
$(B)/diagnostics: $(B)/obj/tests/check/diagnostics.o $(B)/libsmc.a
$(B)/editors: $(B)/obj/tests/check/editors.o $(B)/libsmc.a
$(B)/fixes: $(B)/obj/tests/check/fixes.o $(B)/obj/tests/check/fixes_meaning.o $(B)/libsmc.a
$(B)/fragments: $(B)/obj/tests/check/fragments.o $(B)/libsmc.a
$(B)/golden $(B)/diagnostics $(B)/editors $(B)/fixes $(B)/fragments:
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o %.a,$^)
# -O1 builds faster than -O2, and these programs are short.
$(ONE_FILE:$(B)/%=$(B)/obj/tests/%.o) $(patsubst %.c,$(B)/obj/%.o,$(wildcard tests/check/*.c tests/golden/*.c)): override CFLAGS := $(CFLAGS:-O2=-O1)
# stdlib_convert again with the code that stdlib selects under -Os.
$(B)/unit/stdlib_convert_small: tests/unit/stdlib_convert.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -Os $(DEPFLAGS) $< -o $@ $(B)/libsmc.a -lm

# `make test T=folder-or-file` runs some conformance cases on every engine.
T ?= conformance
test: all
	$(B)/smc test --engine=all $(T)

# tests/golden.  `make update-golden` writes the current output into the cases.
GOLDEN = $(wildcard tests/golden/*.smt tests/golden/long/*.smt)
update-golden: all $(B)/golden
	UPDATE=1 $(B)/golden $(B)/smc $(GOLDEN)

RUNTIME_ARCHIVES = $(foreach platform,linux sim desk,$(B)/runtime/$(platform).a)
# docs/flight.svg, the flight of the example rocket.  `make docs` draws it.
FLIGHT_SVG = $(B)/smc log $(B)/flight/flight.log --format=svg altitude velocity tankPressure
$(B)/flight/flight.log: $(wildcard examples/rocket/*.[csa]*) $(B)/smc $(B)/runtime/desk.a
	@rm -rf $(@D) && mkdir -p $(@D)/made
	$(call say,FLY)$(B)/smc build examples/rocket/rocket.app -o $(@D)/made && $(CC) -std=c99 -O1 -ffp-contract=off -I. -I$(@D)/made \
	    examples/rocket/*.c $(@D)/made/*.c $(B)/runtime/desk.a -o $(@D)/rocket -pthread && cd $(@D) && ./rocket
docs: docs/flight.svg
docs/flight.svg: $(B)/flight/flight.log
	$(FLIGHT_SVG) -o $@

# docs/ignition.svg and docs/tank.svg, state diagrams of examples.  `make docs` draws them.
docs: docs/ignition.svg docs/tank.svg
docs/ignition.svg docs/tank.svg: docs/%.svg: $(wildcard compiler/report/*.c) | $(B)/smc
	$(B)/smc graph examples/$*/$*.sm -o $@
docs/ignition.svg: examples/ignition/ignition.sm
docs/tank.svg: examples/tank/tank.sm

# tests/fuzz: functions that must survive any input.  seeds/NAME/ holds the first inputs of each.
$(B)/fuzz/%: tests/fuzz/%.c tests/fuzz/driver.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(filter %.c,$^) -o $@ $(B)/libsmc.a

# The seed for flight logs is a log that runtime/log writes.
$(B)/corpus/log/flight.log: $(B)/runtime/log
	@mkdir -p $(@D)
	@$(B)/runtime/log $@.new && head -c 4000 $@.new >$@ && rm $@.new
$(B)/fuzz-cov/log: | $(B)/corpus/log/flight.log
# The seeds for images are those of unit/vm_mutate.  `make check-mutate` changes every byte of them to every value, and runs the images
# that the verifier accepts for STEPS steps.
MUTATE_SMB = $(patsubst %,$(B)/mutate/%.smb,pins signed ignition stand)
$(B)/mutate/pins.smb: examples/tank/tank.sm tests/avr/tank.sv tests/avr/tank.io $(B)/smc
	@mkdir -p $(@D)
	@$(B)/smc build -w $< --sv tests/avr/tank.sv --io tests/avr/tank.io -o $@
$(B)/mutate/signed.smb: $(B)/mutate/pins.smb
	@printf '%032d\n' 7 >$(@D)/key && chmod 600 $(@D)/key && $(B)/smc sign $< --key=$(@D)/key --number=7 -o $@
$(B)/mutate/ignition.smb: examples/ignition/ignition.sm $(B)/smc
$(B)/mutate/stand.smb: examples/teststand/stand.sm $(B)/smc
$(B)/mutate/ignition.smb $(B)/mutate/stand.smb:
	@mkdir -p $(@D)
	@$(B)/smc build -w $< -o $@
$(B)/corpus/image: $(B)/unit/vm_mutate $(MUTATE_SMB)
	@mkdir -p $@
	@$(B)/unit/vm_mutate 1 1 $@ $(MUTATE_SMB) >$(B)/vm_mutate.log 2>&1
$(B)/fuzz/image $(B)/fuzz-cov/image: compiler/device/sign.c
$(B)/fuzz-cov/image: | $(B)/corpus/image

MUTATE_SRC = tests/unit/vm_mutate.c $(LIBSMC)
$(B)/vm_mutate_san: $(MUTATE_SRC) | $(B)/gen/stdlib_text.h $(B)/gen/soft_text.h
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined $(MUTATE_SRC) -lm -o $@
STEPS ?= 1000
check-mutate: $(B)/vm_mutate_san $(MUTATE_SMB)
	$(B)/vm_mutate_san $(STEPS) 256 - $(MUTATE_SMB)

# unit/vm_docs compiles and runs the example of docs/bytecode.md.
$(B)/gen/embed.c: docs/bytecode.md
	@mkdir -p $(@D)
	@sed -n '/^```c$$/,/^```$$/{/^```/d;p;}' $< >$@
$(B)/obj/tests/unit/vm_docs.o: $(B)/gen/embed.c

# tests/diff: random programs on all engines in lock step.  `make diff N=1000000 SEED=1 J=2` is a campaign; it resumes where it was
# interrupted.
N    ?= 20000
SEED ?= 1
J    ?= 2
DIFF_OBJ = $(patsubst %.c,$(B)/obj/%.o,$(wildcard tests/diff/*.c))
GEN_OBJ  = $(B)/obj/tests/diff/subject.o $(patsubst %.c,$(B)/obj/%.o,$(wildcard tests/diff/gen*.c))     # random programs alone
$(B)/diff/difftest: $(DIFF_OBJ) $(B)/libsmc.a $(B)/runtime/sim.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

diff: $(B)/diff/difftest
	$(B)/diff/difftest --seed=$(SEED) --count=$(N) --jobs=$(J) --out=$(B)/diff/campaign --resume

# tests/net: random and mutated packets for the messages of tests/runtime/link.net (UDP), and hostile peers for those of stream.net (TCP).
# `make net-campaign NET_SECONDS=3600 SEED=1` plays each for half of that time, under the sanitizers.
NET_SECONDS ?= 3600
NET_HOSTILE  = $(STRICT_C) -I$(B)/runtime/made $(WARN)
$(B)/net/hostile $(B)/net/hostile_stream $(B)/net/packets: $(B)/net/%: tests/net/%.c $(B)/runtime/sim.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(NET_HOSTILE) $< $(CFLAGS) $(DEPFLAGS) $(B)/runtime/sim.a -o $@
$(B)/net/hostile_san: NET_VECTOR = link
$(B)/net/hostile_stream_san: NET_VECTOR = stream
$(B)/net/hostile_san $(B)/net/hostile_stream_san: $(B)/net/%_san: tests/net/%.c tests/net/oracle.h $(B)/runtime/sim.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(NET_HOSTILE) $< -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined $(RUNTIME_SRC_sim) \
	    $(filter %/$(NET_VECTOR).c %/$(NET_VECTOR)_net.c,$(RUNTIME_MADE)) -lm -o $@
net-campaign: $(B)/net/hostile_san $(B)/net/hostile_stream_san
	$(B)/net/hostile_san $(SEED) 1 $$(($(NET_SECONDS) / 2))
	$(B)/net/hostile_stream_san $(SEED) 1 $$(($(NET_SECONDS) / 2))
.PHONY: net-campaign

# tests/swap: machines that are replaced while they run.  `make swap-campaign N=100000 SEED=1` swaps random pairs.
SWAP_OBJ = $(B)/obj/tests/swap/machine.o $(B)/obj/tests/swap/reference.o
$(B)/swap/clauses $(B)/swap/hostile: $(B)/swap/%: $(B)/obj/tests/swap/%.o $(SWAP_OBJ) $(B)/libsmc.a
$(B)/swap/random: $(B)/obj/tests/swap/random.o $(SWAP_OBJ) $(GEN_OBJ) $(B)/libsmc.a
$(B)/swap/clauses $(B)/swap/hostile $(B)/swap/random:
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# tests/joint: scripts of random applications, against a slow reference.  `make joint-campaign N=100000 SEED=1` runs more of them.
$(B)/joint/random: $(B)/obj/tests/joint/random.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
joint-campaign: $(B)/joint/random
	$(B)/joint/random $(SEED) $(N)
.PHONY: joint-campaign

# Swaps in an application that runs, in the simulation.
$(B)/swap/running $(B)/swap/storing: $(B)/swap/%: $(B)/obj/tests/swap/%.o $(patsubst %,$(B)/obj/tests/swap/%.o,stage machine) $(B)/runtime/sim.a $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# Hosts that reach it over the link: every request cut off, lost and repeated, and hostile ones.
$(B)/swap/link: $(patsubst %,$(B)/obj/tests/swap/%.o,link link_keys wire stage machine) $(B)/obj/compiler/device/app_host.o $(B)/obj/compiler/device/link_host.o $(B)/runtime/sim.a $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# The same with processes, and `smc swap` itself.
$(B)/swap/reach: $(patsubst %,$(B)/obj/tests/swap/%.o,reach stage machine) $(patsubst %,$(B)/obj/compiler/device/%.o,app_host link_host) $(B)/obj/compiler/base/os_serial_posix.o $(B)/runtime/linux.a $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -pthread -lrt

# An application that stores swaps is killed at each call that writes, and each of them fails.
$(B)/swap/killed: $(patsubst %,$(B)/obj/tests/swap/%.o,killed stage machine) $(B)/runtime/linux.a $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(patsubst %,-Wl$(,)--wrap=%,write fsync rename ftruncate) -pthread -lrt

# The same with threads, on Linux, and once more under the thread sanitizer.
# `make swap-lateness SECONDS=5` measures whether swaps make ticks late on this computer.
$(B)/swap/threads $(B)/swap/lateness: $(B)/swap/%: $(B)/obj/tests/swap/%.o $(patsubst %,$(B)/obj/tests/swap/%.o,stage machine) $(B)/runtime/linux.a $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -pthread -lrt

# `make swap-times` prints how long the preparation and the exchange of a machine of 300 lines take.
swap-times: $(B)/swap/reach $(B)/smc
	$(B)/swap/reach $(B)/smc --measure
.PHONY: swap-times

swap-lateness: $(B)/swap/lateness
	$(B)/swap/lateness $(or $(SECONDS),5)
.PHONY: swap-lateness

swap-campaign: $(B)/swap/random $(B)/swap/hostile
	$(B)/swap/random $(SEED) $(N)
	$(B)/swap/hostile $(SEED) $(N)
.PHONY: swap-campaign

# tests/requirements: random requirements over the runs of random machines.  `make requirements-campaign N=100000 SEED=1`.
$(B)/requirements/random: $(B)/obj/tests/requirements/random.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

requirements-campaign: $(B)/requirements/random
	$(B)/requirements/random $(SEED) $(N)
.PHONY: requirements-campaign

# tests/compare: smc diff of random machines, their other forms and their mutants.  `make compare-campaign N=10000 SEED=1`.
$(B)/compare/random: $(B)/obj/tests/compare/random.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

compare-campaign: $(B)/compare/random
	$(B)/compare/random $(SEED) $(N)
.PHONY: compare-campaign

# The square root where the processor has none, for every upper half of its argument.  A minute.
sqrt-campaign: $(B)/unit/stdlib_sqrt
	$(B)/unit/stdlib_sqrt all
.PHONY: sqrt-campaign

# tests/prove: verdicts on random requirements of random machines, against random runs.  `make prove-campaign N=10000 SEED=1 STEPS=100000`.
$(B)/prove/random: $(B)/obj/tests/prove/random.o $(B)/obj/tests/prove/related_text.o $(B)/obj/tests/prove/held_text.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

$(B)/prove/apps: $(B)/obj/tests/prove/apps.o $(B)/obj/tests/prove/related_text.o $(B)/obj/tests/prove/held_text.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

prove-app-campaign: $(B)/prove/apps
	$(B)/prove/apps $(SEED) $(N) $(or $(STEPS),10000)
.PHONY: prove-app-campaign
prove-campaign: $(B)/prove/random
	$(B)/prove/random $(SEED) $(N) $(or $(STEPS),100000)
# tests/prove/corpus: requirements of the examples that a person has decided.  A minute of processor time.
prove-corpus: $(B)/smc
	sh tests/prove/corpus.sh $(B)/smc --effort=2
# tests/prove/author: requirements of an independent author.  Some 12 seconds of processor time.
prove-author: $(B)/smc
	sh tests/prove/author.sh $(B)/smc
# tests/prove/second: 40 more requirements.  A minute of processor time.
prove-second: $(B)/smc
	sh tests/prove/second.sh $(B)/smc
.PHONY: prove-campaign prove-corpus prove-author prove-second

# tests/cover: scripts that are written from random scenarios, and what is called impossible.  `make scripts-campaign N=100000 SEED=1`.
$(B)/cover/scripts: $(B)/obj/tests/cover/scripts.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

$(B)/cover/exhaustive: $(B)/obj/tests/cover/exhaustive.o $(B)/obj/tests/diff/cover_model.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

scripts-campaign: $(B)/cover/scripts $(B)/cover/exhaustive
	$(B)/cover/scripts $(SEED) $(N)
	$(B)/cover/exhaustive $(SEED) $(N)
.PHONY: scripts-campaign

# tests/why: what is recorded for smc why, in runs of random machines.
$(B)/why/random: $(B)/obj/tests/why/random.o $(GEN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

# tests/library: libsmc by its public header.  `make library-campaign N=100000 SEED=1` makes random calls under sanitizers.
LIBRARY_TESTS = $(patsubst %,$(B)/library/%,api machines broken memory refuse threads random command)
$(LIBRARY_TESTS): $(B)/library/%: $(B)/obj/tests/library/%.o $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBRARY_WRAP) -pthread
$(B)/library/refuse: LIBRARY_WRAP = -Wl,--wrap=malloc
$(B)/library/broken: LIBRARY_WRAP = -Wl,--wrap=pass_dce,--wrap=pass_if_convert
$(LIBRARY_TESTS:$(B)/%=$(B)/obj/tests/%.o): override CFLAGS := $(CFLAGS:-O2=-O1)
LIBRARY_FILES = $(B)/lib/libsmc.a $(B)/lib/$(SONAME)

library-campaign:
	$(MAKE) -s B=$(B)/san CFLAGS='-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined' $(B)/san/library/random
	$(B)/san/library/random $(SEED) $(N)
.PHONY: library-campaign

# Runs random programs for a thousand steps each, and fails if something happens that the analyses report as impossible.
SOUND = $(B)/diff/difftest --sound --steps=1000
sound: $(B)/diff/difftest
	$(SOUND) --seed=$(SEED) --count=$(N) --jobs=$(J) --out=$(B)/diff/campaign-sound --resume

# Random programs on all engines and as emitted C, built by the compilers of DIFF_CC.  Add others as --cc='clang-19 -O2' --cc=tcc.
DIFF_CC ?= --cc='$(CC) -std=c99 -O0' --cc='$(CC) -std=gnu11 -O2'
diff-c: $(B)/diff/difftest
	$(B)/diff/difftest --seed=$(SEED) --count=$(N) --jobs=$(J) --out=$(B)/diff/campaign-c --resume $(DIFF_CC)

.PHONY: diff diff-c sound

# tests/cost: the reported bound of the longest step, against a VM that counts instructions.
COST_FLAGS = -DSMVM_CONFIG='"tests/cost/config.h"'
COST_SRC   = tests/cost/run.c $(filter-out $(VM_FAST) $(VM_TEXT),$(VM))
$(B)/cost: $(COST_SRC) tests/cost/config.h $(filter-out %/main.o,$(DIFF_OBJ)) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(COST_FLAGS) $(WARN) $(CFLAGS) $(COST_SRC) -o $@ $(GEN_OBJ) $(B)/libsmc.a

# tests/cover: mutants that are called equivalent.  `make equivalent N=10000 SEED=1` is the campaign.
$(B)/equivalent: tests/cover/equivalent.c $(filter-out %/main.o,$(DIFF_OBJ)) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $< -o $@ $(GEN_OBJ) $(B)/libsmc.a
equivalent: $(B)/equivalent
	$(B)/equivalent $(N) $(SEED)
.PHONY: equivalent

# tests/emitc
ENGINE_C_OBJ = $(patsubst %.c,$(B)/obj/%.o,compiler/device/engine_c.c $(OS_FILES))
$(B)/emitc/flow $(B)/emitc/typed: $(B)/emitc/%: tests/emitc/%.c $(ENGINE_C_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -o $@ $^

# The parts quick and thorough under the sanitizers: compiler, VM and emitted C.  CC includes -O0, since some tests use only CC.
# ASAN_LEAVES_OUT: tests that would run no code of the project under them that the other tests do not.
#   1. The rules of the house read sources with sh and awk.
#   2. Documents and CI pages are mostly compiled by a plain `cc`, or run the commands that golden cases and examples run.
#   3. findings-seeded runs the analyses of `findings`, `analysis` and `examples` on more machines; under the sanitizers it takes 7 times as long.
#   4. These read what the command has written with python3, a browser or dot: golden cases write reports, JUnit, SARIF and graphs as well.
#   5. The table of searches takes five minutes under the sanitizers, alone at the end: `make asan-search`.  search_run, cover, mutation and prove
#      run its code on smaller machines.
#   6. conformance-c-small compiles what conformance-O2 compiles with one macro; stdlib_roll_small runs that code under the sanitizers.
ASAN_LEAVES_OUT = check-words check-wrap check-sentences check-links check-layers check-hints check-codes check-builtins check-arguments check-clauses \
                  check-citations check-licence check-columns check-last-return check-places check-configurations check-headers check-headers-targets check-names \
                  check-imports check-commits check-mutants documents mutants-places runner \
                  check-docs ci-pages findings-seeded search report junit sarif graph-read conformance-c-small conformance-c-soft analysis-long
#   7. conformance-c-soft compiles C that calls the functions of `soft`, which run under the sanitizers on operands of their own and in vm-soft;
#      diff-c-soft compiles such C.
#   8. analysis-long is those of analysis/ that take longest.  Of golden-long, the case runs that alone runs some lines (prove_near.c).
# SANITIZED is not empty under them.  Then rows that start a process for each of many cases, or run a campaign, have fewer cases of the same
# kinds, and names that end in -short, for which floors.txt has other floors.
SANITIZED = $(findstring -fsanitize,$(CC))
SHORT     = $(if $(SANITIZED),-short)
SANITIZE = -fsanitize=address,undefined -fno-sanitize-recover=all
# -no-pie: a process of smc starts in two thirds of the time, and there are thousands.
asan:
	$(MAKE) B=$(B)/asan CFLAGS='-O1 -g1' LDFLAGS=-no-pie CC='$(CC) $(SANITIZE) -O0' LEVELS=2 PARTS='quick thorough' LEFT_OUT='$(ASAN_LEAVES_OUT)' check
asan-search:
	$(MAKE) B=$(B)/asan CFLAGS='-O1 -g1' LDFLAGS=-no-pie CC='$(CC) $(SANITIZE) -O0' check-search

# Coverage-guided fuzzing with clang: `make fuzz FUZZ=script FUZZ_SECONDS=3600`.  The next run starts from the inputs found so far.
FUZZ         ?= $(notdir $(basename $(filter-out tests/fuzz/driver.c,$(wildcard tests/fuzz/*.c))))
FUZZ_SECONDS ?= 60
FUZZ_CC      ?= clang-19
# Arenas with one allocation per chunk: every request reaches malloc, so that a sanitizer checks its bounds.
TINY_CHUNKS   = -DARENA_FIRST_CHUNK=16 -DARENA_LARGEST_CHUNK=16
FUZZ_C        = $(FUZZ_CC) $(STRICT_C) $(TINY_CHUNKS) -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined
$(B)/fuzz-cov/obj/%.o: %.c | $(B)/gen/stdlib_text.h $(B)/gen/soft_text.h
	@mkdir -p $(@D)
	$(call say,CC)$(FUZZ_C:-fsanitize=fuzzer,%=-fsanitize=fuzzer-no-link,%) $(DEPFLAGS) -c $< -o $@
.SECONDARY: $(LIBSMC:%.c=$(B)/fuzz-cov/obj/%.o)
$(B)/fuzz-cov/%: tests/fuzz/%.c $(LIBSMC:%.c=$(B)/fuzz-cov/obj/%.o)
	$(call say,CC)$(FUZZ_C) $(filter %.c %.o,$^) -o $@
fuzz: $(FUZZ:%=$(B)/fuzz-cov/%)
	$(foreach f,$(FUZZ),mkdir -p $(B)/corpus/$(f) && $(B)/fuzz-cov/$(f) -max_total_time=$(FUZZ_SECONDS) -timeout=10 -rss_limit_mb=2048 \
	    -artifact_prefix=$(B)/corpus/$(f)- $(B)/corpus/$(f) $(FUZZ_SEEDS_$(f)) $(wildcard tests/fuzz/seeds/$(f)) || exit 1;)
FUZZ_SEEDS_ir = tests/ir/samples

# tests/bench: time per step, size of code, growth of compile time.  `make bench W=mission`: one workload.
WORKLOADS    = tank mission arith bigwindow seq40 big200 intcount f32filter vote decide ledger redlines kalman guide persist
W           ?= $(WORKLOADS)
$(B)/bench/scale $(B)/bench/compile $(B)/bench/memory: $(B)/bench/%: $(B)/obj/tests/bench/%.o $(B)/obj/tests/bench/shapes.o $(patsubst %.c,$(B)/obj/%.o,$(OS_FILES)) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# What is measured is what a user gets: the VM and stdlib of `make install` with the default CFLAGS.  A build with other CFLAGS is
# not that, and a second one is made.  Handwritten and emitted C are built with BENCH_USER, as a user would build them, except that functions are
# aligned: where they lie depends on all other code, and a step of 2 ns takes up to 1.6 times as long in a bad place.
BENCH_PREFIX = $(B)/bench/prefix
BENCH_MAKE   = $(if $(filter $(DEFAULT_CFLAGS),$(CFLAGS)),$(B),$(B)/bench/default)
BENCH_VM     = $(BENCH_PREFIX)/lib/libsmvm.a
BENCH_ALIGN  = -falign-functions=64
BENCH_USER   = -std=c99 -O2 $(BENCH_ALIGN)
BENCH_FLAGS  = -I$(BENCH_PREFIX)/include/smc -I$(B)/bench/gen $(STRICT_C) -O2 $(BENCH_ALIGN)
$(BENCH_VM): $(B)/smc $(B)/libsmvm.a
	$(call say,INSTALL)$(MAKE) -s install B=$(BENCH_MAKE) CFLAGS='$(DEFAULT_CFLAGS)' DESTDIR= PREFIX=$(abspath $(BENCH_PREFIX)) && touch $@

# Each machine as C, tank_o0 to bigwindow_o2: $(call bench_emit,WORKLOAD,NAME,LEVEL,FLAG OF CC).  Their headers declare the same state
# vector.
BENCH_EMITTED =
bench_sm      = $(firstword $(wildcard tests/bench/workloads/$(1).sm examples/$(1)/$(1).sm))
define bench_emit
BENCH_EMITTED += $(B)/bench/gen/$(1)_$(2)
$(B)/bench/gen/$(1)_$(2).c: $(bench_sm) tests/bench/workloads/$(1).sv $(B)/smc
	@mkdir -p $$(@D)
	$$(call say,SMC)$(B)/smc build -w $(bench_sm) --sv tests/bench/workloads/$(1).sv --emit=c -O$(3) --prefix=$(1)_$(2) -o $$@
$(B)/bench/gen/$(1)_$(2).o: $(B)/bench/gen/$(1)_$(2).c
	$$(call say,CC)$$(CC) $$(BENCH_USER) $(4) -c $$< -o $$@
endef
$(foreach w,$(WORKLOADS),$(foreach o,0 1 2,$(eval $(call bench_emit,$(w),o$(o),$(o))))$(eval $(call bench_emit,$(w),os,2,-Os)))
$(BENCH_EMITTED:%=%.h): %.h: %.c ;

# The row `wasm3`: WASM3=FOLDER names the sources of wasm3 (tests/bench/README.md); needs clang and wasm-ld, and the package wasi-libc.
# `make wasm3` fetches them from PyPI; what it fetched is the default.
WASM3_VERSION = 0.5.0
ifndef WASM3
WASM3      := $(if $(shell command -v wasm-ld-19),$(wildcard $(B)/wasm3/pywasm3-$(WASM3_VERSION)/wasm3))
endif
wasm3:
	@mkdir -p $(B)/wasm3
	cd $(B)/wasm3 && python3 -m pip download -q --no-deps --no-binary :all: -d . pywasm3==$(WASM3_VERSION) && tar -xzf pywasm3-$(WASM3_VERSION).tar.gz
.PHONY: wasm3
WASM_CC    ?= clang-19 --target=wasm32-wasi
BENCH_WASM  = $(if $(WASM3),$(WORKLOADS:%=$(B)/bench/gen/%.wasm))
$(B)/bench/gen/%.wasm: tests/bench/workloads/%_rows.c tests/bench/workloads/%_f64.c tests/bench/rows.h $(BENCH_VM) | $(BENCH_EMITTED:%=%.h)
	$(call say,WASM)$(WASM_CC) $(BENCH_FLAGS) -nostdlib -Wl$(,)--no-entry $(filter %.c,$^) -lc -o $@
BENCH_WASM3 = $(patsubst $(WASM3)/%.c,$(B)/bench/wasm3/%.o,$(if $(WASM3),$(wildcard $(WASM3)/m3_*.c)))
$(B)/bench/wasm3/%.o: $(WASM3)/%.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) -std=gnu99 -O3 -fomit-frame-pointer -fno-stack-protector -c $< -o $@
$(B)/bench/obj/tests/bench/wasm.o: BENCH_FLAGS += $(if $(WASM3),-DBENCH_WASM3 -I$(WASM3))
# Made again when WASM3 changes.
$(B)/bench/wasm3.txt: $(if $(findstring $(WASM3)!,$(shell cat $(B)/bench/wasm3.txt 2>/dev/null)),,FORCE)
	@mkdir -p $(@D)
	@echo '$(WASM3)!' >$@
$(B)/bench/obj/tests/bench/wasm.o: $(B)/bench/wasm3.txt
FORCE:

BENCH_C   = $(wildcard tests/bench/workloads/*.c) $(addprefix tests/bench/,steps.c engines.c lua.c wasm.c nothing.c)
BENCH_OBJ = $(patsubst %.c,$(B)/bench/obj/%.o,$(BENCH_C))
$(B)/bench/obj/%.o: %.c $(BENCH_VM) | $(BENCH_EMITTED:%=%.h)
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(BENCH_FLAGS) $(WARN) $(DEPFLAGS) -c $< -o $@
$(B)/bench/obj/tests/bench/workloads/%_native.o: BENCH_FLAGS = $(BENCH_USER) -I. -I$(B)/bench/gen
$(B)/bench/steps: $(BENCH_OBJ) $(BENCH_EMITTED:%=%.o) $(BENCH_WASM3) $(BENCH_VM) $(B)/libsmc.a | $(BENCH_WASM)
	$(call say,LD)$(CC) -o $@ $^ -lm

# What coverage costs: `make bench-coverage W="tank mission"`.
$(B)/bench/coverage: $(B)/bench/obj/tests/bench/coverage.o $(filter-out %/steps.o,$(BENCH_OBJ)) $(BENCH_EMITTED:%=%.o) $(BENCH_WASM3) $(BENCH_VM) $(B)/libsmc.a
	$(call say,LD)$(CC) -o $@ $^ -lm
bench-coverage: $(B)/bench/coverage
	$(B)/bench/coverage $(W)
	@sh tests/bench/coverage.sh $(B)/smc
.PHONY: bench-coverage

# tests/search: how far searches come on every machine, and how fast.  `make bench-search M=machine.sm`: one machine.
SEARCH_MACHINES = $(filter-out %_rows.sm,$(wildcard examples/*/*.sm tests/search/machines/*.sm tests/bench/workloads/*.sm))
$(B)/search/bench: tests/search/bench.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -D_POSIX_C_SOURCE=200809L $(WARN) $(CFLAGS) $< -o $@ $(B)/libsmc.a -lm
bench-search: $(B)/search/bench
	$(B)/search/bench $(or $(M),$(SEARCH_MACHINES))
bench-mutants: $(B)/smc
	@sh tests/bench/mutants.sh $(B)/smc
# The machines of the table of searches, with a tenth of the default effort and with all of it; the last two lines are the totals.
search-table: $(B)/search/bench
	$(B)/search/bench $$(awk '!/^#/ && NF { print $$1 }' tests/search/expected.txt)
# What searches call impossible, against random runs of every machine: N steps for each of the seeds SEED to SEED + 3.  Half of the runs begin as a
# run of the search.  A machine without such goals ends at once.
impossible-campaign: $(B)/search/bench
	for m in $(or $(M),$(SEARCH_MACHINES)); do for s in 0 1 2 3; do \
	    $(B)/search/bench --seed=$$(($(SEED) + s)) --random=$(N) $$m || exit 1; done; done
# Proofs of how many inputs a script must change at least, against the scripts of those machines.
search-bounds: $(B)/search/bench
	$(B)/search/bench --effort=32000000 --bounds $$(awk '!/^#/ && NF { print $$1 }' tests/search/expected.txt)
.PHONY: bench-search bench-mutants search-table impossible-campaign search-bounds

# `make bench` runs all parts; `make bench-time`, `bench-count`, `bench-sizes`, `bench-compile` and `bench-avr` one each (tests/bench/run.sh).
BENCH_PARTS = time count sizes compile avr
bench: $(B)/bench/steps $(B)/bench/compile
	sh tests/bench/run.sh $(B) '$(CC)' '$(BENCH_PARTS)' '$(W)'
$(BENCH_PARTS:%=bench-%): bench-%: $(B)/bench/steps $(B)/bench/compile
	sh tests/bench/run.sh $(B) '$(CC)' $* '$(W)'

# Checks that the time of every stage of the compiler grows linearly with its input.
bench-scale: $(B)/bench/scale
	$(B)/bench/scale
.PHONY: bench-scale $(BENCH_PARTS:%=bench-%)

# Flash, RAM, stack and cycles on boards, against tests/bench/budgets.txt.
sizes: $(B)/smc
	@sh tests/bench/sizes.sh $(B) '$(CC)' '$(MAKE)'
.PHONY: sizes

# tests/fault: every request for memory fails in turn.  FAULT_ALL=1 tries every machine of conformance/ (minutes).
FAULT_CASES = $(if $(FAULT_ALL),$(wildcard conformance/*/*.smt),$(wildcard tests/fault/*.smt))
$(B)/fault/memory: tests/fault/memory.c compiler/base/arena.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(TINY_CHUNKS) $(filter %.c,$^) -o $@ $(B)/libsmc.a

$(B)/fault/shim.so: tests/fault/shim.c
	@mkdir -p $(@D)
	-$(call say,CC)$(CC) -std=c99 -O1 -Wall -Wextra -shared -fPIC $< -o $@ -ldl || rm -f $@

# tests/host
HOST_OBJ     = $(patsubst %.c,$(B)/obj/%.o,$(OS_FILES))
HOST_FOLDER  = rm -rf $(B)/host/$(1).made && mkdir -p $(B)/host/$(1).made &&
$(B)/host/files: HOST_WRAP = -Wl,--wrap=fsync,--wrap=rename,--wrap=fchmod
$(B)/host/files $(B)/host/signals $(B)/host/folders: $(B)/host/%: tests/host/%.c $(HOST_OBJ)
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< $(HOST_OBJ) -o $@ $(HOST_WRAP)
# tests/soft: soft binary64 against the processor's.  `make f64-campaign N=1000000000` tries N random operands of each operation and
# resumes where it was interrupted; f64-f32 tries every binary32.
SOFT_OBJ = $(patsubst %.c,$(B)/obj/%.o,$(wildcard tests/soft/*.c))
$(B)/obj/tests/soft/subject.o: STRICT_C += -DSM_F64_SOFT=1
$(B)/soft/run: $(SOFT_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

f64-campaign: $(B)/soft/run
	$(B)/soft/run $(N) $(SEED) $(B)/soft/campaign
f64-f32: $(B)/soft/run
	$(B)/soft/run f32
.PHONY: f64-campaign f64-f32

# tests/elementary: the elementary functions.  `make elementary-campaign N=1000000` measures their errors against libquadmath, in every
# binade and for N random arguments each, and compares the bits of native and soft numbers for as many.
# `make elementary-constants` computes every coefficient again (needs python3 with mpmath).
$(B)/elementary/native.o: OWN_FLAGS += -DSUBJECT=bits_native
$(B)/elementary/soft.o: OWN_FLAGS += -DSM_F64_SOFT=1 -DSUBJECT=bits_soft
$(B)/elementary/native.o $(B)/elementary/soft.o: tests/elementary/subject.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(OWN_FLAGS) $(DEPFLAGS) -c $< -o $@
$(B)/elementary/bits: $(B)/obj/tests/elementary/bits.o $(B)/elementary/native.o $(B)/elementary/soft.o $(B)/libsmc.a
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm
$(B)/elementary/precision: tests/elementary/precision.c $(wildcard tests/elementary/*.h tests/elementary/*.def) stdlib/elementary.h
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -std=gnu11 $(CFLAGS) $< -o $@ -lquadmath -lm
elementary-campaign: $(B)/elementary/precision $(B)/elementary/bits
	$(B)/elementary/precision $(or $(N),1000000) $(or $(SEED),1)
	$(B)/elementary/bits $(or $(N),1000000) $(or $(SEED),1)
elementary-constants:
	python3 tests/elementary/coefficients.py --check
.PHONY: elementary-campaign elementary-constants

# tests/avr, on an emulated ATmega328P.  `make avr-operands N=100000 SEED=2`: the test `avr` with N random operands for each operation.
avr-operands: all $(B)/diff/difftest
	sh tests/avr/run.sh $(B) '$(CC)' $(N) $(SEED) 300
# `make avr-campaign N=10000 SEED=1`: N random programs as images; resumes where it was interrupted.
avr-campaign:
	$(MAKE) avr-operands N= SEED=
	nice -n 19 sh tests/avr/campaign.sh $(B) $(or $(N),10000) $(or $(SEED),1)

# `make avr-cycles` measures the cycles of avr_cycles.def again, in some minutes; avr-cycles-check N=4000 SEED=7 checks them with more
# and other operands than the test `avr-cycles`.
avr-cycles: $(B)/libsmc.a
	sh tests/avr/cycles.sh $(B) '$(CC)' make $(or $(N),800) $(or $(SEED),1)
avr-cycles-check: $(B)/libsmc.a
	sh tests/avr/cycles.sh $(B) '$(CC)' check $(N) $(SEED)

# `make avr-c-campaign N=1000`: N random programs as emitted C, and every conformance case; resumes where it was interrupted.
avr-c-campaign: all $(B)/diff/difftest $(B)/targets/cases
	RESUME=1 sh tests/avr/c.sh $(B) '$(CC)' $(N) $(SEED) 1
.PHONY: avr-operands avr-campaign avr-cycles avr-cycles-check avr-c-campaign

# tests/psl: one suite per platform.  On Linux, IIO devices are files in a folder of the test, and the test can make calls of the C
# library fail (PSL_WRAP).  The hardware watchdog is only compiled.
PSL_SUITE       = $(filter-out tests/psl/bench_% tests/psl/own_% tests/psl/qemu_%,$(wildcard tests/psl/*.c))
PSL_WATCHDOG    = watchdog_process
PSL_FLAGS_linux = -DPSL_LINUX_IIO='"iio"'
PSL_OBJ_linux   = psl/linux
# On sbRIO, tests/sbrio has a stand-in for the library and FPGA of NI.
PSL_FLAGS_sbrio = -Itests/sbrio -Itests/psl
PSL_OBJ_sbrio   = psl/sbrio
PSL_TEST_sbrio  = tests/sbrio/NiFpga.c
define psl_objects
$$(B)/psl/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$$(call say,CC)$$(CC) $$(STRICT_C) $$(WARN) $$(CFLAGS) $$(PSL_FLAGS_$(1)) $$(DEPFLAGS) -c $$< -o $$@
endef
$(foreach platform,linux sbrio,$(eval $(call psl_objects,$(platform))))
PSL_WRAP_linux  = $(patsubst %,-Wl$(,)--wrap=%,write fsync fdatasync rename unlink syscall timer_settime ppoll accept4 recvmsg connect)
define psl_test
include runtime-c/psl/$(1)/psl.mk
PSL_SRC_$(1)  := $$(PSL) $$(PSL_SUITE) $$(wildcard tests/psl/*_$(1).c) $$(PSL_TEST_$(1)) stdlib/result.c runtime-c/io.c runtime-c/pin.c runtime-c/statevec.c
PSL_LIBS_$(1) := $$(PSL_LIBS)
$$(B)/psl/$(1)/suite: $$(PSL_SRC_$(1):%.c=$$(B)/$(or $(PSL_OBJ_$(1)),obj)/%.o)
	@mkdir -p $$(@D)
	$$(call say,LD)$$(CC) $$(CFLAGS) $$(LDFLAGS) -o $$@ $$^ $$(PSL_WRAP_$(1)) $$(PSL_LIBS_$(1))
endef
$(foreach platform,linux sbrio sim desk none,$(eval $(call psl_test,$(platform))))

# Tests with threads run a second time under the thread sanitizer.  has_tsan is empty if the compiler lacks it.
TSAN = test ! -s $(B)/has_tsan || $(CC) $(STRICT_C) -O1 -g -fsanitize=thread
$(B)/has_tsan:
	@mkdir -p $(@D)
	@echo 'int main(void) { return 0; }' >$@.c; $(CC) -fsanitize=thread $@.c -o $@.out 2>/dev/null && echo yes >$@ || : >$@

$(B)/psl/tsan: $(PSL_SRC_linux) | $(B)/has_tsan
	@mkdir -p $(@D)
	$(call say,CC)$(TSAN) $(PSL_FLAGS_linux) $^ -o $@ $(PSL_WRAP_linux) $(PSL_LIBS_linux)

# tests/store: updates of images, with the power cut at every byte.  `make store-cuts`: all pairs of cuts.
STORE_SRC = tests/store/cuts.c bytecode-vm/target/store.c $(LINK) $(filter-out $(VM_FAST) $(VM_TEXT),$(VM)) stdlib/tables.c $(filter runtime-c/psl/sim/%,$(PSL_SRC_sim))
STORE_SMB = $(B)/store/old.smb $(B)/store/new.smb
$(B)/store/cuts: $(STORE_SRC:%.c=$(B)/obj/%.o)
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
$(B)/store/old.smb: examples/tank/tank.sm $(B)/smc
	@mkdir -p $(@D)
	$(B)/smc build -w $< -o $@
$(B)/store/new.smb: examples/chilldown/chilldown.sm $(B)/smc
	@mkdir -p $(@D)
	$(B)/smc build -w $< -o $@

# The same image with two values of its parameters.
LIMITS_SMB = $(B)/device/limits.smb
$(LIMITS_SMB): tests/device/limits.sm $(B)/smc
	@mkdir -p $(@D)
	$(B)/smc build -w $< -o $@
LIMITS_SET = $(B)/device/set.smb
$(LIMITS_SET): $(LIMITS_SMB)
	$(B)/smc set $< limit=750 count=9 -o $@

# The link between a host and a board, over lines that lose and damage bytes.  `make link-trouble N=100000 SEED=2`: N updates.
BOARD_SRC = bytecode-vm/target/agent.c bytecode-vm/target/store.c runtime-c/event.c $(filter runtime-c/psl/sim/%,$(PSL_SRC_sim))
AGENT_SRC = bytecode-vm/target/state_log.c compiler/device/device.c compiler/device/link_host.c $(BOARD_SRC)
$(B)/store/agent $(B)/store/agent_log $(B)/store/older: $(B)/store/%: $(B)/obj/tests/store/%.o $(AGENT_SRC:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
# A board with a key.
AUTH_SRC = tests/store/auth.c compiler/device/sign.c $(BOARD_SRC)
$(B)/store/auth: $(AUTH_SRC:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
link-trouble: $(B)/store/agent $(STORE_SMB) $(LIMITS_SMB)
	$(B)/store/agent $(STORE_SMB) $(LIMITS_SMB) $(or $(N),100000) $(or $(SEED),1)
$(B)/fuzz/link $(B)/fuzz-cov/link: $(BOARD_SRC)
LINK_SEEDS = $(B)/corpus/link/slots-1 $(B)/corpus/link/slots-2
$(LINK_SEEDS): $(B)/corpus/link/slots-%: tests/fuzz/link_seed.sh $(B)/store/old.smb
	@mkdir -p $(@D)
	@sh tests/fuzz/link_seed.sh $* $(B)/store/old.smb >$@.new && mv $@.new $@
$(B)/fuzz-cov/link: | $(LINK_SEEDS)
.PHONY: link-trouble

# tests/device: smc flash and smc device against a program that acts as the board.  `make device-trouble N=1000 SEED=2`: N updates.
DEVICE_SRC = tests/device/board.c bytecode-vm/target/agent.c bytecode-vm/target/store.c runtime-c/event.c $(filter runtime-c/psl/linux/%,$(PSL_SRC_linux))
$(B)/device/board: $(DEVICE_SRC:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -pthread -lrt
$(B)/device/link: tests/device/link.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $< -o $@
DEVICE_RUN = $(B)/device/link $(B)/smc $(B)/device/board $(B)/device $(STORE_SMB) $(LIMITS_SMB)
device-trouble: $(B)/device/link $(B)/device/board $(STORE_SMB) $(LIMITS_SMB)
	$(DEVICE_RUN) $(or $(N),1000) $(or $(SEED),1)
.PHONY: device-trouble
store-cuts: $(B)/store/cuts $(STORE_SMB)
	$(B)/store/cuts $(STORE_SMB) all
.PHONY: store-cuts

# `make firmware-trouble N=100 SEED=2`: N updates of emulated boards.
firmware-trouble: $(B)/device/link $(STORE_SMB) $(LIMITS_SMB)
	sh tests/avr/firmware.sh '$(MAKE)' $(B) '$(CC)' $(or $(N),100) $(or $(SEED),1)
.PHONY: firmware-trouble

# `make psl-qemu KERNEL=FOLDER`: the suite on Linux with real pins and a real watchdog, in an emulator.  Needs qemu-system-arm,
# gcc-arm-linux-gnueabihf, libc6-dev-armhf-cross and cpio.  FOLDER: Debian's linux-image-*-armmp:armhf, unpacked by dpkg-deb -x.
ARM_CC   ?= arm-linux-gnueabihf-gcc
PSL_ARM   = $(ARM_CC) $(STRICT_C) $(WARN) -O1 -static
PSL_HARD  = $(patsubst %/watchdog_process.c,%/watchdog.c,$(PSL_SRC_linux))
psl-qemu:
	@mkdir -p $(B)/psl/qemu
	$(PSL_ARM) $(PSL_FLAGS_linux) $(PSL_SRC_linux) -o $(B)/psl/qemu/suite $(PSL_WRAP_linux) $(PSL_LIBS_linux)
	$(PSL_ARM) $(PSL_FLAGS_linux) $(PSL_HARD) -o $(B)/psl/qemu/suite-watchdog $(PSL_WRAP_linux) $(PSL_LIBS_linux)
	$(PSL_ARM) tests/psl/qemu_init.c -o $(B)/psl/qemu/init
	@KERNEL='$(KERNEL)' sh tests/psl/qemu.sh $(B)/psl/qemu $(B)/psl/qemu/suite $(B)/psl/qemu/suite-watchdog $(B)/psl/qemu/init
.PHONY: psl-qemu

# tests/runtime: one program per file.  NAME_linux.c runs on Linux, with threads, and again under the thread sanitizer; the others run in
# the simulation.  Of the folder's files, V.sv is compiled to "V.h", V.io to "V_io.h", V.net to "V_net.h", and M.sm to "M.h", with the vector RUNTIME_SV_M.
RUNTIME_SRC   = $(wildcard runtime-c/*.c) $(filter-out %/store.c %/agent.c %/state_log.c,$(wildcard bytecode-vm/target/*.c)) $(VM) $(LINK) $(STDLIB)
RUNTIME_MADE  = $(patsubst tests/runtime/%,$(B)/runtime/made/%.c,$(basename $(wildcard tests/runtime/*.sv tests/runtime/*.sm))) \
                $(patsubst tests/runtime/%.io,$(B)/runtime/made/%_io.c,$(wildcard tests/runtime/*.io)) \
                $(patsubst tests/runtime/%.net,$(B)/runtime/made/%_net.c,$(wildcard tests/runtime/*.net))
RUNTIME_TESTS = $(patsubst tests/runtime/%.c,$(B)/runtime/%,$(wildcard tests/runtime/*.c))
RUNTIME_TSAN  = $(patsubst %_linux,%_tsan,$(filter %_linux,$(RUNTIME_TESTS)))
RUNTIME_C     = $(STRICT_C) -I$(B)/runtime/made $(WARN)
# For the tests of machines: machines with these vectors, one built without `lock`, and images as arrays.
RUNTIME_SV_tester = stand
RUNTIME_SV_bystander = stand
RUNTIME_SV_picker = many
RUNTIME_SV_pinned = pins
RUNTIME_SV_first  = shared
RUNTIME_SV_second = shared
$(B)/runtime/made/plain_tester.c: tests/runtime/tester.sm tests/runtime/stand.sv $(B)/smc
	@mkdir -p $(@D)/unlocked
	@sed '/^\[options\]/d; /^lock/d' tests/runtime/stand.sv >$(@D)/unlocked/stand.sv
	$(call say,SMC)$(B)/smc build --emit=c --runtime -w --prefix=plain_tester --sv $(@D)/unlocked/stand.sv -o $@ $<
RUNTIME_MADE += $(B)/runtime/made/plain_tester.c
$(B)/runtime/made/images.h: tests/runtime/images.sh $(wildcard tests/runtime/*.sm tests/runtime/*.sv tests/runtime/*.io) $(B)/smc
	@mkdir -p $(@D)
	$(call say,SMC)sh tests/runtime/images.sh $(B)/smc >$@.new && mv $@.new $@
$(RUNTIME_TESTS) $(RUNTIME_TSAN): | $(B)/runtime/made/images.h
$(B)/runtime/made/%.c: tests/runtime/%.sv $(B)/smc
	@mkdir -p $(@D)
	$(call say,SMC)$(B)/smc build --emit=c --runtime -w -o $@ $<
$(B)/runtime/made/%_io.c: tests/runtime/%.io tests/runtime/%.sv $(B)/smc
	@mkdir -p $(@D)
	$(call say,SMC)$(B)/smc build --emit=c --sv tests/runtime/$*.sv -o $@ $<
$(B)/runtime/made/%_net.c: tests/runtime/%.net tests/runtime/%.sv $(B)/smc
	@mkdir -p $(@D)
	$(call say,SMC)$(B)/smc build --emit=c --sv tests/runtime/$*.sv -o $@ $<
$(B)/runtime/made/%.c: tests/runtime/%.sm $(B)/smc
	@mkdir -p $(@D)
	$(call say,SMC)$(B)/smc build --emit=c --runtime -w $(if $(RUNTIME_SV_$*),--sv tests/runtime/$(RUNTIME_SV_$*).sv) -o $@ $<
$(RUNTIME_MADE:%.c=%.o): %.o: %.c | $(RUNTIME_MADE)
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) -c $< -o $@
define runtime_platform
include runtime-c/psl/$(1)/psl.mk
RUNTIME_SRC_$(1) := $$(PSL) $$(RUNTIME_SRC)
$$(B)/runtime/$(1).a: $$(RUNTIME_SRC_$(1):%.c=$$(B)/obj/%.o) $$(RUNTIME_MADE:%.c=%.o)
	@rm -f $$@
	$$(call say,AR)$$(AR) rcs $$@ $$^
endef
$(foreach platform,linux sim desk,$(eval $(call runtime_platform,$(platform))))
# A program that links link_net.c or stream_net.c defines its key, so only the tests of messages do, from an archive.
RUNTIME_LINKED = $(filter-out %/link_net.c %/stream_net.c,$(RUNTIME_MADE))
RUNTIME_TSAN_SRC = $(RUNTIME_SRC_linux) $(RUNTIME_LINKED)
RUNTIME_TSAN_OBJ = $(patsubst $(B)/%.c,$(B)/tsan/%.o,$(filter $(B)/%,$(RUNTIME_TSAN_SRC))) $(patsubst %.c,$(B)/tsan/%.o,$(filter-out $(B)/%,$(RUNTIME_TSAN_SRC)))
$(B)/tsan/runtime/made/%.o: $(B)/runtime/made/%.c | $(B)/has_tsan $(RUNTIME_MADE)
	@mkdir -p $(@D)
	$(call say,CC)$(TSAN) -I$(B)/runtime/made $(DEPFLAGS) -c $< -o $@
$(B)/tsan/%.o: %.c | $(B)/has_tsan
	@mkdir -p $(@D)
	$(call say,CC)$(TSAN) $(DEPFLAGS) -c $< -o $@
$(B)/runtime/%_linux: tests/runtime/%_linux.c $(B)/runtime/linux.a
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/runtime/linux.a $(RUNTIME_LIBS) -pthread -lrt
# Hosts of an application whose machines are swapped.  `make swap-fuzz N=100000 SEED=1` changes the seeds at random, under sanitizers.
SWAP_FUZZ_SRC = $(sort $(filter-out $(LIBSMC),tests/swap/stage.c tests/swap/machine.c compiler/device/app_host.c compiler/device/link_host.c $(RUNTIME_SRC_sim)))
$(B)/fuzz/swap $(B)/fuzz-cov/swap: $(SWAP_FUZZ_SRC)
swap-fuzz:
	$(MAKE) -s B=$(B)/san CFLAGS='-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined' $(B)/san/fuzz/swap
	$(B)/san/fuzz/swap -n $(N) -s $(SEED) tests/fuzz/seeds/swap/*
.PHONY: swap-fuzz

$(B)/runtime/%: tests/runtime/%.c $(B)/runtime/sim.a
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/runtime/sim.a $(RUNTIME_LIBS)
$(B)/runtime/threads: RUNTIME_LIBS = -pthread
# These tests read logs with the reader of `smc log`.
RUNTIME_READS = $(patsubst %,$(B)/runtime/%,log log_damage log_linux log_tsan kill_linux kill_tsan)
$(RUNTIME_READS): RUNTIME_LIBS = $(B)/libsmc.a
$(RUNTIME_READS): | $(B)/libsmc.a
.SECONDARY: $(RUNTIME_TSAN_OBJ)
$(B)/runtime/%_tsan: tests/runtime/%_linux.c $(RUNTIME_TSAN_OBJ)
	$(call say,CC)$(TSAN) -I$(B)/runtime/made $^ -o $@ $(RUNTIME_LIBS) -pthread -lrt
$(B)/swap/threads_tsan: $(patsubst %,$(B)/tsan/tests/swap/%.o,threads stage machine) $(RUNTIME_TSAN_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(TSAN) $^ -o $@ -pthread -lrt
# `make kill-runtime N=10000`: kills a program N times, at random times.
kill-runtime: $(B)/runtime/kill_linux
	$(B)/runtime/kill_linux $(N)
.PHONY: kill-runtime
# tests/targets, on emulated processors.  `make targets-campaign N=10000 NC=1000 SEED=1`: N random programs as images and NC as C at each
# level, on each processor of targets.txt or those that TARGETS names; resumes where it was interrupted.
# The VM is built with a user's options, without -ffp-contract.
TARGETS_OPT  ?= -Os
TARGETS_VM    = tests/targets/vm.c $(filter-out $(VM_TEXT),$(VM)) $(STDLIB)
TARGETS_ROOM  = $(shell sh tests/targets/cc.sh $* vm)
$(B)/targets/vm-%: $(TARGETS_VM) $(wildcard tests/targets/*.txt tests/targets/cc.sh tests/targets/bare/* bytecode-vm/*.[hd]* stdlib/*.[hd]*)
	@mkdir -p $(@D)
	$(call say,CC)sh tests/targets/cc.sh $* -std=gnu11 -I. -Wall -Wextra -Werror $(TARGETS_OPT) $(TARGETS_ROOM) -o $@ \
	    $(if $(findstring DECODED=0,$(TARGETS_ROOM)),$(filter-out $(VM_FAST),$(TARGETS_VM)),$(TARGETS_VM))
$(B)/targets/cases: tests/targets/cases.c $(filter-out %/main.o,$(DIFF_OBJ)) $(B)/libsmc.a $(B)/runtime/sim.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(LDFLAGS) -o $@ $^

# The VM's unit tests in the configuration of the target.  Sources that include bytecode-vm/config.h are compiled for it; libsmc has
# the rest.  vm_hostile and vm_switch have configurations of their own, vm_mutate takes long.
TARGETS_UNIT = $(filter-out %/vm_hostile.c %/vm_switch.c %/vm_mutate.c,$(wildcard tests/unit/vm_*.c))
TARGETS_CONF = $(VM) $(STDLIB) $(wildcard compiler/emit/bytecode/*.c) compiler/script/engine_vm.c
$(B)/targets/units-%: $(TARGETS_UNIT) $(TARGETS_CONF) $(B)/libsmc.a $(B)/gen/embed.c tests/targets/targets.txt
	@mkdir -p $@
	$(call say,CC)for f in $(TARGETS_CONF); do \
	    sh tests/targets/cc.sh $* $(STRICT_C) -Wall -Wextra -Werror -O0 -c $$f -o $@/$$(echo $$f | tr / _).o || exit 1; \
	done; for t in $(TARGETS_UNIT); do sh tests/targets/cc.sh $* $(STRICT_C) -O0 $$t $@/*.o $(B)/libsmc.a -lm -o $@/$$(basename $$t .c) || exit 1; done
	@touch $@

# Tests of runtime-c without threads, on targets with an operating system.  Their aim is the wire forms on a big-endian processor.
TARGETS_RUNTIME = statevec region event executor task keep machine
$(B)/targets/runtime-%: $(RUNTIME_SRC_sim) $(RUNTIME_LINKED) $(TARGETS_RUNTIME:%=tests/runtime/%.c) | $(B)/runtime/made/images.h
	@mkdir -p $@.tests
	$(call say,CC)for f in $(filter-out tests/%,$^); do \
	    sh tests/targets/cc.sh $* $(RUNTIME_C) -O0 -c $$f -o $@.tests/$$(echo $$f | tr / _).o || exit 1; \
	done; for t in $(TARGETS_RUNTIME); do sh tests/targets/cc.sh $* $(RUNTIME_C) -O0 tests/runtime/$$t.c $@.tests/*.o -o $@.tests/$$t || exit 1; done
	@touch $@

targets-campaign: $(B)/diff/difftest $(B)/targets/cases
targets-campaign:
	N=$(N) NC=$(NC) SEED=$(SEED) nice -n 19 sh tests/targets/campaign.sh $(B) $(TARGETS)

# smc itself and its tests on targets with an operating system: `make targets-native TARGETS=s390x-fma`.  Without vm_mutate, which
# would take an hour.
NATIVE_UNIT = $(filter-out %/vm_mutate,$(UNIT))
targets-native: $(B)/golden
	for t in $(or $(TARGETS),s390x-fma armhf-fma); do \
	    $(MAKE) B=$(B)/native-$$t CC="sh tests/targets/cc.sh $$t" AR="sh tests/targets/cc.sh $$t ar" CFLAGS='-O1 -Werror' native-tests || exit 1; \
	    $(B)/golden $(B)/native-$$t/smc $(filter-out %/example-tank.smt %/test-all-engines.smt %/test-engine-absent.smt %/test-engine-all-without-c.smt %/thesis-%,$(GOLDEN)) || exit 1; \
	done
native-tests: all $(NATIVE_UNIT) $(B)/diff/difftest $(TARGETS_RUNTIME:%=$(B)/runtime/%)
	for t in $(NATIVE_UNIT) $(TARGETS_RUNTIME:%=$(B)/runtime/%); do $$t || exit 1; done
	for engine in ref vm vm-soft; do $(B)/smc test --engine=$$engine conformance || exit 1; done
	$(B)/diff/difftest --count=$(or $(NC),1000) --out=$(B)/diff/native
.PHONY: targets-campaign targets-native native-tests

# Random applications and random faults, compared with a model: N steps.
stress-runtime: $(B)/runtime/stress
	$(B)/runtime/stress $(or $(N),1000000) $(or $(SEED),1)

# How late ticks begin on this computer, without and with real-time priorities, for SECONDS=5 each.
$(B)/runtime/lateness: tests/bench/lateness.c $(B)/runtime/linux.a
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/runtime/linux.a -pthread -lrt
lateness: $(B)/runtime/lateness
	$(B)/runtime/lateness $(or $(SECONDS),5)
.PHONY: stress-runtime lateness

# Time and size of an access to the state vector and of a tick.
bench-runtime: $(RUNTIME_MADE)
	sh tests/bench/runtime.sh $(B) '$(CC)'
	sh tests/bench/ticks.sh $(B) '$(CC)'
# What 10 messages in 1 ms cost, beside the system calls of the same traffic.
bench-net: $(B)/smc
	@sh tests/bench/net.sh $(B) '$(CC)' $(B)/smc
# How many rows of recorded data a script reads a second.
bench-data: $(B)/smc
	@sh tests/bench/data.sh $(B)/smc
.PHONY: bench-runtime bench-net bench-data

# tests/runtime/flights: the example machines as tasks, in the flights of their scripts.
FLIGHTS        = $(B)/runtime/flights
FLIGHT_TRACES  = $(patsubst examples/mission/%.ss,$(FLIGHTS)/%.trace,$(wildcard examples/mission/*.ss))
FLIGHT_RUNTIME = $(FLIGHTS)/rocket.c $(FLIGHTS)/mission.c $(FLIGHTS)/airbrakes.c
$(FLIGHTS)/rocket.sv: examples/mission/rocket.sv
	@mkdir -p $(@D)
	@{ printf '[options]\nlock\n'; cat $<; } >$@
$(FLIGHTS)/rocket.c: $(FLIGHTS)/rocket.sv $(B)/smc
	$(call say,SMC)$(B)/smc build --emit=c --runtime -o $@ $<
$(FLIGHTS)/mission.c $(FLIGHTS)/airbrakes.c: $(FLIGHTS)/%.c: examples/mission/%.sm $(FLIGHTS)/rocket.sv $(B)/smc
	$(call say,SMC)$(B)/smc build --emit=c --runtime --sv $(FLIGHTS)/rocket.sv -o $@ $<
$(FLIGHTS)/flight.smb: examples/mission/mission.sm examples/mission/airbrakes.sm $(FLIGHTS)/rocket.sv $(B)/smc
	$(call say,SMC)$(B)/smc build --sv $(FLIGHTS)/rocket.sv -o $@ examples/mission/mission.sm examples/mission/airbrakes.sm
$(FLIGHTS)/%.trace: examples/mission/%.ss examples/mission/mission.sm examples/mission/airbrakes.sm $(FLIGHTS)/rocket.sv $(B)/smc
	@$(B)/smc test --sv $(FLIGHTS)/rocket.sv --trace=$@ --trace-format=exact examples/mission/$(firstword $(subst -, ,$*)).sm $< >$@.log
$(FLIGHTS)/flights: tests/runtime/flights/flights.c $(FLIGHT_RUNTIME) $(B)/runtime/sim.a
	$(call say,CC)$(CC) $(STRICT_C) -I$(FLIGHTS) $(WARN) $(CFLAGS) $^ -o $@

# `make bench-machine`: the instructions of a step as a task of the runtime.
$(FLIGHTS)/plain_mission.c: examples/mission/mission.sm examples/mission/rocket.sv $(B)/smc
	$(call say,SMC)$(B)/smc build --emit=c --runtime --prefix=plain_mission --sv examples/mission/rocket.sv -o $@ $<
BENCH_MACHINE = tests/bench/machine.c $(FLIGHTS)/rocket.c $(FLIGHTS)/mission.c $(FLIGHTS)/plain_mission.c $(RUNTIME_SRC_linux)
bench-machine: $(BENCH_MACHINE) $(FLIGHTS)/flight.smb
	$(CC) $(STRICT_C) -O2 -I$(FLIGHTS) $(BENCH_MACHINE) -o $(FLIGHTS)/bench -pthread -lrt
	@sh tests/bench/machine_cost.sh $(FLIGHTS)/bench $(FLIGHTS)/flight.smb
.PHONY: bench-machine

# tests/clauses
HOST         = $(OS_FILES) $(wildcard compiler/device/*.c)
CLAUSE_TESTS = $(B)/clauses/steps $(B)/clauses/memory $(B)/clauses/regions
$(B)/clauses/probe.c: tests/clauses/probe.sm tests/clauses/probe.sv $(B)/smc
	@mkdir -p $(@D)
	@$(B)/smc build tests/clauses/probe.sm --sv=tests/clauses/probe.sv --emit=c -o $@
$(B)/clauses/probe.smb: tests/clauses/probe.sm tests/clauses/probe.sv $(B)/smc
	@mkdir -p $(@D)
	@$(B)/smc build tests/clauses/probe.sm --sv=tests/clauses/probe.sv -o $@
$(B)/clauses/steps $(B)/clauses/regions: $(B)/clauses/%: tests/clauses/%.c $(HOST:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -o $@ $^
$(B)/clauses/memory: tests/clauses/memory.c $(B)/clauses/probe.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -I$(B)/clauses $(WARN) $(CFLAGS) -o $@ $^

# docs/diagnostics.md, generated from codes.def by `make docs`.
DIAGNOSTICS = $(B)/diagnostics | LC_ALL=C awk -f tests/check/wrap.awk
docs: $(B)/diagnostics
	$(DIAGNOSTICS) >docs/diagnostics.md
.PHONY: docs

# The grammars in editors/, generated from the tables of the compiler.
grammars: $(B)/editors
	$(B)/editors textmate >editors/smc.tmLanguage.json
	$(B)/editors vim >editors/vim/syntax/smc.vim
.PHONY: grammars

# Wraps the prose of documents at 100 columns.
wrap-docs:
	@sh tests/check/files.sh documents | xargs sh tests/check/wrap.sh -w
.PHONY: wrap-docs

# The schema for the test `sarif`.
sarif-schema:
	sh tests/check/sarif_schema.sh $(B)/sarif/schema.json
.PHONY: sarif-schema

# `make mutants` breaks the implementation line by line; the cases must notice each fault.  `make faults`: random programs and the tests of
# soft numbers and of the store must notice.  An hour each.  `make mutants M="6 7.12"`: some clauses; `M=100-200`, `M=100-`: lines of the list.
mutants faults:
	@CC='$(CC)' CFLAGS=$(if $(filter faults,$@),-O1,-O0) sh tests/check/mutants.sh tests/check/$@.txt $(B)/$@ $(M)
.PHONY: mutants faults

# ---- part 2: the tests ----

# The order is the order in which they start.  Those that take most processor seconds come first in their part, so that the last ones to run are
# short.

# quick: no other compiler, no campaign.

$(call test, golden,               quick, $(B)/golden, $(B)/golden $(B)/smc tests/golden/*.smt)
$(call test, analysis,             quick,, $(B)/smc test tests/analysis/*.smt)
$(call test, conformance,          quick,, $(B)/smc test --engine=ref,vm conformance)
UNIT_SLOW = fault_pairs vm_mutate vm_switch vm_decode stdlib_roll stdlib_roll_small stdlib_roll_emitted search_run
$(foreach u,$(filter-out $(UNIT_SLOW:%=$(B)/unit/%),$(UNIT)) $(B)/unit/stdlib_convert_small,$(call test,$(notdir $(u)),quick,$(u),$(u)))
$(call test, ir,                   quick, $(B)/ir/run, $(B)/ir/run tests/ir/*.smt tests/ir/samples/*.ir conformance/*/*.smt)
$(call test, ir-verify,            quick, $(B)/ir/verify, $(B)/ir/verify)
$(call test, ir-read,              quick, $(B)/ir/read, $(B)/ir/read)
$(call test, data,                 quick,, sh tests/data/run.sh $(B)/smc)
$(call test, script,               quick,, $(B)/smc test tests/script)
$(call test, graph-layout,         quick, $(B)/graph/layout, $(B)/graph/layout tests/graph/machines/*.sm)
$(call test, clauses-steps,        quick, $(B)/clauses/steps, $(B)/clauses/steps)
$(call test, clauses-memory,       quick, $(B)/clauses/memory $(B)/clauses/probe.smb, $(B)/clauses/memory $(B)/clauses/probe.smb)
$(call test, library-api,          quick, $(B)/library/api, $(B)/library/api)
$(call test, library-machines,     quick, $(B)/library/machines, $(B)/library/machines)
$(call test, library-locale,       quick, $(B)/library/api, sh tests/library/locale.sh $(B)/library/api)
$(call test, library-refuse,       quick, $(B)/library/refuse, $(B)/library/refuse)
$(call test, library-broken,       quick, $(B)/library/broken, $(B)/library/broken)
$(call test, library-memory,       quick, $(B)/library/memory, $(B)/library/memory)
$(call test, library-threads,      quick, $(B)/library/threads, $(B)/library/threads)
$(call test, library-random,       quick, $(B)/library/random, $(B)/library/random 1 500)
$(call test, library-calls,        quick, , sh tests/library/calls.sh)
$(call test, swap-clauses,         quick, $(B)/swap/clauses, $(B)/swap/clauses)
$(call test, clauses-regions,      quick, $(B)/clauses/regions, $(B)/clauses/regions)
$(call test, fixes,                quick, $(B)/fixes, $(B)/fixes tests/check/fixes.txt conformance/*/*.smt tests/*/*.smt tests/*/long/*.smt README.md docs/*.md examples/*/*.sm tests/findings/*/*.sm)
$(call test, fragments,            quick, $(B)/fragments, $(B)/fragments tests/check/fragments.txt)
$(call test, diagnostics,          quick, $(B)/diagnostics, $(DIAGNOSTICS) | cmp - docs/diagnostics.md && echo 1 passed$(,) 0 failed)
$(call test, editors,              quick, $(B)/editors, sh tests/check/editors.sh $(B)/editors)
$(call test, graph-docs,           quick,, $(B)/smc graph examples/ignition/ignition.sm | cmp - docs/ignition.svg && $(B)/smc graph examples/tank/tank.sm | cmp - docs/tank.svg && echo 2 passed$(,) 0 failed)

$(call test, prove-author-scripts, quick,, sh tests/prove/author.sh --scripts $(B)/smc)

# The house rules.
$(call test, runner,               quick,, sh tests/check/runner.sh)
$(call test, check-commits,        quick,, sh tests/check/commits_test.sh)
$(call test, check-mutants,        quick,, sh tests/check/mutants_test.sh)
$(call test, mutants-places,       quick,, sh tests/check/mutants.sh --places tests/check/mutants.txt tests/check/faults.txt)
$(call test, check-words,          quick,, sh tests/check/files.sh text | awk -f tests/check/words.awk tests/check/words.txt -)
$(call test, check-wrap,           quick,, sh tests/check/files.sh documents | xargs sh tests/check/wrap.sh)
$(call test, check-sentences,      quick,, sh tests/check/files.sh documents | grep -v '^docs/evidence/' | LC_ALL=C awk -f tests/check/sentences.awk)
$(call test, documents,            quick,, sh tests/check/documents.sh)
$(call test, check-links,          quick,, { sh tests/check/files.sh text; echo LICENSE; echo --; sh tests/check/files.sh documents | grep -v '^docs/evidence/'; } | LC_ALL=C awk -f tests/check/links.awk)
$(call test, check-layers,         quick,, sh tests/check/files.sh code | awk -f tests/check/layers.awk tests/check/layers.txt -)
$(call test, check-hints,          quick,, sh tests/check/files.sh cases | awk -f tests/check/hints.awk compiler/syntax/hints.h compiler/syntax/hints.def -)
$(call test, check-codes,          quick,, sh tests/check/files.sh cases | awk -f tests/check/codes.awk compiler/diag/flags.def compiler/diag/codes.def tests/check/codes.txt -)
$(call test, check-builtins,       quick,, sh tests/check/builtins.sh)
$(call test, check-arguments,      quick,, sh tests/check/files.sh compiler | awk -f tests/check/arguments.awk compiler/diag/codes.def compiler/syntax/hints.def compiler/sema/foreign_names.def -)
$(call test, check-clauses,        quick,, sh tests/check/files.sh evidence | awk -f tests/check/clauses.awk docs/language.md docs/config.md docs/swapping.md docs/requirements.md tests/check/clauses.txt -)
$(call test, check-citations,      quick,, sh tests/check/files.sh sources | awk -f tests/check/citations.awk docs/language.md docs/config.md docs/swapping.md docs/requirements.md -)
$(call test, check-licence,        quick,, sh tests/check/files.sh code | awk -f tests/check/licence.awk)
$(call test, check-columns,        quick,, sh tests/check/files.sh code | LC_ALL=C awk -f tests/check/columns.awk tests/check/columns.txt -)
$(call test, check-last-return,    quick,, sh tests/check/files.sh code | awk -f tests/check/last_return.awk)
$(call test, check-places,         quick,, sh tests/check/files.sh text | awk -f tests/check/places.awk)
$(call test, check-configurations, quick,, sh tests/check/configurations.sh)
$(call test, check-headers,        quick,, CC='$(CC)' sh tests/check/headers.sh c -I$(B)/gen)
$(call test, check-purposes,       quick,, sh tests/check/files.sh product | awk -f tests/check/purposes.awk)
$(call test, check-folders,        quick,, sh tests/check/folders.sh)
$(call test, check-names,          quick,, sh tests/check/files.sh product | awk -f tests/check/names.awk tests/check/names.txt -)
IMPORTS = $(patsubst %.c,$(B)/obj/%.o,$(filter-out $(VM_TEXT),$(VM)) $(STDLIB) $(wildcard runtime-c/*.c bytecode-vm/target/*.c))
$(call test, check-imports,        quick, $(IMPORTS), sh tests/check/imports.sh $(IMPORTS))

# thorough: the rest of what needs cc and make only.

$(call test, check-docs,           thorough,, sh tests/check/docs.sh $(B)/smc $(B)/docs README.md */README.md docs/*.md)
$(call test, fault-command,        thorough, $(B)/fault/shim.so, sh tests/fault/command.sh $(B)/smc $(B)/fault/shim.so)
$(call test, report,               thorough,, sh tests/report/run.sh $(B)/smc $(B)/report)
$(call test, findings-seeded,      thorough,, sh tests/findings/seeded.sh $(B)/smc)
$(call test, examples$(SHORT),     thorough,, sh tests/check/examples.sh $(B)/smc $(if $(SANITIZED),--once) $(patsubst %/,%,$(sort $(dir $(wildcard examples/*/*.sm)))))
$(call test, findings$(SHORT),     thorough,, sh tests/findings/run.sh $(B)/smc $(if $(SANITIZED),--every=2))
$(call test, golden-long$(SHORT),  thorough, $(B)/golden, $(B)/golden $(B)/smc tests/golden/long/$(if $(SANITIZED),prove-near,*).smt)
$(call test, analysis-long,        thorough,, $(B)/smc test tests/analysis/long)
# Emitted C at -O1, as smc test builds it; -O0 builds faster.
LEVELS ?= 0 1 2
$(foreach level,$(LEVELS),$(call test,conformance-O$(level),thorough,,$(if $(filter-out 2,$(level)),CC='$(CC) -O0' )$(B)/smc test -O$(level) conformance))
# Emitted C with numbers in software, as --soft writes it.
$(call test, conformance-c-small,  thorough,, CC='$(CC) -O0 -DSM_ROLL_SMALL=1' $(B)/smc test --engine=ref,c conformance/07-windows)
$(call test, conformance-c-soft,   thorough,, CC='$(CC) -O0' $(B)/smc test --engine=ref,c-soft conformance)
$(foreach u,$(UNIT_SLOW),$(call test,$(u),thorough,$(B)/unit/$(u),$(B)/unit/$(u)))
$(call test, check-headers-targets, thorough,, CC='$(CC)' sh tests/check/headers.sh targets)
$(call test, ci-pages,             thorough,, sh tests/check/ci_pages.sh $(B)/smc $(B)/ci-pages)
$(call test, applications,         thorough, $(RUNTIME_ARCHIVES), sh tests/check/applications.sh $(B)/smc '$(CC)' $(B)/runtime $(patsubst %/,%,$(dir $(wildcard examples/*/*.app))))
$(call test, flight-docs,          thorough, $(B)/flight/flight.log, $(FLIGHT_SVG) | cmp - docs/flight.svg && echo 1 passed$(,) 0 failed)
$(call test, graph-read,           thorough,, sh tests/graph/read.sh $(B)/smc tests/graph/machines/*.sm)
$(call test, outputs$(SHORT),      thorough, $(B)/corpus/log/flight.log, sh tests/outputs/run.sh $(B)/smc $(B)/corpus/log/flight.log $(if $(SANITIZED),short))
$(call test, junit,                thorough,, sh tests/check/junit.sh $(B)/smc $(B)/junit)
$(call test, sarif,                thorough,, sh tests/check/sarif.sh $(B)/smc $(B)/sarif conformance/11-errors/*.smt tests/analysis/*.smt tests/analysis/long/*.smt)
$(call test, analysis-effort,      thorough,, sh tests/analysis/effort.sh $(B)/smc)
$(call test, log,                  thorough, $(B)/runtime/log, sh tests/log/run.sh $(B)/smc $(B)/runtime/log $(B)/log)
$(call test, app,                  thorough, $(B)/runtime/sim.a $(B)/runtime/desk.a, sh tests/app/run.sh $(B)/smc $(B)/runtime/sim.a '$(CC)' $(B)/runtime/desk.a)
$(call test, net,                  thorough, $(B)/runtime/linux.a, sh tests/net/run.sh $(B)/smc $(B)/runtime/linux.a '$(CC)')
$(call test, net-stream,           thorough, $(B)/runtime/linux.a, sh tests/net/stream.sh $(B)/smc $(B)/runtime/linux.a '$(CC)')
$(call test, net-multicast,        thorough, $(B)/runtime/linux.a, sh tests/net/multicast.sh $(B)/smc $(B)/runtime/linux.a '$(CC)')
$(call test, net-dictionary,       thorough, $(B)/net/packets, sh tests/net/dictionary.sh $(B)/smc $(B)/net/packets '$(CC)')
$(call test, net-hostile,          thorough, $(B)/net/hostile, $(B)/net/hostile 1 100000)
$(call test, net-hostile-stream,   thorough, $(B)/net/hostile_stream, $(B)/net/hostile_stream 1 2000)
$(call test, compile-memory,       thorough, $(B)/bench/memory, $(B)/bench/memory)
$(call test, cost,                 thorough, $(B)/cost, $(B)/cost)
$(call test, emitc-flow,           thorough, $(B)/emitc/flow, $(B)/emitc/flow 100)
$(call test, emitc-typed,          thorough, $(B)/emitc/typed, $(B)/emitc/typed 100)
$(call test, soft,                 thorough, $(B)/soft/run, $(B)/soft/run)
$(call test, elementary-bits,      thorough, $(B)/elementary/bits, $(B)/elementary/bits)
$(call test, soft-engine,          thorough, $(VM_SOFT), sh tests/soft/engine.sh $(VM_SOFT))

$(call test, scripts-random,       quick, $(B)/cover/scripts, $(B)/cover/scripts 1 200)
$(call test, exhaustive$(SHORT),   thorough, $(B)/cover/exhaustive, $(B)/cover/exhaustive 3000 $(if $(SANITIZED),50,200))
$(call test, search,               thorough, $(B)/search/bench, $(B)/search/bench --effort=32000000 --expect=tests/search/expected.txt)
$(call test, cover,                thorough, , sh tests/cover/cover.sh $(B)/smc)
$(call test, mutation$(SHORT),     thorough, , sh tests/cover/mutate.sh $(B)/smc $(if $(SANITIZED),10))
$(call test, kept,                 thorough, , sh tests/cover/kept.sh $(B)/smc)
$(call test, mutation-verdicts,    thorough, , sh tests/cover/verdicts.sh $(B)/smc)
$(call test, mutation-equivalent,  thorough, $(B)/equivalent, $(B)/equivalent 15)
$(call test, whatif$(SHORT),       thorough, , sh tests/whatif/run.sh $(B)/smc $(if $(SANITIZED),short))
$(call test, diff,                 thorough, $(B)/diff/difftest, $(B)/diff/difftest --seed=40012098 --count=1 --no-floors --out=$(B)/diff/check-seed && $(B)/diff/difftest --seed=40024584 --count=1 --no-floors --out=$(B)/diff/check-seed && $(B)/diff/difftest --seed=41961545 --count=1 --no-floors --out=$(B)/diff/check-seed && $(B)/diff/difftest --count=2000 --jobs=2 --out=$(B)/diff/check)
$(call test, library-parity$(SHORT), thorough, $(B)/library/command, sh tests/library/parity.sh $(B)/smc $(B)/library/command $(if $(SANITIZED),4))
$(call test, library-swapping,     thorough, $(B)/smc $(LIBRARY_FILES), sh tests/library/swapping.sh $(MAKE) $(B) '$(CC)' '$(CFLAGS)')
$(call test, library-abi,          thorough, $(LIBRARY_FILES), sh tests/library/abi.sh $(B) '$(CC)')
$(call test, swap-running,         thorough, $(B)/swap/running, $(B)/swap/running)
$(call test, swap-storing,         thorough, $(B)/swap/storing, $(B)/swap/storing)
$(call test, swap-link,            thorough, $(B)/swap/link, $(B)/swap/link)
$(call test, swap-reach,           thorough, $(B)/swap/reach $(B)/smc, $(B)/swap/reach $(B)/smc)
$(call test, swap-killed,          thorough, $(B)/swap/killed, $(B)/swap/killed)
$(call test, swap-threads,         thorough, $(B)/swap/threads, $(B)/swap/threads)
$(call test, swap-tsan,            thorough, $(B)/swap/threads_tsan, if test -x $(B)/swap/threads_tsan; then $(B)/swap/threads_tsan; else echo 0 passed$(,) 0 failed$(,) 1 skipped; fi)
$(call test, joint-random,         thorough, $(B)/joint/random, $(B)/joint/random 1 300)
$(call test, joint-sim,            thorough, $(B)/joint/random $(B)/smc $(B)/runtime/sim.a, sh tests/joint/sim.sh $(B)/smc $(B)/joint/random $(B)/runtime/sim.a '$(CC)' 6)
$(call test, compare-random,       thorough, $(B)/compare/random, $(B)/compare/random 1 150)
$(call test, prove-random,         thorough, $(B)/prove/random, $(B)/prove/random 1 40)
$(call test, prove-apps,           thorough, $(B)/prove/apps, $(B)/prove/apps 240 60)
$(call test, prove-interrupted,    thorough,, sh tests/prove/interrupted.sh $(B)/smc)
$(call test, why-random,           thorough, $(B)/why/random, $(B)/why/random 1 1500)
$(call test, requirements-random,  thorough, $(B)/requirements/random, $(B)/requirements/random 1 2000)
$(call test, swap-random,          thorough, $(B)/swap/random, $(B)/swap/random 1 1000)
$(call test, swap-hostile,         thorough, $(B)/swap/hostile, $(B)/swap/hostile 1 3000)
$(call test, sound$(SHORT),        thorough, $(B)/diff/difftest, $(SOUND) --count=$(if $(SANITIZED),60,300) --jobs=2 --out=$(B)/diff/check-sound)
$(call test, diff-c,               thorough, $(B)/diff/difftest, $(B)/diff/difftest --count=25 --forms=012h --cc='$(CC) -std=c99 -O1' --out=$(B)/diff/check-c)
$(call test, diff-c-soft,          thorough, $(B)/diff/difftest, $(B)/diff/difftest --count=10 --forms=012h --cc-soft='$(CC) -std=c99 -O1' --out=$(B)/diff/check-c-soft)
$(call test, fuzz-script,          thorough, $(B)/fuzz/script, $(B)/fuzz/script -n 2000 conformance/0[678]*/*.smt tests/script/*.smt)
$(call test, fuzz-frontend,        thorough, $(B)/fuzz/frontend, $(B)/fuzz/frontend -n 5000 tests/fuzz/seeds/frontend/*)
$(call test, fuzz-ir,              thorough, $(B)/fuzz/ir, $(B)/fuzz/ir -n 2000 tests/ir/samples/*.ir)
$(call test, fuzz-log,             thorough, $(B)/fuzz/log $(B)/corpus/log/flight.log, $(B)/fuzz/log -n 1000 $(B)/corpus/log/flight.log)
$(call test, fuzz-recording,       thorough, $(B)/fuzz/recording, $(B)/fuzz/recording -n 20000 tests/fuzz/seeds/recording/*)
$(call test, fuzz-image,           thorough, $(B)/fuzz/image $(B)/corpus/image, $(B)/fuzz/image -n 20000 $(B)/corpus/image/*.smb)
$(call test, fuzz-swap,            thorough, $(B)/fuzz/swap, $(B)/fuzz/swap -n 5000 tests/fuzz/seeds/swap/*)
$(call test, fuzz-link,            thorough, $(B)/fuzz/link $(LINK_SEEDS), $(B)/fuzz/link -n 20000 $(LINK_SEEDS))

$(call test, fault-memory,         thorough, $(B)/fault/memory, $(B)/fault/memory $(FAULT_CASES))
$(call test, host-folders,         thorough, $(B)/host/folders, $(B)/host/folders)
$(call test, host-files,           thorough, $(B)/host/files, $(call HOST_FOLDER,files) $(B)/host/files $(B)/host/files.made)
$(call test, host-signals,         thorough, $(B)/host/signals, $(call HOST_FOLDER,signals) $(B)/host/signals $(abspath $(B))/smc $(abspath examples)/tank/tank.sm $(abspath examples)/tank/tank.ss $(abspath $(B))/host/signals.made)
$(call test, host-names,           thorough, $(B)/flight/flight.log, sh tests/host/names.sh $(B)/smc $(B)/host/names.made $(B)/flight/flight.log)

$(foreach p,linux sbrio sim desk none,$(call test,psl-$(p),thorough,$(B)/psl/$(p)/suite,$(B)/psl/$(p)/suite))
NEEDS_thorough += $(B)/psl/linux/runtime-c/psl/linux/watchdog.o
$(call test, +sbrio,               thorough,, sh tests/sbrio/run.sh '$(MAKE)' $(B) '$(CC)')
# A program under the thread sanitizer is not there if the compiler lacks it.
$(call test, psl-tsan,             thorough, $(B)/psl/tsan, if test -x $(B)/psl/tsan; then $(B)/psl/tsan; else echo 0 passed$(,) 0 failed$(,) 1 skipped; fi)
$(foreach t,$(RUNTIME_TESTS),$(call test,runtime-$(notdir $(t)),thorough,$(t),$(t)))
$(foreach t,$(RUNTIME_TSAN),$(call test,runtime-$(notdir $(t)),thorough,$(t),if test -x $(t); then $(t); else echo 0 passed$(,) 0 failed$(,) 1 skipped; fi))
$(call test, runtime-flights,      thorough, $(FLIGHTS)/flights $(FLIGHTS)/flight.smb $(FLIGHT_TRACES), $(FLIGHTS)/flights $(FLIGHTS)/flight.smb $(FLIGHT_TRACES))
$(call test, store,                thorough, $(B)/store/cuts $(STORE_SMB), $(B)/store/cuts $(STORE_SMB))
$(call test, store-parameters,     thorough, $(B)/store/cuts $(LIMITS_SMB) $(LIMITS_SET), $(B)/store/cuts $(LIMITS_SMB) $(LIMITS_SET))
$(call test, agent,                thorough, $(B)/store/agent $(STORE_SMB) $(LIMITS_SMB), $(B)/store/agent $(STORE_SMB) $(LIMITS_SMB))
$(call test, agent-parameters,     thorough, $(B)/store/agent $(LIMITS_SMB) $(LIMITS_SET), $(B)/store/agent $(LIMITS_SET) $(LIMITS_SMB) $(LIMITS_SMB))
$(call test, agent-log,            thorough, $(B)/store/agent_log $(STORE_SMB), $(B)/store/agent_log $(STORE_SMB))
$(call test, agent-log-parameters, thorough, $(B)/store/agent_log $(LIMITS_SMB) $(LIMITS_SET), $(B)/store/agent_log $(LIMITS_SET) $(LIMITS_SMB))
$(call test, older-boards,         thorough, $(B)/store/older $(LIMITS_SMB), $(B)/store/older $(LIMITS_SMB))
$(call test, auth,                 thorough, $(B)/store/auth $(STORE_SMB), $(B)/store/auth $(STORE_SMB))
$(call test, device,               thorough, $(B)/device/link $(B)/device/board $(STORE_SMB) $(LIMITS_SMB), $(DEVICE_RUN))

# targets: other compilers and processors, emulated boards, measurements.

# smc.exe and smc.dll, before `python`, which packs them.  Those for 32 bits do not run in `make check`, so they are built fast.
WINDOWS_RUN = '$(MAKE)' '$(B)' '$(CC)'
$(call test, +windows-x86-64,      targets,, sh tests/windows/exports.sh $(WINDOWS_RUN) x86_64 -O2)
$(call test, +windows-x86-32,      targets,, sh tests/windows/exports.sh $(WINDOWS_RUN) i686 -O0)
$(call test, +firmware,            targets, $(B)/device/link $(STORE_SMB) $(LIMITS_SMB), sh tests/avr/firmware.sh '$(MAKE)' $(B) '$(CC)')
$(call test, +processors,          targets, $(B)/diff/difftest $(B)/targets/cases $(RUNTIME_MADE), sh tests/targets/run.sh $(B))
# These two build in folders of their own.
$(call test, native-x86-32,        targets, $(B)/golden, sh tests/targets/native.sh $(B) '$(MAKE)' x86-32)
$(call test, tcc,                  targets, $(B)/golden, sh tests/targets/tcc.sh $(B) '$(MAKE)')
$(call test, +sizes,               targets,, sh tests/bench/sizes.sh $(B) '$(CC)' '$(MAKE)')
$(call test, +install,             targets,, sh tests/install/run.sh $(MAKE) $(B) '$(CC)')
$(call test, +library-programs,    targets,, sh tests/library/programs.sh $(MAKE) $(B) '$(CC)')
$(call test, +python,              targets,, sh tests/python/run.sh $(MAKE) $(B) '$(CC)')
$(call test, emitc,                targets,, sh tests/emitc/run.sh $(B)/smc)
$(call test, emulated,             targets,, sh tests/avr/emulated.sh '$(MAKE)' $(B) '$(CC)')
$(call test, avr,                  targets, $(B)/diff/difftest, sh tests/avr/run.sh $(B) '$(CC)')
$(call test, avr-cycles,           targets,, sh tests/avr/cycles.sh $(B) '$(CC)')
$(call test, avr-c,                targets, $(B)/diff/difftest $(B)/targets/cases, sh tests/avr/c.sh $(B) '$(CC)')
$(call test, arduino,              targets, arduino, CC='$(CC)' sh tests/arduino/run.sh $(B) $(ARDUINO) '$(VERSION)')
$(call test, app-targets,          targets, $(RUNTIME_MADE), sh tests/targets/app.sh $(B) '$(CC)')
$(call test, runtime-targets,      targets,, CC='$(CC)' sh tests/runtime/targets.sh $(B)/smc)
$(call test, +sbrio-arm,           targets,, sh tests/sbrio/run.sh '$(MAKE)' $(B) '$(CC)' arm)
$(call test, models,               targets,, sh tests/check/models.sh $(STRICT_C) $(WARN))
# tests/windows: smc.exe and smc.dll under Wine.  `make windows-campaign` runs the same as 32-bit programs, which needs a Wine that has them.
$(call test, +windows-same,        targets,, sh tests/windows/same.sh $(WINDOWS_RUN) x86_64)
$(call test, +windows-golden,      targets, $(B)/golden, sh tests/windows/golden.sh $(WINDOWS_RUN) x86_64)
$(call test, +windows-files,       targets,, sh tests/windows/files.sh $(WINDOWS_RUN) x86_64)
$(call test, +windows-serial,      targets, $(B)/device/board, sh tests/windows/serial.sh $(WINDOWS_RUN) x86_64)
$(call test, +windows-labview,     targets,, sh tests/windows/labview.sh $(WINDOWS_RUN) x86_64)
$(call test, +windows-console,     targets,, sh tests/windows/console.sh $(WINDOWS_RUN) x86_64)
windows-campaign: all $(B)/golden $(B)/device/board
	@rm -rf $(B)/windows-i686 && $(MAKE) windows-i686
	@for t in same golden files serial labview console; do MUST_RUN=1 sh tests/windows/$$t.sh $(WINDOWS_RUN) i686 || exit 1; done
.PHONY: windows-campaign
$(call test, compile-instructions, targets, $(B)/bench/scale, sh tests/bench/instructions.sh $(B) '$(CC)' '$(CFLAGS)')
$(call test, bench,                targets, $(B)/bench/steps $(B)/bench/compile $(B)/bench/scale, $(B)/bench/steps $(B)/bench check)
$(call test, bench-report,         targets,, sh tests/check/bench_report.sh)
$(call test, coverage-cost,        targets,, sh tests/bench/coverage.sh $(B)/smc)

# ---- running them ----

$(if $(filter-out $(ROWS),$(ASAN_LEAVES_OUT)),$(error ASAN_LEAVES_OUT names tests that do not exist: $(filter-out $(ROWS),$(ASAN_LEAVES_OUT))))
quick: all $(NEEDS_quick)
	$(call run_parts,quick)
check: all $(foreach part,$(PARTS),$(NEEDS_$(part)))
	$(call run_parts,$(PARTS))
check-thorough: all $(NEEDS_thorough)
	$(call run_parts,thorough)
check-targets: all $(NEEDS_targets)
	$(call run_parts,targets)
list-files:
	@sh tests/check/files.sh product | awk -v list=1 -f tests/check/purposes.awk
list-tests:
	@printf '%s\n' $(foreach part,$(PARTS),"[$(part)]" $(LINES_$(part)))
.PHONY: quick check check-thorough check-targets list-tests list-files

# All tests of a folder.
check-graph: check-graph-layout check-graph-read check-graph-docs
check-host: check-host-files check-host-folders check-host-signals check-host-names
check-runtime: $(patsubst $(B)/runtime/%,check-runtime-%,$(RUNTIME_TESTS) $(RUNTIME_TSAN)) check-runtime-flights
.PHONY: check-graph check-host check-runtime
.PHONY: asan bench bench-scale check-mutate update-golden test fuzz
