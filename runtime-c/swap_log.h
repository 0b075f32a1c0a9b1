// SPDX-License-Identifier: Apache-2.0
// Internal to swaps: the names of a machine that another one has replaced, in the flight log (docs/log.md, block N).
#ifndef SM_SWAP_LOG_H
#define SM_SWAP_LOG_H

#include "runtime-c/log.h"

// Appends a block with the names of the states of the machine in `slot`, whose image has the checksum `identity`.  Called by the thread that
// drains the log.  Returns false if the log is in the middle of another block, or the medium fails; then the caller tries again later.
bool sm_swap_log_names(SmLog *log, const SmMachine *m, const void *slot, uint32_t identity);

#endif
