// SPDX-License-Identifier: Apache-2.0
// Shows one mistake as one error. A line that is not understood can be the reason of every other error on it, and a habit of another
// language, such as a semicolon after each statement, is one mistake however often the file has it.
#include <string.h>

#include "compiler/diag/diag.h"

enum {
    HABITS_MAX = 32,          // different habits that are folded in one call
    LINES_NAMED = 8           // lines that the note about a habit names
};

// What an error is to the other errors of its line: only those of the first rank that the line has are shown.
typedef enum FoldRank {
    FOLD_GRAMMAR,             // the line is not understood
    FOLD_OTHER,               // names, types, values: each is a mistake of its own, and all are shown
    FOLD_COMMENT,             // a comment of another language
    FOLD_MISPLACED,           // the line is understood, but a value, or an item of a script, cannot be here
    FOLD_SEMICOLON
} FoldRank;

// Rows DIAG_FOLD of codes.def.
static const struct { DiagCode code; FoldRank rank; bool habit; } folds[] = {
#define DIAG_FOLD(name, rank, habit) {DIAG_##name, rank, habit},
#include "compiler/diag/codes.def"
};
enum { FOLDS = sizeof folds / sizeof *folds };

static size_t find_fold(DiagCode code)
{
    size_t i = 0;

    while (i < FOLDS && folds[i].code != code)
        i++;
    return i;
}

static FoldRank rank_of(const Diag *x)
{
    const char *id = diag_info[x->code].id;
    const size_t row = find_fold(x->code);

    if (row < FOLDS)
        return folds[row].rank;
    return strncmp(id, "E01", 3) == 0 || strncmp(id, "E03", 3) == 0 ? FOLD_GRAMMAR : FOLD_OTHER;
}

static bool is_habit(DiagCode code)
{
    const size_t row = find_fold(code);

    return row < FOLDS && folds[row].habit;
}

// Whether an error at a position of a source can be folded. Warnings, also those that -Werror made errors, are about a meaning.
static bool is_foldable(const Diag *x) { return x->span.src && diag_info[x->code].severity == DIAG_ERROR; }

// ---- one line ----

static uint32_t end_of_line(const Diag *x)
{
    const Source *src = x->span.src;
    const char *end = x->span.at < src->len ? memchr(src->text + x->span.at, '\n', src->len - x->span.at) : NULL;

    return end ? (uint32_t)(end - src->text) : src->len;
}

// Sets folded[i] for the diagnostics `from` to `to` - 1, which are all of one line, if they are not shown.
static void fold_line(const Diags *d, size_t from, size_t to, bool *folded)
{
    FoldRank best = FOLD_SEMICOLON;
    bool any = false;         // one of the best rank is shown

    for (size_t i = from; i < to; i++)
        if (is_foldable(d->list.at[i]) && !d->list.at[i]->follows && rank_of(d->list.at[i]) < best)
            best = rank_of(d->list.at[i]);
    for (size_t i = from; i < to; i++) {
        const Diag *x = d->list.at[i];
        if (!is_foldable(x))
            continue;
        folded[i] = x->follows || rank_of(x) > best || (any && best != FOLD_OTHER);
        any = any || !folded[i];
    }
}

// ---- one habit ----

typedef struct Habit {
    Diag *first;              // the diagnostic that is shown
    uint32_t line;            // the last line with a case
    unsigned long n;          // the lines with further cases
    Buf lines;                // these lines: "7, 9"
} Habit;

static bool is_same_habit(const Diag *a, const Diag *b)
{
    return a->code == b->code && a->span.src == b->span.src && strcmp(a->text, b->text) == 0 && (a->label == NULL) == (b->label == NULL) &&
           (!a->label || strcmp(a->label, b->label) == 0) && (a->edits.n > 0) == (b->edits.n > 0);
}

// Adds x to the habit of which it is another case. Returns false if it is the first case of a habit.
static bool fold_habit(Diags *d, Diag *x, Habit *habit, size_t *n)
{
    const uint32_t line = source_position(x->span.src, x->span.at).line;
    size_t i = 0;

    while (i < *n && !is_same_habit(habit[i].first, x))
        i++;
    if (i == *n) {
        if (i < HABITS_MAX) {
            habit[i] = (Habit){.first = x, .line = line};
            buf_init(&habit[i].lines, d->arena);
            ++*n;
        }
        return false;
    }
    for (size_t e = 0; e < x->edits.n; e++)
        vec_push(d->arena, &habit[i].first->edits, x->edits.at[e]);
    if (line != habit[i].line && habit[i].n++ < LINES_NAMED)
        buf_printf(&habit[i].lines, "%s%lu", habit[i].n > 1 ? ", " : "", (unsigned long)line);
    habit[i].line = line;
    return true;
}

static void note_lines(Diags *d, Habit *h)
{
    if (h->n > LINES_NAMED)
        buf_printf(&h->lines, " and %lu more", h->n - LINES_NAMED);
    if (h->n > 0)
        diag_note(d, h->first, (Span){0}, DIAG_note_same_in_lines, h->n == 1 ? "line" : "lines", buf_text(&h->lines));
}

// ---- all diagnostics ----

void diags_fold(Diags *d)
{
    bool *folded = ARENA_ARRAY(d->arena, bool, d->list.n + 1);
    Habit habit[HABITS_MAX];
    size_t habits = 0;
    uint32_t kept = 0;

    for (size_t from = 0, to; from < d->list.n; from = to) {
        const Source *src = d->list.at[from]->span.src;
        const uint32_t end = src ? end_of_line(d->list.at[from]) : 0;
        for (to = from + 1; src && to < d->list.n && d->list.at[to]->span.src == src && d->list.at[to]->span.at <= end; to++) {}
        fold_line(d, from, to, folded);
    }
    for (size_t i = 0; i < d->list.n; i++) {
        Diag *x = d->list.at[i];
        if (folded[i])
            vec_push(d->arena, &d->folded, x);
        else if (!is_foldable(x) || !is_habit(x->code) || !fold_habit(d, x, habit, &habits))
            d->list.at[kept++] = x;
    }
    d->errors -= d->list.n - kept;
    d->list.n = kept;
    for (size_t i = 0; i < habits; i++)
        note_lines(d, &habit[i]);
}
