# SPDX-License-Identifier: Apache-2.0
# Rules for projects that build state machines, or whole applications:  include smc.mk
#   tank.smb from tank.sm: bytecode.      tank.c and tank.h from tank.sm: C99.      app_io.c and app_io.h from app.io: C99 for runtime-c.
#   make flash-tank PORT=/dev/ttyACM0: tank.smb onto a board; it is on trial until `smc device confirm`.
# Set SMC_SV to the application's state vector (app.sv) if there is one, SMCFLAGS to further options.
#   rocket from rocket.app: a program.  Set before the include
#     SMC_APP       rocket
#     SMC_SOURCES   what you wrote: navigation.c engine.c
#     SMC_PLATFORM  linux (default), or sim: time that nobody waits for (runtime-c/psl)
#     SMC_OUT       the folder for what is made: made

SMC      ?= smc
SMC_SV   ?=
SMCFLAGS ?=
SMC_ARGS  = $(SMCFLAGS) $(if $(SMC_SV),--sv=$(SMC_SV))

%.smb: %.sm $(SMC_SV)
	$(SMC) build $< $(SMC_ARGS) -o $@ -MD -MP -MF $@.d

# Both files come from one call; the pattern tells make so.
%.c %.h: %.sm $(SMC_SV)
	$(SMC) build $< $(SMC_ARGS) --emit=c -o $*.c -MD -MP -MF $*.sm.d -MT '$*.c $*.h'

%_io.c %_io.h: %.io $(SMC_SV)
	$(SMC) build $< $(SMC_ARGS) --emit=c -o $*_io.c -MD -MP -MF $*.io.d -MT '$*_io.c $*_io.h'

# Not %.smb alone: make wants a name that is no file.
flash-%: %.smb
	$(SMC) flash $< --port=$(or $(PORT),$(error PORT=/dev/ttyACM0 says where the board is))

-include $(wildcard *.smb.d *.sm.d *.io.d)

# ---- an application ----

ifdef SMC_APP
$(SMC_APP):

SMC_HERE     := $(dir $(lastword $(filter %smc.mk,$(MAKEFILE_LIST))))
# Where runtime-c, bytecode-vm and stdlib are: beside this file where it is installed, above it in the source tree.
SMC_TREE     ?= $(patsubst %/,%,$(if $(wildcard $(SMC_HERE)runtime-c/runtime.mk),$(SMC_HERE),$(SMC_HERE)..))
SMC_PLATFORM ?= linux
SMC_OUT      ?= made
SMC_CFLAGS   ?= -O2 -g -Wall -Wextra

# What smc makes of it, and what that depends on: SMC_MADE, SMC_IMAGES and a rule.
include $(SMC_OUT)/$(SMC_APP).mk
$(SMC_OUT)/$(SMC_APP).mk: $(SMC_APP).app
	@mkdir -p $(SMC_OUT)
	$(SMC) build $< $(SMCFLAGS) -o $(SMC_OUT) -MD -MP -MF $@.d
	@sed -n '1s/\(.*\): .*/SMC_MADE = \1/p' $@.d >$@.new
	@sed '1s|.*: |$@: |' $@.d >>$@.new
	@if grep -q bytecode-vm $(SMC_OUT)/$(SMC_APP)_app.c; then echo 'SMC_IMAGES = yes' >>$@.new; fi
	@mv $@.new $@
$(SMC_MADE): | $(SMC_OUT)/$(SMC_APP).mk

include $(SMC_TREE)/runtime-c/runtime.mk
include $(SMC_TREE)/runtime-c/psl/$(SMC_PLATFORM)/psl.mk
SMC_RUNTIME  = $(RUNTIME) $(PSL) $(if $(SMC_IMAGES),$(RUNTIME_VM))
SMC_OBJECTS  = $(patsubst $(SMC_OUT)/%.c,$(SMC_OUT)/obj/made/%.o,$(filter %.c,$(SMC_MADE))) $(SMC_SOURCES:%.c=$(SMC_OUT)/obj/own/%.o) \
               $(patsubst %.c,$(SMC_OUT)/obj/$(SMC_PLATFORM)/%.o,$(SMC_RUNTIME))
# The meaning of a program rests on plain IEEE arithmetic.
SMC_COMPILE  = $(CC) -std=c99 -ffp-contract=off -fno-tree-slp-vectorize -I$(SMC_OUT) -I. -I$(SMC_TREE) $(SMC_CFLAGS) $(CFLAGS) -ffunction-sections -MMD -MP -c $< -o $@

$(SMC_APP): $(SMC_OBJECTS)
	$(CC) $(SMC_CFLAGS) $(CFLAGS) $(LDFLAGS) -Wl,--gc-sections -o $@ $^ $(PSL_LIBS) $(LDLIBS)
$(SMC_OUT)/obj/made/%.o: $(SMC_OUT)/%.c
	@mkdir -p $(@D)
	$(SMC_COMPILE)
$(SMC_OUT)/obj/own/%.o: %.c | $(SMC_MADE)
	@mkdir -p $(@D)
	$(SMC_COMPILE)
$(SMC_OUT)/obj/$(SMC_PLATFORM)/%.o: $(SMC_TREE)/%.c
	@mkdir -p $(@D)
	$(SMC_COMPILE)
-include $(SMC_OBJECTS:.o=.d)
endif
