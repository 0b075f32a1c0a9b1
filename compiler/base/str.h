// SPDX-License-Identifier: Apache-2.0
// Interned strings (equal strings are the same object, so they compare by pointer), a map from them to pointers, and tests of characters.
#ifndef SMC_STR_H
#define SMC_STR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"

typedef struct StrData {
    uint32_t hash;
    uint32_t len;         // length in bytes, without the final NUL
    uint8_t mark;         // set by str_mark; 0: none
    bool declared;        // some source declares this name (str_declare)
    char text[1];         // len bytes and a NUL
} StrData;
typedef const StrData *Str;

typedef struct StrPool {
    Arena *arena;
    StrData **slot;       // hash table with open addressing
    size_t cap, n;        // cap is a power of two
} StrPool;

void str_pool_init(StrPool *p, Arena *arena);
Str str_intern(StrPool *p, const char *text, size_t len);
void str_declare(StrPool *p, Str name);                     // records that a source declares an element or a variable `name`
Str str_find(const StrPool *p, const char *text, size_t len);      // NULL if the text has not been interned
Str str_c(StrPool *p, const char *text);                    // interns a NUL-terminated string
void str_mark(StrPool *p, const char *text, uint8_t mark);   // sets StrData.mark, for fast tests whether a string is in a small set

// The edit distance from a to b: insertions, deletions, replacements and swaps of adjacent characters.  Returns at most `limit`.
size_t str_distance(const char *a, const char *b, size_t limit);
// Returns the word nearest to `word`; NULL if none is near.  Up to a third of its characters, plus one, can differ.
const char *str_nearest(const char *word, const char *const *among, size_t n);

// Whitespace within a line.  is_space_tab_or_return also accepts the carriage return before a line feed.
static inline bool is_space_or_tab(char c) { return c == ' ' || c == '\t'; }
static inline bool is_space_tab_or_return(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// A map from interned strings to pointers.  Zeroed memory with `arena` set is an empty map.
typedef struct Map {
    Arena *arena;
    Str *key;
    void **value;
    size_t cap, n;
} Map;

void *map_find(const Map *m, Str key);                      // returns the value; NULL if the map lacks the key
void map_put(Map *m, Str key, void *value);                 // replaces an existing value

#endif
