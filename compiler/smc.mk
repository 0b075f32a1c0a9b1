# SPDX-License-Identifier: Apache-2.0
# Pattern rules for projects that build state machines:  include smc.mk
#   tank.smb from tank.sm: bytecode.      tank.c and tank.h from tank.sm: C99.
# Set SMC_SV to the application's state vector (app.sv) if there is one, SMCFLAGS to further options.

SMC      ?= smc
SMC_SV   ?=
SMCFLAGS ?=
SMC_ARGS  = $(SMCFLAGS) $(if $(SMC_SV),--sv=$(SMC_SV))

%.smb: %.sm $(SMC_SV)
	$(SMC) build $< $(SMC_ARGS) -o $@ -MD -MP -MF $@.d

# Both files come from one call; the pattern tells make so.
%.c %.h: %.sm $(SMC_SV)
	$(SMC) build $< $(SMC_ARGS) --emit=c -o $*.c -MD -MP -MF $*.sm.d -MT '$*.c $*.h'

-include $(wildcard *.smb.d *.sm.d)
