// SPDX-License-Identifier: Apache-2.0
// Collects the words that syntax errors may have hidden: the words of a declaration, or of a section whose header the parser could not read.
// If a name is unknown but is one of these words, the checker does not report it, because that error is already reported.
#include "compiler/sema/sema.h"

#include "compiler/syntax/lex.h"

// Returns the number of sections that begin at or before a position.
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

// Returns the last declaration of the section that begins at or before a position; NULL if all of them begin after it.
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

// Whether a syntax error may have hidden a declared name.  An error after the name in the line of a declaration hides none, unless it
// follows an @: then it may hide an alias.
static bool may_hide(const AstSection *section, Span error)
{
    const char *text = error.src->text;
    const AstDecl *decl;

    switch (section->kind) {
    case AST_STATE: case AST_SCRIPT_STATE: case AST_OPTIONS: case AST_PINS: case AST_DATA: case AST_IGNORED:
        return false;
    case AST_STATE_VECTOR: case AST_LOCAL: case AST_REGION:
        break;
    default:
        return true;
    }
    if (error.at < section->header.at + section->header.len)
        return false;
    decl = decl_at(section, error.at);
    if (!decl || text[error.at] == '@')
        return true;
    for (uint32_t at = decl->type_span.at; at < error.at; at++)
        if (text[at] == '\n' || text[at] == '@')
            return true;
    return false;
}

// ---- all errors of a file ----

typedef struct HiddenWords {
    HiddenNames *l;
    StrPool *strings;
    const AstFile *f;
    uint32_t done;                // words before this position are already added
} HiddenWords;

// Adds every word of a range of the source to the hidden names.
static void add_hidden_range(HiddenWords *k, uint32_t from, uint32_t to)
{
    const char *text = k->f->src->text;

    k->l->names = true;
    for (uint32_t at = from < k->done ? k->done : from; at < to; at++) {
        uint32_t start = at;
        while (at < to && (lex_is_letter(text[at]) || lex_is_digit(text[at])))
            at++;
        if (at > start) {
            Str word = str_intern(k->strings, text + start, at - start);
            map_put(&k->l->word, word, (void *)word);
        }
    }
    if (to > k->done)
        k->done = to;
}

// Adds the words that error d may have hidden: all words up to the end of its section, all words of its line, or none.
static void add_names_hidden_by(HiddenWords *k, const Diag *d)
{
    const Span error = d->span;
    size_t n = sections_up_to(k->f, error.at);
    const AstSection *section = n > 0 ? k->f->sections.at[n - 1] : NULL;
    const char *text = k->f->src->text;
    uint32_t end = n < k->f->sections.n ? k->f->sections.at[n]->header.at : k->f->src->len, from = error.at, to = error.at;
    bool has_block = false;

    for (size_t i = 0; section && i < AST_LABEL_COUNT; i++)
        has_block = has_block || section->block[i].present;
    if (!section || section->name->len == 0) {          // the header of the section is missing or unreadable
        k->l->sections = true;
        add_hidden_range(k, error.at, end);
    } else if (d->code == DIAG_code_before_label && section->kind == AST_STATE && !has_block) {
        add_hidden_range(k, error.at, end);             // parsed as a state, but perhaps intended for declarations
    } else if (may_hide(section, error)) {
        while (from > k->done && text[from - 1] != '\n')
            from--;
        while (to < k->f->src->len && text[to] != '\n')
            to++;
        add_hidden_range(k, from, to);
    }
}

void add_hidden_names(const CheckContext *c, const AstFile *f, HiddenNames *l)
{
    HiddenWords k = {l, c->strings, f, 0};

    for (size_t i = 0; i < c->diags->list.n; i++) {
        const Diag *e = c->diags->list.at[i];
        if (e->severity == DIAG_ERROR && e->span.src == f->src) {
            l->any = true;
            add_names_hidden_by(&k, e);
        }
    }
}

HiddenNames *find_hidden_names(const CheckContext *c, const AstFile *f)
{
    HiddenNames *l = ARENA_NEW(c->arena, HiddenNames);

    l->word.arena = c->arena;
    add_hidden_names(c, f, l);
    return l;
}

void add_names_of_sections(const CheckContext *c, const AstFile *f, HiddenNames *l)
{
    HiddenWords k = {l, c->strings, f, 0};
    const char *text = f->src->text;

    for (size_t i = 0; i < c->diags->list.n; i++) {
        const Diag *e = c->diags->list.at[i];
        uint32_t end = e->span.at;
        if (e->code != DIAG_requirement_section || e->span.src != f->src)
            continue;
        while (end < f->src->len && text[end] != '"')          // stop at the text of the next requirement
            end++;
        add_hidden_range(&k, e->span.at, end);
    }
}
