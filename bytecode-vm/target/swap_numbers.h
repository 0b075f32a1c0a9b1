// SPDX-License-Identifier: Apache-2.0
// Internal to swap_link.h: the key of an application, and the highest number of a signed swap, in non-volatile memory.  The memory has two
// records, which are written alternately, so that a power cut leaves one of them intact.
#ifndef SMVM_TARGET_SWAP_NUMBERS_H
#define SMVM_TARGET_SWAP_NUMBERS_H

#include "bytecode-vm/target/swap_link.h"

// Reads the key and the highest number.  *failed: the file that the result concerns.
// SM_E_ARGUMENT: the file of the key has no key.  SM_E_MISSING: there is no such file; nothing is created.  Otherwise the results of
// pal_nvm_load, pal_nvm_open and pal_nvm_read.
SmResult sm_swap_open_numbers(SmSwapLink *link, const char **failed);

// Stores a number that is above link->newest, and makes it link->newest.
SmResult sm_swap_store_number(SmSwapLink *link, uint32_t number);

#endif
