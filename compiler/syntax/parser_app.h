// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the two files of the parser of applications. parse_app.c: sections, options, executors; parse_app_line.c: the
// parts of a line. Parts can be on lines of their own: a word that begins the next entry ends the previous one.
#ifndef SMC_PARSER_APP_H
#define SMC_PARSER_APP_H

#include "compiler/syntax/ast_app.h"
#include "compiler/syntax/parser.h"

// What a line declares, as far as its annotations are concerned.
typedef enum AppPlace { APP_ON_EXECUTOR, APP_ON_TASK, APP_ON_MACHINE, APP_ON_OUTPUTS, APP_ON_SERVICE, APP_ON_INPUTS,
                       APP_PLACES } AppPlace;

// Reports that `expected` is missing here, and shows the form of such a line.
void app_report_form(Parser *p, const char *expected, const char *form);

// Each returns false after a message.
bool app_parse_name(Parser *p, AstWord *into, const char *expected, const char *form);
bool app_parse_file(Parser *p, AstWord *into, const char *form);
bool app_parse_amount(Parser *p, AstAmount *into, AppMeasure of, const char *form);

bool app_at_option(const Parser *p, AstAppOptionKind *kind);      // a word that begins a line of [options]
bool app_at_task(const Parser *p, AstAppTaskKind *kind);          // of a rate group
bool app_at_rate(const Parser *p);                                // `every`, `at`

// Parses all annotations that follow; `owner` is the name of what they annotate. The text covered by each @allow among them begins at
// `from`.
void app_parse_annotations(Parser *p, AppPlace place, const char *owner, uint32_t from, AstAppAnnotations *into, AstApp *app);

// Parses every @allow that follows an option.
void app_parse_allows(Parser *p, uint32_t from, AstApp *app);

#endif
