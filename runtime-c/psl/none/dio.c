// SPDX-License-Identifier: Apache-2.0
// Platform without digital pins.
#include "runtime-c/pal/dio.h"

SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level)
{
    (void)pin, (void)number, (void)mode, (void)level;
    return SM_E_UNSUPPORTED;
}

SmResult pal_dio_read(PalDio pin, bool *level)
{
    (void)pin, (void)level;
    return SM_E_UNSUPPORTED;
}

SmResult pal_dio_write(PalDio pin, bool level)
{
    (void)pin, (void)level;
    return SM_E_UNSUPPORTED;
}

SmResult pal_dio_close(PalDio pin)
{
    (void)pin;
    return SM_E_UNSUPPORTED;
}
