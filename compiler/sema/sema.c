// SPDX-License-Identifier: Apache-2.0
// Starts the check of a machine or script: sets up the scopes and the known functions.
#include "compiler/base/path.h"
#include "compiler/sema/sema.h"

#include <string.h>

void sema_init(Sema *s, const CheckContext *c, const HiddenNames *lost, const Program *p, Windows *windows)
{
    enum { GUESSES = 30 };        // the most unknown names for which a similar name is suggested: more than the reports that are shown

    memset(s, 0, sizeof *s);
    s->arena = s->nodes = s->scratch = c->arena;
    s->strings = c->strings;
    s->diags = c->diags;
    s->lost = lost;
    s->p = p;
    s->windows = windows;
    s->guesses = GUESSES;
    s->functions.arena = s->arena;
    s->unknown_name.arena = s->unknown_state.arena = s->unknown_function.arena = s->arena;
    s->script_local.arena = s->defines.arena = s->remarked.arena = s->doubtful.arena = s->declared_at.arena = s->arena;
    for (int i = 0; i < SM_FN_COUNT; i++)
        map_put(&s->functions, str_c(s->strings, sm_builtin_info[i].name), (void *)&sm_builtin_info[i]);
}

Str sema_file_stem(StrPool *strings, const Source *src)
{
    const char *name = strcmp(src->name, "<stdin>") == 0 ? "stdin" : path_portable_name(src->name), *end = strrchr(name, '.');

    return str_intern(strings, name, end && end != name ? (size_t)(end - name) : strlen(name));
}
