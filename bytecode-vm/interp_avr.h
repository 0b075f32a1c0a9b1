// SPDX-License-Identifier: Apache-2.0
// Shared by interp.c and interp_avr.S on AVR: offsets of the members of SmVm, and the results of a step.
#ifndef SMVM_INTERP_AVR_H
#define SMVM_INTERP_AVR_H

#define VM_IMAGE 0
#define VM_START 2
#define VM_NEXT 10
#define VM_STORED 18
#define VM_CODE 28
#define VM_LOCAL 30
#define VM_STATE 32
#define VM_WINDOWS 34
#define VM_OUTPUTS 36
#define VM_FUNCTIONS 38
#define VM_F32S 40
#define VM_F64S 42
#define VM_MORE 44
#define VM_MORE_BYTES 46
#define VM_G 48
#define VM_S 50
#define VM_WIDTH 52
#define VM_FLAGS 53
#define VM_BODY 54
#define VM_Y 56

// Bits of VM_FLAGS.
#define VM_FIRST 0
#define VM_ENTERED 1
#define VM_SAMPLES 2
#define VM_MANY 3

#define STEP_OK 0
#define STEP_REFUSED -1

#endif
