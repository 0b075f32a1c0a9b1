// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/engines.h"

#include <string.h>

#include "compiler/device/engine_c.h"
#include "compiler/script/testfile.h"

const char *const engine_name[ENGINE_KINDS] = {"ref", "vm", "vm-soft", "c", "c-soft"};

// Returns the set of engines with these comma-separated names; "all" means all but c-soft; 0: a name is unknown.
unsigned engines_named(const char *name)
{
    unsigned which = 0;

    if (strcmp(name, "all") == 0)
        return ((1u << ENGINE_KINDS) - 1) & ~(1u << ENGINE_C_SOFT);
    for (;; name++) {
        const size_t n = strcspn(name, ",");
        unsigned kind = 0;
        while (kind < ENGINE_KINDS && (strlen(engine_name[kind]) != n || strncmp(name, engine_name[kind], n) != 0))
            kind++;
        if (kind == ENGINE_KINDS)
            return 0;
        which |= 1u << kind;
        if (*(name += n) == '\0')
            return which;
    }
}

// Returns the set of engines in a header's list, as `on ref vm c`; other words are ignored.
unsigned engines_in_list(const char *list)
{
    unsigned which = 0;

    for (unsigned i = 0; i < ENGINE_KINDS; i++)
        if (testfile_has_word(list, engine_name[i]))
            which |= 1u << i;
    return which;
}

static Engine *open_engine(EngineKind kind, Session *s, const Program *p, int opt_level, const char **error)
{
    IrMachine *m;

    switch (kind) {
    case ENGINE_REF: return engine_ref_open(&s->arena, p);
    case ENGINE_VM: return session_open_vm(s, p, opt_level, false, error);
    case ENGINE_VM_SOFT: return session_open_vm(s, p, opt_level, true, error);
    case ENGINE_C:
    case ENGINE_C_SOFT:
        if ((m = session_ir(s, p, opt_level)) != NULL)
            return engine_c_open(&s->arena, p, m, kind == ENGINE_C_SOFT, error);
        *error = "the machine could not be made into C";
        return NULL;
    case ENGINE_KINDS: break;
    }
    *error = "this build does not have it";
    return NULL;
}

// Opens one engine for each machine of an application, and joins them.
static Engine *open_app_engine(EngineKind kind, Session *s, const Program *p, int opt_level, const char **error)
{
    const size_t n = engine_machines(p);
    Engine **machine = ARENA_ARRAY(&s->arena, Engine *, n);

    for (size_t i = 0; i < n; i++)
        if ((machine[i] = open_engine(kind, s, p->joint->member.at[i].program, opt_level, error)) == NULL) {
            while (i-- > 0)
                machine[i]->close(machine[i]);
            return NULL;
        }
    return engine_app_open(&s->arena, p, machine);
}

// Opens the engines of `which`.  After a failure returns false, and the set contains the engines opened before.
bool engines_open(EngineSet *set, Session *s, const Program *p, unsigned which, int opt_level)
{
    for (unsigned i = 0; i < ENGINE_KINDS; i++) {
        const char *error = "";
        if (!(which & 1u << i))
            continue;
        if ((set->at[set->n] = (p->joint ? open_app_engine : open_engine)((EngineKind)i, s, p, opt_level, &error)) == NULL) {
            set->error = format_in(&s->arena, "engine %s: %s", engine_name[i], error);
            return false;
        }
        set->n++;
    }
    return true;
}

void engines_close(EngineSet *set)
{
    while (set->n) {
        Engine *e = set->at[--set->n];
        e->close(e);
    }
}
