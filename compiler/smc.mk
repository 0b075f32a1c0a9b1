# SPDX-License-Identifier: Apache-2.0
# Rules for projects that build state machines, or whole applications:  include smc.mk
#   tank.smb from tank.sm: bytecode.      tank.c and tank.h from tank.sm: C99.      app_io.c and app_io.h from app.io: C99 for runtime-c;
#   app_net.c and app_net.h from app.net likewise.
#   make flash-tank PORT=/dev/ttyACM0: tank.smb onto a board; it is on trial until `smc device confirm`.  make flash: of the one machine here.
#   make test-tank: runs the scripts tank.ss and tank-*.ss, with the requirements tank.rq.      tank.proof: the verdicts on these.
#   tank.html: the page for a review of tank.sm, with its scripts and requirements.  SMC_REPORT has further options, as --all.
#   make mutate-tank, faults-tank, sweep-tank SET=limit=700:900:21: what changes of the machine, faults of its inputs and other values of a parameter
#   do in the scripts tank.ss and tank-*.ss.
#   make cover-tank: scripts for what tank.ss and tank-*.ss do not test, into the folder cover.
#   tank.html, test-, mutate-, faults-, sweep- and cover-tank are also of an application, tank.app, if there is no tank.sm.
#   make diff-tank OLD=flown.sm: what tank.sm does otherwise than flown.sm, and in its scripts tank.ss and tank-*.ss.
#   make swap-tank TO=stand.sock MODE=continue: tank.sm replaces the machine `tank` of an application that runs.  MODE=restart: it starts again.
#     FROM=channel.sm: the machine is in this file.  SMC_APP has the state vector, and the bindings of the machine.
# Set before the include: SMC_SV to the application's state vector (app.sv) if there is one, SMC_IO to the pins of its images (app.io),
# SMCFLAGS to further options, SMC to where the command is if not in PATH.
#   rocket from rocket.app: a program.  Set before the include
#     SMC_APP       rocket
#     SMC_SOURCES   what you wrote: navigation.c engine.cpp; .c, .cc and .cpp
#     SMC_PLATFORM  desk: simulated time, real files; begin with it.  linux (default): the real one.  sim: nothing real, for tests
#                   sbrio: NI Linux Real-Time, pins in the FPGA (docs/sbrio.md)
#     SMC_OUT       the folder for what is made: made
#   make smc-clean removes what these rules made; your own `clean:` may ask for it.

# Nothing here is what plain `make` makes, but the application.
SMC_GOAL := $(.DEFAULT_GOAL)

SMC      ?= smc
SMC_SV   ?=
SMCFLAGS ?=
SMC_IO   ?=
SMC_ARGS  = $(SMCFLAGS) $(if $(SMC_SV),--sv=$(SMC_SV))
# Begins a recipe that needs the command: if it is not found, says what to do.  Not by $(shell), which would not see a PATH set here.
SMC_WANT  = $(if $(filter smc,$(SMC)),@command -v smc >/dev/null || { echo 'smc is not in PATH: set SMC = /where/it/is/smc before the include' >&2; exit 127; })
# Where these are set: another option rebuilds it.
SMC_SET  := $(wildcard $(firstword $(MAKEFILE_LIST)))

%.smb: %.sm $(SMC_SV) $(SMC_IO) $(SMC_SET)
	$(SMC_WANT)
	$(SMC) build $< $(SMC_ARGS) $(if $(SMC_IO),--io=$(SMC_IO)) -o $@ -MD -MP -MF $@.d

# Both files come from one call; the pattern tells make so.
%.c %.h: %.sm $(SMC_SV) $(SMC_SET)
	$(SMC_WANT)
	$(SMC) build $< $(SMC_ARGS) --emit=c -o $*.c -MD -MP -MF $*.sm.d

%_io.c %_io.h: %.io $(SMC_SV) $(SMC_SET)
	$(SMC_WANT)
	$(SMC) build $< $(SMC_ARGS) --emit=c -o $*_io.c -MD -MP -MF $*.io.d

%_net.c %_net.h: %.net $(SMC_SV) $(SMC_SET)
	$(SMC_WANT)
	$(SMC) build $< $(SMC_ARGS) --emit=c -o $*_net.c -MD -MP -MF $*.net.d

# For make, a rule whose file is not there is none: this one is taken then.  Nor is an image sent that was made before.
SMC_LOST = $(strip $(foreach f,$(SMC_SV) $(SMC_IO),$(if $(wildcard $f),,$f)))
%.smb: %.sm
	$(error there is no $(SMC_LOST), as SMC_SV or SMC_IO says)
.PRECIOUS: %.smb

# What failed stays to be read, but as old as can be, so that make makes it again.
SMC_OLD = { code=$$?; test ! -e $@ || touch -t 197001020000 $@; exit $$code; }
# The verdicts on the requirements tank.rq of tank.sm; it fails if one is violated or undecided.  Searches start from tank.ss and tank-*.ss.
%.proof: %.sm %.rq $(SMC_SV) $(SMC_SET)
	$(SMC_WANT)
	$(SMC) prove $< $*.rq $(wildcard $*.ss $*-*.ss) $(SMC_ARGS) -o $@ -MD -MP -MF $@.d || $(SMC_OLD)
# The page for a review; it fails if a script does, and is written all the same.
%.html: %.sm $(SMC_SV) $(SMC_SET)
	$(SMC_WANT)
	$(SMC) report $< $(wildcard $*.ss $*-*.ss) $(wildcard $*.rq) $(SMC_ARGS) $(SMC_REPORT) -o $@ -MD -MP -MF $@.d || $(SMC_OLD)
%.html: %.app $(SMC_SET)
	$(SMC_WANT)
	$(SMC) report $< $(wildcard $*.ss $*-*.ss) $(wildcard $*.rq) $(SMCFLAGS) $(SMC_REPORT) -o $@ -MD -MP -MF $@.d || $(SMC_OLD)

# Not %.smb alone: make wants a name that is no file.
flash-%: %.smb
	$(if $(SMC_LOST),$(error there is no $(SMC_LOST), as SMC_SV or SMC_IO says))
	$(SMC_WANT)
	$(SMC) flash $< --port=$(or $(PORT),$(error PORT=/dev/ttyACM0 says where the board is))
# The command compiles it, with names.  Of the options it takes those for warnings and the optimiser.
swap-%: $(or $(FROM),%.sm) $(SMC_SV)
	$(SMC_WANT)
	$(SMC) swap $*=$< $(filter -w -W% -O%,$(SMCFLAGS)) $(if $(SMC_APP),--app=$(SMC_APP).app,$(if $(SMC_SV),--sv=$(SMC_SV))) --to=$(or $(TO),$(error TO=stand.sock says where the application listens)) \
	    --$(or $(MODE),$(error MODE=continue or MODE=restart says how the machine goes on))
# What runs the scripts of the machine or application, tank.ss and tank-*.ss, with its requirements.  An application names its state vector itself.
SMC_TRY   = $< $(or $(wildcard $*.ss $*-*.ss),$(error there is no $*.ss)) $(wildcard $*.rq) $(filter -w -W%,$(SMCFLAGS)) $(SMC_TRY_SV)
SMC_TRY_SV = $(if $(and $(SMC_SV),$(filter %.sm,$<)),--sv=$(SMC_SV))
SMC_TEST  = $(SMC) test $(SMC_TRY) $(filter -O%,$(SMCFLAGS))
SMC_SWEEP = $(SMC) sweep $(SMC_TRY) --set=$(or $(SET),$(error SET=limit=700:900:21 says which parameter to sweep))
# Writes scripts into cover/ for what the scripts do not test.
SMC_COVER = $(SMC) cover $< $(wildcard $*.ss $*-*.ss) $(filter -w -W%,$(SMCFLAGS)) $(SMC_TRY_SV) -o cover
test-%: %.sm $(SMC_SV)
	$(SMC_WANT)
	$(SMC_TEST)
test-%: %.app
	$(SMC_WANT)
	$(SMC_TEST)
mutate-%: %.sm $(SMC_SV)
	$(SMC_WANT)
	$(SMC) mutate $(SMC_TRY)
mutate-%: %.app
	$(SMC_WANT)
	$(SMC) mutate $(SMC_TRY)
faults-%: %.sm $(SMC_SV)
	$(SMC_WANT)
	$(SMC) faults $(SMC_TRY)
faults-%: %.app
	$(SMC_WANT)
	$(SMC) faults $(SMC_TRY)
sweep-%: %.sm $(SMC_SV)
	$(SMC_WANT)
	$(SMC_SWEEP)
sweep-%: %.app
	$(SMC_WANT)
	$(SMC_SWEEP)
cover-%: %.sm $(SMC_SV)
	$(SMC_WANT)
	$(SMC_COVER)
cover-%: %.app
	$(SMC_WANT)
	$(SMC_COVER)
# Compares the machine with an earlier one; it fails if the behaviour differs.
diff-%: %.sm $(SMC_SV)
	$(SMC_WANT)
	$(SMC) diff $(or $(OLD),$(error OLD=flown.sm says which machine to compare with)) $< $(wildcard $*.ss $*-*.ss) $(filter -w -W%,$(SMCFLAGS)) $(if $(SMC_SV),--sv=$(SMC_SV))
SMC_MACHINES = $(basename $(wildcard *.sm))
flash: $(if $(word 2,$(SMC_MACHINES)),,$(SMC_MACHINES:%=flash-%))
	$(if $(filter 1,$(words $(SMC_MACHINES))),@:,$(error make flash-NAME says which machine; here are: $(SMC_MACHINES)))

# Of machines here and in folders within folders.
SMC_DEPS := $(foreach d,. */. */*/.,$(patsubst ./%,%,$(subst /./,/,$(wildcard $d/*.smb.d $d/*.sm.d $d/*.io.d $d/*.net.d $d/*.proof.d $d/*.html.d))))
-include $(SMC_DEPS)

# Each list of dependencies was written with what it is of.
SMC_WASTE = $(SMC_DEPS) $(patsubst %.d,%,$(filter %.smb.d %.proof.d %.html.d,$(SMC_DEPS))) \
            $(foreach d,$(patsubst %.sm.d,%,$(filter %.sm.d,$(SMC_DEPS))),$d.c $d.h) \
            $(foreach d,$(patsubst %.io.d,%,$(filter %.io.d,$(SMC_DEPS))),$d_io.c $d_io.h) \
            $(foreach d,$(patsubst %.net.d,%,$(filter %.net.d,$(SMC_DEPS))),$d_net.c $d_net.h)
.PHONY: smc-clean smc-changed flash
smc-clean:
	rm -f $(SMC_WASTE)
	$(if $(SMC_APP),rm -rf $(addprefix $(SMC_OUT)/obj/,made own $(notdir $(wildcard $(SMC_TREE)/runtime-c/psl/*))))
	$(if $(SMC_APP),@rmdir $(SMC_OUT)/obj $(SMC_OUT) 2>/dev/null || true)

.DEFAULT_GOAL := $(SMC_GOAL)

# ---- an application ----

ifdef SMC_APP
# (Blanks between a value and a comment belong to the value.)
SMC_APP      := $(strip $(SMC_APP))
ifneq ($(notdir $(SMC_APP)),$(SMC_APP))
$(error SMC_APP = $(SMC_APP): it is a name without a folder. Run make where $(notdir $(SMC_APP)).app is)
endif
$(SMC_APP):

SMC_HERE     := $(dir $(lastword $(filter %smc.mk,$(MAKEFILE_LIST))))
# Where runtime-c, bytecode-vm and stdlib are: beside this file where it is installed, above it in the source tree.
SMC_TREE     ?= $(patsubst %/,%,$(if $(wildcard $(SMC_HERE)runtime-c/runtime.mk),$(SMC_HERE),$(SMC_HERE)..))
SMC_PLATFORM := $(strip $(or $(SMC_PLATFORM),linux))
SMC_OUT      := $(strip $(or $(SMC_OUT),made))
SMC_PSL      := $(SMC_TREE)/runtime-c/psl/$(SMC_PLATFORM)/psl.mk
ifeq ($(wildcard $(SMC_PSL)),)
$(error SMC_PLATFORM = $(SMC_PLATFORM): there is none of that name; there are \
  $(notdir $(patsubst %/psl.mk,%,$(wildcard $(SMC_TREE)/runtime-c/psl/*/psl.mk))))
endif
SMC_CXX       = $(filter %.cc %.cpp,$(SMC_SOURCES))
ifneq ($(filter-out %.c %.cc %.cpp,$(SMC_SOURCES)),)
$(error SMC_SOURCES: $(filter-out %.c %.cc %.cpp,$(SMC_SOURCES)) ends in none of .c, .cc and .cpp)
endif
SMC_CFLAGS   ?= -O2 -g -Wall -Wextra
SMC_STAMP     = $(SMC_OUT)/obj/settings
SMC_WASTE    += $(SMC_APP) $(SMC_STAMP) $(SMC_MADE) $(addprefix $(SMC_OUT)/$(SMC_APP).mk,.d .new) $(SMC_OUT)/$(SMC_APP).mk

# What smc makes of it, and what that depends on: SMC_MADE, SMC_IMAGES and a rule.  (To clean is possible where the .app is broken.)
ifeq ($(filter-out %clean,$(or $(MAKECMDGOALS),all)),)
-include $(SMC_OUT)/$(SMC_APP).mk
else
include $(SMC_OUT)/$(SMC_APP).mk
$(SMC_OUT)/$(SMC_APP).mk: $(SMC_APP).app $(SMC_STAMP)
	@mkdir -p $(SMC_OUT)
	$(SMC_WANT)
	$(SMC) build $< $(SMCFLAGS) -o $(SMC_OUT) -MD -MP -MF $@.d
	@sed -n '1s/\(.*\): .*/SMC_MADE = \1/p' $@.d >$@.new
	@sed '1s|.*: |$@: |' $@.d >>$@.new
	@if cat $(SMC_OUT)/$(SMC_APP)_app.c $(SMC_OUT)/*_net.c 2>/dev/null | grep -q bytecode-vm; then echo 'SMC_IMAGES = yes' >>$@.new; fi
	@for f in $(SMC_MADE); do grep -qwF $$f $@.new || rm -f $$f; done
	@mv $@.new $@
$(SMC_MADE): | $(SMC_OUT)/$(SMC_APP).mk
endif

include $(SMC_TREE)/runtime-c/runtime.mk
include $(SMC_PSL)
SMC_RUNTIME  = $(RUNTIME) $(PSL) $(if $(SMC_IMAGES),$(RUNTIME_VM))
SMC_OBJECTS  = $(patsubst $(SMC_OUT)/%.c,$(SMC_OUT)/obj/made/%.o,$(filter %.c,$(SMC_MADE))) $(patsubst %,$(SMC_OUT)/obj/own/%.o,$(basename $(SMC_SOURCES))) \
               $(patsubst %.c,$(SMC_OUT)/obj/$(SMC_PLATFORM)/%.o,$(SMC_RUNTIME))
# The meaning of a program rests on plain IEEE arithmetic.
SMC_OPTIONS   = -ffp-contract=off -fno-tree-slp-vectorize -I$(SMC_OUT) -I. -I$(SMC_TREE) $(SMC_CFLAGS) -ffunction-sections -MMD -MP
SMC_COMPILE   = $(CC) -std=c99 $(SMC_OPTIONS) $(CFLAGS) -c $< -o $@
SMC_COMPILE_X = $(CXX) $(SMC_OPTIONS) $(CXXFLAGS) -c $< -o $@

# The options of the last build: another platform, watchdog, compiler or option rebuilds everything.
SMC_SETTINGS = $(strip $(SMC_PLATFORM) $(PSL_WATCHDOG) $(SMC_SOURCES) $(SMCFLAGS) $(CC) $(if $(SMC_CXX),$(CXX) $(CXXFLAGS)) $(SMC_CFLAGS) $(CFLAGS) $(LDFLAGS) $(LDLIBS))
ifneq ($(SMC_SETTINGS),$(strip $(shell cat $(SMC_STAMP) 2>/dev/null)))
$(SMC_STAMP): smc-changed
endif
$(SMC_STAMP):
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(SMC_SETTINGS))' >$@

$(SMC_APP): $(SMC_OBJECTS) $(SMC_STAMP)
	$(if $(SMC_CXX),$(CXX),$(CC)) $(SMC_CFLAGS) $(CFLAGS) $(LDFLAGS) -Wl,--gc-sections -o $@ $(SMC_OBJECTS) $(PSL_LIBS) $(LDLIBS)
$(SMC_OUT)/obj/made/%.o: $(SMC_OUT)/%.c $(SMC_STAMP)
	@mkdir -p $(@D)
	$(SMC_COMPILE)
$(SMC_OUT)/obj/own/%.o: %.c $(SMC_STAMP) | $(SMC_MADE)
	@mkdir -p $(@D)
	$(SMC_COMPILE)
$(SMC_OUT)/obj/own/%.o: %.cc $(SMC_STAMP) | $(SMC_MADE)
	@mkdir -p $(@D)
	$(SMC_COMPILE_X)
$(SMC_OUT)/obj/own/%.o: %.cpp $(SMC_STAMP) | $(SMC_MADE)
	@mkdir -p $(@D)
	$(SMC_COMPILE_X)
$(SMC_OUT)/obj/$(SMC_PLATFORM)/%.o: $(SMC_TREE)/%.c $(SMC_STAMP)
	@mkdir -p $(@D)
	$(SMC_COMPILE)
-include $(SMC_OBJECTS:.o=.d)
endif
