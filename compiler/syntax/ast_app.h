// SPDX-License-Identifier: Apache-2.0
// The syntax tree of an application (.app) as written: options, start values, executors with their rate groups. app.def lists its words.
// Parts with syntax errors have been reported and are missing in the tree.
#ifndef SMC_AST_APP_H
#define SMC_AST_APP_H

#include "compiler/syntax/ast.h"

typedef struct AstWord { Str text; Span span; } AstWord;      // text is NULL if the word is absent

typedef enum AppMeasure { APP_NOTHING, APP_NUMBER, APP_TIME, APP_FREQUENCY, APP_SIZE } AppMeasure;

// A number with an optional unit, such as 10 ms, 1 kHz, 64 KB or 80. Its exact value in ns, Hz, bytes or without a unit is
// digits * 10^exponent * factor.
typedef struct AstAmount {
    AppMeasure of;            // the measure of the amount; NOTHING: the amount is absent
    uint64_t digits;
    int exponent;
    uint64_t factor;
    bool is_exact;            // false: more digits than any amount needs; the other fields are 0 then
    Span span;
} AstAmount;

typedef enum AstAppOptionKind {
#define APP_OPTION(name, element, file, amount, example) AST_APP_##name,
#include "compiler/syntax/app.def"
    AST_APP_OPTION_COUNT
} AstAppOptionKind;

typedef struct AstAppOption {
    AstAppOptionKind kind;
    Span name_span;
    AstWord element, file;
    AstAmount amount;
} AstAppOption;

typedef enum AstAppAnnotationKind {
#define APP_ANNOTATION(name, takes, executor, task, machine, outputs, service, example) AST_ON_##name,
#include "compiler/syntax/app.def"
    AST_APP_ANNOTATION_COUNT
} AstAppAnnotationKind;

typedef struct AstAppAnnotation {
    AstAppAnnotationKind kind;
    Span span;                // including its @ and its argument
    AstWord word;             // an element, a state, `skip`, `catch_up`
    AstAmount amount;
} AstAppAnnotation;

typedef VEC(AstAppAnnotation) AstAppAnnotations;

typedef enum AstAppTaskKind {
#define APP_TASK(word, named, file, option, example) AST_TASK_##word,
#include "compiler/syntax/app.def"
    AST_APP_TASK_COUNT
} AstAppTaskKind;

// A binding of a machine: `fire = fireDrogue`. Its right side is a name, or a value.
typedef struct AstBinding {
    AstWord name;             // the name that the machine uses
    AstWord element;          // the element to which the name is bound; absent: the right side is a value
    AstExpr *value;           // the right side of the assignment
    Span span;
} AstBinding;

typedef VEC(AstBinding) AstBindings;

typedef struct AstAppTask {
    AstAppTaskKind kind;
    AstWord name;             // for a task that the user cannot name: the word of its kind, such as "log"
    AstWord file;
    AstBindings bindings;     // for a machine: the bindings in the braces after its file; empty: it has no braces
    AstAppAnnotations annotations;
} AstAppTask;

typedef struct AstAppRate {
    AstAmount amount;         // an APP_TIME after `every`, an APP_FREQUENCY after `at`
    Span span;
    VEC(AstAppTask) tasks;
} AstAppRate;

typedef struct AstAppExecutor {
    AstWord name;
    Span header;
    AstAppAnnotations annotations;
    VEC(AstAppRate) rates;
    bool lost;                // tasks of this executor may be missing, because errors were reported
} AstAppExecutor;

// An @allow, and the line or section that it covers.
typedef struct AstAppAllow {
    const AstAnnotation *is;  // the annotation
    Span covers;              // the line or section
} AstAppAllow;

typedef struct AstApp AstApp;
struct AstApp {
    Span options_header, start_header;    // src is NULL if the section is absent
    VEC(AstAppOption) options;
    AstStmts start;           // the assignments of [start]: AST_ASSIGN
    VEC(AstAppExecutor *) executors;
    VEC(AstAppAllow) allows;
    bool lost;                // entries may be missing, because errors were reported
    bool strayed;             // an option outside [options] has been reported, so further ones are not reported
};

void ast_print_app(const AstApp *app, Buf *out);

const char *app_option_name(AstAppOptionKind kind);
const char *app_task_word(AstAppTaskKind kind);
const char *app_annotation_name(AstAppAnnotationKind kind);
AstAppOptionKind app_find_required_option(AstAppTaskKind kind);         // AST_APP_OPTION_COUNT if the task requires no option

#endif
