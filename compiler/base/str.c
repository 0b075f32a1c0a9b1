// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/str.h"

#include <string.h>

#include "compiler/base/vec.h"

// Makes room for another item of a vector that is full: doubles its capacity.
void vec_reserve(Arena *a, void **items, uint32_t *cap, size_t item_size)
{
    const uint32_t wanted = *cap ? *cap * 2 : 4;

    if (*cap > UINT32_MAX / 2 || wanted > SIZE_MAX / item_size)
        longjmp(*a->oom, 1);
    *items = arena_grow_unzeroed(a, *items, *cap * item_size, wanted * item_size);
    *cap = wanted;
}

static uint32_t hash_bytes(const char *s, size_t len)      // FNV-1a
{
    uint32_t h = 2166136261u;

    for (size_t i = 0; i < len; i++)
        h = (h ^ (unsigned char)s[i]) * 16777619u;
    return h;
}

void str_pool_init(StrPool *p, Arena *arena)
{
    memset(p, 0, sizeof *p);
    p->arena = arena;
}

// Doubles the hash table and inserts every string again.
static void grow_pool(StrPool *p)
{
    size_t cap = p->cap ? p->cap * 2 : 256;
    StrData **slot = ARENA_ARRAY(p->arena, StrData *, cap);

    for (size_t i = 0; i < p->cap; i++) {
        size_t at;
        if (!p->slot[i])
            continue;
        for (at = p->slot[i]->hash & (cap - 1); slot[at]; at = (at + 1) & (cap - 1))
            ;
        slot[at] = p->slot[i];
    }
    p->slot = slot;
    p->cap = cap;
}

// Returns the slot of the string in the hash table, or the free slot where it would be inserted.
static size_t find_slot(const StrPool *p, const char *text, size_t len, uint32_t hash)
{
    size_t at = hash & (p->cap - 1);

    while (p->slot[at] && !(p->slot[at]->hash == hash && p->slot[at]->len == len && memcmp(p->slot[at]->text, text, len) == 0))
        at = (at + 1) & (p->cap - 1);
    return at;
}

// Returns the interned string of this text; NULL if the text has not been interned.
Str str_find(const StrPool *p, const char *text, size_t len)
{
    return p->cap ? p->slot[find_slot(p, text, len, hash_bytes(text, len))] : NULL;
}

static StrData *find_or_add_string(StrPool *p, const char *text, size_t len)
{
    uint32_t hash = hash_bytes(text, len);
    size_t at;
    StrData *s;

    if (p->n * 2 >= p->cap)
        grow_pool(p);
    at = find_slot(p, text, len, hash);
    if (p->slot[at])
        return p->slot[at];
    s = arena_alloc(p->arena, sizeof *s + len);
    s->hash = hash;
    s->len = (uint32_t)len;
    memcpy(s->text, text, len);
    p->slot[at] = s;
    p->n++;
    return s;
}

Str str_intern(StrPool *p, const char *text, size_t len)
{
    return find_or_add_string(p, text, len);
}

Str str_c(StrPool *p, const char *text)
{
    return str_intern(p, text, strlen(text));
}

// Records that a source declares an element or a variable `name`.
void str_declare(StrPool *p, Str name)
{
    find_or_add_string(p, name->text, name->len)->declared = true;
}

// Sets StrData.mark, for fast tests whether a string is in a small set.
void str_mark(StrPool *p, const char *text, uint8_t mark)
{
    find_or_add_string(p, text, strlen(text))->mark = mark;
}

// Returns the smallest of the three.
static size_t smallest(size_t a, size_t b, size_t c)
{
    size_t m = a < b ? a : b;
    return m < c ? m : c;
}

// Returns the edit distance from a to b, at most `limit`: insertions, deletions, replacements and swaps of adjacent characters.
size_t str_distance(const char *a, const char *b, size_t limit)
{
    enum { LONGEST = 64 };                                  // the distance of longer strings is not computed: it counts as `limit`
    size_t row[3][LONGEST + 1];
    size_t la = strlen(a), lb = strlen(b);
    size_t *before = row[0], *last = row[1], *now = row[2];

    if (la > LONGEST || lb > LONGEST || (la > lb ? la - lb : lb - la) >= limit)
        return limit;
    for (size_t j = 0; j <= lb; j++)
        last[j] = j;
    for (size_t i = 1; i <= la; i++) {
        size_t *spare = before;
        now[0] = i;
        for (size_t j = 1; j <= lb; j++) {
            size_t cost = a[i - 1] != b[j - 1];
            now[j] = smallest(last[j] + 1, now[j - 1] + 1, last[j - 1] + cost);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && before[j - 2] + 1 < now[j])
                now[j] = before[j - 2] + 1;
        }
        before = last;
        last = now;
        now = spare;
    }
    return last[lb] < limit ? last[lb] : limit;
}

// Returns the slot of the key, or the free slot where it would be inserted. The map must have slots.
static size_t find_map_slot(const Map *m, Str key)
{
    size_t at = key->hash & (m->cap - 1);

    while (m->key[at] && m->key[at] != key)
        at = (at + 1) & (m->cap - 1);
    return at;
}

// Returns the value of a key; NULL if the map lacks the key.
void *map_find(const Map *m, Str key)
{
    return m->cap ? m->value[find_map_slot(m, key)] : NULL;
}

// Doubles the hash table and inserts every key again.
static void grow_map(Map *m)
{
    Map bigger = {m->arena, NULL, NULL, m->cap ? m->cap * 2 : 16, m->n};

    bigger.key = ARENA_ARRAY(m->arena, Str, bigger.cap);
    bigger.value = ARENA_ARRAY(m->arena, void *, bigger.cap);
    for (size_t i = 0; i < m->cap; i++)
        if (m->key[i]) {
            size_t at = find_map_slot(&bigger, m->key[i]);
            bigger.key[at] = m->key[i];
            bigger.value[at] = m->value[i];
        }
    *m = bigger;
}

// Sets the value of a key, in place of an existing value.
void map_put(Map *m, Str key, void *value)
{
    size_t at;

    if (m->n * 2 >= m->cap)
        grow_map(m);
    at = find_map_slot(m, key);
    m->n += m->key[at] == NULL;
    m->key[at] = key;
    m->value[at] = value;
}

// Returns the word nearest to `word`; NULL if none is near.
const char *str_nearest(const char *word, const char *const *among, size_t n)
{
    size_t limit = strlen(word) / 3 + 2;
    const char *found = NULL;

    for (size_t i = 0; i < n; i++) {
        const size_t d = str_distance(word, among[i], limit);
        if (d < limit) {
            limit = d;
            found = among[i];
        }
    }
    return found;
}
