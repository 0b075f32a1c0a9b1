// SPDX-License-Identifier: Apache-2.0
// Computes fingerprints, which recognise a finding after lines above it were added or removed. A fingerprint is a hash of the code, the
// file's name and the text of the line, and a number that distinguishes findings with the same hash.
#include <stdlib.h>
#include <string.h>

#include "compiler/base/str.h"
#include "compiler/diag/diag.h"

typedef struct FingerprintItem { const Diag *diag; DiagFingerprint *print; } FingerprintItem;

static uint64_t hash_text(uint64_t h, const char *s, size_t n)         // FNV-1a
{
    for (size_t i = 0; i < n; i++)
        h = (h ^ (unsigned char)s[i]) * 1099511628211u;
    return h;
}

// Returns the length of the line up to its comment; n if the line has no comment.
static size_t length_without_comment(const char *s, size_t n)
{
    bool quoted = false;

    for (size_t i = 0; i < n; i++)
        if (s[i] == '"')
            quoted = !quoted;
        else if (s[i] == '#' && !quoted)
            return i;
    return n;
}

// Hashes a line. Any run of spaces and tabs between words counts as one space; comments are ignored.
static uint64_t hash_line(uint64_t h, const char *s, size_t n)
{
    n = length_without_comment(s, n);
    while (n && is_space_or_tab(s[n - 1]))
        n--;
    while (n && is_space_or_tab(*s))
        s++, n--;
    for (size_t i = 0; i < n; i++)
        if (!is_space_or_tab(s[i]))
            h = hash_text(h, s + i, 1);
        else if (!is_space_or_tab(s[i - 1]))
            h = hash_text(h, " ", 1);
    return h;
}

// Hashes the code, the file name and the text of the line, not its number: so the hash survives changes elsewhere in the file.
static uint64_t hash_diagnostic(const Diag *d)
{
    const char *id = diag_info[d->code].id, *file, *line;
    uint64_t h = hash_text(14695981039346656037u, id, strlen(id) + 1);
    uint32_t len;

    if (!d->span.src)
        return hash_text(h, d->text, strlen(d->text));
    file = d->span.src->name;
    for (const char *at = file; *at; at++)                // the name without its folders
        if (*at == '/' || *at == '\\')
            file = at + 1;
    line = source_line(d->span.src, source_position(d->span.src, d->span.at).line, &len);
    return hash_line(hash_text(h, file, strlen(file) + 1), line, len);
}

// Orders findings by hash, then by position in the file.
static int compare_items(const void *a, const void *b)
{
    const FingerprintItem *x = a, *y = b;

    if (x->print->hash != y->print->hash)
        return x->print->hash < y->print->hash ? -1 : 1;
    if (x->diag->span.at != y->diag->span.at)
        return x->diag->span.at < y->diag->span.at ? -1 : 1;
    return (x->print > y->print) - (x->print < y->print);
}

// Returns a fingerprint for each of d->list, then of d->allowed.
const DiagFingerprint *diags_fingerprints(const Diags *d, Arena *arena)
{
    size_t n = d->list.n + d->allowed.n;
    DiagFingerprint *all = ARENA_ARRAY(arena, DiagFingerprint, n + 1);
    FingerprintItem *item = ARENA_ARRAY(arena, FingerprintItem, n + 1);

    for (size_t i = 0; i < n; i++) {
        item[i].diag = i < d->list.n ? d->list.at[i] : d->allowed.at[i - d->list.n];
        item[i].print = &all[i];
        all[i].hash = hash_diagnostic(item[i].diag);
    }
    qsort(item, n, sizeof *item, compare_items);
    for (size_t i = 0; i < n; i++)
        item[i].print->twin = i && item[i - 1].print->hash == item[i].print->hash ? item[i - 1].print->twin + 1 : 1;
    return all;
}
