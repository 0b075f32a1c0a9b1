// SPDX-License-Identifier: Apache-2.0
// fixes CODES FILE…   Applies the edits of every finding of the files, one finding at a time, and checks that they help and do no harm:
//   - the finding has disappeared, and there is no new error; where there was no error, there is no new default warning either.  What only a deleted
//     statement used or wrote is unused or a constant from then on: that is no fault of the edit;
//   - no statement is lost, and none depends on fewer conditions than before;
//   - a machine that compiled before does the same on random inputs.
// A FILE is a case (.smt), a page (.md) with sources in fences, or a source.  CODES lists what has edits: each of them needs a case, and
// no other code has any.
#include <string.h>

#include "compiler/case.h"
#include "tests/check/fixes_meaning.h"
#include "tests/unit/host.h"

enum { ROUNDS = 10 };         // as in smc fix

typedef struct Run {
    Session s;
    Source **src;             // by part; NULL for a part that is not a source
    const Program *program;       // NULL: there is none, or it has errors
} Run;

static size_t passed, failed, checked, statements, steps;
static bool helped[DIAG_COUNT];           // an edit of it did

// ---- results of a case ----

// Compiles the case as smc test does, with the source of part `changed` replaced by `text`.  If `changed` is the number of parts, nothing is
// replaced.
static void open_run(Run *r, const TestFile *f, size_t changed, const Buf *text)
{
    static const char *words[] = {"extra"};               // flight analyses take long and propose no edits
    const DiagSelection warnings = {.word = words, .n = 1};
    const CompileOptions o = {.opt_level = 2, .warnings = &warnings};
    TestFile edited = *f;
    CaseSources sources;
    Compiled made;

    session_init(&r->s, heap_alloc, NULL, &host_oom);
    edited.part.at = ARENA_ARRAY(&r->s.arena, TestPart, f->part.n + 1);
    for (size_t i = 0; i < f->part.n; i++)
        edited.part.at[i] = f->part.at[i];
    if (changed < f->part.n) {
        edited.part.at[changed].text = text->at;
        edited.part.at[changed].n = text->n;
    }
    case_list_sources(&r->s, &edited, &sources);
    compile_sources(&r->s, &sources.in, &o, &made);
    r->src = sources.src;
    r->program = NULL;
    for (size_t i = 0; i < f->part.n; i++)
        if (!sources.in.app && testfile_has_suffix(&f->part.at[i], ".sm"))
            r->program = made.of[sources.input[i]].scripted;
}

// ---- one finding ----

static size_t count(const Diags *d, int code)
{
    size_t n = 0;

    for (size_t i = 0; i < d->list.n; i++)
        n += (int)d->list.at[i]->code == code;
    return n;
}

static bool is_on(int code)
{
    const DiagFlag *flag = diag_info[code].flag ? diag_find_flag(diag_info[code].flag) : NULL;

    return flag && flag->group == DIAG_GROUP_ALL;
}

static bool only_deletes(const Diag *x)
{
    for (size_t i = 0; i < x->edits.n; i++)
        if (*x->edits.at[i].text)
            return false;
    return true;
}

// Whether a warning can result from deleting a statement.
static bool may_follow(int code)
{
    static const char *const flags[] = {"unused-element", "unused-local", "never-written"};

    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
        if (strcmp(diag_info[code].flag, flags[i]) == 0)
            return true;
    return false;
}

// Returns the position to which `at` moves by the edits of x.
static uint32_t moved(const Diag *x, uint32_t at)
{
    uint32_t to = at;

    for (size_t i = 0; i < x->edits.n; i++)
        if (x->edits.at[i].span.at + x->edits.at[i].span.len <= at)
            to += (uint32_t)strlen(x->edits.at[i].text) - x->edits.at[i].span.len;
    return to;
}

static bool is_still_there(const Diags *before, const Diags *after, const Diag *x)
{
    if (count(after, x->code) < count(before, x->code))
        return false;
    for (size_t i = 0; i < after->list.n; i++)
        if (after->list.at[i]->code == x->code && after->list.at[i]->span.at == moved(x, x->span.at) &&
            strcmp(after->list.at[i]->span.src->name, x->span.src->name) == 0)
            return true;
    return false;
}

// Whether an error can have existed before: the first error kept the compiler from finding errors of the second code.
static bool is_uncovered(int code, int then)
{
    static const int pairs[][2] = {{DIAG_assign_in_guard, DIAG_unknown_element}, {DIAG_reason_quotes, DIAG_foreign_operator}};

    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (pairs[i][0] == code && pairs[i][1] == then)
            return true;
    return false;
}

// Returns what is wrong with the source after the edit of x, or NULL.
static const char *wrong(const Diags *before, const Diags *after, const Diag *x)
{
    if (is_still_there(before, after, x))
        return "is still there after its edit";
    if (after->errors > before->errors)
        return "has an edit that brings an error";
    for (int i = 0; i < DIAG_COUNT; i++)
        if (i != (int)x->code && diag_info[i].id && diag_info[i].severity == DIAG_ERROR && count(after, i) > count(before, i) && !is_uncovered(x->code, i))
            return format_in(after->arena, "has an edit that brings %s", diag_info[i].id);
    for (int i = 0; before->errors == 0 && i < DIAG_COUNT; i++)
        if (is_on(i) && count(after, i) > count(before, i) && !(only_deletes(x) && may_follow(i)))
            return format_in(after->arena, "has an edit that brings %s", diag_info[i].id);
    return NULL;
}

static const char *harm(const TestFile *f, Run *was, Run *now, size_t part)
{
    const char *why = NULL;

    if (testfile_has_suffix(&f->part.at[part], ".sm") || testfile_has_suffix(&f->part.at[part], ".ss"))
        why = statements_lost(&now->s.arena, was->src[part], now->src[part], &statements);
    if (!why && was->program && was->s.diags.errors == 0)
        why = now->program ? behaviour_changed(&now->s.arena, was->program, now->program, &steps) : "leaves no machine";
    return why ? format_in(&now->s.arena, "has an edit that %s", why) : NULL;
}

static void check_finding(const TestFile *f, Run *was, const Diag *x, size_t part)
{
    Diags one;
    const char *why;
    Buf text;
    Run now;

    diags_init(&one, &was->s.arena);
    vec_push(&was->s.arena, &one.list, (Diag *)x);
    buf_init(&text, &was->s.arena);
    if (diags_apply_edits(&one, was->src[part], &text) == 0)
        return;
    buf_text(&text);
    open_run(&now, f, part, &text);
    if ((why = wrong(&was->s.diags, &now.s.diags, x)) != NULL || (why = harm(f, was, &now, part)) != NULL) {
        LineCol at = source_position(x->span.src, x->span.at);
        printf("%s: %s:%lu: %s %s: %s\n", f->name, x->span.src->name, (unsigned long)at.line, diag_info[x->code].id, why, x->text);
        failed++;
    } else {
        passed++;
        helped[x->code] = true;
    }
    session_free(&now.s);
}

// Applies all edits of one part at once, repeatedly, as smc fix does.  No round may lose a statement.
static void check_together(const TestFile *f, Run *was, size_t part)
{
    Buf text;
    const char *why = NULL;
    Run now;

    buf_init(&text, &was->s.arena);
    if (!was->src[part] || diags_apply_edits(&was->s.diags, was->src[part], &text) == 0)
        return;
    buf_text(&text);
    open_run(&now, f, part, &text);
    for (int round = 1; round < ROUNDS; round++) {
        Buf next;
        buf_init(&next, &was->s.arena);
        if (diags_apply_edits(&now.s.diags, now.src[part], &next) == 0)
            break;
        buf_text(&next);
        session_free(&now.s);
        open_run(&now, f, part, &next);
    }
    if ((why = harm(f, was, &now, part)) != NULL) {
        printf("%s: %s: all edits together: the file %s\n", f->name, f->part.at[part].name, why);
        failed++;
    } else {
        passed++;
    }
    session_free(&now.s);
}

static void check_parts(const TestFile *f)
{
    Run was;

    open_run(&was, f, f->part.n, NULL);
    for (size_t i = 0; i < was.s.diags.list.n; i++)
        for (size_t k = 0; was.s.diags.list.at[i]->edits.n && k < f->part.n; k++)
            if (was.src[k] && was.s.diags.list.at[i]->edits.at[0].span.src == was.src[k])
                check_finding(f, &was, was.s.diags.list.at[i], k);
    for (size_t k = 0; k < f->part.n; k++)
        check_together(f, &was, k);
    session_free(&was.s);
    checked++;
}

static void put_part(Arena *arena, TestFile *f, const char *name, const char *text, size_t n)
{
    TestPart p = {name, text, n, 1};

    if (testfile_is_source(&p))
        vec_push(arena, &f->part, p);
}

// Checks each source in the fences of a page separately, as in ```sm tank.sm
static void check_page(Arena *arena, const char *path, const char *text)
{
    const char *at = text, *end;
    char name[100];

    while ((at = strstr(at, "\n```s")) != NULL && (end = strstr(at + 4, "\n```")) != NULL) {
        TestFile f = {.name = path};
        const char *body = strchr(at + 1, '\n') + 1;
        if (sscanf(at + 1, "```s%*1[ms] %99[^ \n]", name) == 1 && body <= end)
            put_part(arena, &f, format_in(arena, "%s", name), format_in(arena, "%.*s", (int)(end + 1 - body), body), (size_t)(end + 1 - body));
        if (f.part.n)
            check_parts(&f);
        at = end + 4;
    }
}

static bool ends_in(const char *path, const char *suffix)
{
    const size_t n = strlen(path), k = strlen(suffix);

    return n > k && strcmp(path + n - k, suffix) == 0;
}

static void check_file(Arena *arena, const char *path)
{
    FILE *in = fopen(path, "rb");
    static char text[1 << 20];
    size_t n = in ? fread(text, 1, sizeof text - 1, in) : 0;
    TestFile source = {.name = path}, *f = &source;

    text[n] = '\0';
    if (in)
        fclose(in);
    if (in && ends_in(path, ".md")) {
        check_page(arena, path, text);
        return;
    }
    if (ends_in(path, ".smt"))
        f = testfile_parse(arena, path, text, n);
    else
        put_part(arena, f, path, text, n);
    if (!in || f->error) {
        printf("%s: %s\n", path, in ? f->error : "cannot be read");
        failed++;
        return;
    }
    check_parts(f);
}

static void check_alone(const char *path)
{
    Arena arena;

    HOST_ARENA(&arena);
    check_file(&arena, path);
    arena_free(&arena);
}

// ---- all codes ----

static void check_codes(const char *path)
{
    FILE *in = fopen(path, "r");
    bool listed[DIAG_COUNT] = {false};
    char line[200];

    while (in && fgets(line, sizeof line, in))
        for (int i = 0; i < DIAG_COUNT; i++)
            listed[i] = listed[i] || (diag_info[i].id && strncmp(line, diag_info[i].id, strlen(diag_info[i].id)) == 0);
    for (int i = 0; i < DIAG_COUNT; i++)
        if (helped[i] != listed[i]) {
            printf("%s: %s %s\n", path, diag_info[i].id, listed[i] ? "has no case whose edit helps" : "has edits and is not listed");
            failed++;
        }
    if (in)
        fclose(in);
}

int main(int argc, char **argv)
{
    for (int i = 2; i < argc; i++)
        check_alone(argv[i]);
    if (argc > 1)
        check_codes(argv[1]);
    if (checked < 1200 || statements < 1000 || steps < 50000) {
        printf("too little was checked: %lu files, %lu statements, %lu steps\n", (unsigned long)checked, (unsigned long)statements, (unsigned long)steps);
        failed++;
    }
    printf("%lu passed, %lu failed\n", (unsigned long)passed, (unsigned long)failed);
    return failed > 0;
}
