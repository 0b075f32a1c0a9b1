// SPDX-License-Identifier: Apache-2.0
// How the VM and the platform are set up in the library: on AVR as in the generic firmware, so that images may lie in flash or in EEPROM.
#ifdef __AVR__
#include "bytecode-vm/firmware/config.h"
#endif
