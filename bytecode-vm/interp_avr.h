// SPDX-License-Identifier: Apache-2.0
// What interp.c and interp_avr.S have in common on AVR: whether there is assembly, and where in Run and SmVm what lies.
#ifndef SMVM_INTERP_AVR_H
#define SMVM_INTERP_AVR_H

#define RUN_VM 0
#define RUN_SV 2
#define RUN_LOCALS 4
#define RUN_X 6               // a number: 8 bytes, and whether it is an F64
#define RUN_Y 15
#define RUN_FUNCTIONS 24      // where in the image
#define RUN_CODE 26
#define RUN_OUTPUTS 28
#define RUN_WIDTH 30          // bytes of an entry in the table of functions

#define VM_START 2
#define VM_NEXT 10
#define VM_STORED 18

#endif
