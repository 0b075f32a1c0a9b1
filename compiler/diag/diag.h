// SPDX-License-Identifier: Apache-2.0
// Diagnostics: what the compiler has to say to its user.  Every text lives in codes.def; this collects them with the
// places they speak of.  Nothing here prints: renderers (render_text.c …) turn the list into text.
#ifndef SMC_DIAG_H
#define SMC_DIAG_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"
#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/base/vec.h"

typedef enum DiagSeverity { DIAG_ERROR, DIAG_WARNING, DIAG_NOTE } DiagSeverity;

// A row of codes.def.  E0204 unknown_element is DIAG_unknown_element here.
typedef enum DiagCode {
#define DIAG(id, name, severity, flag, message, page) DIAG_##name,
#define DIAG_NOTE_TEXT(name, message) DIAG_##name,
#include "compiler/diag/codes.def"
#undef DIAG
#undef DIAG_NOTE_TEXT
    DIAG_COUNT
} DiagCode;

typedef struct DiagInfo {
    const char *id;           // "E0204"; NULL for the text of a note
    const char *name;         // "unknown_element"
    DiagSeverity severity;
    const char *flag;         // of a warning: the name behind -W, as "unused-element"; else NULL
    const char *message;      // {} stands for an argument
    const char *page;         // what `smc explain` prints: what it means, an example, what to do
} DiagInfo;

extern const DiagInfo diag_info[DIAG_COUNT];

// A row of flags.def.
typedef enum DiagGroup { DIAG_GROUP_ALL, DIAG_GROUP_EXTRA, DIAG_GROUP_FLIGHT, DIAG_GROUPS } DiagGroup;
#define DIAG_GROUPS_ALL ((1u << DIAG_GROUPS) - 1u)        // all of them, as bits
typedef enum DiagJudged {
    DIAG_JUDGED_ALWAYS, DIAG_JUDGED_VECTOR, DIAG_JUDGED_APP, DIAG_JUDGED_STEP, DIAG_JUDGED_NO_STEP, DIAG_JUDGED_NEVER
} DiagJudged;
typedef struct DiagFlag {
    const char *name;         // behind -W
    DiagGroup group;
    DiagJudged judged;
    const char *sentence;
} DiagFlag;

extern const DiagFlag diag_flag[];
extern const size_t diag_flag_count;
const DiagFlag *diag_find_flag(const char *name);         // NULL if there is none
extern const char *const diag_group_name[];               // by DiagGroup, as behind -W: "all", "extra", "flight"

typedef struct DiagEdit { Span span; const char *text; } DiagEdit;     // replace span by text
typedef struct DiagNote {
    Span span;                // span.src may be NULL
    const char *text;
    unsigned step;            // 1, 2, 3 … of a finding that takes several; 0: no step
} DiagNote;

// A declaration that a finding names: an @allow there covers it too, where all declarations of one subject have one.
typedef enum DiagSubject { DIAG_SENSOR, DIAG_OUTPUTS, DIAG_OTHER_WRITER, DIAG_CONSTANT, DIAG_SUBJECTS } DiagSubject;
typedef struct DiagAbout { Span span; DiagSubject subject; } DiagAbout;

// @allow: warnings of one flag in one part of a source are known and wanted.
typedef struct DiagAllow {
    const char *flag, *reason;
    Span span, covers;        // the annotation; what it is about
    bool shared;              // it may be needed elsewhere: by other machines, or by what is reported later
    bool used;
} DiagAllow;

typedef struct Diag {
    DiagCode code;
    DiagSeverity severity;                // as reported: -Werror may have raised it
    Span span;
    const char *text;                     // the message, arguments filled in
    const char *label;                    // behind the caret, as "did you mean 'valveOpen'?"; or NULL
    VEC(DiagNote) notes;
    VEC(DiagEdit) edits;                  // together one proposed fix
    VEC(DiagAbout) about;
    const char *allowed;                  // the reason of the @allow that covers it; else NULL
} Diag;

typedef struct Diags {
    Arena *arena;
    VEC(Diag *) list;                     // in the order reported; diags_sort puts them in source order
    size_t errors, warnings;              // reported; of a flood of errors the list keeps the first DIAG_KEPT_MAX
    size_t met;                           // errors met, repeated and muted ones too: what tells a caller that it failed
    VEC(DiagAllow) allow;
    VEC(Diag *) allowed;                  // what diags_apply_allows took out of the list
    unsigned known;                       // 1u << DiagJudged of what this run knows beyond the machine
    unsigned analysed;                    // 1u << DiagGroup of each group whose every warning has been reported: analyses have run
    bool muted;                           // while set, reports are dropped
    Diag *dropped;                        // stands for every report that is not in the list; its fields mean nothing
    Diag *first;                          // what the last dropped report repeats; NULL: it repeats none
    VEC(const Source *) files;            // in the order first seen
    struct DiagPlace *place;              // where something was reported already: open addressing, a power of two long
    size_t place_cap, place_n;
} Diags;

enum { DIAG_KEPT_MAX = 10000 };

void diags_init(Diags *d, Arena *arena);
void diags_clear(Diags *d);               // forgets what was reported; every @allow still covers what is reported from now on

// Adds a diagnostic.  One `const char *` follows for each {} of its message.  Returns it, so that notes, a label and
// edits can be added; never NULL.  A second report of one code at one place is dropped (what is returned then is not in the
// list and keeps nothing).
Diag *diag_report(Diags *d, DiagCode code, Span span, ...);
Diag *diag_report_list(Diags *d, DiagCode code, Span span, va_list args);     // the same, from a function that has them
// Adds a note; `text` is a DIAG_NOTE_TEXT row, its arguments follow.
void diag_note(Diags *d, Diag *to, Span span, DiagCode text, ...);
// The same, as the next step on the way to what was found.
void diag_step(Diags *d, Diag *to, Span span, DiagCode text, ...);
// Sets the text behind the caret; `text` is a DIAG_NOTE_TEXT row.
void diag_label(Diags *d, Diag *to, DiagCode text, ...);
// The name of a variable where it is declared, which the diagnostic names as its sensor or as one of its outputs.  A report that
// repeats another adds to that one: it is allowed only if what all of them name is.
void diag_about(Diags *d, Diag *to, DiagSubject subject, Span declaration);
// Proposes an edit that is certain to be meant.  `text` must live as long as the diagnostics.
void diag_edit(Diags *d, Diag *to, Span span, const char *text);

// An @allow.  One that is shared is never said to be useless: another machine may need it.
void diag_allow(Diags *d, const char *flag, const char *reason, Span span, Span covers);
void diag_allow_shared(Diags *d, const char *flag, const char *reason, Span span, Span covers);
// Takes the warnings that are allowed out of the list, into `allowed`; once everything has been reported.  Where analyses have
// run and there is no error, what no warning needed is reported.
void diags_apply_allows(Diags *d);

void diags_sort(Diags *d);                // by file as first seen, then place; stable

typedef struct DiagStyle {
    bool color;
    size_t most;                          // errors shown before the rest is only counted; 0 shows all
} DiagStyle;

// The list as the user reads it, closed by "1 error, 2 warnings" when there is any.
void diags_render_text(const Diags *d, const DiagStyle *style, Buf *out);
// Text of a source as a terminal may show it; gives how many columns it takes.
size_t diag_put_printable(Buf *out, const char *s, size_t n);
// One JSON object a line.
void diags_render_json(const Diags *d, Buf *out);
void diag_plain_json(const char *severity, const char *message, Buf *out);    // of what is no diagnostic: a file that cannot be read
// One SARIF 2.1.0 document, with no results when there is nothing to say.  `version`: of the program that speaks.  It is whole
// when it has been ended, with what there is to say beside diagnostics, as above.
typedef VEC(const char *) Sentences;
void diags_render_sarif(const Diags *d, const char *version, Buf *out);
void diags_end_sarif(const Sentences *plain, Buf *out);

// What tells a finding again in a later version of its file.
typedef struct DiagPrint {
    uint64_t hash;
    unsigned long twin;                   // 1, 2, 3 … of those with one hash
} DiagPrint;

const DiagPrint *diags_fingerprints(const Diags *d, Arena *arena);        // of the list, then of `allowed`

// The row whose id (or warning name) is `id`, upper or lower case; NULL if there is none.
const DiagInfo *diag_find(const char *id);

// Writes the text of src with all proposed edits made that do not touch each other, a diagnostic's own together.  Returns
// of how many diagnostics.
size_t diags_apply_edits(const Diags *d, const Source *src, Buf *out);

// All rows with their pages: docs/diagnostics.md.
void diags_write_markdown(Buf *out);
// A warning's name, what it finds, and how it is switched: what stands before the pages of its codes.
void diag_put_flag(Buf *out, const DiagFlag *flag);
void diag_put_title(const DiagInfo *row, Buf *out);        // the message, "..." for what is filled in
// What stands behind the message where people read it: "E0204"; of a warning with its name too, "W0503 unreachable-state".
const char *diag_code_and_name(const Diag *d, Arena *arena);

#endif
