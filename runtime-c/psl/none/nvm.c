// SPDX-License-Identifier: Apache-2.0
// Platform without non-volatile memory.
#include "runtime-c/pal/nvm.h"

SmResult pal_nvm_open(PalNvm *memory, const char *name, uint32_t size)
{
    (void)memory, (void)name, (void)size;
    return SM_E_UNSUPPORTED;
}

SmResult pal_nvm_load(const char *name, void *bytes, uint32_t n)
{
    (void)name, (void)bytes, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_nvm_info(PalNvm memory, PalNvmInfo *info)
{
    (void)memory, (void)info;
    return SM_E_UNSUPPORTED;
}

SmResult pal_nvm_read(PalNvm memory, uint32_t at, void *bytes, uint32_t n)
{
    (void)memory, (void)at, (void)bytes, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_nvm_write(PalNvm memory, uint32_t at, const void *bytes, uint32_t n)
{
    (void)memory, (void)at, (void)bytes, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_nvm_erase(PalNvm memory, uint32_t at, uint32_t n)
{
    (void)memory, (void)at, (void)n;
    return SM_E_UNSUPPORTED;
}

SmResult pal_nvm_close(PalNvm memory)
{
    (void)memory;
    return SM_E_UNSUPPORTED;
}
