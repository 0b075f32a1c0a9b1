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
// Reports that a parameter cannot have the value of a setting, for a reason of stdlib/parameters.def.
void setting_report_refused(Cli *c, const Setting *s, const char *reason);

typedef VEC(ScriptSetting) ScriptSettings;

// Reads all values of --set for the parameters of p, as the caller's settings of a run.  EXIT_OK, or the exit code after a message.
int settings_read(Cli *c, const Program *p, ScriptSettings *out);

#endif
