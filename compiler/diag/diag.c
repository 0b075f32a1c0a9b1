// SPDX-License-Identifier: Apache-2.0
// Collects diagnostics: fills arguments into the messages of codes.def, drops repeated reports, sorts.
#include "compiler/diag/diag.h"

#include <string.h>

const DiagInfo diag_info[DIAG_COUNT] = {
#define DIAG(id, name, severity, flag, message, page) {id, #name, severity, flag, message, page},
#define DIAG_NOTE_TEXT(name, message) {NULL, #name, DIAG_NOTE, NULL, message, NULL},
#include "compiler/diag/codes.def"
};

// A slot of the hash table that recognises a second report of the same code at the same position.
typedef struct DiagPosition {
    const Source *src;        // valid only if `used` is set; otherwise the slot is empty
    uint32_t at;
    DiagCode code;
    bool used;
    Diag *diag;               // NULL: the report was not stored in the list
} DiagPosition;

// Removes all reports; every @allow still covers later reports.
void diags_clear(Diags *d)
{
    const Diags reported = *d;

    diags_init(d, reported.arena);
    d->allow = reported.allow;
    d->known = reported.known;
}

void diags_init(Diags *d, Arena *arena)
{
    memset(d, 0, sizeof *d);
    d->arena = arena;
}

// ---- repeated reports ----

// Returns the entry of a code and a position in the hash table, or the free slot where it would be inserted.
static DiagPosition *find_position(const Diags *d, const Source *src, uint32_t at, DiagCode code)
{
    size_t slot = (at * 2654435761u ^ (uint32_t)code * 40503u) & (d->position_cap - 1);

    while (d->position[slot].used &&
           (d->position[slot].src != src || d->position[slot].at != at || d->position[slot].code != code))
        slot = (slot + 1) & (d->position_cap - 1);
    return &d->position[slot];
}

static void grow_positions(Diags *d)
{
    DiagPosition *old = d->position;
    size_t n = d->position_cap;

    d->position_cap = n ? n * 2 : 64;
    d->position = ARENA_ARRAY(d->arena, DiagPosition, d->position_cap);
    for (size_t i = 0; i < n; i++)
        if (old[i].used)
            *find_position(d, old[i].src, old[i].at, old[i].code) = old[i];
}

// Records code and position; returns false if they were already recorded. A report without a position is always new.
static bool record_position(Diags *d, DiagCode code, Span span)
{
    DiagPosition *p;

    if (!span.src)
        return true;
    if (d->position_n * 2 >= d->position_cap)
        grow_positions(d);
    p = find_position(d, span.src, span.at, code);
    if (p->used)
        return false;
    *p = (DiagPosition){span.src, span.at, code, true, NULL};
    d->position_n++;
    return true;
}

// ---- reporting ----

// Returns the message of a row, with each {} replaced by the next argument.
static const char *fill_arguments(Arena *arena, const char *message, va_list args)
{
    Buf b;

    buf_init(&b, arena);
    for (const char *s = message; *s; s++)
        if (s[0] == '{' && s[1] == '}') {
            buf_str(&b, va_arg(args, const char *));
            s++;
        } else {
            buf_char(&b, *s);
        }
    return buf_text(&b);
}

// Returns the source in d->files that has the same name and text as src, so that a file loaded twice counts as one file; else src.
static const Source *find_listed_file(const Diags *d, const Source *src)
{
    for (size_t i = d->files.n; src && i-- > 0; ) {
        const Source *file = d->files.at[i];
        if (file == src || (file->len == src->len && strcmp(file->name, src->name) == 0 && memcmp(file->text, src->text, src->len) == 0))
            return file;
    }
    return src;
}

// Records that diagnostic x applies to a state. The reports for one state follow each other.
static void add_state(Diags *d, Diag *x, const char *state)
{
    if (x->states.n == 0 || strcmp(x->states.at[x->states.n - 1], state) != 0)
        vec_push(d->arena, &x->states, state);
}

// Records that diagnostic x applies to the current machine. The reports for one machine follow each other.
static void add_machine(Diags *d, Diag *x)
{
    if (d->machine && (x->machines.n == 0 || x->machines.at[x->machines.n - 1] != d->machine))
        vec_push(d->arena, &x->machines, d->machine);
}

// Replaces the copy of a source by the source itself.
static Span written_source(Span span)
{
    if (span.src && span.src->copy_of)
        span.src = span.src->copy_of;
    return span;
}

Diag *diag_report_list(Diags *d, DiagCode code, Span span, va_list args)
{
    const bool is_error = diag_info[code].severity == DIAG_ERROR;
    const char *state = span.src ? span.src->state : NULL;
    size_t *count = is_error ? &d->errors : &d->warnings, file = d->files.n;
    Diag *x;

    d->errors_seen += is_error;
    span.src = find_listed_file(d, written_source(span).src);
    if (d->muted || !record_position(d, code, span) || ++*count > DIAG_KEPT_MAX) {
        d->first = span.src && d->position_cap ? find_position(d, span.src, span.at, code)->diag : NULL;
        if (d->first && state)
            add_state(d, d->first, state);
        if (d->first)
            add_machine(d, d->first);
        if (!d->dropped) {                    // all dropped reports share one Diag, so that even very many need no memory
            d->dropped = ARENA_NEW(d->arena, Diag);
            d->dropped->text = "";
        }
        return d->dropped;
    }
    x = ARENA_NEW(d->arena, Diag);
    if (span.src)
        find_position(d, span.src, span.at, code)->diag = x;
    x->code = code;
    x->severity = diag_info[code].severity;
    x->span = span;
    x->text = fill_arguments(d->arena, diag_info[code].message, args);
    if (state)
        add_state(d, x, state);
    add_machine(d, x);
    while (file > 0 && d->files.at[file - 1] != span.src)
        file--;
    if (file == 0)
        vec_push(d->arena, &d->files, span.src);
    vec_push(d->arena, &d->list, x);
    return x;
}

// Adds a diagnostic; its arguments, each a `const char *`, replace the {} of the message.  The caller can add notes, a label and edits to
// the result.
Diag *diag_report(Diags *d, DiagCode code, Span span, ...)
{
    va_list args;
    Diag *x;

    va_start(args, span);
    x = diag_report_list(d, code, span, args);
    va_end(args);
    return x;
}

static void add_note(Diags *d, Diag *to, Span span, unsigned step, DiagCode text, va_list args)
{
    DiagNote note = {written_source(span), NULL, step};

    if (to == d->dropped)
        return;
    note.text = fill_arguments(d->arena, diag_info[text].message, args);
    vec_push(d->arena, &to->notes, note);
}

// Adds a note; `text` is a DIAG_NOTE_TEXT row, its arguments follow.
void diag_note(Diags *d, Diag *to, Span span, DiagCode text, ...)
{
    va_list args;

    va_start(args, text);
    add_note(d, to, span, 0, text, args);
    va_end(args);
}

// Adds a note that is the next numbered step of the path that leads to the finding.
void diag_note_step(Diags *d, Diag *to, Span span, DiagCode text, ...)
{
    unsigned step = 1;
    va_list args;

    for (size_t i = 0; i < to->notes.n; i++)
        step += to->notes.at[i].step > 0;
    va_start(args, text);
    add_note(d, to, span, step, text, args);
    va_end(args);
}

// Sets the text printed after the caret; `text` is a DIAG_NOTE_TEXT row.
void diag_label(Diags *d, Diag *to, DiagCode text, ...)
{
    va_list args;

    if (to == d->dropped)
        return;
    va_start(args, text);
    to->label = fill_arguments(d->arena, diag_info[text].message, args);
    va_end(args);
}

// Returns the text of a DIAG_NOTE_TEXT row with its arguments, to be an argument of another message.
const char *diag_text(Diags *d, DiagCode text, ...)
{
    const char *out;
    va_list args;

    va_start(args, text);
    out = fill_arguments(d->arena, diag_info[text].message, args);
    va_end(args);
    return out;
}

// Adds the declaration of a variable that the diagnostic names, for example as one of its outputs.
void diag_note_declaration(Diags *d, Diag *to, DiagSubject subject, Span declaration)
{
    const DiagAbout about = {written_source(declaration), subject};
    Diag *x = to == d->dropped ? d->first : to;

    for (size_t i = 0; x && i < x->about.n; i++)
        if (x->about.at[i].subject == subject && x->about.at[i].span.src == declaration.src && x->about.at[i].span.at == declaration.at)
            return;
    if (x)
        vec_push(d->arena, &x->about, about);
}

// Proposes an edit that is certainly what the user meant: replaces `span` by a copy of `text`.
void diag_edit(Diags *d, Diag *to, Span span, const char *text)
{
    DiagEdit edit = {written_source(span), NULL};

    if (to == d->dropped)
        return;
    edit.text = arena_copy(d->arena, text, strlen(text) + 1);
    vec_push(d->arena, &to->edits, edit);
}

// Removes the warning at index i of the list.
void diags_remove_warning(Diags *d, size_t i)
{
    memmove(d->list.at + i, d->list.at + i + 1, (d->list.n - i - 1) * sizeof *d->list.at);
    d->list.n--;
    d->warnings--;
}

// ---- order ----

// Returns the position of a source in the order of diagnostics: its index in d->files.
static size_t file_rank(const Diags *d, const Source *src)
{
    size_t i = 0;

    while (i < d->files.n && d->files.at[i] != src)
        i++;
    return i;
}

// Whether a comes before b in the output: by file, then by position.
static bool is_before(const Diags *d, const Diag *a, const Diag *b)
{
    if (a->span.src != b->span.src)
        return file_rank(d, a->span.src) < file_rank(d, b->span.src);
    return a->span.at < b->span.at;
}

// Merges two sorted runs. On ties the left run's item comes first, which makes the sort stable.
static void merge_runs(const Diags *d, Diag **to, Diag **a, size_t na, Diag **b, size_t nb)
{
    while (na && nb) {
        if (is_before(d, *b, *a))
            *to++ = *b++, nb--;
        else
            *to++ = *a++, na--;
    }
    memcpy(to, na ? a : b, (na ? na : nb) * sizeof *to);
}

static size_t min_size(size_t n, size_t limit) { return n < limit ? n : limit; }

// Sorts the diagnostics by file, in the order of Diags.files, then by position; stable.
void diags_sort(Diags *d)
{
    size_t n = d->list.n;
    Diag **from = d->list.at, **to = ARENA_ARRAY(d->arena, Diag *, n + 1);

    for (size_t run = 1; run < n; run *= 2) {
        Diag **swap = from;
        for (size_t i = 0; i < n; i += 2 * run) {
            size_t na = min_size(n - i, run), nb = min_size(n - i - na, run);
            merge_runs(d, to + i, from + i, na, from + i + na, nb);
        }
        from = to;
        to = swap;
    }
    if (from != d->list.at)
        memcpy(d->list.at, from, n * sizeof *from);
}

// ---- lookup ----

static char to_upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

// Whether two words are equal, apart from upper and lower case.
static bool same_word(const char *a, const char *b)
{
    while (*a && to_upper(*a) == to_upper(*b))
        a++, b++;
    return !*a && !*b;
}

const DiagFlag diag_flag[] = {
#define FLAG(name, group, judged, copies, sentence) {name, DIAG_GROUP_##group, DIAG_JUDGED_##judged, DIAG_COPIES_##copies, sentence},
#include "compiler/diag/flags.def"
#undef FLAG
};
const char *const diag_group_name[] = {"all", "extra", "flight"};
const size_t diag_flag_count = sizeof diag_flag / sizeof *diag_flag;

const DiagFlag *diag_find_flag(const char *name)
{
    for (size_t i = 0; i < diag_flag_count; i++)
        if (strcmp(diag_flag[i].name, name) == 0)
            return &diag_flag[i];
    return NULL;
}

// Returns the row whose id, or warning name, is `id`; case does not matter.  NULL if no row has it.
const DiagInfo *diag_find(const char *id)
{
    for (int i = 0; i < DIAG_COUNT; i++) {
        const DiagInfo *row = &diag_info[i];
        if (row->id && (same_word(row->id, id) || (row->flag && same_word(row->flag, id))))
            return row;
    }
    return NULL;
}

// Returns what follows the message in text output: "E0204"; for a warning also its name: "W0503 unreachable-state".
const char *diag_code_and_name(const Diag *d, Arena *arena)
{
    const DiagInfo *row = &diag_info[d->code];

    return row->flag ? format_in(arena, "%s %s", row->id, row->flag) : row->id;
}
