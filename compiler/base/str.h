// SPDX-License-Identifier: Apache-2.0
// Interned strings: equal text is one object, so they compare by pointer.  And the map from them to anything.
#ifndef SMC_STR_H
#define SMC_STR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"

typedef struct StrData {
    uint32_t hash;
    uint32_t len;         // without the closing NUL
    uint8_t mark;         // whatever str_mark gave it; 0: nothing
    bool declared;        // by str_declare
    char text[1];         // len bytes and a NUL
} StrData;
typedef const StrData *Str;

typedef struct StrPool {
    Arena *arena;
    StrData **slot;       // open addressing, a power of two long
    size_t cap, n;
} StrPool;

void str_pool_init(StrPool *p, Arena *arena);
Str str_intern(StrPool *p, const char *text, size_t len);
void str_declare(StrPool *p, Str name);                     // a source declares an element or a variable of that name
Str str_find(const StrPool *p, const char *text, size_t len);      // NULL when it has not been interned
Str str_c(StrPool *p, const char *text);                    // of a C string
void str_mark(StrPool *p, const char *text, uint8_t mark);   // for whoever asks of every string whether it is one of a few

// How many single-letter edits (insert, delete, replace, swap neighbours) lead from a to b; `limit` or more gives `limit`.
size_t str_distance(const char *a, const char *b, size_t limit);

// A map from interned string to pointer.  Zeroed memory with `arena` set is an empty one.
typedef struct Map {
    Arena *arena;
    Str *key;
    void **value;
    size_t cap, n;
} Map;

void *map_find(const Map *m, Str key);                      // NULL when absent
void map_put(Map *m, Str key, void *value);                 // replaces what was there

#endif
