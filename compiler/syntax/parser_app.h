// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the two files of the parser of applications. parse_app.c: sections, options, executors; parse_app_line.c: the
// parts of a line. An entry (an option, a rate, a task) can continue on further lines, up to a word that begins the next entry.
#ifndef SMC_PARSER_APP_H
#define SMC_PARSER_APP_H

#include "compiler/syntax/ast_app.h"
#include "compiler/syntax/parser.h"

// The kinds of lines that can have different annotations (columns of app.def).
typedef enum AppAnnotationTarget { APP_ON_EXECUTOR, APP_ON_TASK, APP_ON_MACHINE, APP_ON_OUTPUTS, APP_ON_SERVICE, APP_ON_INPUTS,
                       APP_ANNOTATION_TARGETS } AppAnnotationTarget;

// Reports that the source lacks `expected` at the next token, and shows `example`, a correct line.
void app_report_expected(Parser *p, const char *expected, const char *example);

// Each of these three functions returns false after reporting an error.
bool app_parse_name(Parser *p, AstWord *into, const char *expected, const char *example);
bool app_parse_file(Parser *p, AstWord *into, const char *example);
bool app_parse_amount(Parser *p, AstAmount *into, AppMeasure of, const char *example);

bool app_match_option(const Parser *p, AstAppOptionKind *kind);      // whether the next word begins a line of [options]; sets *kind
bool app_match_task(const Parser *p, AstAppTaskKind *kind);          // whether the next word begins a task of a rate group; sets *kind
bool app_is_at_rate(const Parser *p);                                // whether the next tokens begin a rate, with `every` or `at`

// Parses the braces of a machine, { fire = fireDrogue }. The next token is the opening brace.
void app_parse_bindings(Parser *p, AstBindings *into);
// Parses `fire = fireDrogue`, of which the next token is the first; adds it to `into`. Returns false after reporting an error.
bool app_parse_binding(Parser *p, AstBindings *into);

// Parses all annotations that follow; `owner` is the name of the annotated line. Each @allow among them covers the source from `from` on.
void app_parse_annotations(Parser *p, AppAnnotationTarget target, const char *owner, uint32_t from, AstAppAnnotations *into, AstApp *app);

// Parses every @allow that follows an option, which begins at `from`.
void app_parse_allows(Parser *p, uint32_t from, AstApp *app);

#endif
