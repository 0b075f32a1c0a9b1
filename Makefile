# SPDX-License-Identifier: Apache-2.0
# Builds smc with a C compiler and make, nothing else.  `make help` lists the targets.

B       ?= build
CC      ?= cc
AR      ?= ar
CFLAGS  ?= -O2
DEPFLAGS ?= $(if $(findstring tcc,$(CC)),-MD,-MMD -MP)
PREFIX  ?= /usr/local
WARN     = -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -pedantic
# The meaning of a program rests on plain IEEE arithmetic: no contraction of a*b+c, whatever CFLAGS says.  And gcc 12 at -O2 drops
# the rounding of (double)(float)x where its SLP vectoriser does two of them at once.
STRICT_C = -std=c99 -ffp-contract=off -fno-tree-slp-vectorize -I. -I$(B)/gen

VERSION := $(shell sed -n 's/.*SMC_VERSION "\(.*\)".*/\1/p' compiler/version.h)

# Sources, folder by folder in the order data flows through them.
STDLIB   = $(wildcard stdlib/*.c)
VM       = $(wildcard bytecode-vm/*.c)
VM_TEXT  = $(wildcard bytecode-vm/disasm*.c)
VM_FAST  = $(wildcard bytecode-vm/decode*.c) bytecode-vm/fast.c
LINK     = $(wildcard runtime-c/link/*.c)
EMIT_C   = $(filter-out %/embed_tool.c,$(wildcard compiler/emit/c/*.c))
LIBSMC   = $(filter-out compiler/base/os_%,$(wildcard compiler/base/*.c)) $(wildcard compiler/diag/*.c compiler/syntax/*.c compiler/sema/*.c compiler/ir/*.c \
             compiler/facts/*.c compiler/passes/*.c compiler/analysis/*.c compiler/budget/*.c) $(EMIT_C) $(wildcard compiler/emit/bytecode/*.c compiler/report/*.c compiler/script/*.c compiler/log/*.c compiler/*.c) $(STDLIB) $(VM) $(LINK)
COMMAND  = $(wildcard compiler/base/os_*.c compiler/device/*.c compiler/cli/*.c)

# `make V=1` shows the commands themselves, `make -s` nothing.
say = $(if $(V)$(findstring s,$(firstword -$(MAKEFLAGS))),,@echo '  $(1)  $(patsubst $(B)/%,%,$@)';)

all: $(B)/smc

$(B)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) -c $< -o $@

# The engine vm-soft: the VM once more as on a chip, with soft numbers and its tables kept, its names changed so that both fit in one
# program.
VM_SOFT = $(patsubst %.c,$(B)/soft/obj/%.o,compiler/script/engine_vm.c $(VM))
$(B)/gen/soft_names.h: $(wildcard bytecode-vm/*.[ch]) compiler/script/engine_vm.c
	@mkdir -p $(@D)
	$(call say,GEN)cat $^ | tr -c 'a-z0-9_' '\n' | grep '^smvm_\|^engine_vm_' | sort -u | \
	    sed -e 's/.*/#define & soft_&/' -e 's/soft_engine_vm_open/engine_vm_soft_open/' >$@.new && mv $@.new $@
$(B)/soft/obj/%.o: %.c $(B)/gen/soft_names.h
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -DSM_F64_SOFT=1 -DSMVM_KEEP_TABLES=1 -include $(B)/gen/soft_names.h $(WARN) $(CFLAGS) $(DEPFLAGS) -c $< -o $@

# What need not be fast is built in half the time.  (The command only tests with the VM; make bench measures it at -O2.)
SELDOM = $(filter compiler/cli/% compiler/device/% compiler/diag/% compiler/report/% compiler/log/% compiler/script/%,$(LIBSMC) $(COMMAND))
$(B)/obj/bytecode-vm/interp.o $(B)/obj/bytecode-vm/fast.o $(SELDOM:%.c=$(B)/obj/%.o): override CFLAGS := $(CFLAGS:-O2=-O1)
$(VM_SOFT): override CFLAGS := $(patsubst -O%,-O0,$(CFLAGS))

$(B)/libsmc.a: $(LIBSMC:%.c=$(B)/obj/%.o) $(VM_SOFT)
	@rm -f $@
	$(call say,AR)$(AR) rcs $@ $^

$(B)/smc: $(COMMAND:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# The texts of the stdlib functions that emitted C quotes.
EMBEDDED = stdlib/f64.h stdlib/convert.h stdlib/math.h stdlib/roll.h
$(B)/embed_tool: compiler/emit/c/embed_tool.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) -std=c99 -pedantic -Wall -Wextra $< -o $@

$(B)/gen/stdlib_text.h: $(B)/embed_tool $(EMBEDDED)
	@mkdir -p $(@D)
	$(call say,GEN)$(B)/embed_tool $(EMBEDDED) >$@.new && mv $@.new $@

# Soft binary64 as it goes with emitted C for chips without it.
SOFT_EMBEDDED = header:stdlib/soft.h,stdlib/f64_soft.h cells:stdlib/soft_cells.h \
                code:stdlib/soft_pack.h,stdlib/soft_arith.c,stdlib/soft_convert.c,stdlib/soft_cells.c \
                assembly:stdlib/soft_pack.h,stdlib/soft_avr.S,stdlib/soft_cells_avr.S
$(B)/gen/soft_text.h: $(B)/embed_tool $(wildcard stdlib/*soft*)
	@mkdir -p $(@D)
	$(call say,GEN)for f in $(SOFT_EMBEDDED); do $(B)/embed_tool -lines soft_$${f%%:*} $$(echo $${f#*:} | tr , ' ') || exit 1; done >$@.new && mv $@.new $@

$(EMIT_C:%.c=$(B)/obj/%.o): | $(B)/gen/stdlib_text.h $(B)/gen/soft_text.h

# One program per file of tests/unit.
UNIT = $(patsubst tests/unit/%.c,$(B)/unit/%,$(wildcard tests/unit/*.c))
$(B)/unit/%: tests/unit/%.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/libsmc.a -lm
# What stdlib does another way where code is to be small.
$(B)/unit/stdlib_convert_small: tests/unit/stdlib_convert.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -Os $(DEPFLAGS) $< -o $@ $(B)/libsmc.a -lm
check: $(B)/unit/stdlib_convert_small
CHECK_LINES += "stdlib_convert_small: $(B)/unit/stdlib_convert_small"

# ---- tests ----

# `make check` needs cc and make only; what wants more is skipped and says so (STRICT=1: a skip is a failure).
# A line a test: its name (behind a + if it calls make), a colon, the command; each ends with "N passed, N failed".
# OTHERS_LINES are about what other compilers and boards make of it, and what is measured: they take long, and what runs of ours
# has run in other lines.
# Files are named by patterns, which the command's own shell spells out: all lines together are one argument, and that has a limit of 128 KB.
UNIT_LINES = $(foreach u,$(UNIT),"$(notdir $(u)): $(u)")

check: all $(UNIT)
	@printf '%s\n' $(UNIT_LINES) $(CHECK_LINES) $(OTHERS_LINES) | sh tests/run.sh

# `make list-tests`: those lines; `make mutants` finds by their names what has to notice a fault.
list-tests:
	@printf '%s\n' $(UNIT_LINES) $(CHECK_LINES) $(OTHERS_LINES)
.PHONY: list-tests

CHECK_LINES += "runner: sh tests/check/runner.sh"

# `make test T=folder-or-file` runs some conformance cases.
T ?= conformance
test: all
	$(B)/smc test --engine=all $(T)

# Emitted C by -O1, as of anybody's smc test, and faster to build by -O0.
LEVELS ?= 0 1 2
CHECK_LINES += $(foreach level,$(LEVELS),"conformance-O$(level): $(if $(filter-out 2,$(level)),CC='$(CC) -O0' )$(B)/smc test -O$(level) conformance")

# Emitted C with numbers in software, as --soft makes it, on this computer.
CHECK_LINES += "conformance-c-soft: CC='$(CC) -O0' $(B)/smc test --engine=ref,c-soft conformance"

# tests/ir: passes on IR text, the invariants, the reader.
IR_TESTS = $(B)/ir/run $(B)/ir/verify $(B)/ir/read
IR_TEXTS = tests/ir/*.smt tests/ir/samples/*.ir conformance/*/*.smt
$(B)/ir/%: tests/ir/%.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/libsmc.a

check: $(IR_TESTS)
CHECK_LINES += "ir: $(B)/ir/run $(IR_TEXTS)" "ir-verify: $(B)/ir/verify" "ir-read: $(B)/ir/read"
check-ir: $(IR_TESTS)
	$(B)/ir/run $(IR_TEXTS) && $(B)/ir/verify && $(B)/ir/read

# tests/golden: what the command prints, writes and exits with.  `make update-golden` writes what it does now into the cases.
GOLDEN = $(wildcard tests/golden/*.smt)
$(B)/golden: tests/golden/run.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/libsmc.a

check: $(B)/golden
CHECK_LINES += "golden: $(B)/golden $(B)/smc $(GOLDEN)"
check-golden: all $(B)/golden
	$(B)/golden $(B)/smc $(GOLDEN)
update-golden: all $(B)/golden
	UPDATE=1 $(B)/golden $(B)/smc $(GOLDEN)

# examples: checked without a word, and tested on every engine.
CHECK_LINES += "examples: sh tests/check/examples.sh $(B)/smc $(patsubst %/,%,$(wildcard examples/*/))"

# Applications among them: built, and flown or tried on their bench.
RUNTIME_ARCHIVES = $(foreach platform,linux sim desk,$(B)/runtime/$(platform).a)
check: $(RUNTIME_ARCHIVES)
CHECK_LINES += "applications: sh tests/check/applications.sh $(B)/smc '$(CC)' $(B)/runtime $(patsubst %/,%,$(dir $(wildcard examples/*/*.app)))"
check-applications: all $(RUNTIME_ARCHIVES)
	sh tests/check/applications.sh $(B)/smc '$(CC)' $(B)/runtime $(patsubst %/,%,$(dir $(wildcard examples/*/*.app)))
# docs/flight.svg is the flight of the rocket as it would be drawn now; `make docs` draws it.
FLIGHT_SVG = $(B)/smc log $(B)/flight/flight.log --format=svg altitude velocity tankPressure
$(B)/flight/flight.log: $(wildcard examples/rocket/*.[csa]*) $(B)/smc $(B)/runtime/desk.a
	@rm -rf $(@D) && mkdir -p $(@D)/made
	$(call say,FLY)$(B)/smc build examples/rocket/rocket.app -o $(@D)/made && $(CC) -std=c99 -O1 -ffp-contract=off -I. -I$(@D)/made \
	    examples/rocket/*.c $(@D)/made/*.c $(B)/runtime/desk.a -o $(@D)/rocket -pthread && cd $(@D) && ./rocket
check: $(B)/flight/flight.log
CHECK_LINES += "flight-docs: $(FLIGHT_SVG) | cmp - docs/flight.svg && echo 1 passed, 0 failed"
docs: docs/flight.svg
docs/flight.svg: $(B)/flight/flight.log
	$(FLIGHT_SVG) -o $@

# tests/analysis: what the analyses find, and what they leave alone.
CHECK_LINES += "analysis: $(B)/smc test tests/analysis" "findings: sh tests/findings/run.sh $(B)/smc" "findings-seeded: sh tests/findings/seeded.sh $(B)/smc"

# tests/graph: state diagrams, how they are laid out; and that others can read them, where Graphviz and librsvg are installed.
GRAPH_MACHINES = $(wildcard tests/graph/machines/*.sm)
$(B)/graph/layout: tests/graph/layout.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/libsmc.a
check: $(B)/graph/layout
CHECK_LINES += "graph-layout: $(B)/graph/layout $(GRAPH_MACHINES)" "graph-read: sh tests/graph/read.sh $(B)/smc $(GRAPH_MACHINES)"
# docs/ignition.svg is the one that would be drawn now; `make docs` draws it.
CHECK_LINES += "graph-docs: $(B)/smc graph examples/ignition/ignition.sm | cmp - docs/ignition.svg && echo 1 passed, 0 failed"
docs: docs/ignition.svg
docs/ignition.svg: examples/ignition/ignition.sm $(wildcard compiler/report/*.c) | $(B)/smc
	$(B)/smc graph $< -o $@
check-graph: all $(B)/graph/layout
	$(B)/graph/layout $(GRAPH_MACHINES)
	sh tests/graph/read.sh $(B)/smc $(GRAPH_MACHINES)
.PHONY: check-graph

# tests/script: what the script engine does and reports.
CHECK_LINES += "script: $(B)/smc test tests/script"
check: $(B)/fuzz/script
CHECK_LINES += "fuzz-script: $(B)/fuzz/script -n 2000 conformance/0[678]*/*.smt tests/script/*.smt"

# tests/fuzz: targets that must survive any input; seeds/NAME/ holds what each starts from.
$(B)/fuzz/%: tests/fuzz/%.c tests/fuzz/driver.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(filter %.c,$^) -o $@ $(B)/libsmc.a

check: $(B)/fuzz/ir $(B)/fuzz/frontend
CHECK_LINES += "fuzz-frontend: $(B)/fuzz/frontend -n 5000 $(wildcard tests/fuzz/seeds/frontend/*)"
CHECK_LINES += "fuzz-ir: $(B)/fuzz/ir -n 2000 $(wildcard tests/ir/samples/*.ir)"

# Flight logs: the seed is a flight that the test of logs writes.
$(B)/corpus/log/flight.log: $(B)/runtime/log
	@mkdir -p $(@D)
	@$(B)/runtime/log $@.new && head -c 4000 $@.new >$@ && rm $@.new
check: $(B)/fuzz/log $(B)/corpus/log/flight.log
$(B)/fuzz-cov/log: | $(B)/corpus/log/flight.log
# What --junit writes.
CHECK_LINES += "junit: sh tests/check/junit.sh $(B)/smc $(B)/junit"

# What an output may replace.
CHECK_LINES += "outputs: sh tests/outputs/run.sh $(B)/smc $(B)/corpus/log/flight.log"
check-outputs: all $(B)/corpus/log/flight.log
	sh tests/outputs/run.sh $(B)/smc $(B)/corpus/log/flight.log
.PHONY: check-outputs
CHECK_LINES += "fuzz-log: $(B)/fuzz/log -n 1000 $(B)/corpus/log/flight.log" "log: sh tests/log/run.sh $(B)/smc $(B)/runtime/log $(B)/log"

# Images: their seeds are those that the mutation test works on.  `make check-mutate` changes every byte of them to every value,
# and runs what is accepted for STEPS steps.
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
check: $(B)/fuzz/image $(B)/corpus/image
$(B)/fuzz/image $(B)/fuzz-cov/image: compiler/device/sign.c
$(B)/fuzz-cov/image: | $(B)/corpus/image
CHECK_LINES += "fuzz-image: $(B)/fuzz/image -n 20000 $(B)/corpus/image/*.smb"

MUTATE_SRC = tests/unit/vm_mutate.c $(LIBSMC)
$(B)/vm_mutate_san: $(MUTATE_SRC) | $(B)/gen/stdlib_text.h $(B)/gen/soft_text.h
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined $(MUTATE_SRC) -lm -o $@
STEPS ?= 1000
check-mutate: $(B)/vm_mutate_san $(MUTATE_SMB)
	$(B)/vm_mutate_san $(STEPS) 256 - $(MUTATE_SMB)

# docs/bytecode.md: its example is compiled and run.
$(B)/gen/embed.c: docs/bytecode.md
	@mkdir -p $(@D)
	@sed -n '/^```c$$/,/^```$$/{/^```/d;p;}' $< >$@
$(B)/unit/vm_docs: $(B)/gen/embed.c

# tests/diff: random programs on all engines in lock step.  `make diff N=1000000 SEED=1 J=2` is a campaign that goes on where
# it was stopped.
N    ?= 20000
SEED ?= 1
J    ?= 2
DIFF_OBJ = $(patsubst %.c,$(B)/obj/%.o,$(wildcard tests/diff/*.c))
$(B)/diff/difftest: $(DIFF_OBJ) $(B)/libsmc.a $(B)/runtime/sim.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

diff: $(B)/diff/difftest
	$(B)/diff/difftest --seed=$(SEED) --count=$(N) --jobs=$(J) --out=$(B)/diff/campaign --resume

# Whether anything happens that the analyses call impossible: random programs alone, a thousand steps each.
SOUND = $(B)/diff/difftest --sound --steps=1000
sound: $(B)/diff/difftest
	$(SOUND) --seed=$(SEED) --count=$(N) --jobs=$(J) --out=$(B)/diff/campaign-sound --resume

# Programs on all engines through emitted C, by these compilers; add others as --cc='clang-19 -O2' --cc=tcc.
DIFF_CC ?= --cc='$(CC) -std=c99 -O0' --cc='$(CC) -std=gnu11 -O2'
diff-c: $(B)/diff/difftest
	$(B)/diff/difftest --seed=$(SEED) --count=$(N) --jobs=$(J) --out=$(B)/diff/campaign-c --resume $(DIFF_CC)

.PHONY: diff diff-c sound

check: $(B)/diff/difftest
CHECK_LINES += "sound: $(SOUND) --count=300 --jobs=2 --out=$(B)/diff/check-sound" \
               "diff: $(B)/diff/difftest --count=2000 --jobs=2 --out=$(B)/diff/check" \
               "diff-c-soft: $(B)/diff/difftest --count=10 --forms=012h --cc-soft='$(CC) -std=c99 -O1' --out=$(B)/diff/check-c-soft" \
               "diff-c: $(B)/diff/difftest --count=25 --forms=012h --cc='$(CC) -std=c99 -O1' --out=$(B)/diff/check-c"

# tests/cost: the longest step as it is reported, against a VM that counts.
COST_FLAGS = -DSMVM_CONFIG='"tests/cost/config.h"'
COST_SRC   = tests/cost/run.c $(filter-out $(VM_FAST) $(VM_TEXT),$(VM))
$(B)/cost: $(COST_SRC) tests/cost/config.h $(filter-out %/main.o,$(DIFF_OBJ)) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(COST_FLAGS) $(WARN) $(CFLAGS) $(COST_SRC) -o $@ $(filter %/gen.o %/gen_change.o %/gen_print.o %/gen_shapes.o %/gen_values.o %/subject.o,$(DIFF_OBJ)) $(B)/libsmc.a
check: $(B)/cost
CHECK_LINES += "cost: $(B)/cost"

# tests/report: pages of smc report, looked at by a browser where one is.
CHECK_LINES += "report: sh tests/report/run.sh $(B)/smc $(B)/report"

# tests/emitc: emitted C under every compiler that is here, under options that touch arithmetic, in programs that use it; and
# control flow that no source has.
ENGINE_C_OBJ = $(patsubst %.c,$(B)/obj/%.o,compiler/device/engine_c.c $(wildcard compiler/base/os_*.c))
$(B)/emitc/flow $(B)/emitc/typed: $(B)/emitc/%: tests/emitc/%.c $(ENGINE_C_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -o $@ $^

check: $(B)/emitc/flow $(B)/emitc/typed
OTHERS_LINES += "emitc: sh tests/emitc/run.sh $(B)/smc"
CHECK_LINES += "emitc-flow: $(B)/emitc/flow 100" "emitc-typed: $(B)/emitc/typed 100"
check-emitc: all $(B)/emitc/flow $(B)/emitc/typed
	sh tests/emitc/run.sh $(B)/smc && $(B)/emitc/flow && $(B)/emitc/typed

# Everything again under the sanitizers: compiler, VM and emitted C (by -O0: what it is, not what a compiler makes of it); but for
# OTHERS_LINES.
SANITIZE = -fsanitize=address,undefined -fno-sanitize-recover=all
asan:
	$(MAKE) B=$(B)/asan CFLAGS='-O1 -g1' CC='$(CC) $(SANITIZE) -O0' LEVELS=2 OTHERS_LINES= OTHERS_NEED= check

# Coverage-guided, with clang: `make fuzz FUZZ=script FUZZ_SECONDS=3600`.  What it found goes on from where it stopped.
FUZZ         ?= $(notdir $(basename $(filter-out tests/fuzz/driver.c,$(wildcard tests/fuzz/*.c))))
FUZZ_SECONDS ?= 60
FUZZ_CC      ?= clang-19
# Arenas whose chunks hold one allocation each: then every request goes to the host, and a sanitizer sees its bounds.
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

# tests/bench: what a step costs, what code weighs, how compiling grows.  `make bench W=mission`: one workload.  What is measured is
# built with the options here, whatever CFLAGS says; emitted C, and C that stands for it, as anybody would build it.
W           ?= tank mission arith bigwindow
BENCH_FLAGS  = $(STRICT_C) -I$(B)/bench/gen -O2
BENCH_USER   = -std=c99 -O2
$(B)/bench/scale $(B)/bench/compile: $(B)/bench/%: $(B)/obj/tests/bench/%.o $(B)/obj/tests/bench/shapes.o $(B)/obj/compiler/base/os_posix.o $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# Each machine as C at each level, tank_o0 to bigwindow_o2; their headers declare the same state vector.
BENCH_EMITTED =
define bench_emit
BENCH_EMITTED += $(B)/bench/gen/$(1)_o$(2)
$(B)/bench/gen/$(1)_o$(2).c: $(3) tests/bench/workloads/$(1).sv $(B)/smc
	@mkdir -p $$(@D)
	$$(call say,SMC)$(B)/smc build $(3) --sv tests/bench/workloads/$(1).sv --emit=c -O$(2) --prefix=$(1)_o$(2) -o $$@
endef
$(foreach o,0 1 2,$(eval $(call bench_emit,tank,$(o),examples/tank/tank.sm)))
$(foreach o,0 1 2,$(foreach w,mission arith bigwindow,$(eval $(call bench_emit,$(w),$(o),tests/bench/workloads/$(w).sm))))
$(BENCH_EMITTED:%=%.h): %.h: %.c ;
$(BENCH_EMITTED:%=%.o): %.o: %.c
	$(call say,CC)$(CC) $(BENCH_USER) -c $< -o $@

BENCH_C   = $(wildcard tests/bench/workloads/*.c) $(addprefix tests/bench/,steps.c engines.c lua.c nothing.c)
BENCH_OBJ = $(patsubst %.c,$(B)/bench/obj/%.o,$(BENCH_C) $(VM) $(STDLIB))
$(B)/bench/obj/%.o: %.c | $(BENCH_EMITTED:%=%.h)
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(BENCH_FLAGS) $(WARN) $(DEPFLAGS) -c $< -o $@
$(B)/bench/obj/tests/bench/workloads/%_native.o: BENCH_FLAGS = $(BENCH_USER) -I. -I$(B)/bench/gen
$(B)/bench/steps: $(BENCH_OBJ) $(BENCH_EMITTED:%=%.o) $(B)/libsmc.a
	$(call say,LD)$(CC) -o $@ $^ -lm

OTHERS_NEED  += $(B)/bench/steps
OTHERS_LINES += "bench: $(B)/bench/steps $(B)/bench check" "bench-report: sh tests/check/bench_report.sh"

# All of it, or `make bench-time`, `bench-count`, `bench-sizes`, `bench-compile`; run.sh says what each is.
BENCH_PARTS = time count sizes compile
bench: $(B)/bench/steps $(B)/bench/compile
	sh tests/bench/run.sh $(B) '$(CC)' '$(BENCH_PARTS)' '$(W)'
$(BENCH_PARTS:%=bench-%): bench-%: $(B)/bench/steps $(B)/bench/compile
	sh tests/bench/run.sh $(B) '$(CC)' $* '$(W)'

# Whether every stage of the compiler grows with its input as it should.
bench-scale: $(B)/bench/scale
	$(B)/bench/scale
.PHONY: bench-scale $(BENCH_PARTS:%=bench-%)

# What the parts take on boards (flash, RAM, stack, cycles), against tests/bench/budgets.txt.
sizes: $(B)/smc
	@sh tests/bench/sizes.sh $(B) '$(CC)' '$(MAKE)'
OTHERS_LINES += "+sizes: sh tests/bench/sizes.sh $(B) '$(CC)' '$(MAKE)'"
.PHONY: sizes

# tests/fault: memory taken away at every request.  FAULT_ALL=1 tries every machine of conformance/ (minutes).
FAULT_CASES = $(if $(FAULT_ALL),$(wildcard conformance/*/*.smt),$(wildcard tests/fault/*.smt))
$(B)/fault/memory: tests/fault/memory.c compiler/base/arena.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(TINY_CHUNKS) $(filter %.c,$^) -o $@ $(B)/libsmc.a

$(B)/fault/shim.so: tests/fault/shim.c
	@mkdir -p $(@D)
	-$(call say,CC)$(CC) -std=c99 -O1 -Wall -Wextra -shared -fPIC $< -o $@ -ldl || rm -f $@

check: $(B)/fault/memory $(B)/fault/shim.so
CHECK_LINES += "fault-memory: $(B)/fault/memory $(FAULT_CASES)" "fault-command: sh tests/fault/command.sh $(B)/smc $(B)/fault/shim.so"

# tests/host: files, signals and names as compiler/base/os.h promises them.
HOST_OBJ     = $(patsubst %.c,$(B)/obj/%.o,$(wildcard compiler/base/os_*.c))
HOST_FOLDER  = rm -rf $(B)/host/$(1).made && mkdir -p $(B)/host/$(1).made &&
$(B)/host/files: HOST_WRAP = -Wl,--wrap=fsync,--wrap=rename,--wrap=fchmod
$(B)/host/files $(B)/host/signals $(B)/host/folders: $(B)/host/%: tests/host/%.c $(HOST_OBJ)
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< $(HOST_OBJ) -o $@ $(HOST_WRAP)
check: $(B)/host/folders
CHECK_LINES += "host-folders: $(B)/host/folders"
check: $(B)/host/files $(B)/host/signals $(B)/flight/flight.log
CHECK_LINES += "host-files: $(call HOST_FOLDER,files) $(B)/host/files $(B)/host/files.made" \
               "host-signals: $(call HOST_FOLDER,signals) $(B)/host/signals $(abspath $(B))/smc $(abspath examples)/tank/tank.sm $(abspath examples)/tank/tank.ss $(abspath $(B))/host/signals.made" \
               "host-names: sh tests/host/names.sh $(B)/smc $(B)/host/names.made $(B)/flight/flight.log"
check-host: all $(B)/host/files $(B)/host/signals $(B)/flight/flight.log
	$(call HOST_FOLDER,files) $(B)/host/files $(B)/host/files.made
	$(call HOST_FOLDER,signals) $(B)/host/signals $(abspath $(B))/smc $(abspath examples)/tank/tank.sm $(abspath examples)/tank/tank.ss $(abspath $(B))/host/signals.made
	sh tests/host/names.sh $(B)/smc $(B)/host/names.made $(B)/flight/flight.log
.PHONY: check-host

# tests/soft: soft binary64 against the computer's own.  `make f64-campaign N=1000000000` tries so many random operands of each
# operation and goes on where it was stopped; f64-f32 tries every binary32.
SOFT_OBJ = $(patsubst %.c,$(B)/obj/%.o,$(wildcard tests/soft/*.c))
$(B)/obj/tests/soft/subject.o: STRICT_C += -DSM_F64_SOFT=1
$(B)/soft/run: $(SOFT_OBJ) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

check: $(B)/soft/run
CHECK_LINES += "soft: $(B)/soft/run" "soft-engine: sh tests/soft/engine.sh $(VM_SOFT)"
f64-campaign: $(B)/soft/run
	$(B)/soft/run $(N) $(SEED) $(B)/soft/campaign
f64-f32: $(B)/soft/run
	$(B)/soft/run f32
.PHONY: f64-campaign f64-f32

# tests/avr: on an emulated ATmega328P: the same bits as here, and cycles.  `make check-avr N=100000 SEED=2`: more of it.
check: $(B)/diff/difftest
OTHERS_LINES += "avr: sh tests/avr/run.sh $(B) '$(CC)'"
check-avr: all $(B)/diff/difftest
	sh tests/avr/run.sh $(B) '$(CC)' $(N) $(SEED) 300
# `make avr-campaign N=10000 SEED=1`: so many random programs as images, going on where it was stopped.
avr-campaign:
	$(MAKE) check-avr N= SEED=
	nice -n 19 sh tests/avr/campaign.sh $(B) $(or $(N),10000) $(or $(SEED),1)

# The cycles of compiler/budget/avr_cycles.def.  `make avr-cycles`: measured anew, some minutes; `N=4000 SEED=7`: more operands, others.
OTHERS_LINES += "avr-cycles: sh tests/avr/cycles.sh $(B) '$(CC)'"
avr-cycles: $(B)/libsmc.a
	sh tests/avr/cycles.sh $(B) '$(CC)' make $(or $(N),800) $(or $(SEED),1)
check-avr-cycles: $(B)/libsmc.a
	sh tests/avr/cycles.sh $(B) '$(CC)' check $(N) $(SEED)

# Emitted C there.  `make avr-c-campaign N=1000`: so many random programs, going on where it was stopped, and every conformance case.
OTHERS_LINES += "avr-c: sh tests/avr/c.sh $(B) '$(CC)'"
avr-c-campaign: all $(B)/diff/difftest $(B)/targets/cases
	RESUME=1 sh tests/avr/c.sh $(B) '$(CC)' $(N) $(SEED) 1
.PHONY: check-avr avr-campaign avr-cycles check-avr-cycles avr-c-campaign

# tests/psl: what the headers of runtime-c/pal promise, on each platform, and what io.h makes of its pins.  Linux: with IIO devices in a folder of the test, and with
# calls that the test can let fail; the other watchdog is only compiled.
,               := ,
PSL_SUITE       = $(filter-out tests/psl/bench_% tests/psl/own_% tests/psl/qemu_%,$(wildcard tests/psl/*.c))
PSL_WATCHDOG    = watchdog_process
PSL_FLAGS_linux = -DPSL_LINUX_IIO='"iio"'
PSL_OBJ_linux   = psl/linux
$(B)/psl/linux/%.o: %.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(PSL_FLAGS_linux) $(DEPFLAGS) -c $< -o $@
PSL_WRAP_linux  = $(patsubst %,-Wl$(,)--wrap=%,write fsync fdatasync rename unlink syscall timer_settime ppoll accept4 recvmsg connect)
define psl_test
include runtime-c/psl/$(1)/psl.mk
PSL_SRC_$(1)  := $$(PSL) $$(PSL_SUITE) $$(wildcard tests/psl/*_$(1).c) stdlib/result.c runtime-c/io.c runtime-c/pin.c runtime-c/statevec.c
PSL_LIBS_$(1) := $$(PSL_LIBS)
$$(B)/psl/$(1)/suite: $$(PSL_SRC_$(1):%.c=$$(B)/$(or $(PSL_OBJ_$(1)),obj)/%.o)
	@mkdir -p $$(@D)
	$$(call say,LD)$$(CC) $$(CFLAGS) $$(LDFLAGS) -o $$@ $$^ $$(PSL_WRAP_$(1)) $$(PSL_LIBS_$(1))
check: $$(B)/psl/$(1)/suite
CHECK_LINES += "psl-$(1): $$(B)/psl/$(1)/suite"
endef
$(foreach platform,linux sim desk none,$(eval $(call psl_test,$(platform))))
check: $(B)/psl/linux/runtime-c/psl/linux/watchdog.o

# What is tested with threads is tested once more under the thread sanitizer, if the compiler has it: then this file is not empty.
TSAN = test ! -s $(B)/has_tsan || $(CC) $(STRICT_C) -O1 -g -fsanitize=thread
$(B)/has_tsan:
	@mkdir -p $(@D)
	@echo 'int main(void) { return 0; }' >$@.c; $(CC) -fsanitize=thread $@.c -o $@.out 2>/dev/null && echo yes >$@ || : >$@

$(B)/psl/tsan: $(PSL_SRC_linux) | $(B)/has_tsan
	@mkdir -p $(@D)
	$(call say,CC)$(TSAN) $(PSL_FLAGS_linux) $^ -o $@ $(PSL_WRAP_linux) $(PSL_LIBS_linux)
check: $(B)/psl/tsan
CHECK_LINES += "psl-tsan: if test -x $(B)/psl/tsan; then $(B)/psl/tsan; else echo 0 passed, 0 failed, 1 skipped; fi"

# tests/store: updates of images with the power cut at every byte.  `make store-cuts`: all pairs of cuts.
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
check: $(B)/store/cuts $(STORE_SMB)
CHECK_LINES += "store: $(B)/store/cuts $(STORE_SMB)"

# The link between a host and a board, over lines that lose and damage what they carry.  `make link-trouble N=100000 SEED=2`: more of it.
BOARD_SRC = bytecode-vm/target/agent.c bytecode-vm/target/store.c runtime-c/event.c $(filter runtime-c/psl/sim/%,$(PSL_SRC_sim))
AGENT_SRC = tests/store/agent.c compiler/device/device.c compiler/device/link_host.c $(BOARD_SRC)
$(B)/store/agent: $(AGENT_SRC:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
check: $(B)/store/agent $(STORE_SMB)
CHECK_LINES += "agent: $(B)/store/agent $(STORE_SMB)"
# A board with a key.
AUTH_SRC = tests/store/auth.c compiler/device/sign.c $(BOARD_SRC)
$(B)/store/auth: $(AUTH_SRC:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
check: $(B)/store/auth
CHECK_LINES += "auth: $(B)/store/auth $(STORE_SMB)"
link-trouble: $(B)/store/agent $(STORE_SMB)
	$(B)/store/agent $(STORE_SMB) $(or $(N),100000) $(or $(SEED),1)
$(B)/fuzz/link $(B)/fuzz-cov/link: $(BOARD_SRC)
LINK_SEEDS = $(B)/corpus/link/slots-1 $(B)/corpus/link/slots-2
$(LINK_SEEDS): $(B)/corpus/link/slots-%: tests/fuzz/link_seed.sh $(B)/store/old.smb
	@mkdir -p $(@D)
	@sh tests/fuzz/link_seed.sh $* $(B)/store/old.smb >$@.new && mv $@.new $@
$(B)/fuzz-cov/link: | $(LINK_SEEDS)
check: $(B)/fuzz/link $(LINK_SEEDS)
CHECK_LINES += "fuzz-link: $(B)/fuzz/link -n 20000 $(LINK_SEEDS)"
.PHONY: link-trouble

# tests/device: smc flash and smc device, and a board that is a program.  `make device-trouble N=1000 SEED=2`: more of it.
DEVICE_SRC = tests/device/board.c bytecode-vm/target/agent.c bytecode-vm/target/store.c runtime-c/event.c $(filter runtime-c/psl/linux/%,$(PSL_SRC_linux))
$(B)/device/board: $(DEVICE_SRC:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -pthread -lrt
$(B)/device/link: tests/device/link.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $< -o $@
DEVICE_RUN = $(B)/device/link $(B)/smc $(B)/device/board $(B)/device $(STORE_SMB)
check: $(B)/device/link $(B)/device/board
CHECK_LINES += "device: $(DEVICE_RUN)"
device-trouble: $(B)/device/link $(B)/device/board $(STORE_SMB)
	$(DEVICE_RUN) $(or $(N),1000) $(or $(SEED),1)
.PHONY: device-trouble
store-cuts: $(B)/store/cuts $(STORE_SMB)
	$(B)/store/cuts $(STORE_SMB) all
.PHONY: store-cuts

# The generic firmware of Arduino boards (docs/boards.md): `make firmware MCU=atmega2560` (Mega) or atmega328p (Uno) makes build/firmware/MCU.hex.
# SAFE: another image to be built in; ARM_PIN: the pin with the arming plug; KEY: a file of smc key, and no image but those signed
# with it is run.  `make firmware-trouble N=100 SEED=2`: more updates in trouble.
MCU         ?= atmega2560
AVR_CC      ?= avr-gcc
FIRMWARE_OUT = $(B)/firmware
FIRMWARE_SRC = $(addprefix bytecode-vm/,firmware/firmware.c firmware/runner.c target/store.c target/agent.c target/io.c auth.c pins.c load.c verify.c interp.c interp_avr_eeprom.S) \
               runtime-c/link/link.c runtime-c/pin.c runtime-c/event.c $(wildcard runtime-c/psl/avr/*.c stdlib/soft_*.c stdlib/soft_*.S)
# What makes avr-gcc 5.4 make the least of it, together 3 % less than -Os, -mcall-prologues, -mrelax and -flto alone.
FIRMWARE_SMALL = -Os -mcall-prologues -mrelax -mstrict-X -flto -flto-partition=one -fira-algorithm=priority -fshort-enums -fno-ipa-sra -fno-tree-dominator-opts \
               -finline-limit=6 -fno-move-loop-invariants -fno-gcse -fno-tree-tail-merge -fno-tree-pta
FIRMWARE_C   = $(AVR_CC) -mmcu=$(MCU) -DF_CPU=16000000UL $(FIRMWARE_SMALL) -std=c99 $(filter-out -pedantic,$(WARN)) -Wno-maybe-uninitialized -I. -I$(FIRMWARE_OUT) \
               -ffunction-sections -fdata-sections -Wl,--gc-sections $(foreach v,SMVM_CONFIG SM_CONFIG,-D$(v)='"bytecode-vm/firmware/config.h"') $(if $(ARM_PIN),-DFIRMWARE_ARM_PIN=$(ARM_PIN)) $(if $(KEY),-DFIRMWARE_KEY)
firmware: $(B)/smc
	@case '$(MCU)' in atmega328p | atmega2560) ;; *) echo "MCU=$(MCU): atmega328p is an Uno, atmega2560 a Mega" >&2; exit 1 ;; esac
	@case '$(ARM_PIN)' in '' | [0-9] | [1-9][0-9]) ;; *) echo "ARM_PIN=$(ARM_PIN): it is the number of a digital pin, as in ARM_PIN=7" >&2; exit 1 ;; esac
	@mkdir -p $(FIRMWARE_OUT)
	$(B)/smc build -w bytecode-vm/firmware/safe.sm --sv bytecode-vm/firmware/safe.sv --io bytecode-vm/firmware/safe.io -o $(FIRMWARE_OUT)/safe.smb
	@$(B)/smc verify '$(or $(SAFE),$(FIRMWARE_OUT)/safe.smb)' >$(FIRMWARE_OUT)/safe.txt
	@! grep -q 'not marked @safe' $(FIRMWARE_OUT)/safe.txt || echo 'warning: $(SAFE) starts in a state that is not marked @safe: until it has left it, the board takes no image' >&2
	od -An -v -tx1 $(or $(SAFE),$(FIRMWARE_OUT)/safe.smb) | sed 's/ \(..\)/0x\1,/g' >$(FIRMWARE_OUT)/safe_image.inc
ifneq ($(KEY),)
	@grep -qx '[0-9a-fA-F]\{32\}' '$(KEY)' || { echo "KEY=$(KEY) is no key of smc key, 32 hexadecimal digits: 'smc key FILE' makes one" >&2; exit 1; }
	@umask 077 && sed 's/\(..\)/0x\1,/g' '$(KEY)' >$(FIRMWARE_OUT)/key.inc
endif
	$(call say,AVR)$(FIRMWARE_C) $(FIRMWARE_SRC) -Wl,-Map=$(FIRMWARE_OUT)/$(MCU).map -o $(FIRMWARE_OUT)/$(MCU).elf
	avr-objcopy -O ihex -R .eeprom $(FIRMWARE_OUT)/$(MCU).elf $(FIRMWARE_OUT)/$(MCU).hex
	avr-size $(FIRMWARE_OUT)/$(MCU).elf
check: $(B)/device/link $(STORE_SMB)
OTHERS_LINES += "+firmware: sh tests/avr/firmware.sh '$(MAKE)' $(B) '$(CC)'"
firmware-trouble: $(B)/device/link $(STORE_SMB)
	sh tests/avr/firmware.sh '$(MAKE)' $(B) '$(CC)' $(or $(N),100) $(or $(SEED),1)
.PHONY: firmware firmware-trouble

# `make psl-qemu KERNEL=FOLDER`: Linux with real pins and a real watchdog, in an emulator (qemu-system-arm gcc-arm-linux-gnueabihf
# libc6-dev-armhf-cross cpio; FOLDER: where a linux-image-*-armmp:armhf of Debian was unpacked by dpkg-deb -x).
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

# tests/runtime: what the headers of runtime-c promise, one program a file: NAME_linux.c on Linux, with threads, and once more under the
# thread sanitizer if the compiler has it; the others in the simulation.  V.sv of the folder is there as "V.h", V.io as "V_io.h", M.sm
# too, with the vector that RUNTIME_SV_M names.
RUNTIME_SRC   = $(wildcard runtime-c/*.c) $(filter-out %/store.c %/agent.c,$(wildcard bytecode-vm/target/*.c)) $(VM) $(STDLIB)
RUNTIME_MADE  = $(patsubst tests/runtime/%,$(B)/runtime/made/%.c,$(basename $(wildcard tests/runtime/*.sv tests/runtime/*.sm))) \
                $(patsubst tests/runtime/%.io,$(B)/runtime/made/%_io.c,$(wildcard tests/runtime/*.io))
RUNTIME_TESTS = $(patsubst tests/runtime/%.c,$(B)/runtime/%,$(wildcard tests/runtime/*.c))
RUNTIME_TSAN  = $(patsubst %_linux,%_tsan,$(filter %_linux,$(RUNTIME_TESTS)))
RUNTIME_C     = $(STRICT_C) -I$(B)/runtime/made $(WARN)
# What the tests of machines take: machines that run on these vectors, one built without `lock`, and images as arrays.
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
RUNTIME_TSAN_SRC = $(RUNTIME_SRC_linux) $(RUNTIME_MADE)
RUNTIME_TSAN_OBJ = $(patsubst $(B)/%.c,$(B)/tsan/%.o,$(filter $(B)/%,$(RUNTIME_TSAN_SRC))) $(patsubst %.c,$(B)/tsan/%.o,$(filter-out $(B)/%,$(RUNTIME_TSAN_SRC)))
$(B)/tsan/runtime/made/%.o: $(B)/runtime/made/%.c | $(B)/has_tsan $(RUNTIME_MADE)
	@mkdir -p $(@D)
	$(call say,CC)$(TSAN) -I$(B)/runtime/made $(DEPFLAGS) -c $< -o $@
$(B)/tsan/%.o: %.c | $(B)/has_tsan
	@mkdir -p $(@D)
	$(call say,CC)$(TSAN) $(DEPFLAGS) -c $< -o $@
$(B)/runtime/%_linux: tests/runtime/%_linux.c $(B)/runtime/linux.a
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/runtime/linux.a $(RUNTIME_LIBS) -pthread -lrt
$(B)/runtime/%: tests/runtime/%.c $(B)/runtime/sim.a
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/runtime/sim.a $(RUNTIME_LIBS)
$(B)/runtime/threads: RUNTIME_LIBS = -pthread
# What logs hold is read by what `smc log` reads them with.
RUNTIME_READS = $(patsubst %,$(B)/runtime/%,log log_linux log_tsan kill_linux kill_tsan)
$(RUNTIME_READS): RUNTIME_LIBS = $(B)/libsmc.a
$(RUNTIME_READS): | $(B)/libsmc.a
.SECONDARY: $(RUNTIME_TSAN_OBJ)
$(B)/runtime/%_tsan: tests/runtime/%_linux.c $(RUNTIME_TSAN_OBJ)
	$(call say,CC)$(TSAN) -I$(B)/runtime/made $^ -o $@ $(RUNTIME_LIBS) -pthread -lrt
check: $(RUNTIME_TESTS) $(RUNTIME_TSAN)
CHECK_LINES += $(foreach t,$(RUNTIME_TESTS),"runtime-$(notdir $(t)): $(t)") \
               $(foreach t,$(RUNTIME_TSAN),"runtime-$(notdir $(t)): if test -x $(t); then $(t); else echo 0 passed, 0 failed, 1 skipped; fi")
OTHERS_LINES += "runtime-targets: CC='$(CC)' sh tests/runtime/targets.sh $(B)/smc"
# `make kill-runtime N=10000`: a program killed so often, at random moments.
kill-runtime: $(B)/runtime/kill_linux
	$(B)/runtime/kill_linux $(N)
.PHONY: kill-runtime
check-runtime: $(RUNTIME_TESTS) $(RUNTIME_TSAN)
	@for t in $(RUNTIME_TESTS) $(RUNTIME_TSAN); do test ! -x $$t || $$t || exit 1; done
.PHONY: check-runtime

# tests/targets: on other processors, emulated: the VM, and emitted C.  `make targets-campaign N=10000 NC=1000 SEED=1`: so many random
# programs as images, and as C at each level, on each of them, or on those that TARGETS names; goes on where it was stopped.
# The VM is built as by somebody who has not read about -ffp-contract.
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

# The VM's unit tests as the target's options configure it.  What includes bytecode-vm/config.h is compiled with them, the rest is libsmc's
# own.  vm_hostile and vm_switch have configurations of their own, vm_mutate takes long.
TARGETS_UNIT = $(filter-out %/vm_hostile.c %/vm_switch.c %/vm_mutate.c,$(wildcard tests/unit/vm_*.c))
TARGETS_CONF = $(VM) $(STDLIB) $(wildcard compiler/emit/bytecode/*.c) compiler/script/engine_vm.c
$(B)/targets/units-%: $(TARGETS_UNIT) $(TARGETS_CONF) $(B)/libsmc.a $(B)/gen/embed.c tests/targets/targets.txt
	@mkdir -p $@
	$(call say,CC)for f in $(TARGETS_CONF); do \
	    sh tests/targets/cc.sh $* $(STRICT_C) -Wall -Wextra -Werror -O0 -c $$f -o $@/$$(echo $$f | tr / _).o || exit 1; \
	done; for t in $(TARGETS_UNIT); do sh tests/targets/cc.sh $* $(STRICT_C) -O0 $$t $@/*.o $(B)/libsmc.a -lm -o $@/$$(basename $$t .c) || exit 1; done
	@touch $@

# Tests of runtime-c that need no thread, on targets with an operating system: above all its wire forms, where memory is the other way round.
TARGETS_RUNTIME = statevec region event executor task keep machine
$(B)/targets/runtime-%: $(RUNTIME_SRC_sim) $(RUNTIME_MADE) $(TARGETS_RUNTIME:%=tests/runtime/%.c) | $(B)/runtime/made/images.h
	@mkdir -p $@.tests
	$(call say,CC)for f in $(filter-out tests/%,$^); do \
	    sh tests/targets/cc.sh $* $(RUNTIME_C) -O0 -c $$f -o $@.tests/$$(echo $$f | tr / _).o || exit 1; \
	done; for t in $(TARGETS_RUNTIME); do sh tests/targets/cc.sh $* $(RUNTIME_C) -O0 tests/runtime/$$t.c $@.tests/*.o -o $@.tests/$$t || exit 1; done
	@touch $@

check: $(B)/diff/difftest $(B)/targets/cases $(RUNTIME_MADE)
OTHERS_LINES += "+targets: sh tests/targets/run.sh $(B)"
OTHERS_LINES += "app-targets: sh tests/targets/app.sh $(B) '$(CC)'"
check-targets targets-campaign: $(B)/diff/difftest $(B)/targets/cases
check-targets:
	sh tests/targets/run.sh $(B)
targets-campaign:
	N=$(N) NC=$(NC) SEED=$(SEED) nice -n 19 sh tests/targets/campaign.sh $(B) $(TARGETS)

# Everything itself on targets with an operating system: `make targets-native TARGETS=s390x-fma`.  (All mutations
# would take an hour.)
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
.PHONY: check-targets targets-campaign targets-native native-tests
check: $(B)/golden
OTHERS_LINES += "+native-x86-32: sh tests/targets/native.sh $(B) '$(MAKE)' x86-32" "models: sh tests/check/models.sh $(STRICT_C) $(WARN)"

# tests/app: applications (.app) from source to a flight in simulated time, and everything that can be wrong with one.
check: $(B)/runtime/sim.a
CHECK_LINES += "app: sh tests/app/run.sh $(B)/smc $(B)/runtime/sim.a '$(CC)'"
check-app: all $(B)/runtime/sim.a
	sh tests/app/run.sh $(B)/smc $(B)/runtime/sim.a '$(CC)'
.PHONY: check-app

# Random applications in random trouble, held against a model: some steps in check, N of them here.
stress-runtime: $(B)/runtime/stress
	$(B)/runtime/stress $(or $(N),1000000) $(or $(SEED),1)

# How late ticks begin on this computer: SECONDS=5 without real-time priorities, and with.
$(B)/runtime/lateness: tests/bench/lateness.c $(B)/runtime/linux.a
	$(call say,CC)$(CC) $(RUNTIME_C) $(CFLAGS) $(DEPFLAGS) $< -o $@ $(B)/runtime/linux.a -pthread -lrt
lateness: $(B)/runtime/lateness
	$(B)/runtime/lateness $(or $(SECONDS),5)
.PHONY: stress-runtime lateness

# What an access to the state vector and a tick cost, and what they weigh.
bench-runtime: $(RUNTIME_MADE)
	sh tests/bench/runtime.sh $(B) '$(CC)'
	sh tests/bench/ticks.sh $(B) '$(CC)'
.PHONY: bench-runtime

# tests/runtime/flights: the example machines as tasks, over the flights of their scripts.
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
check: $(FLIGHTS)/flights $(FLIGHTS)/flight.smb $(FLIGHT_TRACES)
CHECK_LINES += "runtime-flights: $(FLIGHTS)/flights $(FLIGHTS)/flight.smb $(FLIGHT_TRACES)"

# `make bench-machine`: what a step costs as a task of the runtime, in instructions.
$(FLIGHTS)/plain_mission.c: examples/mission/mission.sm examples/mission/rocket.sv $(B)/smc
	$(call say,SMC)$(B)/smc build --emit=c --runtime --prefix=plain_mission --sv examples/mission/rocket.sv -o $@ $<
BENCH_MACHINE = tests/bench/machine.c $(FLIGHTS)/rocket.c $(FLIGHTS)/mission.c $(FLIGHTS)/plain_mission.c $(RUNTIME_SRC_linux)
bench-machine: $(BENCH_MACHINE) $(FLIGHTS)/flight.smb
	$(CC) $(STRICT_C) -O2 -I$(FLIGHTS) $(BENCH_MACHINE) -o $(FLIGHTS)/bench -pthread -lrt
	@sh tests/bench/machine_cost.sh $(FLIGHTS)/bench $(FLIGHTS)/flight.smb
.PHONY: bench-machine

# ---- the Arduino library ----

# `make arduino`: the library, for the Arduino IDE, arduino-cli and PlatformIO, in $(B)/arduino/smc, and as a .zip where there is zip.
PROJECT_URL      ?= https://example.org/smc
ARDUINO           = $(B)/arduino/smc
ARDUINO_SOURCES   = $(sort $(STDLIB) $(filter-out $(VM_TEXT) %/debug.c $(VM_FAST),$(VM)) $(FIRMWARE_SRC))
ARDUINO_INPUTS    = $(wildcard arduino/* arduino/examples/*/* stdlib/* bytecode-vm/*.* bytecode-vm/firmware/* bytecode-vm/target/* runtime-c/*.* \
                      runtime-c/link/* runtime-c/pal/* runtime-c/psl/avr/*) docs/arduino.md compiler/version.h
arduino: $(ARDUINO)/library.properties
$(ARDUINO)/library.properties: $(ARDUINO_INPUTS) $(B)/smc
	$(call say,ARDUINO)sh arduino/make.sh $(B)/smc $(ARDUINO) '$(VERSION)' '$(PROJECT_URL)' $(ARDUINO_SOURCES)
check: arduino
OTHERS_LINES += "arduino: CC='$(CC)' sh tests/arduino/run.sh $(B) $(ARDUINO) '$(VERSION)'"
.PHONY: arduino

# ---- installing ----

DEST = $(DESTDIR)$(PREFIX)
INSTALLED_HEADERS = $(wildcard stdlib/*.h stdlib/*.def bytecode-vm/*.h bytecode-vm/*.def)
# What smc.mk builds applications from, as it lies here.
INSTALLED_RUNTIME = $(sort $(shell find runtime-c stdlib bytecode-vm -type f ! -name "*.in"))

$(B)/libsmvm.a: $(VM:%.c=$(B)/obj/%.o) $(STDLIB:%.c=$(B)/obj/%.o)
	@rm -f $@
	$(call say,AR)$(AR) rcs $@ $^

install: all $(B)/libsmvm.a
	mkdir -p "$(DEST)/bin" "$(DEST)/lib/pkgconfig" "$(DEST)/share/smc/docs" "$(DEST)/include/smc/stdlib" "$(DEST)/include/smc/bytecode-vm"
	cp $(B)/smc "$(DEST)/bin/smc"
	cp $(B)/libsmvm.a "$(DEST)/lib/libsmvm.a"
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' bytecode-vm/smvm.pc.in >"$(DEST)/lib/pkgconfig/smvm.pc"
	cp compiler/smc.mk "$(DEST)/share/smc/smc.mk"
	cp docs/*.md docs/*.svg "$(DEST)/share/smc/docs"
	@for f in $(INSTALLED_HEADERS); do cp $$f "$(DEST)/include/smc/$$f" || exit 1; done
	@for f in $(INSTALLED_RUNTIME); do mkdir -p "$(DEST)/share/smc/$$(dirname $$f)" && cp $$f "$(DEST)/share/smc/$$f" || exit 1; done

OTHERS_LINES += "+install: sh tests/install/run.sh $(MAKE) $(B) '$(CC)'"

uninstall:
	rm -f "$(DEST)/bin/smc" "$(DEST)/lib/libsmvm.a" "$(DEST)/lib/pkgconfig/smvm.pc"
	rm -rf "$(DEST)/share/smc" "$(DEST)/include/smc"

help:
	@echo 'make                 builds $(B)/smc'
	@echo 'make check           runs every test that needs cc and make only, the others say what they need; JOBS=1: one after another'
	@echo 'make test T=FILE     runs some conformance cases on every engine'
	@echo 'make diff N=100000   runs so many random programs on all engines, from seed SEED=1, in J=2 processes'
	@echo 'make f64-campaign N=100000000  tries soft binary64 on so many random operands for each operation'
	@echo 'make avr-cycles      measures anew what instructions take on an ATmega328P, for reports'
	@echo 'make avr-campaign N=10000  runs so many random programs as images on an emulated ATmega328P'
	@echo 'make avr-c-campaign N=1000  runs so many random programs as C on an emulated ATmega328P, and every conformance case'
	@echo 'make sound N=100000  runs so many random programs and holds them against what the analyses say of them'
	@echo 'make stress-runtime  N=1000000 steps of random applications of the flight runtime, from SEED=1; make lateness: how late ticks begin here'
	@echo 'make asan            runs the tests under the address and undefined-behaviour sanitizers'
	@echo 'make fuzz            fuzzes with clang: FUZZ=target FUZZ_SECONDS=60'
	@echo 'make docs            writes docs/diagnostics.md and the pictures of documents; wrap-docs: wraps documents at 100 columns'
	@echo 'make bench           measures what a step costs and what code weighs: W=mission, one workload; bench-scale: how compile time grows; bench-runtime: the state vector'
	@echo 'make sizes           measures what the parts take on boards: flash, RAM, stack, cycles'
	@echo 'make arduino         makes the Arduino library, $(ARDUINO) and smc.zip beside it'
	@echo 'make install         to PREFIX ($(PREFIX)), below DESTDIR if that is set; uninstall removes it'
	@echo 'make clean           removes $(B)'

clean:
	rm -rf $(B)

# ---- the house rules ----

find_code = { find stdlib compiler bytecode-vm runtime-c arduino tests examples -name '*.[ch]' -o -name '*.def' -o -name '*.awk' -o -name '*.sh' \
              -o -name '*.cpp' -o -name '*.mk'; echo Makefile; } 2>/dev/null | sort
find_text = { find stdlib compiler bytecode-vm runtime-c arduino tests examples conformance docs editors -type f; ls README.md CONTRIBUTING.md Makefile; } 2>/dev/null | sort
find_smt  = find conformance tests -name '*.smt' | sort
find_md   = $(find_text) | grep '[.]md$$'

check-layers:
	@$(find_code) | awk -f tests/check/layers.awk tests/check/layers.txt -
check-codes:
	@$(find_smt) | awk -f tests/check/codes.awk compiler/diag/flags.def compiler/diag/codes.def tests/check/codes.txt -
check-headers: $(B)/gen/stdlib_text.h $(B)/gen/soft_text.h
	@CC='$(CC)' sh tests/check/headers.sh -I$(B)/gen
check-imports: $(patsubst %.c,$(B)/obj/%.o,$(filter-out $(VM_TEXT),$(VM)) $(STDLIB) $(wildcard runtime-c/*.c bytecode-vm/target/*.c))
	@sh tests/check/imports.sh $^
check-licence:
	@$(find_code) | awk -f tests/check/licence.awk
check-places:
	@$(find_text) | awk -f tests/check/places.awk
check-arguments:
	@$(find_code) | grep "^compiler/.*c$$" | awk -f tests/check/arguments.awk compiler/diag/codes.def -
check-words:
	@$(find_text) | awk -f tests/check/words.awk tests/check/words.txt -
# The prose of documents is wrapped at 100 columns; `make wrap-docs` wraps it.
check-wrap:
	@sh tests/check/wrap.sh $$($(find_md))
wrap-docs:
	@sh tests/check/wrap.sh -w $$($(find_md))
.PHONY: wrap-docs
# No sentence of a document is too long.  What docs/evidence/ collects stays as it was written on its day.
check-sentences:
	@$(find_md) | grep -v '^docs/evidence' | LC_ALL=C awk -f tests/check/sentences.awk
check-configurations:
	@sh tests/check/configurations.sh
HOUSE_RULES = check-words check-wrap check-sentences check-configurations check-layers check-codes check-arguments check-headers check-imports check-licence check-places
CHECK_LINES += $(foreach rule,$(HOUSE_RULES),"+$(rule): $(MAKE) -s --no-print-directory $(rule)")

# ---- the language and its evidence ----

# tests/clauses: what state scripts cannot show of the language: refused steps, memory, stored NaN.
HOST         = $(wildcard compiler/base/os_*.c compiler/device/*.c)
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

check: $(CLAUSE_TESTS) $(B)/clauses/probe.smb
CHECK_LINES += "clauses-steps: $(B)/clauses/steps" "clauses-memory: $(B)/clauses/memory $(B)/clauses/probe.smb" \
               "clauses-regions: $(B)/clauses/regions"

# docs/diagnostics.md is generated from codes.def, and must be the one that would be generated now; `make docs` writes it.
DIAGNOSTICS = $(B)/diagnostics | LC_ALL=C awk -f tests/check/wrap.awk
$(B)/diagnostics: tests/check/diagnostics.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $< -o $@ $(B)/libsmc.a
docs: $(B)/diagnostics
	$(DIAGNOSTICS) >docs/diagnostics.md
check: $(B)/diagnostics
CHECK_LINES += "diagnostics: $(DIAGNOSTICS) | cmp - docs/diagnostics.md && echo 1 passed, 0 failed"
.PHONY: docs

# Every edit that a finding proposes helps and does no harm.
FIXES = $(B)/fixes tests/check/fixes.txt conformance/*/*.smt tests/*/*.smt README.md docs/*.md examples/*/*.sm tests/findings/*/*.sm
$(B)/fixes: tests/check/fixes.c tests/check/fixes_meaning.c tests/check/fixes_meaning.h $(B)/libsmc.a
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(DEPFLAGS) $< tests/check/fixes_meaning.c -o $@ $(B)/libsmc.a
check: $(B)/fixes
CHECK_LINES += "fixes: $(FIXES)"
check-fixes: $(B)/fixes
	@$(FIXES)
.PHONY: check-fixes

# What --message-format=sarif writes is valid.  `make sarif-schema` gets the schema that says what that is.
CHECK_LINES += "sarif: sh tests/check/sarif.sh $(B)/smc $(B)/sarif conformance/11-errors/*.smt tests/analysis/*.smt"
sarif-schema:
	sh tests/check/sarif_schema.sh $(B)/sarif/schema.json
.PHONY: sarif-schema

# Every clause of docs/language.md and docs/config.md has a case, every case names clauses that exist.
check-clauses:
	@{ find conformance tests -name '*.smt' | sort; ls tests/clauses/*.c tests/runtime/*.c 2>/dev/null; } | \
	    awk -f tests/check/clauses.awk docs/language.md docs/config.md tests/check/clauses.txt -
CHECK_LINES += "+check-clauses: $(MAKE) -s --no-print-directory check-clauses"

# `make mutants` breaks the implementation line by line and demands that the cases notice, `make faults` that random programs and the
# tests of soft numbers and of the store do; an hour each.  `make mutants M="6 7.12"`: some clauses; `M=100-200`, `M=100-`: lines of the list.
mutants faults:
	@CC='$(CC)' CFLAGS=$(if $(filter faults,$@),-O1,-O0) sh tests/check/mutants.sh tests/check/$@.txt $(B)/$@ $(M)
CHECK_LINES += "mutants-places: sh tests/check/mutants.sh --places tests/check/mutants.txt tests/check/faults.txt"

# The fenced examples of the documentation do what their pages say.
check-docs: all
	@sh tests/check/docs.sh $(B)/smc $(B)/docs README.md conformance/README.md examples/README.md $(wildcard docs/*.md)
CHECK_LINES += "+check-docs: $(MAKE) -s --no-print-directory check-docs"
.PHONY: check-clauses check-docs mutants faults

.PHONY: $(HOUSE_RULES) all asan bench bench-scale check check-emitc check-ir check-golden check-mutate update-golden test fuzz install uninstall help clean
check: $(OTHERS_NEED)
-include $(shell find $(B) -name '*.d' 2>/dev/null)
