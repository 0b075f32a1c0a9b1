# SPDX-License-Identifier: Apache-2.0
# What an application links of the runtime, relative to the root of this tree; a platform's psl.mk gives the rest.
RUNTIME_ROOT := $(dir $(lastword $(MAKEFILE_LIST)))..
RUNTIME       = $(patsubst $(RUNTIME_ROOT)/%,%,$(wildcard $(RUNTIME_ROOT)/runtime-c/*.c)) stdlib/result.c
