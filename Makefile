# SPDX-License-Identifier: Apache-2.0
# Builds smc with a C compiler and make, nothing else.  `make help` lists the targets.

B       ?= build
CC      ?= cc
AR      ?= ar
CFLAGS  ?= -O2 -g
PREFIX  ?= /usr/local
WARN     = -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -pedantic
# The meaning of a program rests on plain IEEE arithmetic: no contraction of a*b+c, whatever CFLAGS says.
STRICT_C = -std=c99 -ffp-contract=off -I. -I$(B)/gen

VERSION := $(shell sed -n 's/.*SMC_VERSION "\(.*\)".*/\1/p' compiler/version.h)

# Sources, folder by folder in the order data flows through them.
STDLIB   = $(wildcard stdlib/*.c)
VM       = $(wildcard bytecode-vm/*.c)
EMIT_C   = $(filter-out %/embed_tool.c,$(wildcard compiler/emit/c/*.c))
LIBSMC   = $(filter-out compiler/base/os_%,$(wildcard compiler/base/*.c)) $(wildcard compiler/diag/*.c compiler/syntax/*.c compiler/sema/*.c compiler/ir/*.c \
             compiler/passes/*.c compiler/analysis/*.c) $(EMIT_C) $(wildcard compiler/emit/bytecode/*.c compiler/script/*.c compiler/*.c) $(STDLIB) $(VM)
COMMAND  = compiler/base/os_posix.c $(wildcard compiler/device/*.c compiler/cli/*.c)

all: $(B)/smc

$(B)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -MMD -MP -c $< -o $@

$(B)/libsmc.a: $(LIBSMC:%.c=$(B)/obj/%.o)
	@rm -f $@
	$(AR) rcs $@ $^

$(B)/smc: $(COMMAND:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

# The texts of the stdlib functions that emitted C quotes.
EMBEDDED = stdlib/f64.h stdlib/convert.h stdlib/math.h stdlib/roll.h
$(B)/embed_tool: compiler/emit/c/embed_tool.c
	@mkdir -p $(@D)
	$(CC) -std=c99 -pedantic -Wall -Wextra $< -o $@

$(B)/gen/stdlib_text.h: $(B)/embed_tool $(EMBEDDED)
	@mkdir -p $(@D)
	$(B)/embed_tool $(EMBEDDED) >$@.new && mv $@.new $@

$(EMIT_C:%.c=$(B)/obj/%.o): | $(B)/gen/stdlib_text.h

# One program per file of tests/unit.
UNIT = $(patsubst tests/unit/%.c,$(B)/unit/%,$(wildcard tests/unit/*.c))
$(B)/unit/%: tests/unit/%.c $(B)/libsmc.a
	@mkdir -p $(@D)
	$(CC) $(STRICT_C) $(WARN) $(CFLAGS) -MMD -MP $< -o $@ $(B)/libsmc.a -lm

clean:
	rm -rf $(B)

.PHONY: all clean
-include $(shell find $(B) -name '*.d' 2>/dev/null)
