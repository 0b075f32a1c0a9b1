// SPDX-License-Identifier: Apache-2.0
// A table of entries behind handles, for any platform.  Entry i belongs to handle i + 1, so that {0} is never valid.  The caller
// provides an array of bool for the entries, and must prevent concurrent access while it takes one.
#ifndef PSL_TABLE_H
#define PSL_TABLE_H

#include <stdbool.h>
#include <stdint.h>

// Takes a free entry and returns its handle number, or 0 if all are in use.
static inline uint8_t psl_table_allocate(bool used[], uint8_t entries)
{
    for (uint8_t i = 0; i < entries; i++)
        if (!used[i]) {
            used[i] = true;
            return (uint8_t)(i + 1);
        }
    return 0;
}

// Whether a handle number refers to an entry in use.
static inline bool psl_table_is_used(const bool used[], uint8_t entries, uint8_t id)
{
    return id != 0 && id <= entries && used[id - 1];
}

#endif
