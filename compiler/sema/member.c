// SPDX-License-Identifier: Apache-2.0
#include "compiler/sema/member.h"

#include <string.h>

// The parts of a name such as `deploy.T`.
typedef struct Dotted { Str machine, rest; } Dotted;

static bool split_at_dot(Sema *s, Str name, Dotted *out)
{
    const char *dot = memchr(name->text, '.', name->len);

    if (!dot)
        return false;
    out->machine = str_intern(s->strings, name->text, (size_t)(dot - name->text));
    out->rest = str_c(s->strings, dot + 1);
    return true;
}

static bool has_name(const Program *p, Str name, bool is_state) { return map_find(is_state ? &p->state_by_name : &p->by_name, name) != NULL; }

// Reports `deploy.T` in the script of a single machine, where the variable is called T.
static void report_one_machine(Sema *s, Str name, const Dotted *d, Span span, bool is_state)
{
    Diag *x = diag_report(s->diags, DIAG_member_of_machine, span, name->text);

    if (!has_name(s->p, d->rest, is_state))
        return;
    diag_label(s->diags, x, DIAG_label_write, d->rest->text);
    if (d->machine == s->p->name)
        diag_edit(s->diags, x, span, d->rest->text);
}

// Reports `deploy.x`, if the application has no machine `deploy`, or if this machine has no `x`.
static void report_unknown_member(Sema *s, const Dotted *d, Span span, bool is_state)
{
    const Joint *j = s->p->joint;
    Guess g = guess_init(d->machine);
    const Program *m = NULL;

    for (size_t i = 0; i < j->member.n && !m; i++) {
        m = j->member.at[i].name == d->machine ? j->member.at[i].program : NULL;
        guess_consider(&g, j->member.at[i].name);
    }
    if (!m) {
        guess_add_label(s->diags, diag_report(s->diags, DIAG_member_no_machine, span, d->machine->text), &g);
        return;
    }
    g = guess_init(d->rest);
    for (size_t i = 0; is_state && i < m->state.n; i++)
        guess_consider(&g, m->state.at[i]->name);
    for (size_t i = 0; !is_state && i < m->var.n; i++) {
        guess_consider(&g, m->var.at[i]->name);
        if (m->var.at[i]->alias)
            guess_consider(&g, m->var.at[i]->alias);
    }
    if (g.best)
        g.best = str_c(s->strings, format_in(s->arena, "%s.%s", d->machine->text, g.best->text));
    guess_add_label(s->diags, diag_report(s->diags, DIAG_member_unknown, span, d->machine->text, is_state ? "state" : "variable", d->rest->text), &g);
}

// Where a name without a machine is, which decides what it can mean: a variable, a state in a section's header, or a state in an expression.
typedef enum Bare { BARE_VARIABLE, BARE_SECTION, BARE_STATE } Bare;

// Reports a name such as `T`, which needs the name of a machine before it. Returns false if no machine has a variable or state of this name.
static bool report_missing_machine(Sema *s, Str name, Span span, Bare bare)
{
    static const char *const form[] = {"%s.%s", "%s.%s", "%s.S == %s"};
    const Joint *j = s->p->joint;
    const char *list = "", *only = NULL;
    size_t n = 0;
    Diag *d;

    for (size_t i = 0; i < j->member.n; i++)
        if (has_name(j->member.at[i].program, name, bare != BARE_VARIABLE)) {
            const char *machine = j->member.at[i].name->text;
            only = format_in(s->arena, "%s.%s", machine, name->text);
            if (n++ < 3)
                list = format_in(s->arena, "%s%s%s", list, *list ? " or " : "", format_in(s->arena, form[bare], machine, name->text));
        }
    if (n == 0)
        return false;
    d = diag_report(s->diags, DIAG_member_without_machine, span, name->text);
    diag_label(s->diags, d, DIAG_label_write, list);
    if (n == 1 && bare == BARE_VARIABLE)
        diag_edit(s->diags, d, span, only);
    return true;
}

bool report_member_name(Sema *s, Str name, Span span, bool is_state)
{
    Dotted d;

    if (!split_at_dot(s, name, &d))
        return s->p->joint && (report_missing_machine(s, name, span, is_state ? BARE_SECTION : BARE_VARIABLE) ||
                               (!is_state && report_missing_machine(s, name, span, BARE_STATE)));
    if (s->p->joint)
        report_unknown_member(s, &d, span, is_state);
    else
        report_one_machine(s, name, &d, span, is_state);
    return true;
}

void label_state_of_machine(Sema *s, const Program *m, Str name, Span span, Diag *x)
{
    const Joint *j = s->p->joint;
    Dotted d;

    if (!j || !split_at_dot(s, name, &d) || !has_name(m, d.rest, true))
        return;
    for (size_t i = 0; i < j->member.n; i++)
        if (j->member.at[i].name == d.machine && j->member.at[i].program == m) {
            diag_label(s->diags, x, DIAG_label_write, d.rest->text);
            diag_edit(s->diags, x, span, d.rest->text);
        }
}

bool report_dotted_declaration(Sema *s, Str name, Span span)
{
    if (!memchr(name->text, '.', name->len))
        return false;
    diag_report(s->diags, DIAG_member_declared, span, name->text);
    return true;
}
