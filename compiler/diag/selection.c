// SPDX-License-Identifier: Apache-2.0
// Applies -Wname, -Wno-name, -Werror, -Werror=name and -w to the reported warnings.
#include "compiler/diag/diag.h"

#include <string.h>

#include "compiler/base/str.h"

// A name after -W that selects whole groups: bit 1u << DiagGroup for each.
typedef struct GroupName { const char *name; unsigned groups; } GroupName;

enum { ALL = 1u << DIAG_GROUP_ALL, EXTRA = 1u << DIAG_GROUP_EXTRA, FLIGHT = 1u << DIAG_GROUP_FLIGHT };

static const GroupName groups[] = {{"all", ALL}, {"extra", EXTRA}, {"flight", FLIGHT}, {"everything", ALL | EXTRA | FLIGHT}};
enum { GROUPS = sizeof groups / sizeof *groups };

// Returns the groups that a name such as "all" selects, as in GroupName.groups; 0 if it is no name of groups.
static unsigned find_groups(const char *name)
{
    for (size_t i = 0; i < GROUPS; i++)
        if (strcmp(groups[i].name, name) == 0)
            return groups[i].groups;
    return 0;
}

// Returns the rest of the text after the prefix; NULL if the text does not begin with the prefix.
static const char *skip_prefix(const char *text, const char *prefix)
{
    size_t n = strlen(prefix);
    return strncmp(text, prefix, n) == 0 ? text + n : NULL;
}

// Returns the name of the warning, x, in a word after -W: "no-x", "error=x", "no-error=x" or "x".
static const char *skip_flag_prefix(const char *w)
{
    const char *rest;

    if ((rest = skip_prefix(w, "error=")) != NULL || (rest = skip_prefix(w, "no-error=")) != NULL ||
        (rest = skip_prefix(w, "no-")) != NULL)
        return rest;
    return w;
}

// Returns the name of a warning or group that is most similar to `name`; NULL if none is.
static const char *nearest_warning(Arena *arena, const char *name)
{
    const char **names = ARENA_ARRAY(arena, const char *, diag_flag_count + GROUPS);
    size_t n = 0;

    for (size_t i = 0; i < diag_flag_count; i++)
        names[n++] = diag_flag[i].name;
    for (size_t i = 0; i < GROUPS; i++)
        names[n++] = groups[i].name;
    return str_nearest(name, names, n);
}

// Returns what is wrong with the words: "no warning is called 'x'; did you mean 'y'?"; NULL if they are correct.
const char *diag_selection_error(Arena *arena, const DiagSelection *w)
{
    for (size_t i = 0; i < w->n; i++) {
        const char *word = w->word[i], *name = skip_flag_prefix(word), *near;
        if (strcmp(word, "error") == 0 || strcmp(word, "no-error") == 0 || find_groups(name) || diag_find_flag(name))
            continue;
        near = nearest_warning(arena, name);
        return near ? format_in(arena, "no warning is called '%s'; did you mean '%s'?", name, near)
                    : format_in(arena, "no warning is called '%s'", name);
    }
    return NULL;
}

typedef struct FlagChoice { bool on, error; } FlagChoice;

// Applies one word after -W to the current decision *v about a warning.
static void apply_word(const char *w, const DiagFlag *flag, FlagChoice *v)
{
    const char *name = skip_flag_prefix(w);

    if (strcmp(w, "error") == 0 || strcmp(w, "no-error") == 0)
        v->error = w[0] == 'e';
    else if (strcmp(name, flag->name) != 0 && !(find_groups(name) & 1u << flag->group))
        return;
    else if (skip_prefix(w, "error="))
        *v = (FlagChoice){true, true};
    else if (skip_prefix(w, "no-error="))
        v->error = false;
    else
        v->on = skip_prefix(w, "no-") == NULL;
}

// Decides about a warning: the words that name it or its group, `error` and `no-error` apply in order, and a later one replaces what an earlier one
// said.  With -w the warning is off.
static FlagChoice select_flag(const DiagSelection *w, const DiagFlag *flag)
{
    FlagChoice v = {!flag || flag->group == DIAG_GROUP_ALL, false};

    for (size_t i = 0; flag && i < w->n; i++)
        apply_word(w->word[i], flag, &v);
    v.on = v.on && !w->none;
    return v;
}

static FlagChoice select_diag(const DiagSelection *w, const Diag *d)
{
    return select_flag(w, diag_info[d->code].flag ? diag_find_flag(diag_info[d->code].flag) : NULL);
}

// Returns the groups with at least one enabled warning: a set of 1u << DiagGroup.
unsigned diag_selection_groups(const DiagSelection *w)
{
    unsigned wanted = 0;

    if (w->n == 0)
        return w->none ? 0 : 1u << DIAG_GROUP_ALL;
    for (size_t i = 0; i < diag_flag_count; i++)
        if (select_flag(w, &diag_flag[i]).on)
            wanted |= 1u << diag_flag[i].group;
    return wanted;
}

bool diag_selection_enables(const DiagSelection *w, DiagCode code) { return select_flag(w, diag_find_flag(diag_info[code].flag)).on; }

// Drops disabled warnings and turns those that -Werror names into errors.  To be called after diags_apply_allows.
void diags_select(Diags *d, const DiagSelection *w)
{
    uint32_t kept = 0, allowed = 0;

    for (size_t i = 0; i < d->list.n; i++) {
        Diag *diag = d->list.at[i];
        if (diag->severity == DIAG_WARNING) {
            FlagChoice v = select_diag(w, diag);
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
        d->warnings = 0;              // Diags.warnings also counts warnings that were dropped
    for (size_t i = 0; i < d->allowed.n; i++)
        if (select_diag(w, d->allowed.at[i]).on)
            d->allowed.at[allowed++] = d->allowed.at[i];
    d->allowed.n = allowed;
}
