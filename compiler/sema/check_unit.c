// SPDX-License-Identifier: Apache-2.0
// @unit of elements, locals and definitions (language.md 2.24 to 2.27).
#include <string.h>

#include "compiler/sema/sema.h"

// Reports a name that is no unit. The variable then has no unit, so its unit is compared with no other one.
static void warn_of_unknown(const CheckContext *c, const AstAnnotation *a, const MeasureError *error)
{
    const Span span = {a->name_span.src, a->name_span.at + error->at, error->len};
    Diag *d = diag_report(c->diags, DIAG_unit_not_known, span, format_in(c->arena, "%.*s", (int)error->len, a->name->text + error->at));

    if (error->near[0])
        diag_label(c->diags, d, DIAG_label_did_you_mean, error->near);
    if (error->is_certain)
        diag_edit(c->diags, d, span, error->near);
}

// The characters of typeset units, and the text for each.
static const struct { const char *typeset, *ascii; } unit_characters[] = {
    {"\xc2\xb2", "^2"}, {"\xc2\xb3", "^3"},                                             // superscript 2 and 3
    {"\xe2\x81\xbb\xc2\xb9", "^-1"}, {"\xe2\x81\xbb\xc2\xb2", "^-2"},                 // superscript -1 and -2
    {"\xc2\xb7", "*"}, {"\xe2\x8b\x85", "*"}, {"\xc3\x97", "*"}};                      // middle dot, dot operator, multiplication sign

// Returns the unit with the text for each character of a typeset one: m/s^2.
static const char *write_in_ascii(Arena *arena, const char *unit)
{
    Buf out;

    buf_init(&out, arena);
    while (*unit) {
        const char *ascii = NULL;
        size_t len = 1;
        for (size_t i = 0; i < sizeof unit_characters / sizeof *unit_characters && !ascii; i++)
            if (strncmp(unit, unit_characters[i].typeset, strlen(unit_characters[i].typeset)) == 0) {
                ascii = unit_characters[i].ascii;
                len = strlen(unit_characters[i].typeset);
            }
        buf_put(&out, ascii ? ascii : unit, ascii ? strlen(ascii) : 1);
        unit += len;
    }
    return buf_text(&out);
}

// Reports text that is no unit, with the unit that it means if it is a typeset one.
static void report_malformed(const CheckContext *c, const AstAnnotation *a, const MeasureError *error)
{
    const char *text = a->name->text, *ascii = write_in_ascii(c->arena, text);
    Diag *d = diag_report(c->diags, DIAG_unit_malformed, (Span){a->name_span.src, a->name_span.at + error->at, error->len}, text, error->expected);
    MeasureError ignored;
    Measure unit;

    if (strcmp(ascii, text) == 0 || measure_parse(ascii, &unit, &ignored) != MEASURE_GOOD)
        return;
    diag_label(c->diags, d, DIAG_label_write, ascii);
    diag_edit(c->diags, d, a->name_span, ascii);
}

// Returns the @unit among the annotations; NULL if there is no @unit, or if its word is no unit, which is reported. `is_bool`: a bool has the
// annotations.
const Measure *check_unit(const CheckContext *c, const AstAnnotations *all, Str name, bool is_bool)
{
    for (size_t i = 0; i < all->n; i++) {
        const AstAnnotation *a = &all->at[i];
        Measure unit;
        MeasureError error;
        MeasureFlaw flaw;
        if (a->kind != AST_UNIT)
            continue;
        if (is_bool) {
            diag_report(c->diags, DIAG_unit_of_bool, a->span, name->text);
            return NULL;
        }
        flaw = measure_parse(a->name->text, &unit, &error);
        if (flaw == MEASURE_MALFORMED)
            report_malformed(c, a, &error);
        else if (flaw == MEASURE_UNKNOWN)
            warn_of_unknown(c, a, &error);
        return flaw == MEASURE_GOOD ? arena_copy(c->arena, &unit, sizeof unit) : NULL;
    }
    return NULL;
}

// Returns the source text of the `unit` annotation, or an empty span.
static Span unit_span(const AstAnnotations *all)
{
    for (size_t i = 0; i < all->n; i++)
        if (all->at[i].kind == AST_UNIT)
            return all->at[i].span;
    return (Span){0};
}

// Sets the unit of v, which a machine lists, to that of the .sv if the machine gives none. Warns if they differ.
void set_listed_unit(Sema *s, Var *v, const AstDecl *decl, bool from_machine)
{
    const Measure *own = v->unit, *shared = v->element ? v->element->unit : NULL;

    if (v->element && from_machine)
        v->element->unit = own;
    else if (!own)
        v->unit = shared;
    else if (shared && (!measure_is_same_kind(own, shared) || !measure_is_same_scale(own, shared)))
        diag_note(s->diags, diag_report(s->diags, DIAG_unit_elsewhere, unit_span(&decl->annotations), v->name->text, measure_text(s->arena, own),
                                        measure_text(s->arena, shared)), v->element->span, DIAG_note_declared_here, v->name->text);
    s->has_units |= v->unit != NULL;
}
