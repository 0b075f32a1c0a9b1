// SPDX-License-Identifier: Apache-2.0
// The sender: its numbers follow a rule that a receiver can check.
#include "sender_app.h"

SmResult source_step(const SmTick *tick)
{
    const uint32_t n = (uint32_t)tick->number;

    link_set_n(n);
    link_set_square((uint64_t)n * n);
    link_set_half(n / 2.0);
    link_set_odd(n & 1);
    return SM_OK;
}
