// SPDX-License-Identifier: Apache-2.0
// Checks a pin file (config.md 9) and builds an IoMap: elements exist and have the right type, no pin and no input element is
// used twice, annotations are valid.
#include "compiler/sema/sema.h"

#include <string.h>

typedef struct IoCheck {
    const CheckContext *c;
    IoMap *io;
    Map taken[2];                 // [0] analog, [1] digital: a pin number, to the first AstPin with this number
    Map input;                    // the name of an element that an input pin writes, to the first such AstPin
    Map unknown;                  // set of the unknown names that are already reported
    unsigned guesses;             // how many more unknown names may be compared with all known ones
} IoCheck;

static const AstAnnotation *find_annotation(const AstPin *pin, AstAnnotationKind kind)
{
    for (size_t i = 0; i < pin->annotations.n; i++)
        if (pin->annotations.at[i].kind == kind)
            return &pin->annotations.at[i];
    return NULL;
}

static const char *source_text(const CheckContext *c, Span s)
{
    return format_in(c->arena, "%.*s", (int)(s.len < 40 ? s.len : 40), s.src->text + s.at);
}

// ---- the element ----

// Returns the pin's element; NULL after reporting that the state vector does not have it.  Also reports a digital pin whose element is not
// a bool, and an analog pin whose element is one (config.md 9.4, 9.5).
static const Element *check_element(IoCheck *k, const AstPin *pin, bool digital)
{
    const Element *e = map_find(&k->io->sv->by_name, pin->element);
    Diag *d;

    if (!e && !map_find(&k->unknown, pin->element)) {
        map_put(&k->unknown, pin->element, (void *)pin->element);
        d = diag_report(k->c->diags, DIAG_element_not_in_vector, pin->element_span, pin->element->text);
        suggest_element(k->c->diags, d, &k->guesses, k->io->sv, pin->element);
    }
    if (!e)
        return NULL;
    if (e->untyped || digital == (e->type == SM_BOOL))
        return e;
    if (digital)
        d = diag_report(k->c->diags, DIAG_digital_not_bool, pin->element_span, e->name->text, sm_type_info[e->type].spelling);
    else
        d = diag_report(k->c->diags, DIAG_analog_bool, pin->element_span, e->name->text);
    diag_note(k->c->diags, d, e->span, DIAG_note_declared_here, e->name->text);
    return e;
}

// Reports a second input pin for the same element (config.md 9.7).
static void check_single_input(IoCheck *k, const AstPin *pin, const Element *e)
{
    const AstPin *first = map_find(&k->input, e->name);
    Diag *d;

    if (!first) {
        map_put(&k->input, e->name, (void *)(size_t)pin);
        return;
    }
    d = diag_report(k->c->diags, DIAG_two_inputs, pin->element_span, e->name->text);
    diag_note(k->c->diags, d, first->element_span, DIAG_note_first_here);
}

// ---- numbers ----

// Whether x is a whole number from 0 to `most`.  If so, stores it in *out.
static bool try_whole_number(SmF64 x, uint32_t most, uint32_t *out)
{
    if (!sm_le(sm_from_i32(0), x) || !sm_le(x, sm_from_u32(most)))
        return false;
    *out = sm_truncate_u32(x);
    return sm_eq(sm_from_u32(*out), x);
}

// Returns the pin's number; 0 after reporting a number that is not a whole number of 16 bits.  Also reports a number that an earlier pin of
// the same kind uses (config.md 9.3, 9.6).
static uint16_t check_pin_number(IoCheck *k, const AstPin *pin, bool digital)
{
    const AstPin *first;
    uint32_t n = 0;
    Str key;
    Diag *d;

    if (!try_whole_number(pin->number.value, UINT16_MAX, &n)) {
        diag_report(k->c->diags, DIAG_pin_range, pin->number.span, source_text(k->c, pin->number.span));
        return 0;
    }
    key = str_c(k->c->strings, format_in(k->c->arena, "%lu", (unsigned long)n));
    if ((first = map_find(&k->taken[digital], key)) != NULL) {
        d = diag_report(k->c->diags, DIAG_pin_twice, pin->number.span, digital ? "digital" : "analog",
                        source_text(k->c, pin->number.span));
        diag_note(k->c->diags, d, first->number.span, DIAG_note_first_here);
    } else {
        map_put(&k->taken[digital], key, (void *)(size_t)pin);
    }
    return (uint16_t)n;
}

// ---- annotations ----

// Sets out->safe.  Reports a number as the @safe value of a digital pin, and true or false as that of an analog one (config.md 9.9).
static void check_safe_value(IoCheck *k, const AstPin *pin, Pin *out)
{
    const AstAnnotation *safe = find_annotation(pin, AST_SAFE_VALUE);
    const char *edit;
    Diag *d;

    out->safe = safe ? safe->lo.value : sm_from_i32(0);
    if (!safe || safe->is_truth == pin_is_digital(out))
        return;
    d = diag_report(k->c->diags, safe->is_truth ? DIAG_safe_of_analog : DIAG_safe_of_digital, safe->lo.span,
                    source_text(k->c, safe->lo.span));
    edit = sm_eq(safe->lo.value, sm_from_i32(0)) ? "false" : sm_eq(safe->lo.value, sm_from_i32(1)) ? "true" : NULL;
    if (edit && pin_is_digital(out)) {
        diag_label(k->c->diags, d, DIAG_label_write, edit);
        diag_edit(k->c->diags, d, safe->lo.span, edit);
    }
}

// Sets the flags for @inverted and the pull resistors.  Reports a pin with both pull resistors (config.md 9.10).
static void check_level_and_pulls(IoCheck *k, const AstPin *pin, Pin *out)
{
    const AstAnnotation *up = find_annotation(pin, AST_PULL_UP), *down = find_annotation(pin, AST_PULL_DOWN);
    Diag *d;

    out->inverted = find_annotation(pin, AST_INVERTED) != NULL;
    out->pull_up = up != NULL;
    out->pull_down = down != NULL;
    if (!up || !down)
        return;
    d = diag_report(k->c->diags, DIAG_two_pulls, up->span.at > down->span.at ? up->span : down->span, pin->element->text);
    diag_note(k->c->diags, d, up->span.at > down->span.at ? down->span : up->span, DIAG_note_first_here);
}

// Registers each @allow of a pin as shared, so that it is never reported as unused: machines that are checked later may need it.
static void register_allows(IoCheck *k, const AstPin *pin)
{
    Span covers = pin->element_span;

    if (pin->annotations.n)
        covers = span_join(covers, pin->annotations.at[pin->annotations.n - 1].span);
    for (size_t i = 0; i < pin->annotations.n; i++) {
        const AstAnnotation *a = &pin->annotations.at[i];
        if (a->kind == AST_ALLOW)
            diag_allow_shared(k->c->diags, a->name->text, a->reason->text, a->span, covers);
    }
}

// ---- the file ----

static void check_pin(IoCheck *k, const AstPin *pin, bool digital)
{
    const AstAnnotation *scale = find_annotation(pin, AST_SCALE), *offset = find_annotation(pin, AST_OFFSET);
    const AstAnnotation *hold = find_annotation(pin, AST_HOLD);
    uint32_t hold_ticks = 0;
    Pin p = {0};

    if (digital)
        p.kind = pin->output ? PIN_DIGITAL_OUT : PIN_DIGITAL_IN;
    else
        p.kind = pin->output ? PIN_ANALOG_OUT : PIN_ANALOG_IN;
    p.span = pin->element_span;
    p.number = check_pin_number(k, pin, digital);
    p.element = check_element(k, pin, digital);
    if (p.element && !pin->output)
        check_single_input(k, pin, p.element);
    p.scale = scale ? scale->lo.value : sm_from_i32(1);
    p.offset = offset ? offset->lo.value : sm_from_i32(0);
    if (scale && sm_eq(p.scale, sm_from_i32(0)))                                          // config.md 9.8
        diag_report(k->c->diags, DIAG_scale_zero, scale->span, pin->element->text);
    check_safe_value(k, pin, &p);
    if (hold && !try_whole_number(hold->lo.value, UINT8_MAX, &hold_ticks))                // config.md 9.11
        diag_report(k->c->diags, DIAG_hold_value, hold->lo.span, source_text(k->c, hold->lo.span));
    p.hold = (uint8_t)hold_ticks;
    check_level_and_pulls(k, pin, &p);
    register_allows(k, pin);
    vec_push(k->c->arena, &k->io->pin, p);
}

IoMap *check_io(CheckContext *c, const AstFile *f, const StateVec *sv)
{
    enum { GUESSES = 30,              // the most unknown names for which a similar name is suggested: more than the shown reports
           MOST = 65535 };            // the most pins: runtime-c/io.h counts them in 16 bits
    size_t errors = c->diags->errors_seen;
    const Map none = {c->arena, NULL, NULL, 0, 0};
    IoCheck k = {c, ARENA_NEW(c->arena, IoMap), {none, none}, none, none, GUESSES};

    k.io->name = sema_file_stem(c->strings, f->src);
    k.io->src = f->src;
    k.io->sv = sv;
    if (f->sections.n == 0 && !find_hidden_names(c, f)->any)
        diag_report(c->diags, DIAG_no_pins, (Span){f->src, 0, 0});
    for (size_t i = 0; i < f->sections.n; i++)
        for (size_t j = 0; j < f->sections.at[i]->pins.n; j++)
            check_pin(&k, &f->sections.at[i]->pins.at[j], f->sections.at[i]->digital);
    if (k.io->pin.n > MOST)
        diag_report(c->diags, DIAG_app_too_many, k.io->pin.at[MOST].span, "pins", "65535");
    return c->diags->errors_seen > errors ? NULL : k.io;
}
