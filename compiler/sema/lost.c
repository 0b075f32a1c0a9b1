// SPDX-License-Identifier: Apache-2.0
// What the parser's errors may have hidden: the words of an unreadable declaration, or of a section whose header is unreadable.
// If such a word is unknown later, that follows from an error already reported.
#include "compiler/sema/sema.h"

// The number of sections that begin at or before a position.
static size_t sections_up_to(const AstFile *f, uint32_t at)
{
    size_t low = 0, high = f->sections.n;

    while (low < high) {
        size_t middle = (low + high) / 2;
        if (f->sections.at[middle]->header.at <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

// The last declaration that begins at or before a position; NULL if there is none.
static const AstDecl *decl_at(const AstSection *section, uint32_t at)
{
    size_t low = 0, high = section->decls.n;

    while (low < high) {
        size_t middle = (low + high) / 2;
        if (section->decls.at[middle].type_span.at <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low ? &section->decls.at[low - 1] : NULL;
}

// Whether an error is on the line of a declaration after its name, so that it hides no name.  After an @ it may hide an alias.
static bool hides_no_name(const AstSection *section, Span error)
{
    const AstDecl *decl = decl_at(section, error.at);
    const char *c, *end = error.src->text + error.at;

    if (!decl)
        return false;
    for (c = error.src->text + decl->type_span.at; c < end; c++)
        if (*c == '\n' || *c == '@')
            return false;
    return *end != '@';
}

// Whether an error may have hidden a declaration.
static bool may_hide(const AstSection *section, Span error)
{
    switch (section->kind) {
    case AST_STATE_VECTOR: case AST_LOCAL: case AST_REGION:
        return error.at >= section->header.at + section->header.len && !hides_no_name(section, error);
    case AST_STATE: case AST_SCRIPT_STATE: case AST_OPTIONS: case AST_PINS: case AST_IGNORED:
        return false;
    }
    return true;
}

// ---- words ----

static bool is_name_char(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

// Adds every word in a range of the source to the hidden names.
static void add_words(HiddenNames *l, StrPool *strings, const Source *src, uint32_t from, uint32_t to)
{
    for (uint32_t at = from; at < to; at++) {
        uint32_t start = at;
        while (at < to && is_name_char(src->text[at]))
            at++;
        if (at > start) {
            Str word = str_intern(strings, src->text + start, at - start);
            map_put(&l->word, word, (void *)word);
        }
    }
}

// ---- all errors of a file ----

typedef struct HiddenWords {
    HiddenNames *l;
    StrPool *strings;
    const AstFile *f;
    uint32_t done;                // words before this position are already added
} HiddenWords;

static void add_hidden_range(HiddenWords *k, uint32_t from, uint32_t to)
{
    k->l->names = true;
    if (from < k->done)
        from = k->done;
    add_words(k->l, k->strings, k->f->src, from, to);
    if (to > k->done)
        k->done = to;
}

static void add_hidden_line(HiddenWords *k, uint32_t at)
{
    const char *text = k->f->src->text;
    uint32_t from = at, to = at;

    while (from > k->done && text[from - 1] != '\n')
        from--;
    while (to < k->f->src->len && text[to] != '\n')
        to++;
    add_hidden_range(k, from, to);
}

// Whether a section is parsed as a state but has no block: it may have been intended for declarations.
static bool lacks_blocks(const AstSection *section)
{
    bool blocks = section->kind != AST_STATE;

    for (size_t i = 0; i < AST_LABEL_COUNT; i++)
        blocks = blocks || section->block[i].present;
    return !blocks;
}

// Adds the names that an error may have hidden: to the end of its section, of its line, or none.
static void add_names_hidden_by(HiddenWords *k, const Diag *d)
{
    const Span error = d->span;
    size_t n = sections_up_to(k->f, error.at);
    const AstSection *section = n > 0 ? k->f->sections.at[n - 1] : NULL;
    uint32_t end = n < k->f->sections.n ? k->f->sections.at[n]->header.at : k->f->src->len;

    if (!section || section->name->len == 0) {          // its header is missing or unreadable
        k->l->sections = true;
        add_hidden_range(k, error.at, end);
    } else if (d->code == DIAG_code_before_label && lacks_blocks(section)) {
        add_hidden_range(k, error.at, end);
    } else if (may_hide(section, error))
        add_hidden_line(k, error.at);
}

HiddenNames *find_hidden_names(const CheckContext *c, const AstFile *f)
{
    HiddenNames *l = ARENA_NEW(c->arena, HiddenNames);
    HiddenWords k = {l, c->strings, f, 0};

    l->word.arena = c->arena;
    for (size_t i = 0; i < c->diags->list.n; i++) {
        const Diag *e = c->diags->list.at[i];
        if (e->severity == DIAG_ERROR && e->span.src == f->src) {
            l->any = true;
            add_names_hidden_by(&k, e);
        }
    }
    return l;
}
