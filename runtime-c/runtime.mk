# SPDX-License-Identifier: Apache-2.0
# The runtime's sources for an application, relative to the root of this tree.  A platform's psl.mk lists the others.
RUNTIME_ROOT := $(dir $(lastword $(MAKEFILE_LIST)))..
RUNTIME       = $(patsubst $(RUNTIME_ROOT)/%,%,$(wildcard $(RUNTIME_ROOT)/runtime-c/*.c)) stdlib/result.c
# Additional sources for machines that run as images, and for messages with a key.
RUNTIME_VM    = bytecode-vm/load.c bytecode-vm/interp.c bytecode-vm/function.c bytecode-vm/pins.c bytecode-vm/verify.c bytecode-vm/debug.c bytecode-vm/target/machine.c stdlib/tables.c \
                bytecode-vm/swap.c bytecode-vm/target/slot.c bytecode-vm/target/swap_link.c bytecode-vm/target/swap_serve.c bytecode-vm/target/swap_numbers.c bytecode-vm/target/swap_store.c \
                bytecode-vm/auth.c bytecode-vm/target/seal.c bytecode-vm/permit.c runtime-c/link/link.c
