// SPDX-License-Identifier: Apache-2.0
// Applies -Wname, -Wno-name, -Werror, -Werror=name and -w to the reported warnings.
#include "compiler/cli/cli.h"

#include <string.h>

// The groups that a name after -W covers, as bits; 0: not a group.
typedef struct Group { const char *name; unsigned groups; } Group;

enum { ALL = 1u << DIAG_GROUP_ALL, EXTRA = 1u << DIAG_GROUP_EXTRA, FLIGHT = 1u << DIAG_GROUP_FLIGHT };

static const Group groups[] = {{"all", ALL}, {"extra", EXTRA}, {"flight", FLIGHT}, {"everything", ALL | EXTRA | FLIGHT}};
enum { GROUPS = sizeof groups / sizeof *groups };

static unsigned group_named(const char *name)
{
    for (size_t i = 0; i < GROUPS; i++)
        if (strcmp(groups[i].name, name) == 0)
            return groups[i].groups;
    return 0;
}

static const char *skip_prefix(const char *text, const char *prefix)
{
    size_t n = strlen(prefix);
    return strncmp(text, prefix, n) == 0 ? text + n : NULL;
}

// The warning's name in "no-x", "error=x", "no-error=x" or "x".
static const char *flag_in(const char *w)
{
    const char *rest;

    if ((rest = skip_prefix(w, "error=")) != NULL || (rest = skip_prefix(w, "no-error=")) != NULL ||
        (rest = skip_prefix(w, "no-")) != NULL)
        return rest;
    return w;
}

static bool is_known(const char *word)
{
    const char *name = flag_in(word);

    return strcmp(word, "error") == 0 || strcmp(word, "no-error") == 0 || group_named(name) || diag_find_flag(name);
}

static const char *nearest_warning(Arena *arena, const char *name)
{
    const char **names = ARENA_ARRAY(arena, const char *, diag_flag_count + GROUPS);
    size_t n = 0;

    for (size_t i = 0; i < diag_flag_count; i++)
        names[n++] = diag_flag[i].name;
    for (size_t i = 0; i < GROUPS; i++)
        names[n++] = groups[i].name;
    return nearest_name(name, names, n);
}

const char *warnings_complaint(Arena *arena, const Warnings *w)
{
    for (size_t i = 0; i < w->n; i++) {
        const char *name = flag_in(w->word[i]), *near;
        if (is_known(w->word[i]))
            continue;
        near = nearest_warning(arena, name);
        return near ? format_in(arena, "no warning is called '%s'; did you mean '%s'?", name, near)
                    : format_in(arena, "no warning is called '%s'", name);
    }
    return NULL;
}

typedef struct Verdict { bool on, error; } Verdict;

static bool speaks_of(const char *name, const DiagFlag *flag)
{
    return strcmp(name, flag->name) == 0 || (group_named(name) & 1u << flag->group) != 0;
}

// Applies one -W… to the current decision about a warning.
static void apply_one(const char *w, const DiagFlag *flag, Verdict *v)
{
    const char *name = flag_in(w);

    if (strcmp(w, "error") == 0 || strcmp(w, "no-error") == 0)
        v->error = w[0] == 'e';
    else if (!speaks_of(name, flag))
        return;
    else if (skip_prefix(w, "error="))
        *v = (Verdict){true, true};
    else if (skip_prefix(w, "no-error="))
        v->error = false;
    else
        v->on = skip_prefix(w, "no-") == NULL;
}

static Verdict judge_flag(const Warnings *w, const DiagFlag *flag)
{
    Verdict v = {!flag || flag->group == DIAG_GROUP_ALL, false};

    for (size_t i = 0; flag && i < w->n; i++)
        apply_one(w->word[i], flag, &v);
    v.on = v.on && !w->none;
    return v;
}

static Verdict judge(const Warnings *w, const Diag *d)
{
    return judge_flag(w, diag_info[d->code].flag ? diag_find_flag(diag_info[d->code].flag) : NULL);
}

unsigned warnings_groups(const Warnings *w)
{
    unsigned wanted = 0;

    for (size_t i = 0; i < diag_flag_count; i++)
        if (judge_flag(w, &diag_flag[i]).on)
            wanted |= 1u << diag_flag[i].group;
    return wanted;
}

// A disabled warning needs no @allow either.
static void drop_allowed(const Warnings *w, Diags *d)
{
    uint32_t kept = 0;

    for (size_t i = 0; i < d->allowed.n; i++)
        if (judge(w, d->allowed.at[i]).on)
            d->allowed.at[kept++] = d->allowed.at[i];
    d->allowed.n = kept;
}

void warnings_apply(const Warnings *w, Diags *d)
{
    uint32_t kept = 0;

    for (size_t i = 0; i < d->list.n; i++) {
        Diag *diag = d->list.at[i];
        if (diag->severity == DIAG_WARNING) {
            Verdict v = judge(w, diag);
            d->warnings -= !v.on || v.error;
            if (!v.on)
                continue;
            if (v.error) {
                diag->severity = DIAG_ERROR;
                d->errors++;
            }
        }
        d->list.at[kept++] = diag;
    }
    d->list.n = kept;
    if (w->none)
        d->warnings = 0;              // including those that were too many to store
    drop_allowed(w, d);
}
