// SPDX-License-Identifier: Apache-2.0
// Platform without analog channels.
#include "runtime-c/pal/aio.h"

SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode)
{
    (void)channel, (void)number, (void)mode;
    return SM_E_UNSUPPORTED;
}

SmResult pal_aio_info(PalAio channel, PalAioInfo *info)
{
    (void)channel, (void)info;
    return SM_E_UNSUPPORTED;
}

SmResult pal_aio_read(PalAio channel, int32_t *millionths)
{
    (void)channel, (void)millionths;
    return SM_E_UNSUPPORTED;
}

SmResult pal_aio_write(PalAio channel, int32_t millionths)
{
    (void)channel, (void)millionths;
    return SM_E_UNSUPPORTED;
}

SmResult pal_aio_close(PalAio channel)
{
    (void)channel;
    return SM_E_UNSUPPORTED;
}
