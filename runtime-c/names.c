// SPDX-License-Identifier: Apache-2.0
// Finds elements and regions of the state vector by name.
#include "runtime-c/statevec.h"

static bool is_same_name(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

// Returns the index of `name` among n names; n if it is not found.
static uint16_t find_name(const char *const *names, uint16_t n, const char *name)
{
    uint16_t i = 0;

    while (i < n && !is_same_name(names[i], name))
        i++;
    return i;
}

// Finds an element by name; NULL if no element has it.
const SmElement *sm_find_element(const SmNames *names, const char *name)
{
    uint16_t i;

    if (!names || !name)
        return NULL;
    i = find_name(names->element, names->layout->elements, name);
    return i < names->layout->elements ? &names->layout->element[i] : NULL;
}

// Finds a region by name; "*" is the whole vector.
const SmRegion *sm_find_region(const SmNames *names, const char *name)
{
    uint16_t i;

    if (!names || !name)
        return NULL;
    if (is_same_name(name, "*"))
        return &names->layout->whole;
    i = find_name(names->region, names->layout->regions, name);
    return i < names->layout->regions ? &names->layout->region[i] : NULL;
}
