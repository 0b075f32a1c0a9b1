// SPDX-License-Identifier: Apache-2.0
// Finds elements and regions of the state vector by name.
#include "runtime-c/statevec.h"

static bool same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

// The index of `name` among n names; n if it is not found.
static uint16_t find(const char *const *names, uint16_t n, const char *name)
{
    uint16_t i = 0;

    while (i < n && !same(names[i], name))
        i++;
    return i;
}

const SmElement *sm_find_element(const SmNames *names, const char *name)
{
    uint16_t i;

    if (!names || !name)
        return NULL;
    i = find(names->element, names->layout->elements, name);
    return i < names->layout->elements ? &names->layout->element[i] : NULL;
}

const SmRegion *sm_find_region(const SmNames *names, const char *name)
{
    uint16_t i;

    if (!names || !name)
        return NULL;
    if (same(name, "*"))
        return &names->layout->whole;
    i = find(names->region, names->layout->regions, name);
    return i < names->layout->regions ? &names->layout->region[i] : NULL;
}
