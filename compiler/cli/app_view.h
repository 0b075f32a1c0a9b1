// SPDX-License-Identifier: Apache-2.0
// Functions shared by `smc swap` and `smc device`, for an application at the other end of the line.
#ifndef SMC_APP_VIEW_H
#define SMC_APP_VIEW_H

#include "compiler/cli/board_line.h"

// The actions of `smc device`.
int app_show_info(BoardLine *b, Buf *out);
int app_list_machines(BoardLine *b, Buf *out);
int app_confirm_swap(BoardLine *b, Buf *out);
int app_refuse_erase(BoardLine *b, Buf *out);
int app_refuse_parameters(BoardLine *b, Buf *out);

// Loads the key that the application requires. *key is NULL if it requires none. EXIT_OK, or the exit code after a message.
int app_load_key(BoardLine *b, uint8_t room[16], const uint8_t **key);

// Describes the phase of a swap and its reason or its end, as a line.
void app_describe_swap(Buf *out, const ApplicationSwap *s);
// Returns how a trial ended (SmSwapEnd), as a clause of a sentence.
const char *app_trial_end_text(uint8_t end);

#endif
