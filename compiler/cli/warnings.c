// SPDX-License-Identifier: Apache-2.0
// What -Wname, -Wno-name, -Werror, -Werror=name and -w make of the warnings that were reported.
#include "compiler/cli/cli.h"

#include <string.h>

static const char *const groups[] = {"all", "extra", "flight", "everything"};

static bool is_group(const char *name)
{
    for (size_t i = 0; i < sizeof groups / sizeof *groups; i++)
        if (strcmp(name, groups[i]) == 0)
            return true;
    return false;
}

static const char *skip_prefix(const char *text, const char *prefix)
{
    size_t n = strlen(prefix);
    return strncmp(text, prefix, n) == 0 ? text + n : NULL;
}

static bool is_flag(const char *name)
{
    for (size_t i = 0; i < DIAG_COUNT; i++)
        if (diag_info[i].flag && strcmp(diag_info[i].flag, name) == 0)
            return true;
    return is_group(name);
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

bool warnings_known(Cli *c)
{
    const char *names[DIAG_COUNT + 4], *near;
    size_t n = 0;

    for (size_t i = 0; i < DIAG_COUNT; i++)
        if (diag_info[i].flag)
            names[n++] = diag_info[i].flag;
    for (size_t i = 0; i < c->warns; i++) {
        const char *name = flag_in(c->warn[i]);
        if (strcmp(c->warn[i], "error") == 0 || strcmp(c->warn[i], "no-error") == 0 || is_flag(name))
            continue;
        near = nearest_name(name, names, n);
        if (near)
            cli_usage(c, "no warning is called '%s'; did you mean '%s'?", name, near);
        else
            cli_usage(c, "no warning is called '%s'", name);
        return false;
    }
    return true;
}

typedef struct Verdict { bool on, error; } Verdict;

static bool speaks_of(const char *name, const char *flag)
{
    return strcmp(name, flag) == 0 || is_group(name);
}

// Applies one -W… to what is decided so far about the warning `flag`.
static void apply_one(const char *w, const char *flag, Verdict *v)
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

void warnings_apply(const Cli *c, Diags *d)
{
    size_t kept = 0;

    for (size_t i = 0; i < d->list.n; i++) {
        Diag *diag = d->list.at[i];
        Verdict v = {true, false};
        const char *flag = diag_info[diag->code].flag;
        if (diag->severity == DIAG_WARNING) {
            for (size_t k = 0; flag && k < c->warns; k++)
                apply_one(c->warn[k], flag, &v);
            v.on = v.on && !c->given[OPT_NO_WARN];
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
}
