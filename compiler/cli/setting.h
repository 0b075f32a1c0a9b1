// SPDX-License-Identifier: Apache-2.0
// NAME=VALUE on the command line: a parameter and the value that it gets.
#ifndef SMC_CLI_SETTING_H
#define SMC_CLI_SETTING_H

#include "compiler/cli/cli.h"

typedef struct Setting {
    const char *name, *text;  // as written: before and after the first '='
    uint32_t name_size;
    SmF64 value;              // NaN if the text is no number
} Setting;

// Splits NAME=VALUE.  The value is a number as in sources, with or without a sign, or true or false.  False after a message.
bool setting_parse(Cli *c, const char *word, Setting *s);
// Finds the parameter that a setting names, and its cell.  Returns EXIT_OK, or EXIT_PROBLEM after a message.
int setting_find(Cli *c, const Program *p, const Setting *s, ScriptSetting *out);
// Reports that a parameter cannot have the value of a setting, for a reason of stdlib/parameters.def.
void setting_report_refused(Cli *c, const Setting *s, const char *reason);

typedef VEC(ScriptSetting) ScriptSettings;

// Adds a setting to the list, for a parameter of p that the list does not have yet.  EXIT_OK, or the exit code after a message.
int settings_add(Cli *c, const Program *p, const Setting *s, ScriptSettings *list);
// Adds the values of --set to the list, for the parameters of p.  EXIT_OK, or the exit code after a message.
int settings_read(Cli *c, const Program *p, ScriptSettings *list);

#endif
