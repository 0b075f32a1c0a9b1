// SPDX-License-Identifier: Apache-2.0
// The diagnostics of a session as data, and as smc prints them.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/library/library.h"
#include "compiler/version.h"

// Returns diagnostic number `diag`, or NULL if it does not exist or nothing is compiled.
static const Diag *diag_of(const SmcSession *s, uint32_t diag)
{
    const Diags *d = library_is_open(s) && s->of.is_compiled ? &s->of.shown : NULL;

    if (!d)
        return NULL;
    if (diag < d->list.n)
        return d->list.at[diag];
    return diag - d->list.n < d->allowed.n ? d->allowed.at[diag - d->list.n] : NULL;
}

static const char *text_or_empty(const char *text) { return text ? text : ""; }

uint32_t smc_diag_count(const SmcSession *s) { return library_is_open(s) ? s->of.shown.list.n : 0; }
uint32_t smc_diag_allowed_count(const SmcSession *s) { return library_is_open(s) ? s->of.shown.allowed.n : 0; }

int32_t smc_diag_severity(const SmcSession *s, uint32_t diag)
{
    static const int32_t severity[] = {SMC_SEVERITY_ERROR, SMC_SEVERITY_WARNING, SMC_SEVERITY_NOTE};      // by DiagSeverity
    const Diag *d = diag_of(s, diag);

    return d ? severity[d->severity] : -1;
}

const char *smc_diag_code(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? text_or_empty(diag_info[d->code].id) : "";
}

const char *smc_diag_warning(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? text_or_empty(diag_info[d->code].flag) : "";
}

const char *smc_diag_message(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? d->text : "";
}

const char *smc_diag_label(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? text_or_empty(d->label) : "";
}

const char *smc_diag_allowed(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? text_or_empty(d->allowed) : "";
}

// ---- notes and edits ----

static const DiagNote *note_of(const SmcSession *s, uint32_t diag, uint32_t note)
{
    const Diag *d = diag_of(s, diag);

    return d && note < d->notes.n ? &d->notes.at[note] : NULL;
}

uint32_t smc_diag_note_count(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? d->notes.n : 0;
}

const char *smc_diag_note(const SmcSession *s, uint32_t diag, uint32_t note)
{
    const DiagNote *n = note_of(s, diag, note);

    return n ? n->text : "";
}

uint32_t smc_diag_note_step(const SmcSession *s, uint32_t diag, uint32_t note)
{
    const DiagNote *n = note_of(s, diag, note);

    return n ? n->step : 0;
}

uint32_t smc_diag_edit_count(const SmcSession *s, uint32_t diag)
{
    const Diag *d = diag_of(s, diag);

    return d ? d->edits.n : 0;
}

const char *smc_diag_edit(const SmcSession *s, uint32_t diag, uint32_t edit)
{
    const Diag *d = diag_of(s, diag);

    return d && edit < d->edits.n ? d->edits.at[edit].text : "";
}

// ---- places ----

// Sets *span to the source text of a part of the diagnostic (SMC_PART_...), or returns false. `item`: which note or edit.
static bool find_span(const SmcSession *s, uint32_t diag, int32_t part, uint32_t item, Span *span)
{
    const Diag *d = diag_of(s, diag);

    if (d && part == SMC_PART_DIAG && item == 0)
        *span = d->span;
    else if (d && part == SMC_PART_NOTE && item < d->notes.n)
        *span = d->notes.at[item].span;
    else if (d && part == SMC_PART_EDIT && item < d->edits.n)
        *span = d->edits.at[item].span;
    else
        return false;
    return span->src != NULL;
}

// Returns the column of a byte of a line, from 1, in UTF-16 code units.
static uint32_t utf16_column(const Source *src, LineCol at)
{
    uint32_t length, units = 0, code;
    const char *line = source_line(src, at.line, &length);

    for (uint32_t i = 0; i < at.col - 1 && i < length;) {
        const size_t n = utf8_decode(line + i, length - i, &code);
        units += n == 4 ? 2 : 1;
        i += n ? (uint32_t)n : 1;
    }
    return units + 1;
}

// Returns the session's number of a source; -1 if the session has no such source.
static int64_t number_of_source(const SmcSession *s, const Source *src)
{
    return src->number < s->of.sources && s->of.text[src->number] == src ? (int64_t)src->number : -1;
}

int64_t smc_diag_place(const SmcSession *s, uint32_t diag, int32_t part, uint32_t item, int32_t place, int32_t columns)
{
    Span span;
    LineCol at;

    if ((columns != SMC_COLUMN_BYTES && columns != SMC_COLUMN_UTF16) || !find_span(s, diag, part, item, &span))
        return -1;
    at = source_position(span.src, place == SMC_PLACE_END_LINE || place == SMC_PLACE_END_COLUMN ? span.at + span.len : span.at);
    switch (place) {
    case SMC_PLACE_SOURCE: return number_of_source(s, span.src);
    case SMC_PLACE_LINE: case SMC_PLACE_END_LINE: return at.line;
    case SMC_PLACE_COLUMN: case SMC_PLACE_END_COLUMN: return columns == SMC_COLUMN_UTF16 ? utf16_column(span.src, at) : at.col;
    case SMC_PLACE_OFFSET: return span.at;
    case SMC_PLACE_LENGTH: return span.len;
    }
    return -1;
}

// ---- texts ----

typedef struct TextRequest {
    int32_t form;
    uint32_t source, fixed;
    Buf out;
} TextRequest;

static SmcResult render(SmcSession *s, void *argument)
{
    TextRequest *t = argument;
    const DiagStyle style = {t->form == SMC_RENDER_COLOR, 0};
    const PlainMessages none = {NULL, 0, 0};

    library_begin_layer(s);
    buf_init(&t->out, &s->compiler.arena);
    if (t->form == SMC_RENDER_JSON)
        diags_render_json(&s->of.shown, &t->out);
    else if (t->form == SMC_RENDER_SARIF)
        diags_render_sarif(&s->of.shown, &none, SMC_VERSION, &t->out);
    else
        diags_render_text(&s->of.shown, &style, &t->out);
    library_keep_layer(s, &s->of.page[PAGE_RENDERED]);
    return SMC_OK;
}

static SmcResult apply_edits(SmcSession *s, void *argument)
{
    TextRequest *t = argument;

    library_begin_layer(s);
    buf_init(&t->out, &s->compiler.arena);
    t->fixed = (uint32_t)diags_apply_edits(&s->of.shown, s->of.text[t->source], &t->out);
    library_keep_layer(s, &s->of.page[PAGE_EDITED]);
    return SMC_OK;
}

SmcResult smc_render(SmcSession *s, int32_t form, const char **text, uint64_t *size)
{
    TextRequest t = {form, 0, 0, {0}};
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!text || !size || form < SMC_RENDER_TEXT || form > SMC_RENDER_SARIF)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!s->of.is_compiled)
        return library_fail(s, SMC_E_STATE, NULL);
    if ((r = library_guard(s, render, &t)) != SMC_OK)
        return r;
    *text = buf_text(&t.out);
    *size = t.out.n;
    return SMC_OK;
}

SmcResult smc_apply_edits(SmcSession *s, uint32_t source, const char **text, uint64_t *size, uint32_t *fixed)
{
    TextRequest t = {0, source, 0, {0}};
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!text || !size || !fixed)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!s->of.is_compiled)
        return library_fail(s, SMC_E_STATE, NULL);
    if (source >= s->of.sources || !s->of.text[source])
        return library_fail(s, SMC_E_INDEX, NULL);
    if ((r = library_guard(s, apply_edits, &t)) != SMC_OK)
        return r;
    *text = buf_text(&t.out);
    *size = t.out.n;
    *fixed = t.fixed;
    return SMC_OK;
}
