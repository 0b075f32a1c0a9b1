// SPDX-License-Identifier: Apache-2.0
// Until the C backend is linked: says nothing, writes nothing.
#include "compiler/pipeline.h"
#if defined(__GNUC__)
__attribute__((weak)) void session_emit_c(Session *s, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code) { (void)s; (void)m; (void)o; (void)header; (void)code; }
__attribute__((weak)) void session_emit_c_state_vector(Session *s, const StateVec *sv, const EmitCOptions *o, Buf *header, Buf *code) { (void)s; (void)sv; (void)o; (void)header; (void)code; }
#endif
