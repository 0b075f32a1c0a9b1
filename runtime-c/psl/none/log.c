// SPDX-License-Identifier: Apache-2.0
// Platform without files.
#include "runtime-c/pal/log.h"

SmResult pal_log_open(PalLogFile *file, const char *name)
{
    (void)file, (void)name;
    return SM_E_UNSUPPORTED;
}

SmResult pal_log_append(PalLogFile file, const void *bytes, size_t n)
{
    (void)file, (void)bytes, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_log_sync(PalLogFile file)
{
    (void)file;
    return SM_E_UNSUPPORTED;
}

SmResult pal_log_read(PalLogFile file, void *bytes, size_t n)
{
    (void)file, (void)bytes, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_log_size(PalLogFile file, uint64_t *size)
{
    (void)file, (void)size;
    return SM_E_UNSUPPORTED;
}

SmResult pal_log_close(PalLogFile file)
{
    (void)file;
    return SM_E_UNSUPPORTED;
}
