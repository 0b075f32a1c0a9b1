// SPDX-License-Identifier: Apache-2.0
// Platform with only one thread.
#include "runtime-c/pal/thread.h"

SmResult pal_thread_create(PalThread *thread, const PalThreadPlan *plan, PalThreadMain *run, void *argument)
{
    (void)thread, (void)plan, (void)run, (void)argument;
    return SM_E_UNSUPPORTED;
}

SmResult pal_thread_join(PalThread thread, uint64_t timeout)
{
    (void)thread, (void)timeout;
    return SM_E_UNSUPPORTED;
}

bool pal_thread_is_realtime(PalThread thread)
{
    (void)thread;
    return false;
}

SmResult pal_thread_set_priority(uint8_t priority)
{
    (void)priority;
    return SM_E_UNSUPPORTED;
}
