# SPDX-License-Identifier: Apache-2.0
# What an application links of the runtime, relative to the root of this tree; a platform's psl.mk gives the rest.
RUNTIME_ROOT := $(dir $(lastword $(MAKEFILE_LIST)))..
RUNTIME       = $(patsubst $(RUNTIME_ROOT)/%,%,$(wildcard $(RUNTIME_ROOT)/runtime-c/*.c)) stdlib/result.c
# And for machines that run as images.
RUNTIME_VM    = bytecode-vm/load.c bytecode-vm/interp.c bytecode-vm/pins.c bytecode-vm/verify.c bytecode-vm/debug.c bytecode-vm/target/machine.c stdlib/tables.c
