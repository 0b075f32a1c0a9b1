// SPDX-License-Identifier: Apache-2.0
#include "compiler/source_files.h"

#include <string.h>

#include "compiler/syntax/parse.h"

enum { DEPTH_MAX = 64 };      // limit on the depth of includes; bounds the recursion

// The files of a script that have been found so far.
typedef struct Search {
    Session *s;
    VEC(const Source *) done;         // complete files, in the order in which their sections run
    VEC(Span) include;                // by complete file: as in ScriptFiles
    VEC(const Source *) open;         // the files whose includes are being followed; each is included by the preceding one
} Search;

static bool contains(const Source *const *at, size_t n, const Source *src)
{
    for (size_t i = 0; i < n; i++)
        if (at[i] == src)
            return true;
    return false;
}

static bool is_script_name(Str name)
{
    FileKind kind;

    return strlen(name->text) == name->len && file_kind(name->text, &kind) && kind == FILE_SS;
}

// Returns the source that an include names; NULL after reporting why it cannot be read.
static const Source *find_included(Search *h, const Source *from, const AstInclude *in)
{
    Session *s = h->s;
    const char *problem = "no file can be read here";
    const Source *found = NULL;

    if (!is_script_name(in->name))
        problem = "its name does not end in .ss";
    else if (h->open.n == DEPTH_MAX)
        problem = format_in(&s->arena, "more than %d files include each other in a row", DEPTH_MAX);
    else if (s->finder.find)
        found = s->finder.find(s->finder.context, from, in->name->text, &problem);
    if (!found)
        diag_report(&s->diags, DIAG_include_file, in->span, in->name->text, problem);
    return found;
}

// Reports an include of a file that is still being read.
static void report_cycle(Search *h, const AstInclude *in, const Source *again)
{
    size_t first = h->open.n - 1;
    Buf chain;

    while (h->open.at[first] != again)
        first--;
    buf_init(&chain, &h->s->arena);
    for (size_t i = first; i < h->open.n; i++)
        buf_printf(&chain, "%s -> ", h->open.at[i]->name);
    buf_str(&chain, again->name);
    diag_report(&h->s->diags, DIAG_include_cycle, in->span, buf_text(&chain));
}

// Adds the files that `src` includes, and then src.  include: the line of the script itself that leads to src; without a source for the script.
// Syntax errors are reported later, when the whole file is parsed.
static void add_file(Search *h, const Source *src, Span include)
{
    Diags unseen;
    const AstFile *f;

    diags_init(&unseen, &h->s->arena);
    unseen.muted = true;
    f = parse_script_includes(&h->s->arena, &h->s->strings, &unseen, src);
    vec_push(&h->s->arena, &h->open, src);
    for (size_t i = 0; i < f->includes.n; i++) {
        const Source *in = find_included(h, src, &f->includes.at[i]);
        if (!in || contains(h->done.at, h->done.n, in))
            continue;
        if (contains(h->open.at, h->open.n, in))
            report_cycle(h, &f->includes.at[i], in);
        else
            add_file(h, in, include.src ? include : f->includes.at[i].span);
    }
    h->open.n--;
    vec_push(&h->s->arena, &h->done, src);
    vec_push(&h->s->arena, &h->include, include);
}

ScriptFiles session_script_files(Session *s, const Source *script, bool is_silent)
{
    const bool muted = s->diags.muted;
    const size_t before = s->diags.errors_seen;
    Search h = {.s = s};

    s->diags.muted = muted || is_silent;
    add_file(&h, script, (Span){0});
    s->diags.muted = muted;
    if (is_silent)
        s->diags.errors_seen = before;
    return (ScriptFiles){h.done.at, h.include.at, h.done.n};
}
